#include "ui/swing/SwingFiles.h"

#include <QCoreApplication>
#include <QPrinter>

#include "ui/kit/PageContext.h"
#include "ui/kit/Words.h"
#include "ui/swing/Documents.h"
#include "ui/swing/Gathering.h"
#include "ui/swing/RecordDocuments.h"
#include "ui/swing/SwingEditor.h"
#include "ui/swing/SwingPage.h"

namespace lubberline::ui {

namespace {

struct FileWords {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::SwingFiles)
};

void tell(PageContext& context, const Result<void>& done, const QString& success)
{
    if (done)
        context.say(success);
    else
        context.fail(messageOf(done.error()));
}

/// @param use  with the report of the swing as it is stored now
void withReport(PageContext& context, SwingPage& page, const std::function<void(const ReportInput&)>& use)
{
    const QString now = toText(context.stores.clock().nowUtc());
    page.gathering().start<ReportInput>(
        [id = page.editor().id(), now](db::Stores& stores, const Progress& progress) { return reportOf(stores, id, now, progress); },
        [&context, &page, use](Result<ReportInput> input) {
            if (!input) {
                context.fail(FileWords::tr("No report: %1").arg(messageOf(input.error())));
                return;
            }
            use(*input);
        });
}

void withCard(PageContext& context, SwingPage& page, const CardOptions& options, const std::function<void(const CardInput&)>& use)
{
    const QString now = toText(context.stores.clock().nowUtc());
    const bool again = page.editor().record().swing.state == SwingState::Signed;
    page.gathering().start<CardInput>([id = page.editor().id(), options, now, again](db::Stores& stores,
                                          const Progress& progress) { return cardOf(stores, id, options, now, again, progress); },
        [&context, use](const Result<CardInput>& input) {
            if (input)
                use(*input);
            else
                context.fail(FileWords::tr("No card: %1").arg(messageOf(input.error())));
        });
}

/// A card that went out, as a file or on paper: the next one is a reprint.
void noteIssued(PageContext& context, const CardInput& card)
{
    if (context.stores.readOnly())
        return;
    if (const auto noted = noteCards(context.stores, card); !noted)
        context.fail(messageOf(noted.error()));
}

} // namespace

void writeReportFile(PageContext& context, SwingPage& page)
{
    withReport(context, page, [&context](const ReportInput& input) {
        const QString path = context.files.save(FileWords::tr("Write report"), fileStem(input.record) + ".pdf",
            FileWords::tr("PDF with the data attached (*.pdf);;HTML (*.html);;Readings (*.csv);;Results (*.json)"));
        if (!path.isEmpty())
            tell(context, writeReport(input, path), FileWords::tr("Report written: %1").arg(path));
    });
}

void previewReport(PageContext& context, SwingPage& page)
{
    withReport(context, page, [&context](const ReportInput& input) {
        context.dialogs.printPreview(&context.window, [&context, &input](QPrinter& printer) {
            if (const auto printed = printReport(input, printer); !printed)
                context.fail(messageOf(printed.error()));
        });
    });
}

void writeCardFile(PageContext& context, SwingPage& page, const CardOptions& options)
{
    const QString name = fileStem(page.editor().record()) + " card.pdf";
    withCard(context, page, options, [&context, name](const CardInput& input) {
        const QString path = context.files.save(FileWords::tr("Write correction card"), name, FileWords::tr("PDF (*.pdf)"));
        if (path.isEmpty())
            return;
        const auto written = writeCard(input, path);
        tell(context, written, FileWords::tr("Card written: %1").arg(path));
        if (written)
            noteIssued(context, input);
    });
}

void previewCard(PageContext& context, SwingPage& page)
{
    withCard(context, page, {}, [&context](const CardInput& input) {
        bool painted = true;
        const bool printed = context.dialogs.printPreview(&context.window, [&](QPrinter& printer) {
            const auto done = printCard(input, printer);
            painted = static_cast<bool>(done);
            if (!done)
                context.fail(messageOf(done.error()));
        });
        if (printed && painted)
            noteIssued(context, input);
    });
}

void writeJobCardFile(PageContext& context, SwingPage& page)
{
    const auto input = jobCardOf(context.stores, page.editor().id(), toText(context.stores.clock().nowUtc()));
    if (!input) {
        context.fail(messageOf(input.error()));
        return;
    }
    const QString path = context.files.save(
        FileWords::tr("Write a blank job card"), fileStem(input->record) + " job card.pdf", FileWords::tr("PDF (*.pdf)"));
    if (!path.isEmpty())
        tell(context, writeJobCard(*input, path), FileWords::tr("Job card written: %1").arg(path));
}

void write1613File(PageContext& context, SwingPage& page)
{
    const QString now = toText(context.stores.clock().nowUtc());
    page.gathering().start<StyleSheet1613>(
        [id = page.editor().id(), now](db::Stores& stores, const Progress& progress) { return sheet1613Of(stores, id, now, progress); },
        [&context](const Result<StyleSheet1613>& sheet) {
            if (!sheet) {
                context.fail(messageOf(sheet.error()));
                return;
            }
            const QString path = context.files.save(
                FileWords::tr("Write a sheet in DD 1613 style"), fileStem(sheet->record) + " DD 1613.pdf", FileWords::tr("PDF (*.pdf)"));
            if (!path.isEmpty())
                tell(context, write1613(*sheet, path), FileWords::tr("Sheet written: %1").arg(path));
        });
}

} // namespace lubberline::ui
