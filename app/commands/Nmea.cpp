#include "app/Console.h"
#include "app/Outputs.h"
#include "app/Paths.h"
#include "app/Tables.h"
#include "app/commands/Command.h"
#include "core/angle/AngleText.h"
#include "core/base/Date.h"
#include "core/base/OutputFile.h"
#include "core/base/WholeFile.h"
#include "core/format/csv/SwingCsv.h"
#include "core/format/results/NmeaJson.h"
#include "core/nmea/NmeaSwing.h"
#include "core/swing/SwingResult.h"

namespace lubberline::app {

namespace {

struct NmeaArguments {
    std::string file, date;
    Output output;
    NmeaOptions nmea;
    bool json = false;
};

/// "log", "model", or degrees, east positive. @return empty when understood, as CLI11 wants it.
std::string takeVariation(const std::string& text, NmeaVariation& variation)
{
    if (text == "log") {
        variation = VariationOfLog{};
        return {};
    }
    if (text == "model") {
        variation = VariationOfModel{};
        return {};
    }
    const auto variation_deg = parseSignedAngle_deg(text);
    if (!variation_deg)
        return "--variation: " + describe(variation_deg.error()) + "; or log, or model";
    variation = Variation::fromDegrees(*variation_deg);
    return {};
}

void printTable(const NmeaSwing& swing, const std::optional<Analysis>& analysis)
{
    put("%s, %lld with a wrong checksum; pairs of headings: %zu, %zu used\n", counted(swing.sentences, "sentence").c_str(),
        static_cast<long long>(swing.badChecksums), swing.pairs.size(), swing.used);
    if (swing.variation)
        put("variation %+.2f deg (east +), %s\n", swing.variation->degrees(), swing.variationSource.c_str());
    if (analysis)
        putText(tableOf(*analysis));
}

int writeCsv(const NmeaArguments& options, const NmeaSwing& swing)
{
    SwingRecord record;
    record.swing = toSwing(swing);
    if (const auto written = writeWholeFile(options.output.path, writeSwingCsv(record)); !written)
        return fail(written.error());
    sayWritten(options.output);
    return kDone;
}

int nmeaCommand(const NmeaArguments& options)
{
    const auto swing = readNmeaSwingFile(options.file, options.nmea, consoleProgress("reading " + nameOfInput(options.file)));
    if (!swing)
        return fail(swing.error());
    std::optional<Analysis> analysis;
    std::vector<Message> warnings = swing->warnings;
    SwingRecord record;
    record.swing = toSwing(*swing);
    record.compass.resolution_deg = divisionOf_deg(record.swing);
    if (auto analysed = resultOf(record)) {
        analysis = std::move(analysed.value());
        warnings.insert(warnings.end(), analysis->warnings.begin(), analysis->warnings.end());
    } else {
        warnings.push_back(analysed.error().message);
    }
    if (!options.json || !options.output.empty())
        warn(warnings);
    if (!options.output.empty())
        return writeCsv(options, *swing);
    if (!options.json) {
        printTable(*swing, analysis);
        return kDone;
    }
    NmeaSwing told = *swing;
    if (!analysis)
        told.warnings = warnings;
    put("%s\n", toJson(told, analysis).c_str());
    return kDone;
}

} // namespace

void addNmea(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<NmeaArguments>();
    auto* command = app.add_subcommand("nmea", "a swing from an NMEA 0183 log of a slow turn");
    addInputOption(*command, invocation, "LOG.nmea", options->file,
        "sentences as they came (HDG, HDM, HDT, THS, VHW, RMC, VTG, GGA, ZDA), also inside CSV, JSON or binary")
        ->required();
    command
        ->add_option("--reference", options->nmea.reference,
            "what the compass is held against: track (RMC, VTG), true (HDT, THS), magnetic (another instrument's HDM or HDG)")
        ->transform(CLI::CheckedTransformer(std::map<std::string, NmeaReference>{
            {"track", NmeaReference::Track}, {"true", NmeaReference::HeadingTrue}, {"magnetic", NmeaReference::Magnetic}}))
        ->default_str("track");
    command->add_option_function<std::string>(
        "--variation",
        [options](const std::string& text) {
            if (const auto fault = takeVariation(text, options->nmea.variation); !fault.empty())
                throw CLI::ValidationError(fault);
        },
        "degrees, east positive; log (RMC, HDG); or model (WMM or IGRF at the log's place and date). Default: the log's, else the model's");
    command->add_option("--min-speed", options->nmea.minSpeed_kt, "with track: slower is left out [kt]")
        ->check(CLI::Range(0.0, 1000.0))
        ->capture_default_str();
    command->add_option("--max-turn-rate", options->nmea.maxTurnRate_deg_s, "faster is left out, as a compass lags [deg/s]")
        ->check(CLI::Range(0.0, 360.0))
        ->capture_default_str();
    command
        ->add_option("--wind", options->nmea.wind,
            "with track: found (taken out where it shows and the aircraft flies), out (wherever it shows: afloat), leave (on wheels)")
        ->transform(CLI::CheckedTransformer(std::map<std::string, NmeaWindChoice>{
            {"found", NmeaWindChoice::Found}, {"out", NmeaWindChoice::TakeOut}, {"leave", NmeaWindChoice::Leave}}))
        ->default_str("found");
    command
        ->add_option("--variation-error", options->nmea.variationError_deg,
            "standard error of the variation where you know of one (survey of the base, magnetic storm) [deg]: widens A")
        ->check(CLI::Range(0.0, 180.0));
    command->add_option("--date", options->date, "YYYY-MM-DD, where the log's own is wrong")->check([options](const std::string& text) {
        options->nmea.date = Date::read(text).value_or(Date());
        return options->nmea.date.empty() ? "\"" + text + "\" is no date; expected YYYY-MM-DD" : std::string();
    });
    command->add_option("--talker", options->nmea.compassTalker, "whose HDG and HDM are the compass (HC, II, …), where several send");
    command->add_flag("--json", options->json, "one JSON object on standard output");
    addOutputOption(*command, invocation, "-o,--output", options->output, "write the used pairs as a Swing CSV", {".csv"});
    options->nmea.today = today();
    command->callback([options, &invocation] { invocation.action = [options] { return nmeaCommand(*options); }; });
}

} // namespace lubberline::app
