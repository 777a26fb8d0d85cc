#include "ui/report/swing/ReportPdf.h"

#include <QPageSize>

#include "core/format/exchange/Exchange.h"
#include "ui/report/page/DocumentFont.h"
#include "ui/report/page/PdfFile.h"
#include "ui/report/page/Words.h"
#include "ui/report/swing/ReportPages.h"

namespace lubberline::ui {

QSizeF a4Sheet()
{
    const QSizeF size_mm = QPageSize(QPageSize::A4).size(QPageSize::Millimeter);
    return {mm(size_mm.width()), mm(size_mm.height())};
}

Result<QByteArray> reportPdf(const ReportInput& input, const Progress& progress)
{
    PdfKind kind;
    kind.title = frameFor(input.record, Words::tr("Compass swing report"), {}).subject;
    kind.archive = input.archive;
    if (!input.archive)
        kind.attachment = QByteArray::fromStdString(writeExchange(toFleet(input.record)));
    return makePdf(kind, [&](QPagedPaintDevice& device) { return printReport(input, device, progress); });
}

Result<void> printReport(const ReportInput& input, QPagedPaintDevice& device, const Progress& progress)
{
    const auto pages = layOutReport(input, sheetSize(device));
    return pages ? printReport(**pages, device, progress) : pages.error();
}

Result<std::shared_ptr<const ReportPages>> layOutReport(const ReportInput& input, QSizeF sheet)
{
    const auto family = documentFamily();
    if (!family)
        return family.error();
    return std::shared_ptr<const ReportPages>(std::make_shared<ReportPages>(contentOf(input), *family, sheet));
}

Result<void> printReport(const ReportPages& pages, QPagedPaintDevice& device, const Progress& progress)
{
    return paintSheets(
        device, pages.count(), [&pages](QPainter& painter, int page) { pages.paint(painter, page); }, progress);
}

Result<int> reportPageCount(const ReportInput& input)
{
    const auto pages = layOutReport(input, a4Sheet());
    return pages ? Result<int>((*pages)->count()) : pages.error();
}

} // namespace lubberline::ui
