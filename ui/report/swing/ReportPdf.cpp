#include "ui/report/swing/ReportPdf.h"

#include <QPageSize>

#include "core/format/exchange/Exchange.h"
#include "ui/report/page/DocumentFont.h"
#include "ui/report/page/PdfFile.h"
#include "ui/report/page/Words.h"
#include "ui/report/swing/ReportPages.h"

namespace lubberline::ui {

namespace {

QSizeF a4()
{
    const QSizeF size_mm = QPageSize(QPageSize::A4).size(QPageSize::Millimeter);
    return {mm(size_mm.width()), mm(size_mm.height())};
}

} // namespace

Result<QByteArray> reportPdf(const ReportInput& input)
{
    PdfKind kind;
    kind.title = frameFor(input.record, Words::tr("Compass swing report"), {}).subject;
    kind.archive = input.archive;
    if (!input.archive)
        kind.attachment = QByteArray::fromStdString(writeExchange(toFleet(input.record)));
    return makePdf(kind, [&input](QPagedPaintDevice& device) { return printReport(input, device); });
}

Result<void> printReport(const ReportInput& input, QPagedPaintDevice& device)
{
    const auto family = documentFamily();
    if (!family)
        return family.error();
    const ReportPages pages(contentOf(input), *family, sheetSize(device));
    return paintSheets(device, pages.count(), [&pages](QPainter& painter, int page) { pages.paint(painter, page); });
}

Result<int> reportPageCount(const ReportInput& input)
{
    const auto family = documentFamily();
    if (!family)
        return family.error();
    return ReportPages(contentOf(input), *family, a4()).count();
}

} // namespace lubberline::ui
