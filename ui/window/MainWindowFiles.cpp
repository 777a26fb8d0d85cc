// What the main window does with files: import and export, and every file that is asked for.

#include <QDateTime>
#include <QFileInfo>
#include <QRegularExpression>
#include <QTimer>

#include <utility>

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

/// A document that a page has asked a name for.
void MainWindow::write(const FileToWrite& file)
{
    if (m_transfer.running()) {
        fail(tr("Another file is being read or written. Wait for it, or cancel it."));
        return;
    }
    m_asked = file.path;
    startTransfer(tr("Writing %1").arg(QFileInfo(file.path).fileName()), writing(file));
}

void MainWindow::startTransfer(const QString& what, const Transfer& transfer)
{
    m_messages->mended(); // of the file before
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
            m_messages->add(MessagePanel::Kind::Failure, messageOf(error), {{tr("Name the aircraft…"), [this, path] { askWhose(path); }}});
        else
            fail(messageOf(error));
    } else {
        if (outcome->then)
            outcome->then();
        if (outcome->fleetChanged)
            m_stores.changes().announceFleet();
        if (outcome->swing.valid())
            navigate({{}, outcome->swing});
        const QString message = (QStringList(outcome->message) + outcome->warnings).join('\n');
        if (const QString written = std::exchange(m_asked, {}); !written.isEmpty() && path.isEmpty())
            tellWritten(message, written);
        else
            m_messages->add(MessagePanel::Kind::Information, message);
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

/// What a file of this page is called: with the registration and the day, unless the suggestion has them.
QString MainWindow::namedFor(const QString& suggestion) const
{
    const Shown now = shown();
    QString registration, compass, day = toText(m_stores.clock().today());
    if (const auto record = now.swing.valid() ? m_stores.swings.record(now.swing) : Result<SwingRecord>(Error{}); record) {
        registration = toText(record->aircraft.registration);
        compass = toText(record->compass.name); // both compasses of an aircraft are swung on one day
        day = toText(record->swing.date);
    } else if (const auto aircraft = now.aircraft.valid() ? m_stores.fleet.aircraft(now.aircraft) : Result<Aircraft>(Error{}); aircraft) {
        registration = toText(aircraft->registration);
    }
    static const QRegularExpression unusable(QStringLiteral(R"([/\\:*?"<>|\x00-\x1f])")), dated(QStringLiteral("\\d{4}-\\d{2}-\\d{2}"));
    registration.replace(unusable, QStringLiteral("-"));
    compass.replace(unusable, QStringLiteral("-"));
    QString name = suggestion;
    if (!registration.isEmpty() && !name.contains(registration))
        name.prepend(registration + u' ');
    if (!compass.isEmpty() && !name.contains(compass) && name.startsWith(registration))
        name.insert(registration.size(), u' ' + compass);
    if (!dated.match(name).hasMatch()) {
        const QString whose = compass.isEmpty() ? registration : registration + u' ' + compass;
        const bool led = !whose.isEmpty() && name.startsWith(whose);
        name.insert(led ? whose.size() : 0, led ? u' ' + day : day + u' ');
    }
    return name;
}

QString MainWindow::askToSave(const QString& title, const QString& suggestion, const QString& filter)
{
    const QString path = m_services.dialogs.saveFile(this, title, namedFor(suggestion), filter);
    if (path.isEmpty())
        return {};
    if (const auto allowed = checkOutput(path.toStdString(), db::filesOf(m_stores.location())); !allowed) {
        fail(messageOf(allowed.error()));
        return {};
    }
    watchFile(path);
    return path;
}

/// Whoever asked writes it before the event loop goes on; that it was written is said where nobody has said so.
void MainWindow::watchFile(const QString& path)
{
    m_asked = path;
    QTimer::singleShot(0, this, [this, path, before = QFileInfo(path).lastModified()] {
        if (m_asked == path && !m_transfer.running() && QFileInfo(path).lastModified() != before)
            tellWritten(tr("Written: %1").arg(path), std::exchange(m_asked, {}));
    });
}

} // namespace lubberline::ui
