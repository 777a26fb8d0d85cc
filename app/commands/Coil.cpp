// coil: a sensor on its bench, kept with a compass and held against the benches before.
#include "app/Console.h"
#include "app/LogOptions.h"
#include "app/OpenStores.h"
#include "app/Outputs.h"
#include "app/Paths.h"
#include "app/SheetOutput.h"
#include "core/base/Number.h"
#include "core/base/TerminalText.h"
#include "core/base/WholeFile.h"
#include "core/coil/CoilHistory.h"
#include "core/format/results/SensorTestsJson.h"
#include "ui/report/forms/InflightSheets.h"
#include "ui/report/forms/SensorTestSheets.h"

namespace lubberline::app {

namespace {

struct CoilArguments {
    LogArguments log;
    std::string keep, history, remove; ///< registration of the aircraft; of the last: the bench's record id
    std::string compass, date, serialNumber, note;
    Output output;
    bool json = false;
};

Result<CompassSystem> compassOf(db::Stores& stores, const std::string& registration, const std::string& name)
{
    const auto aircraft = stores.fleet.aircraftNamed(registration);
    if (!aircraft)
        return aircraft.error();
    const auto rows = stores.fleet.compassesOf(*aircraft);
    if (!rows)
        return rows.error();
    std::vector<CompassId> named;
    for (const auto& row : *rows)
        if (name.empty() || row.name == name)
            named.push_back(row.id);
    if (named.size() == 1)
        return stores.fleet.compass(named.front());
    return Error{ErrorCode::InvalidInput,
        {MARKED("app", "%1 of the compasses of %2 are meant; expected one: state it with --compass"), named.size(), registration}};
}

void printThree(const char* name, const Eigen::Vector3d& values, int decimals)
{
    put("%-28s%14.*f%14.*f%14.*f\n", name, decimals, values.x(), decimals, values.y(), decimals, values.z());
}

void print(const CoilResult& result)
{
    put("%s, %zu used, range %.0f nT\n%-28s%14s%14s%14s\n", counted(static_cast<std::int64_t>(result.samples), "sample").c_str(),
        result.used, result.range_nT, "", "x", "y", "z");
    printThree("scale, measured per applied", result.scale, 6);
    printThree("  standard error", result.scaleError, 6);
    printThree(result.biasAt_c ? text("bias, at %.1f deg C", *result.biasAt_c).c_str() : "bias", result.bias_nT, 1);
    printThree("  standard error", result.biasError_nT, 1);
    if (result.temperature_nT_per_c)
        printThree("per degree of temperature", *result.temperature_nT_per_c, 2);
    if (result.hysteresis_nT)
        printThree("hysteresis, up - down", *result.hysteresis_nT, 1);
    printThree("nonlinearity, largest", result.nonlinearity_nT, 1);
    printThree("noise, rms", result.noise_nT, 1);
    put("not orthogonal: xy %+.3f, xz %+.3f, yz %+.3f deg; mount: roll %+.3f, pitch %+.3f, yaw %+.3f deg\n",
        result.nonOrthogonality_deg.x(), result.nonOrthogonality_deg.y(), result.nonOrthogonality_deg.z(),
        toDegrees(result.misalignment.roll_rad), toDegrees(result.misalignment.pitch_rad), toDegrees(result.misalignment.yaw_rad));
}

void print(const std::vector<CoilBench>& benches)
{
    if (benches.empty())
        put("no bench is kept\n");
    for (std::size_t i = 0; i < benches.size(); ++i) {
        const CoilBench& bench = benches[i];
        put("%s  %.8s  %s  %s\n", bench.date.text().c_str(), bench.record.c_str(),
            bench.serialNumber.empty() ? "serial number not stated" : inOneLine(bench.serialNumber).c_str(), inOneLine(bench.log).c_str());
        if (const auto result = coilBench(logOf(bench)))
            print(*result);
        else
            put("%s\n", describe(result.error()).c_str());
        if (i + 1 == benches.size())
            return;
        put("since %s:\n", benches[i + 1].date.text().c_str());
        const auto drift = driftBetween(benches[i + 1], bench);
        if (!drift) {
            put("  the two benches %s\n\n", describe(drift.error()).c_str());
            continue;
        }
        printThree(drift->at_c ? text("  bias a year, at %.1f deg C", *drift->at_c).c_str() : "  bias a year", drift->bias_nT_per_year, 1);
        printThree("    +/- (95 %)", drift->biasInterval_nT_per_year, 1);
        printThree("  scale a year, of it", drift->scale_per_year, 6);
        printThree("    +/- (95 %)", drift->scaleInterval_per_year, 6);
        printThree("  noise now / before", drift->noiseRatio, 2);
        for (const auto& doubt : inEnglish(drift->doubts))
            put("  %s\n", doubt.c_str());
        put("\n");
    }
}

int historyCommand(const CoilArguments& options, const std::string& database)
{
    auto stores = openStores(database, options.remove.empty() ? db::OpenMode::ReadOnly : db::OpenMode::ReadWriteCreate);
    if (!stores)
        return fail(stores.error());
    const auto compass = compassOf(**stores, options.history, options.compass);
    if (!compass)
        return fail(compass.error());
    auto benches = (*stores)->coilBenches.of(compass->id);
    if (!benches)
        return fail(benches.error());
    if (!options.remove.empty()) {
        std::vector<CoilBench> meant;
        for (const auto& bench : *benches)
            if (bench.record.starts_with(options.remove))
                meant.push_back(bench);
        if (meant.size() != 1)
            return fail({ErrorCode::NotFound,
                {MARKED("app", "%1 benches of this compass have a record id that begins with %2; expected one"), meant.size(),
                    options.remove}});
        if (const auto removed = (*stores)->coilBenches.remove(compass->id, meant.front().record); !removed)
            return fail(removed.error());
        std::erase(*benches, meant.front());
    }
    if (options.json)
        put("%s\n", toJson(*benches).c_str());
    else
        print(*benches);
    return kDone;
}

Result<void> keep(const CoilArguments& options, const SensorLog& log, const std::string& database)
{
    auto bench = coilRecordOf(log);
    if (!bench)
        return bench.error();
    bench->date = today();
    if (!options.date.empty()) {
        const auto day = Date::read(options.date);
        if (!day)
            return Error{ErrorCode::InvalidInput, {MARKED("app", "'%1' is no day of the calendar; expected YYYY-MM-DD"), options.date}};
        bench->date = *day;
    }
    bench->serialNumber = options.serialNumber;
    bench->note = options.note;
    bench->log = ui::sourceName(options.log.file).toStdString();
    auto stores = openStores(database, db::OpenMode::ReadWriteCreate);
    if (!stores)
        return stores.error();
    const auto compass = compassOf(**stores, options.keep, options.compass);
    if (!compass)
        return compass.error();
    if (bench->serialNumber.empty())
        bench->serialNumber = compass->serialNumber;
    const auto kept = (*stores)->coilBenches.add(compass->id, *bench);
    if (!kept)
        return kept.error();
    say(text("kept as %.8s", kept->c_str()));
    return {};
}

int coilCommand(const CoilArguments& options, const std::string& database)
{
    if (options.log.file.empty() == options.history.empty()) {
        say("coil: expected a log, or --history, and not both");
        return kUsage;
    }
    if (!options.history.empty())
        return historyCommand(options, database);
    const auto log = readLog(options.log);
    if (!log)
        return fail(log.error());
    const auto result = coilBench(*log);
    if (!result)
        return fail({result.error().code, result.error().message, nameOfInput(options.log.file)});
    if (!options.keep.empty())
        if (const auto kept = keep(options, *log, database); !kept)
            return fail(kept.error());
    if (!options.json) {
        warn(log->warnings);
        warn(result->warnings);
    }
    if (options.json)
        put("%s\n", toJson(*result, *log).c_str());
    if (!options.output.empty())
        return writeSheet(ui::coilSheet(*result, ui::sourceName(options.log.file)), options.output);
    if (!options.json)
        print(*result);
    return kDone;
}

} // namespace

void addCoil(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<CoilArguments>();
    auto* command = app.add_subcommand("coil", "a sensor in a coil: applied (ax_nT, ay_nT, az_nT) against measured");
    addLogOptions(*command, invocation, options->log);
    command->get_option("LOG.csv")->required(false);
    command->add_flag("--json", options->json, "one JSON object on standard output");
    addOutputOption(*command, invocation, "-o,--output", options->output, "the report", {".pdf"});
    auto* keep = command->add_option("--keep", options->keep, "keep the bench with a compass of this aircraft (registration)");
    auto* history
        = command->add_option("--history", options->history, "the benches kept of a compass of this aircraft, and its drift between them");
    command->add_option("--compass", options->compass, "its name, where the aircraft has several");
    command->add_option("--date", options->date, "of the bench that is kept, YYYY-MM-DD; default: today")->needs(keep);
    command->add_option("--serial", options->serialNumber, "serial number of the sensor; default: the compass's")->needs(keep);
    command->add_option("--note", options->note, "the bench, its coil, who did it")->needs(keep);
    command->add_option("--remove", options->remove, "take this bench out: its record id or the beginning of it")->needs(history);
    addDatabaseOption(*command, invocation);
    command->callback(
        [options, &invocation] { invocation.action = [options, &invocation] { return coilCommand(*options, invocation.database); }; });
}

} // namespace lubberline::app
