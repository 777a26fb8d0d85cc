#include "app/Console.h"
#include "app/OpenStores.h"
#include "app/Outputs.h"
#include "app/Paths.h"
#include "app/QtSession.h"
#include "app/SwingSource.h"
#include "app/commands/Command.h"
#include "ui/swing/RecordDocuments.h"

namespace lubberline::app {

namespace {

struct ReportArguments {
    std::string file, swing;
    Output output;
    bool archive = false;
};

int writeInput(const ReportArguments& options, ui::ReportInput input, const std::vector<Message>& warnings)
{
    warn(warnings);
    warn(input.analysis.warnings);
    input.archive = options.archive;
    if (const auto written
        = ui::writeReport(input, QString::fromStdString(options.output.path), QString::fromStdString(options.output.kind.substr(1)));
        !written)
        return fail(written.error());
    sayWritten(options.output);
    return kDone;
}

int reportFromFile(const ReportArguments& options)
{
    const auto swing = swingFromCsv(options.file);
    if (!swing)
        return fail(swing.error());
    const auto analysis = analyseSwing(*swing);
    if (!analysis)
        return fail(analysis.error());
    ui::ReportInput input;
    input.record = swing->record;
    input.analysis = *analysis;
    input.madeAtUtc = nowUtc();
    return writeInput(options, std::move(input), swing->warnings);
}

int reportFromDatabase(const ReportArguments& options, const std::string& database)
{
    auto stores = openStores(database, db::OpenMode::ReadOnly);
    if (!stores)
        return fail(stores.error());
    const auto id = (*stores)->swings.named(options.swing);
    if (!id)
        return fail(id.error());
    auto input = ui::reportOf(**stores, *id, nowUtc());
    if (!input) {
        Error error = input.error();
        if (error.file.empty())
            error.file = "swing " + options.swing;
        return fail(error);
    }
    return writeInput(options, std::move(input.value()), {});
}

int reportCommand(const ReportArguments& options, const std::string& database)
{
    if (options.file.empty() == options.swing.empty()) {
        say("report: expected a Swing CSV or --swing ID, and not both");
        return kUsage;
    }
    const auto session = makeDrawingSession();
    if (!options.swing.empty())
        return reportFromDatabase(options, database);
    return reportFromFile(options);
}

} // namespace

void addReport(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<ReportArguments>();
    auto* command = app.add_subcommand("report", "a swing report: PDF (A4, the data attached), HTML, CSV or JSON");
    addInputOption(*command, invocation, "SWING.csv", options->file, "a Swing CSV");
    command->add_option("--swing", options->swing, "a swing of the database: its record id or the beginning of it (see `swings`)");
    addOutputOption(*command, invocation, "-o,--output", options->output, "the file to write", {".pdf", ".html", ".csv", ".json"})
        ->required();
    command->add_flag("--archive", options->archive, "PDF/A-1b for the archive: nothing attached");
    addDatabaseOption(*command, invocation);
    command->callback(
        [options, &invocation] { invocation.action = [options, &invocation] { return reportCommand(*options, invocation.database); }; });
}

} // namespace lubberline::app
