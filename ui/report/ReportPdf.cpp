#include "ui/report/ReportPdf.h"

#include <QBuffer>
#include <QPageSize>
#include <QPdfWriter>

#include "core/base/Contract.h"
#include "core/format/Exchange.h"
#include "ui/report/DocumentFont.h"
#include "ui/report/ReportPages.h"
#include "ui/report/Words.h"

namespace lubberline::ui {

namespace {

constexpr int kDotsPerInch = 300; ///< of the coordinates: everything is drawn as vectors

QSizeF a4()
{
    const QSizeF size_mm = QPageSize(QPageSize::A4).size(QPageSize::Millimeter);
    return {mm(size_mm.width()), mm(size_mm.height())};
}

} // namespace

Result<QByteArray> makePdf(const PdfKind& kind, const std::function<Result<void>(QPagedPaintDevice&)>& paint)
{
    LUBBERLINE_EXPECT(!kind.archive || kind.attachment.isEmpty(), "PDF/A-1b carries no attachment");
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setPdfVersion(kind.archive ? QPagedPaintDevice::PdfVersion_A1b : QPagedPaintDevice::PdfVersion_1_6);
    writer.setResolution(kDotsPerInch);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF());
    writer.setTitle(kind.title);
    writer.setCreator(QStringLiteral("Lubberline"));
    if (!kind.attachment.isEmpty())
        writer.addFileAttachment(QString::fromLatin1(kAttachmentName), kind.attachment, QStringLiteral("application/json"));
    if (const auto painted = paint(writer); !painted)
        return painted.error();
    buffer.close();
    return buffer.data();
}

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
