#include "ui/report/page/PdfFile.h"

#include <QBuffer>
#include <QPageSize>
#include <QPdfWriter>

#include "core/base/Contract.h"

namespace lubberline::ui {

namespace {

constexpr int kDotsPerInch = 300; ///< of the coordinates: everything is drawn as vectors

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

} // namespace lubberline::ui
