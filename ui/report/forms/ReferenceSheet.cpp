#include "ui/report/forms/ReferenceSheet.h"

#include "ui/report/forms/FormGrid.h"
#include "ui/report/page/DataHash.h"
#include "ui/report/page/DocumentFont.h"
#include "ui/report/page/SheetDocument.h"
#include "ui/report/page/TableBlocks.h"
#include "ui/report/page/Words.h"

namespace lubberline::ui {

namespace {

constexpr double kUnitsAPixel = mm(25.4) / 96; ///< of the screen that pictures are drawn for

Block paragraph(const QString& text, const QString& family, double width)
{
    const QFont font = documentFont(family, 9);
    return {wrappedHeight(font, width, text) + mm(1.5),
        [font, text](QPainter& painter, const QRectF& rect) { paintWrapped(painter, font, rect, text); }};
}

Block pictureBlock(const ReferenceSheet::Picture& picture, const QString& family)
{
    return {mm(picture.height_mm), [paint = picture.paint, family](QPainter& painter, const QRectF& rect) {
                painter.save();
                painter.translate(rect.topLeft());
                painter.scale(kUnitsAPixel, kUnitsAPixel);
                QFont font(family);
                font.setPixelSize(11);
                painter.setFont(font);
                paint(painter, QRectF(0, 0, rect.width() / kUnitsAPixel, rect.height() / kUnitsAPixel - 6));
                painter.restore();
            }};
}

std::vector<Block> referenceBlocks(const ReferenceSheet& sheet, const QString& family, double width)
{
    std::vector<Block> blocks;
    for (const QString& text : sheet.text)
        if (!text.isEmpty())
            blocks.push_back(paragraph(text, family, width));
    for (const auto& picture : sheet.pictures)
        blocks.push_back(pictureBlock(picture, family));
    if (!sheet.table.rows.empty())
        append(blocks, tableBlocks(sheet.table, width, family));
    if (sheet.signatures && !sheet.table.rows.empty())
        blocks.push_back({mm(4), [](QPainter&, const QRectF&) {}});
    if (sheet.signatures)
        append(blocks,
            formGrid(Words::tr("Signed by hand; performer and inspector are two people"),
                {{Words::tr("role"), 30}, {Words::tr("name, licence"), 60}, {Words::tr("signature"), 50}, {Words::tr("date (UTC)"), 30}},
                {{Words::tr("Performer"), {}, {}, {}}, {Words::tr("Inspector"), {}, {}, {}}}, width, family, mm(9)));
    return blocks;
}

} // namespace

Result<void> writeReferenceSheet(const ReferenceSheet& sheet, const QString& path, const Progress& progress)
{
    PageFrame frame;
    frame.title = sheet.title;
    frame.subject = sheet.subject;
    frame.convention = Words::tr("Deviation = magnetic − compass, easterly positive; indication error = read − magnetic is its negative.");
    QStringList data = sheet.text; // what was read is data, too
    for (const TableRow& row : sheet.table.rows)
        data += row.cells.join(u'\t');
    frame.hash = hashOfText(data.join(u'\n').toStdString());
    frame.made = madeWords(sheet.madeAtUtc);
    return writeSheet(
        frame, [&sheet](const QString& family, QSizeF room) { return referenceBlocks(sheet, family, room.width()); }, path, progress);
}

} // namespace lubberline::ui
