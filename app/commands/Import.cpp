#include <QString>

#include <algorithm>

#include "app/Console.h"
#include "app/OpenStores.h"
#include "app/Paths.h"
#include "app/QtSession.h"
#include "app/SwingSource.h"
#include "app/commands/Command.h"
#include "core/base/WholeFile.h"
#include "core/format/csv/YearsCsv.h"
#include "core/record/ClockDates.h"
#include "db/transfer/Transfer.h"
#include "db/transfer/Years.h"
#include "ui/intake/ImportFile.h"

namespace lubberline::app {

namespace {

struct ImportArguments {
    std::vector<std::string> files;
    ui::CsvParticulars particulars;
    std::vector<std::string> columns, common; ///< KEY=NAME, KEY=VALUE
    std::string cells, by = "magnetic", dates = "ymd";
    bool years = false; ///< said to be tables of many swings
};

/// "KEY=TEXT" into a map. Errors: InvalidInput.
Result<void> takePairs(const std::vector<std::string>& pairs, const char* option, std::map<std::string, std::string>& into)
{
    for (const auto& pair : pairs) {
        const auto middle = pair.find('=');
        if (middle == std::string::npos || middle == 0 || middle + 1 == pair.size())
            return Error{ErrorCode::InvalidInput,
                {MARKED("app", "%1 '%2': expected a key and what it is, as %1 date=DATUM"), std::string(option), pair}};
        if (!into.emplace(pair.substr(0, middle), pair.substr(middle + 1)).second)
            return Error{ErrorCode::InvalidInput,
                {MARKED("app", "%1: %2 is said twice; expected it once"), std::string(option), pair.substr(0, middle)}};
    }
    return {};
}

Result<YearsTable> yearsTableOf(const ImportArguments& options)
{
    YearsTable table;
    for (const auto& done : {takePairs(options.columns, "--column", table.columns), takePairs(options.common, "--set", table.common)})
        if (!done)
            return done.error();
    for (const auto& [key, value] : {std::pair("aircraft", &options.particulars.aircraft), std::pair("type", &options.particulars.type),
             std::pair("compass", &options.particulars.compass)})
        if (!value->empty())
            table.common.emplace(key, *value);
    table.cells = yearsCellsNamed(options.cells);
    table.byCompass = options.by == "compass";
    table.dates = *dateOrderNamed(options.dates);
    return table;
}

/// Registration and date as columns: no file of one swing has them. Standard input is not looked at: it cannot be read twice.
bool looksLikeYears(const std::string& file)
{
    if (isStandardStream(file) || file.ends_with(".json") || file.ends_with(".pdf"))
        return false;
    const auto input = openInput(file, MARKED("app", "a table of swings"));
    if (!input)
        return false; // the reader says what is wrong
    const auto header = yearsHeader(**input, file);
    return header && header->looksLikeYears();
}

void sayOutcome(const std::string& file, const db::YearsOutcome& outcome)
{
    warn(outcome.warnings);
    warn(outcome.suspicions);
    say(text("%s: stored %s with %s, of %d new aircraft and %s; there already: %s", nameOfInput(file).c_str(),
        counted(outcome.swings, "new swing").c_str(), counted(outcome.readings, "reading").c_str(), outcome.aircraft,
        counted(outcome.compasses, "new compass system").c_str(), counted(outcome.alreadyThere, "swing").c_str()));
}

/// Reads tables from end to end: where there is no database yet, none is made for what cannot be stored. Standard input is read once only.
Result<void> readThrough(const std::vector<std::string>& files, const YearsTable& table)
{
    for (const auto& file : files) {
        if (isStandardStream(file))
            continue;
        const auto input = openInput(file, MARKED("app", "a table of swings"));
        if (!input)
            return input.error();
        YearsReader reader(**input, file, table, consoleProgress("reading " + file));
        for (;;) {
            const auto swing = reader.next();
            if (!swing)
                return swing.error();
            if (!*swing)
                break;
        }
    }
    return {};
}

/// Tables of many swings, in constant memory: all or none.
int importYearsCommand(const ImportArguments& options, const std::string& database)
{
    const auto table = yearsTableOf(options);
    if (!table)
        return fail(table.error());
    const auto session = makeDrawingSession();
    if (const auto there = openStores(database, db::OpenMode::ReadOnly); !there && there.error().code == ErrorCode::NotFound)
        if (const auto whole = readThrough(options.files, *table); !whole)
            return fail(whole.error());
    std::vector<std::unique_ptr<std::istream>> inputs;
    std::vector<std::unique_ptr<YearsReader>> readers;
    for (const auto& file : options.files) {
        auto input = openInput(file, MARKED("app", "a table of swings"));
        if (!input)
            return fail(input.error());
        inputs.push_back(std::move(input.value()));
        readers.push_back(
            std::make_unique<YearsReader>(*inputs.back(), nameOfInput(file), *table, consoleProgress("storing " + nameOfInput(file))));
    }
    auto stores = openStores(database, db::OpenMode::ReadWriteCreate);
    if (!stores)
        return fail(stores.error());
    const auto imported = db::importYears((*stores)->database(), readers, today());
    if (!imported)
        return fail(imported.error());
    for (std::size_t i = 0; i < imported->size(); ++i)
        sayOutcome(options.files[i], (*imported)[i]);
    return kDone;
}

/// All files or none: they are read first, then stored in one transaction.
int importSwings(const ImportArguments& options, const std::string& database)
{
    std::vector<Fleet> fleets;
    for (const auto& file : options.files) {
        auto read = ui::readImportFile(QString::fromStdString(file), options.particulars, consoleProgress("reading " + nameOfInput(file)));
        if (!read)
            return fail(read.error());
        warn(read->warnings);
        for (const Swing& swing : read->fleet.swings)
            if (const auto doubt = doubtOfDate(swing.date, today()); !doubt.empty())
                warn({doubt});
        fleets.push_back(std::move(read->fleet));
    }
    const auto session = makeDrawingSession();
    auto stores = openStores(database, db::OpenMode::ReadWriteCreate);
    if (!stores)
        return fail(stores.error());
    const auto imported = db::importAll((*stores)->database(), fleets, consoleProgress("storing"));
    if (!imported)
        return fail(imported.error());
    warn(imported->warnings);
    say(text("stored %s of %d new aircraft; there already: %s", counted(imported->swings, "new swing").c_str(), imported->aircraft,
        counted(imported->alreadyThere, "swing").c_str()));
    return kDone;
}

int importCommand(const ImportArguments& options, const std::string& database)
{
    if (options.years || !options.columns.empty() || !options.common.empty() || !options.cells.empty())
        return importYearsCommand(options, database);
    const auto years = std::count_if(options.files.begin(), options.files.end(), looksLikeYears);
    if (years == 0)
        return importSwings(options, database);
    if (years < static_cast<std::ptrdiff_t>(options.files.size()))
        return fail(Error{ErrorCode::InvalidInput,
            MARKED("app", "some of the files are tables of many swings, others are not; expected them in two imports")});
    return importYearsCommand(options, database);
}

} // namespace

void addImport(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<ImportArguments>();
    auto* command = app.add_subcommand(
        "import", "store swings from Swing CSV, exchange JSON or our own report PDF; or a table of many swings, as records of years");
    addInputOption(*command, invocation, "FILE", options->files, "files of any of these kinds, told by their endings; - by its content")
        ->required();
    command->add_option("--aircraft", options->particulars.aircraft, "for a CSV that does not state it: the registration");
    command->add_option("--type", options->particulars.type, "likewise: the aircraft type");
    command->add_option("--compass", options->particulars.compass, "likewise: the compass");
    command->add_flag("--years", options->years,
        "the files are tables of many swings (told by itself where aircraft and date are columns, or one of the next options is there)");
    command->add_option("--column", options->columns, "KEY=NAME: the column NAME of the table is KEY, as date=DATUM")
        ->type_name("KEY=NAME")
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
    command->add_option("--set", options->common, "KEY=VALUE: what every swing of the table has, as stage=as_found")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
    command
        ->add_option(
            "--cells", options->cells, "what stands under headings that are columns: compass, deviation, indication_error or magnetic")
        ->check(CLI::IsMember({"compass", "magnetic", "deviation", "indication_error"}));
    command->add_option("--by", options->by, "the headings that are columns are magnetic (default) or compass headings")
        ->check(CLI::IsMember({"magnetic", "compass"}));
    command->add_option("--dates", options->dates, "how dates are written: ymd (default), dmy or mdy")
        ->check(CLI::IsMember({"ymd", "dmy", "mdy"}));
    addDatabaseOption(*command, invocation);
    command->callback(
        [options, &invocation] { invocation.action = [options, &invocation] { return importCommand(*options, invocation.database); }; });
}

} // namespace lubberline::app
