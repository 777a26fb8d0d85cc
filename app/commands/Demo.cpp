#include <QDir>
#include <QFileInfo>

#include <unistd.h>

#include "app/Console.h"
#include "app/Demonstration.h"
#include "app/Paths.h"
#include "app/QtSession.h"
#include "app/SwingList.h"
#include "app/SwingSource.h"
#include "app/commands/Command.h"
#include "core/base/WholeFile.h"
#include "ui/plots/swing/PictureOf.h"
#include "ui/plots/swing/SwingPlot.h"
#include "ui/report/swing/Report.h"
#include "ui/swing/RecordDocuments.h"

namespace lubberline::app {

namespace {

struct DemoArguments {
    std::string output;
    bool noWindow = false;
};

/// The newest swing that has a result and an older one of its compass: its report can show last year's curve.
Result<SwingId> swingToShow(db::Stores& stores)
{
    const auto swings = listSwings(stores);
    if (!swings)
        return swings.error();
    for (std::size_t i = 0; i + 1 < swings->size(); ++i) {
        const SwingRow& row = (*swings)[i].row;
        const bool usual = row.readings >= 8 && row.readings <= 12; // its report is the usual one
        if (row.maxAbsDeviation_deg && usual && (*swings)[i + 1].row.compass == row.compass)
            return row.id;
    }
    return Error{
        ErrorCode::NotFound, MARKED("app", "the demonstration database has no swing with a result"), stores.location().toStdString()};
}

Result<void> writePlots(
    const SwingRecord& record, const std::shared_ptr<const Analysis>& analysis, const std::optional<Swing>& previous, const QDir& folder)
{
    std::shared_ptr<const Analysis> last;
    QString lastDate;
    if (previous) {
        if (auto analysed = analyseSwing({SwingRecord{*previous, {}, {}, {}, {}, {}}, {}, "the previous swing"}); analysed) {
            last = std::make_shared<Analysis>(std::move(analysed.value()));
            lastDate = QString::fromStdString(previous->date.text());
        }
    }
    const auto picture = ui::pictureOf(record, analysis, {}, last, lastDate, AngleStyle::DecimalDegrees);
    for (const auto make : {ui::makePolarPlot, ui::makeCurvePlot, ui::makeSpectrumPlot, ui::makeComponentsPlot}) {
        const std::unique_ptr<ui::SwingPlot> plot(make(nullptr));
        plot->setPicture(picture);
        const QString stem = folder.filePath("swing-" + plot->name().toLower());
        for (const char* ending : {".png", ".svg"})
            if (const auto written = plot->exportTo(stem + ending); !written)
                return written;
    }
    return {};
}

Result<void> writeDocuments(db::Stores& stores, SwingId id, const QDir& folder)
{
    const auto record = stores.swings.record(id);
    if (!record)
        return record.error();
    const auto previous = stores.swings.previous(id);
    if (!previous)
        return previous.error();
    auto analysed = analyseSwing({*record, {}, "demonstration swing"});
    if (!analysed)
        return analysed.error();
    const auto analysis = std::make_shared<const Analysis>(std::move(analysed.value()));

    ui::ReportInput report;
    report.record = *record;
    report.analysis = *analysis;
    report.previous = *previous;
    const auto sensors = stores.sensors.of(record->compass.id);
    if (!sensors)
        return sensors.error();
    report.sensors = *sensors;
    report.madeAtUtc = nowUtc();
    if (const auto written = ui::writeReport(report, folder.filePath("swing-report.pdf")); !written)
        return written;
    const auto card = ui::cardOf(stores, id, {}, nowUtc());
    if (!card)
        return card.error();
    if (const auto written = ui::writeCard(*card, folder.filePath("correction-card.pdf")); !written)
        return written;
    return writePlots(*record, analysis, *previous, folder);
}

int demoCommand(const DemoArguments& options, const Invocation& invocation)
{
    const auto session = makeDrawingSession();
    auto stores = openDemonstration(invocation.database);
    if (!stores)
        return fail(stores.error());
    const QString path = QFileInfo((*stores)->location()).absoluteFilePath();
    const QDir folder(
        options.output.empty() ? QFileInfo(path).absoluteDir().filePath("demonstration") : QString::fromStdString(options.output));
    if (!folder.mkpath("."))
        return fail(
            {ErrorCode::Io, MARKED("app", "the folder cannot be made; expected one that may be written"), folder.path().toStdString()});

    const auto swing = swingToShow(**stores);
    if (!swing)
        return fail(swing.error());
    if (const auto written = writeDocuments(**stores, *swing, folder); !written)
        return fail(written.error());
    put("database  %s\n", qPrintable(path));
    for (const auto& file : folder.entryInfoList(QDir::Files, QDir::Name))
        put("%-8s  %s\n", file.suffix() == "pdf" ? "document" : "plot", qPrintable(file.absoluteFilePath()));
    std::fflush(stdout);

    if (options.noWindow || !hasDisplay()) {
        if (!options.noWindow)
            say("no display here, so no window; on a desktop: lubberline --db " + path.toStdString());
        return kDone;
    }
    // The documents were drawn on the offscreen platform; the window needs an application of its own.
    stores->reset();
    const std::string program = QCoreApplication::applicationFilePath().toStdString();
    const std::string database = path.toStdString();
    execl(program.c_str(), program.c_str(), "--db", database.c_str(), nullptr);
    return fail({ErrorCode::Io, MARKED("app", "the window could not be started"), program});
}

} // namespace

void addDemo(CLI::App& app, Invocation& invocation)
{
    auto options = std::make_shared<DemoArguments>();
    auto* command = app.add_subcommand("demo", "fill a database with a demonstration fleet, write a report and plots, open the window");
    command->add_option("-o,--output", options->output, "the folder for the report and plots (default: beside the database)")
        ->check([](const std::string& path) {
            return isStandardStream(path) ? std::string("-o: several files are written; expected a folder, not -") : std::string();
        });
    command->add_flag("--no-window", options->noWindow, "do not open the window");
    addDatabaseOption(*command, invocation);
    command->callback([options, &invocation] { invocation.action = [options, &invocation] { return demoCommand(*options, invocation); }; });
}

} // namespace lubberline::app
