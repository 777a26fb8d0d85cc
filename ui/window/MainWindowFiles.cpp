// What the main window does with files: import, export, backup.

#include <QFileInfo>

#include "core/base/OutputFile.h"
#include "ui/intake/ImportPanels.h"
#include "ui/kit/MessagePanel.h"
#include "ui/kit/Words.h"
#include "ui/window/MainWindow.h"
#include "ui/window/Transfers.h"

namespace lubberline::ui {

void MainWindow::chooseImport()
{
    const QString path
        = m_pageContext.files.open(tr("Import"), tr("Swings, exchange files, reports (*.csv *.txt *.tsv *.json *.pdf);;All files (*)"));
    if (!path.isEmpty())
        importFile(path);
}

void MainWindow::importFile(const QString& path, const CsvParticulars& particulars)
{
    if (m_transfer.running()) {
        fail(tr("Another file is being read or written. Wait for it, or cancel it."));
        return;
    }
    m_importPath = path;
    startTransfer(tr("Importing %1").arg(QFileInfo(path).fileName()), importing(m_stores, path, particulars));
}

void MainWindow::startTransfer(const QString& what, const Transfer& transfer)
{
    m_progress->begin(what);
    m_transfer.start(transfer);
}

void MainWindow::finishTransfer(const Result<TransferOutcome>& outcome)
{
    m_progress->hide();
    const QString path = std::exchange(m_importPath, QString());
    if (!outcome) {
        const Error& error = outcome.error();
        const bool unnamed = !path.isEmpty() && error.code == ErrorCode::InvalidInput && error.line == 0
            && QFileInfo(path).suffix().toLower() != "json" && QFileInfo(path).suffix().toLower() != "pdf";
        if (error.code == ErrorCode::Cancelled)
            m_messages->add(MessagePanel::Kind::Information, tr("Cancelled: nothing was changed."));
        else if (unnamed)
            m_messages->add(MessagePanel::Kind::Failure, messageOf(error), tr("Name the aircraft…"), [this, path] { askWhose(path); });
        else
            fail(messageOf(error));
    } else {
        if (outcome->fleetChanged)
            m_stores.changes().announceFleet();
        m_messages->add(MessagePanel::Kind::Information, (QStringList(outcome->message) + outcome->warnings).join('\n'));
        if (outcome->swing.valid())
            navigate({{}, outcome->swing});
    }
    emit importFinished();
}

/// Proposes the aircraft of the swing that is shown.
void MainWindow::askWhose(const QString& path)
{
    CsvParticulars proposed;
    if (const SwingId swing = shown().swing; swing.valid())
        if (const auto record = m_stores.swings.record(swing))
            proposed = {record->aircraft.registration, record->type.name, record->compass.name};
    m_naming->ask(path, proposed);
}

void MainWindow::exportExchange(bool wholeFleet)
{
    if (m_transfer.running()) {
        fail(tr("Another file is being read or written. Wait for it, or cancel it."));
        return;
    }
    const AircraftId aircraft = shown().aircraft;
    QString stem = tr("fleet");
    if (!wholeFleet)
        if (const auto record = m_stores.fleet.aircraft(aircraft))
            stem = toText(record->registration);
    const QString path = askToSave(tr("Export"), stem + ".lubberline.json", tr("Exchange files (*.lubberline.json)"));
    if (path.isEmpty())
        return;
    std::vector<AircraftId> wanted;
    if (!wholeFleet)
        wanted.push_back(aircraft);
    startTransfer(tr("Exporting"), exporting(m_stores, wanted, path));
}

QString MainWindow::askToSave(const QString& title, const QString& suggestion, const QString& filter)
{
    const QString path = m_services.dialogs.saveFile(this, title, suggestion, filter);
    if (path.isEmpty())
        return {};
    if (const auto allowed = checkOutput(path.toStdString(), db::filesOf(m_stores.location())); !allowed) {
        fail(messageOf(allowed.error()));
        return {};
    }
    return path;
}

void MainWindow::backUp()
{
    const QString path = askToSave(tr("Back up the database"), QFileInfo(m_stores.location()).completeBaseName() + "-backup.lubberline",
        tr("Lubberline databases (*.lubberline)"));
    if (path.isEmpty())
        return;
    if (const auto done = m_services.backup(path); done)
        m_messages->add(MessagePanel::Kind::Information, tr("Backup written: %1").arg(path));
    else
        fail(messageOf(done.error()));
}

} // namespace lubberline::ui
