#include <algorithm>
#include <memory>

#include "app/Console.h"
#include "app/OpenStores.h"
#include "app/Outputs.h"
#include "app/Paths.h"
#include "app/QtSession.h"
#include "app/SwingList.h"
#include "app/SwingSource.h"
#include "app/commands/Command.h"
#include "core/angle/PrintedHeading.h"
#include "core/base/FileText.h"
#include "core/base/OutputFile.h"
#include "core/base/WholeFile.h"
#include "core/check/CheckHeadings.h"
#include "core/check/History.h"
#include "core/check/TwoCompasses.h"
#include "core/earth/FieldModel.h"
#include "core/format/csv/SwingCsv.h"
#include "core/format/reference/CheckJson.h"
#include "core/format/reference/PairCsv.h"
#include "core/record/Completeness.h"
#include "core/swing/Observations.h"

namespace lubberline::app {

namespace {

/// Where the history of a compass comes from: files, or all swings of the compass that a swing of the database is of.
struct HistorySource {
    std::vector<std::string> files;
    std::string swing;
};

struct CheckedCompass {
    CompassBelief belief;
    CheckOptions options;
    std::size_t swings = 0;
    std::vector<SourcedRecord> records; ///< of its history
    std::vector<Message> warnings;
    SwingRecord last; ///< the newest swing that there is: what the check is of
};

struct CheckArguments {
    std::string readings, date;
    HistorySource history;
    Output output;
    CheckOptions options;
    std::optional<double> error_deg, limit_deg;
    int headings = 3;
    bool json = false;
};

Result<std::vector<SourcedRecord>> recordsOf(const HistorySource& source, const std::string& database)
{
    std::vector<SourcedRecord> records;
    for (const std::string& file : source.files) {
        auto swing = swingFromCsv(file);
        if (!swing)
            return swing.error();
        if (swing->record.swing.date.empty())
            return Error{ErrorCode::InvalidInput,
                MARKED("app", "a swing without a date is no part of a history; expected “# date: YYYY-MM-DD”"), nameOfInput(file)};
        records.push_back({nameOfInput(file), std::move(swing->record)});
    }
    if (source.swing.empty())
        return records;
    auto stores = openStores(database, db::OpenMode::ReadOnly);
    if (!stores)
        return stores.error();
    const auto named = (*stores)->swings.named(source.swing);
    if (!named)
        return named.error();
    const auto one = (*stores)->swings.record(*named);
    if (!one)
        return one.error();
    const auto listed = listSwings(**stores, one->aircraft.registration);
    if (!listed)
        return listed.error();
    for (const ListedSwing& swing : *listed) {
        if (swing.compass != one->compass.name || swing.row.superseded) // what amends it is there, too
            continue;
        const auto id = (*stores)->swings.named(swing.record);
        auto record = id ? (*stores)->swings.record(*id) : Result<SwingRecord>(id.error());
        if (!record)
            return record.error();
        records.push_back({record->swing.record, std::move(record.value())});
    }
    return records;
}

/// @param read what the check itself reads: no part of its own history
Result<CheckedCompass> compassOf(
    const HistorySource& source, const std::string& database, double year, const CheckArguments& options, const SwingRecord* read = nullptr)
{
    auto records = recordsOf(source, database);
    if (!records)
        return records.error();
    CheckedCompass compass;
    if (!source.swing.empty()) {
        if (read && std::erase_if(*records, [&](const SourcedRecord& one) { return isSameSwing(one.record, *read); }) > 0)
            compass.warnings.push_back(MARKED("app", "these readings are on record already: they are no part of the history here"));
        for (auto one = records->begin(); one != records->end(); ++one) // what is on record is not this command's to refuse
            records->erase(std::remove_if(std::next(one), records->end(),
                               [&](const SourcedRecord& other) { return isSameSwing(one->record, other.record); }),
                records->end());
    }
    std::vector<SourcedRecord> together = *records;
    if (read) // of which compass they are is as doubtful as of its history
        together.push_back({nameOfInput(options.readings), *read});
    if (const auto one = checkHistory(together); !one)
        return one.error();
    for (Message& doubt : doubtsOfHistory(together))
        compass.warnings.push_back(std::move(doubt));
    compass.options = options.options;
    std::vector<SwingRecord> swings;
    for (const SourcedRecord& one : *records)
        swings.push_back(one.record);
    const auto history = historyOf(swings);
    compass.swings = static_cast<std::size_t>(
        std::count_if(history.begin(), history.end(), [year](const PastSwing& one) { return one.year <= year; }));
    compass.records = std::move(*records);
    std::stable_sort(swings.begin(), swings.end(), [](const auto& a, const auto& b) { return a.swing.date < b.swing.date; });
    if (!swings.empty())
        compass.last = swings.back();
    if (options.error_deg)
        compass.options.readingError_deg = *options.error_deg;
    compass.options.limit_deg = options.limit_deg;
    if (!options.limit_deg && compass.last.limits)
        compass.options.limit_deg = compass.last.limits->maxDeviation_deg;
    if (!source.swing.empty() || !source.files.empty())
        compass.belief = beliefOf(history, year, plausibleFor(compass.last.compass.kind));
    else
        compass.belief = beliefOf({}, year, {});
    return compass;
}

Result<double> yearOfCheck(const CheckArguments& options) { return decimalYear(options.date.empty() ? today().text() : options.date); }

/// The readings as a check swing of the compass, with the verdict in its note: what is imported, completed and signed.
SwingRecord checkSwing(const CheckedCompass& compass, const SwingRecord& read, const CheckVerdict& verdict)
{
    SwingRecord record = read;
    record.swing.kind = SwingKind::Check;
    record.swing.stage = SwingStage::AsFound;
    record.swing.procedure = kCheckProcedure;
    if (record.aircraft.registration.empty()) {
        record.aircraft = compass.last.aircraft;
        record.compass = compass.last.compass;
        record.type = compass.last.type;
    }
    std::string said = inWords(verdict, compass.options).english();
    if (read.aircraft.registration.empty() && !record.aircraft.registration.empty())
        said += "; the readings did not say of which aircraft they are";
    record.swing.note += (record.swing.note.empty() ? "" : "; ") + said;
    return record;
}

void printHeadings(const ChosenHeadings& chosen)
{
    put("read on compass headings");
    for (const double heading : chosen.compass_deg)
        put(" %03.0f", printedHeading_deg(heading, 0));
    put(" deg\nof the changes that matter %.2f deg are left unknown (before: %.2f; evenly spaced: %.2f)\n", chosen.left_deg,
        chosen.before_deg, chosen.leftEven_deg);
}

int checkCommand(const CheckArguments& options, const std::string& database)
{
    const auto session = makeDrawingSession();
    const auto year = yearOfCheck(options);
    if (!year)
        return fail(year.error());
    auto read = options.readings.empty() ? Result<SourcedSwing>(SourcedSwing{}) : swingFromCsv(options.readings);
    if (!read)
        return fail(read.error());
    const bool isRead = !options.readings.empty();
    auto compass = compassOf(options.history, database, *year, options, isRead ? &read->record : nullptr);
    if (!compass)
        return fail(compass.error());
    const ChosenHeadings chosen = headingsFor(compass->belief, options.headings, compass->options);
    if (!isRead) {
        if (Message unknown = whatIsUnknown(compass->belief); !unknown.empty())
            compass->warnings.push_back(std::move(unknown));
        if (options.json) {
            put("%s\n", toJson(compass->belief, compass->swings, chosen, compass->options, compass->warnings).c_str());
        } else {
            warn(compass->warnings);
            printHeadings(chosen);
        }
        return kDone;
    }
    const auto observations = observationsOf(read->record.swing);
    auto verdict = verdictOf(compass->belief, observations, compass->options);
    if (!verdict)
        return fail({verdict.error().code, verdict.error().message, nameOfInput(options.readings)});
    verdict->warnings.insert(verdict->warnings.begin(), compass->warnings.begin(), compass->warnings.end());
    if (!options.json) {
        warn(read->warnings);
        warn(verdict->warnings);
    }
    if (!options.output.empty()) {
        if (const auto written = writeWholeFile(options.output.path, writeSwingCsv(checkSwing(*compass, read->record, *verdict))); !written)
            return fail(written.error());
        sayWritten(options.output);
    }
    if (options.json) {
        put("%s\n", toJson(compass->belief, compass->swings, chosen, compass->options, observations, *verdict).c_str());
    } else if (!options.output.toStandardOutput()) {
        for (std::size_t i = 0; i < observations.size(); ++i)
            put("compass %06.2f deg: %+.2f deg from its card\n", printedHeading_deg(observations[i].compass.degrees(), 2),
                verdict->differences_deg[i]);
        put("%s\n", inWords(*verdict, compass->options).english().c_str());
    }
    return kDone;
}

struct CompareArguments {
    std::string pairs;
    HistorySource first, second;
    CheckArguments common;
};

int compareCommand(const CompareArguments& options, const std::string& database)
{
    const auto session = makeDrawingSession();
    const auto pairs = readPairCsvFile(options.pairs);
    if (!pairs)
        return fail(pairs.error());
    const auto year = yearOfCheck(options.common);
    if (!year)
        return fail(year.error());
    auto first = compassOf(options.first, database, *year, options.common);
    if (!first)
        return fail(first.error());
    auto second = compassOf(options.second, database, *year, options.common);
    if (!second)
        return fail(second.error());
    if (const auto two = checkTwoCompasses(first->records, second->records); !two)
        return fail(two.error());
    auto verdict = compareCompasses(first->belief, second->belief, *pairs, first->options);
    if (!verdict)
        return fail({verdict.error().code, verdict.error().message, nameOfInput(options.pairs)});
    for (const CheckedCompass* one : {&*first, &*second})
        verdict->warnings.insert(verdict->warnings.begin(), one->warnings.begin(), one->warnings.end());
    if (options.common.json) {
        put("%s\n", toJson(*verdict).c_str());
        return kDone;
    }
    warn(verdict->warnings);
    put("%s on %s, %zu with a datum; corrected by their cards they differ by %.2f deg rms\n",
        counted(std::int64_t(verdict->readings), "pair").c_str(), counted(std::int64_t(verdict->headings), "heading").c_str(),
        verdict->withDatum, verdict->rms_deg);
    put("headings by card, first - second (a deviation of the first that rose makes it fall):");
    for (std::size_t c = 0; c < 5; ++c)
        put("  %c %+.2f (%.2f)", letterOf(kCoefficients[c]), verdict->difference_deg[c], verdict->differenceError_deg[c]);
    put(" deg (standard error)\n%s\n", inWords(*verdict).english().c_str());
    return kDone;
}

void addCommon(CLI::App& command, Invocation& invocation, CheckArguments& options)
{
    command.add_option("--date", options.date, "of the check: YYYY-MM-DD (default: today)");
    command.add_option("--tolerance", options.options.tolerance_deg, "the card holds while no heading is further from it [deg]")
        ->check(CLI::Range(0.1, 90.0))
        ->capture_default_str();
    command.add_option("--limit", options.limit_deg, "of |deviation| [deg] (default: the compass's own, if it has one)")
        ->check(CLI::Range(0.1, 180.0));
    command.add_option("--reading-error", options.error_deg, "standard deviation of one deviation read on the apron [deg] (default: 0.7)")
        ->check(CLI::Range(0.01, 45.0));
    command.add_option("--accept", options.options.accepted, "largest error probability with which “holds” is said")
        ->check(CLI::Range(0.0001, 0.5))
        ->capture_default_str();
    command.add_flag("--json", options.json, "one JSON object on standard output");
    addDatabaseOption(command, invocation);
}

} // namespace

void addCheck(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<CheckArguments>();
    auto* command
        = app.add_subcommand("check", "the two-minute check: the headings that tell most about a compass, and whether its card holds");
    addInputOption(
        *command, invocation, "READINGS.csv", options->readings, "a Swing CSV of the two or three readings; without: which to take");
    addInputOption(
        *command, invocation, "--history", options->history.files, "a Swing CSV of an earlier swing of the compass; once for each")
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
    command->add_option("--of", options->history.swing, "a swing of the database: all swings of its compass are the history");
    command->add_option("--headings", options->headings, "how many headings to choose; also for a swing of n")
        ->check(CLI::Range(1, 24))
        ->capture_default_str();
    addOutputOption(*command, invocation, "-o,--output", options->output,
        "write the check as a Swing CSV with its verdict, to be imported and signed", {".csv"});
    addCommon(*command, invocation, *options);
    command->callback([options, &invocation] {
        if (options->readings.empty() && !options->output.empty())
            throw CLI::ValidationError("-o: there is no verdict without READINGS.csv");
        invocation.action = [options, &invocation] { return checkCommand(*options, invocation.database); };
    });
}

void addCompare(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<CompareArguments>();
    auto* command = app.add_subcommand("compare", "two compasses of one aircraft read together: which of them moved");
    addInputOption(*command, invocation, "PAIRS.csv", options->pairs,
        "columns first_compass_deg, second_compass_deg, and magnetic_heading_deg where a datum told it")
        ->required();
    addInputOption(*command, invocation, "--first-history", options->first.files,
        "a Swing CSV of an earlier swing of the first compass; once for each")
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
    addInputOption(*command, invocation, "--second-history", options->second.files, "the same of the second")
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
    command->add_option("--first-of", options->first.swing, "a swing of the database: all swings of its compass are the first's history");
    command->add_option("--second-of", options->second.swing, "the same of the second");
    addCommon(*command, invocation, options->common);
    command->callback(
        [options, &invocation] { invocation.action = [options, &invocation] { return compareCommand(*options, invocation.database); }; });
}

} // namespace lubberline::app
