#include "app/Console.h"
#include "app/OpenStores.h"
#include "app/Outputs.h"
#include "app/Paths.h"
#include "app/QtSession.h"
#include "app/commands/Command.h"
#include "core/base/OutputFile.h"
#include "core/base/TerminalText.h"
#include "core/format/results/FleetJson.h"
#include "db/stores/PopulationStore.h"
#include "ui/report/fleet/FleetDocument.h"

namespace lubberline::app {

namespace {

struct FleetArguments {
    FleetSelection selection;
    FleetOptions options;
    std::string today, training;
    Output output;
    bool json = false;
};

Result<std::optional<int>> dayOption(const std::string& text, const char* name)
{
    if (text.empty())
        return std::optional<int>();
    if (const auto day = dayOfDate(text))
        return day;
    return Error{
        ErrorCode::InvalidInput, {MARKED("app", "%1: '%2' is no day of the calendar; expected YYYY-MM-DD"), std::string(name), text}};
}

/// Dates as days; what is wrong with them is told before anything is opened.
Result<void> readDays(FleetArguments& arguments)
{
    for (const auto& [text, name] : {std::pair(&arguments.selection.from, "--from"), std::pair(&arguments.selection.to, "--to")})
        if (const auto day = dayOption(*text, name); !day)
            return day.error();
    const auto today = dayOption(arguments.today, "--today");
    if (!today)
        return today.error();
    arguments.options.today_day = today->value_or(*dayOfDate(nowUtc().left(10).toStdString()));
    const auto training = dayOption(arguments.training, "--training");
    if (!training)
        return training.error();
    arguments.options.training_day = *training;
    return {};
}

std::string figureOrDash(const std::optional<double>& value, const char* format) { return value ? text(format, *value) : "-"; }

void printPattern(const FleetReport& report)
{
    put("%s of %d aircraft used, of %d in the selection\n\n", counted(report.counts.used, "swing").c_str(),
        static_cast<int>(report.counts.aircraft), static_cast<int>(report.counts.swings));
    put("magnetic  aircraft      mean   sd found  sd between       5 %%      95 %%\n   (deg)           (deg, E +)     (deg)       (deg)     (deg)     (deg)\n");
    for (const auto& p : report.pattern.points)
        put("%8.1f %9d %10s %10s %11s %9s %9s\n", p.heading_deg, p.units, figureOrDash(p.mean_deg, "%+.2f").c_str(),
            figureOrDash(p.standardDeviation_deg, "%.2f").c_str(), figureOrDash(p.between_deg, "%.2f").c_str(),
            figureOrDash(p.percentile5_deg, "%+.2f").c_str(), figureOrDash(p.percentile95_deg, "%+.2f").c_str());
    put("\ncoefficient   mean (deg)   between (deg)\n");
    for (std::size_t c = 0; c < kCoefficientCount; ++c)
        put("%-11c %12s %15s\n", letterOf(kCoefficients[c]), figureOrDash(report.pattern.coefficients[c].mean_deg, "%+.2f").c_str(),
            figureOrDash(report.pattern.coefficients[c].between_deg, "%.2f").c_str());
}

void printExceedance(const Exceedance& exceedance)
{
    if (exceedance.pairs == 0)
        return;
    put("\nout of limits at the next inspection: %d of %s (%.1f %% to %.1f %% at 95 %%)", static_cast<int>(exceedance.exceeded),
        counted(exceedance.pairs, "pair").c_str(), 100 * exceedance.share95->low, 100 * exceedance.share95->high);
    if (exceedance.expectedShare)
        put("; expected %.1f %%, by mean and sd of one heading %.1f %%", 100 * *exceedance.expectedShare,
            100 * exceedance.threeSigmaShare.value_or(0));
    put("\n");
}

void printChanges(const FleetReport& report, const FleetSwings& fleet)
{
    if (report.plants.training)
        for (const auto& words : inWords(*report.plants.training))
            put("%s\n", words.english().c_str());
    put("\n%s at a false discovery rate of 10 %%\n", counted(std::ssize(report.changes.jumps), "jump").c_str());
    for (const auto& jump : report.changes.jumps)
        put("  %s\n", inWords(jump, fleet).english().c_str());
    constexpr std::size_t shown = 20;
    put("\n%-10s %-18s %11s  %-10s  %s\n", "aircraft", "compass", "probability", "by", "who next, and why");
    for (std::size_t i = 0; i < report.ranking.compasses.size() && i < shown; ++i) {
        const auto& ranked = report.ranking.compasses[i];
        const auto& compass = fleet.compasses[static_cast<std::size_t>(ranked.compass)];
        const std::string chance = ranked.probability < 0.001 ? "<0.001" : text("%.3f", ranked.probability);
        put("%-10s %-18s %11s  %-10s  %s\n", inOneLine(compass.aircraft).c_str(), inOneLine(compass.compass).c_str(), chance.c_str(),
            dateOfDay(ranked.by_day).c_str(), inWords(ranked).english().c_str());
    }
    if (report.ranking.compasses.size() > shown)
        put("  and %zu more: --json or -o has all\n", report.ranking.compasses.size() - shown);
}

Result<void> writeFleet(const FleetReport& report, const FleetSwings& fleet, const FleetArguments& arguments)
{
    const Output& output = arguments.output;
    if (output.kind == ".csv")
        return writeWholeFile(output.path, toCsv(report, fleet));
    if (output.kind == ".json")
        return writeWholeFile(output.path, toJson(report, fleet) + "\n");
    return ui::writeFleetDocument({report, fleet, arguments.selection, nowUtc()}, QString::fromStdString(output.path),
        output.kind == ".html" ? ui::DocumentKind::Html : ui::DocumentKind::Pdf);
}

int fleetCommand(FleetArguments& arguments, const std::string& database)
{
    if (const auto days = readDays(arguments); !days)
        return fail(days.error());
    const auto session = makeDrawingSession();
    auto stores = openStores(database, db::OpenMode::ReadOnly);
    if (!stores)
        return fail(stores.error());
    const auto fleet = db::PopulationStore((*stores)->database()).columns(arguments.selection, consoleProgress("reading"));
    if (!fleet)
        return fail(fleet.error());
    const auto report = fleetReportOf(*fleet, arguments.options, consoleProgress("computing"));
    if (!report)
        return fail(report.error());
    if (!arguments.output.empty()) {
        warn(report->warnings);
        if (const auto written = writeFleet(*report, *fleet, arguments); !written)
            return fail(written.error());
        sayWritten(arguments.output);
    } else if (arguments.json) {
        put("%s\n", toJson(*report, *fleet).c_str());
    } else {
        warn(report->warnings);
        printPattern(*report);
        printExceedance(report->exceedance);
        printChanges(*report, *fleet);
    }
    return kDone;
}

} // namespace

void addFleet(CLI::App& app, Invocation& invocation)
{
    auto arguments = std::make_shared<FleetArguments>();
    auto* command = app.add_subcommand("fleet", "years of swings as a population: pattern, exceedance, jumps, and who to swing next");
    auto& selection = arguments->selection;
    auto& options = arguments->options;
    command->add_option("--type", selection.type, "of this aircraft type");
    command->add_option("--aircraft", selection.aircraft, "of this aircraft (registration)");
    command->add_option("--compass", selection.compass, "of compass systems of this name");
    command->add_option("--site", selection.site, "swung at this compass base");
    command->add_option("--base", selection.base, "of aircraft that are based here now");
    command->add_option("--from", selection.from, "from this day on, YYYY-MM-DD");
    command->add_option("--to", selection.to, "up to this day, YYYY-MM-DD");
    command
        ->add_option_function<std::string>(
            "--stage",
            [&options](const std::string& stage) { options.stage = stage == "found" ? SwingStage::AsFound : SwingStage::AsLeft; },
            "found or left: of pattern, coefficients and bases; pairs and histories need both")
        ->check(CLI::IsMember({"found", "left"}));
    command
        ->add_option_function<std::string>(
            "--radio", [&selection](const std::string& radio) { selection.radio = radio == "on" ? RadioState::On : RadioState::Off; },
            "on or off")
        ->check(CLI::IsMember({"on", "off"}));
    command->add_option("--grid", options.grid, "headings of the pattern, evenly spaced from north")
        ->check(CLI::Range(3, 360))
        ->capture_default_str();
    command
        ->add_option_function<double>(
            "--limit", [&options](const double& limit) { options.limit_deg = limit; },
            "the largest |deviation| allowed [deg]; default: each compass's own")
        ->check(CLI::PositiveNumber);
    command
        ->add_option_function<std::string>(
            "--vote", [&options](const std::string& vote) { options.vote = vote == "swing" ? FleetVote::Swing : FleetVote::Aircraft; },
            "aircraft: one aircraft one vote (default); swing: each swing")
        ->check(CLI::IsMember({"aircraft", "swing"}));
    command->add_option("--training", arguments->training, "compare |A| before and after this day, YYYY-MM-DD; default: it is looked for");
    command->add_option("--today", arguments->today, "rank as of this day, YYYY-MM-DD; default: today (UTC)");
    auto* json = command->add_flag("--json", arguments->json, "one JSON object on standard output");
    addOutputOption(*command, invocation, "-o,--output", arguments->output, "the file to write", {".pdf", ".html", ".csv", ".json"})
        ->excludes(json);
    addDatabaseOption(*command, invocation);
    command->callback([arguments, &invocation] {
        invocation.action = [arguments, &invocation] { return fleetCommand(*arguments, invocation.database); };
    });
}

} // namespace lubberline::app
