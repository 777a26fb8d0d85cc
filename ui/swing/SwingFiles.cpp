#include "ui/swing/SwingFiles.h"

#include <QCoreApplication>
#include <QPrinter>

#include <cmath>
#include <memory>
#include <utility>

#include "ui/kit/PageContext.h"
#include "ui/kit/Words.h"
#include "ui/report/swing/ReportPages.h"
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

/// @param write (what is written, path), on a worker
template <class Input>
void writeFile(PageContext& context, const Input& input, Result<void> (*write)(const Input&, const QString&), const QString& path,
    const QString& success, std::function<void()> then = {})
{
    context.files.write({path, [input, write, path](const Progress&) { return write(input, path); }, success, std::move(then)});
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

/// In another size of paper than was to be expected it is laid out anew.
bool fits(const ReportPages& pages, const QPrinter& printer)
{
    const QSizeF off = pages.sheet() - sheetSize(printer);
    return std::abs(off.width()) < mm(0.1) && std::abs(off.height()) < mm(0.1);
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
            context.files.write({path, [input, path](const Progress& progress) { return writeReport(input, path, {}, progress); },
                FileWords::tr("Report written: %1").arg(path)});
    });
}

void previewReport(PageContext& context, SwingPage& page)
{
    using Laid = std::pair<ReportInput, std::shared_ptr<const ReportPages>>;
    const QString now = toText(context.stores.clock().nowUtc());
    page.gathering().start<Laid>(
        [id = page.editor().id(), now](db::Stores& stores, const Progress& progress) -> Result<Laid> {
            auto input = reportOf(stores, id, now, progress);
            if (!input)
                return input.error();
            auto pages = layOutReport(*input, a4Sheet());
            return pages ? Result<Laid>(Laid(std::move(*input), *pages)) : pages.error();
        },
        [&context](const Result<Laid>& laid) {
            if (!laid) {
                context.fail(FileWords::tr("No report: %1").arg(messageOf(laid.error())));
                return;
            }
            const auto printed = context.dialogs.printPreview(&context.window, [&](QPrinter& printer, const Progress& progress) {
                const auto& [input, pages] = *laid;
                return fits(*pages, printer) ? printReport(*pages, printer, progress) : printReport(input, printer, progress);
            });
            if (!printed)
                context.fail(messageOf(printed.error()));
        });
}

void writeCardFile(PageContext& context, SwingPage& page, const CardOptions& options)
{
    const QString name = fileStem(page.editor().record()) + " card.pdf";
    withCard(context, page, options, [&context, name](const CardInput& input) {
        const QString path = context.files.save(FileWords::tr("Write correction card"), name, FileWords::tr("PDF (*.pdf)"));
        if (path.isEmpty())
            return;
        writeFile(context, input, writeCard, path, FileWords::tr("Card written: %1").arg(path),
            [&context, input] { noteIssued(context, input); });
    });
}

void previewCard(PageContext& context, SwingPage& page)
{
    withCard(context, page, {}, [&context](const CardInput& input) {
        const auto printed
            = context.dialogs.printPreview(&context.window, [&](QPrinter& printer, const Progress&) { return printCard(input, printer); });
        if (!printed)
            context.fail(messageOf(printed.error()));
        else if (*printed)
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
        writeFile(context, *input, writeJobCard, path, FileWords::tr("Job card written: %1").arg(path));
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
                writeFile(context, *sheet, write1613, path, FileWords::tr("Sheet written: %1").arg(path));
        });
}

} // namespace lubberline::ui
