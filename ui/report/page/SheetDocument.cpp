#include "ui/report/page/SheetDocument.h"

#include <QFileInfo>
#include <QPagedPaintDevice>

#include "core/base/OutputFile.h"
#include "core/base/WholeFile.h"
#include "ui/report/page/DocumentFont.h"
#include "ui/report/page/PdfFile.h"
#include "ui/report/page/Words.h"

namespace lubberline::ui {

Result<void> printSheet(const PageFrame& frame, const SheetBlocks& make, QPagedPaintDevice& device, const Progress& progress)
{
    const auto family = documentFamily();
    if (!family)
        return family.error();
    const QSizeF sheet = sheetSize(device);
    const QRectF room = bodyOf(frame, sheet);
    const std::vector<Block> blocks = make(*family, room.size());
    const auto pages = paginate(blocks, room.height());
    const int count = static_cast<int>(pages.size());
    const auto paint = [&](QPainter& painter, int page) {
        paintFrame(painter, frame, *family, sheet, page, count);
        paintBlocks(painter, pages[static_cast<std::size_t>(page)], room);
    };
    return paintSheets(device, count, paint, progress);
}

Result<void> writeSheet(const PageFrame& frame, const SheetBlocks& blocks, const QString& path, const Progress& progress)
{
    if (!isStandardStream(path.toStdString()) && QFileInfo(path).suffix().toLower() != "pdf")
        return Error{ErrorCode::InvalidInput,
            said(Words::tr("this document cannot be written under this name; expected one that ends in .pdf")), path.toStdString()};
    PdfKind kind;
    kind.title = joined({frame.title, frame.subject});
    kind.archive = true; // nothing is attached, and cards are kept for as long as the aircraft
    const auto bytes = makePdf(kind, [&](QPagedPaintDevice& device) { return printSheet(frame, blocks, device, progress); });
    if (!bytes) {
        Error error = bytes.error();
        error.file = path.toStdString();
        return error;
    }
    return writeWholeFile(path.toStdString(), bytes->toStdString());
}

} // namespace lubberline::ui
