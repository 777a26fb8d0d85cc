// What the main window does with files: import, export, documents, backup.

#include <QFileInfo>
#include <QPrinter>
#include <QSettings>

#include "ui/fleet/RecordEdits.h"
#include "ui/intake/ImportPanels.h"
#include "ui/kit/MessagePanel.h"
#include "ui/kit/Words.h"
#include "ui/swing/SwingEditor.h"
#include "ui/swing/SwingPage.h"
#include "ui/window/Documents.h"
#include "ui/window/MainWindow.h"
#include "ui/window/RecordDocuments.h"
#include "ui/window/Transfers.h"

namespace lubberline::ui {

void MainWindow::chooseImport()
{
    const QString path
        = fileQuestions().open(tr("Import"), tr("Swings, exchange files, reports (*.csv *.txt *.tsv *.json *.pdf);;All files (*)"));
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
            m_messages->add(MessagePanel::Kind::Failure, messageOf(error), tr("Name the aircraft…"), [this, path] {
                CsvParticulars shown;
                if (swingShown()) {
                    const SwingRecord& record = m_swingPage->editor().record();
                    shown = {record.aircraft.registration, record.type.name, record.compass.name};
                }
                m_naming->ask(path, shown);
            });
        else
            fail(messageOf(error));
    } else {
        if (outcome->fleetChanged)
            m_stores.changes().announceFleet();
        m_messages->add(MessagePanel::Kind::Information, (QStringList(outcome->message) + outcome->warnings).join('\n'));
        if (outcome->swing.valid())
            showSwing(outcome->swing);
    }
    emit importFinished();
}

void MainWindow::exportExchange(bool wholeFleet)
{
    if (m_transfer.running()) {
        fail(tr("Another file is being read or written. Wait for it, or cancel it."));
        return;
    }
    const AircraftId aircraft = aircraftShown();
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

void MainWindow::report(const Result<void>& done, const QString& success)
{
    if (done)
        m_messages->add(MessagePanel::Kind::Information, success);
    else
        fail(messageOf(done.error()));
}

void MainWindow::writeReportFile()
{
    auto input = reportOf(m_stores, m_swingPage->editor().id(), toText(nowUtc()));
    if (!input) {
        fail(tr("No report: %1").arg(messageOf(input.error())));
        return;
    }
    input->angleStyle = m_style;
    const QString path = askToSave(tr("Write report"), fileStem(input->record) + ".pdf",
        tr("PDF with the data attached (*.pdf);;HTML (*.html);;Readings (*.csv);;Results (*.json)"));
    if (!path.isEmpty())
        report(writeReport(*input, path), tr("Report written: %1").arg(path));
}

void MainWindow::previewReport()
{
    auto input = reportOf(m_stores, m_swingPage->editor().id(), toText(nowUtc()));
    if (!input) {
        fail(tr("No report: %1").arg(messageOf(input.error())));
        return;
    }
    input->angleStyle = m_style;
    m_services.dialogs.printPreview(this, [this, &input](QPrinter& printer) {
        if (const auto printed = printReport(*input, printer); !printed)
            fail(messageOf(printed.error()));
    });
}

Result<CardInput> MainWindow::cardShown(int step_deg)
{
    CardOptions options;
    options.step_deg = step_deg;
    const bool again = m_swingPage->editor().record().swing.state == SwingState::Signed;
    return cardOf(m_stores, m_swingPage->editor().id(), options, toText(nowUtc()), again);
}

void MainWindow::writeCardFile(int step_deg)
{
    const auto input = cardShown(step_deg);
    if (!input) {
        fail(tr("No card: %1").arg(messageOf(input.error())));
        return;
    }
    const QString path = askToSave(tr("Write correction card"), fileStem(input->record) + " card.pdf", tr("PDF (*.pdf)"));
    if (!path.isEmpty())
        report(writeCard(*input, path), tr("Card written: %1").arg(path));
}

void MainWindow::previewCard()
{
    const auto input = cardShown(30);
    if (!input) {
        fail(tr("No card: %1").arg(messageOf(input.error())));
        return;
    }
    m_services.dialogs.printPreview(this, [this, &input](QPrinter& printer) {
        if (const auto printed = printCard(*input, printer); !printed)
            fail(messageOf(printed.error()));
    });
}

void MainWindow::writeJobCardFile()
{
    const auto input = jobCardOf(m_stores, m_swingPage->editor().id(), toText(nowUtc()));
    if (!input) {
        fail(messageOf(input.error()));
        return;
    }
    const QString path = askToSave(tr("Write a blank job card"), fileStem(input->record) + " job card.pdf", tr("PDF (*.pdf)"));
    if (!path.isEmpty())
        report(writeJobCard(*input, path), tr("Job card written: %1").arg(path));
}

void MainWindow::write1613File()
{
    const auto sheet = sheet1613Of(m_stores, m_swingPage->editor().id(), toText(nowUtc()));
    if (!sheet) {
        fail(messageOf(sheet.error()));
        return;
    }
    const QString path = askToSave(tr("Write a sheet in DD 1613 style"), fileStem(sheet->record) + " DD 1613.pdf", tr("PDF (*.pdf)"));
    if (!path.isEmpty())
        report(write1613(*sheet, path), tr("Sheet written: %1").arg(path));
}

void MainWindow::backUp()
{
    const QString path = askToSave(tr("Back up the database"), QFileInfo(m_stores.location()).completeBaseName() + "-backup.lubberline",
        tr("Lubberline databases (*.lubberline)"));
    if (!path.isEmpty())
        report(m_services.backup(path), tr("Backup written: %1").arg(path));
}

void MainWindow::removeDraft()
{
    leaveField();
    const SwingRecord record = m_swingPage->editor().record();
    m_stack.push(new MakeSwing(
        m_context, record.swing, MakeSwing::Direction::Remove, tr("removal of the swing of %1").arg(toText(record.swing.date))));
    if (m_swingPage->editor().id().valid())
        return;
    showAircraft(record.aircraft.id, record.compass.id);
}

void MainWindow::applyAngleStyle(bool minutes)
{
    m_style = minutes ? AngleStyle::DegreesMinutes : AngleStyle::DecimalDegrees;
    m_services.settings.setValue("view/minutes", minutes);
    if (m_swingPage)
        m_swingPage->setAngleStyle(m_style);
}

} // namespace lubberline::ui
