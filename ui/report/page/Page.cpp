#include "ui/report/page/Page.h"

#include <QFontMetricsF>
#include <QPageLayout>
#include <QPagedPaintDevice>
#include <QPainter>
#include <QTextLayout>
#include <QTextOption>

#include "ui/report/page/DocumentFont.h"
#include "ui/report/page/Words.h"
#include "ui/text/AngleWords.h"

#include <iterator>
#include <numeric>

namespace lubberline::ui {

namespace {

/// From the origin of the device, which is inside its margins unless it was set to the full page, to the sheet's corner.
void enterSheet(QPainter& painter, const QPagedPaintDevice& device)
{
    const QPageLayout layout = device.pageLayout();
    painter.resetTransform();
    painter.scale(painter.device()->logicalDpiX() / mm(25.4), painter.device()->logicalDpiY() / mm(25.4));
    if (layout.mode() == QPageLayout::StandardMode) {
        const QMarginsF margins = layout.margins(QPageLayout::Millimeter);
        painter.translate(-mm(margins.left()), -mm(margins.top()));
    }
}

/// The height of a block and of all that it must stay together with.
double heightOfGroup(const std::vector<Block>& blocks, std::size_t first)
{
    double height = blocks[first].height;
    for (std::size_t i = first; blocks[i].keepWithNext && i + 1 < blocks.size(); ++i)
        height += blocks[i + 1].height;
    return height;
}

} // namespace

QSizeF sheetSize(const QPagedPaintDevice& device)
{
    const QSizeF size = device.pageLayout().fullRect(QPageLayout::Millimeter).size();
    return {mm(size.width()), mm(size.height())};
}

Result<void> paintSheets(
    QPagedPaintDevice& device, int pages, const std::function<void(QPainter&, int)>& paintPage, const Progress& progress)
{
    QPainter painter;
    if (!painter.begin(&device))
        return Error{ErrorCode::Io, said(Words::tr("the printer takes no pages; expected one that is switched on and connected"))};
    for (int page = 0; page < pages; ++page) {
        if (progress && !progress(static_cast<double>(page) / pages))
            return Error{ErrorCode::Cancelled, {}};
        if (page > 0 && !device.newPage())
            return Error{ErrorCode::Io, said(Words::tr("the printer stopped before page %1 of %2").arg(page + 1).arg(pages))};
        painter.save();
        painter.setRenderHint(QPainter::Antialiasing); // on screen (print preview); paper has no pixels
        enterSheet(painter, device);
        paintPage(painter, page);
        painter.restore();
    }
    return {};
}

void paintLine(QPainter& painter, const QFont& font, QPointF at, Qt::Alignment alignment, const QString& text)
{
    const QString shown = inAngleStyle(text);
    if (alignment & (Qt::AlignRight | Qt::AlignHCenter)) { // to measure is half the work
        const double width = QFontMetricsF(font).horizontalAdvance(shown);
        at.rx() -= alignment & Qt::AlignRight ? width : width / 2;
    }
    painter.setFont(font);
    painter.drawText(at, shown);
}

QStringList wrappedLines(const QFont& font, double width, const QString& given)
{
    const QString text = inAngleStyle(given); // before it is measured
    if (text.isEmpty())
        return QStringList(QString());
    QTextLayout layout(text, font);
    QTextOption option;
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout.setTextOption(option);
    QStringList lines;
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
        line.setLineWidth(width);
        lines += text.mid(line.textStart(), line.textLength()).trimmed();
    }
    layout.endLayout();
    return lines;
}

double wrappedHeight(const QFont& font, double width, const QString& text)
{
    return QFontMetricsF(font).lineSpacing() * static_cast<double>(wrappedLines(font, width, text).size());
}

void paintWrapped(QPainter& painter, const QFont& font, const QRectF& rect, const QString& text)
{
    const QFontMetricsF metrics(font);
    double baseline = rect.top() + metrics.ascent();
    for (const QString& line : wrappedLines(font, rect.width(), text)) {
        paintLine(painter, font, {rect.left(), baseline}, Qt::AlignLeft, line);
        baseline += metrics.lineSpacing();
    }
}

QFont fitted(const QString& family, double size_pt, bool bold, double width, const QString& text)
{
    const QFont font = documentFont(family, size_pt, bold);
    const double needed = QFontMetricsF(font).horizontalAdvance(inAngleStyle(text));
    return needed <= width ? font : documentFont(family, size_pt * width / needed, bold);
}

std::vector<std::vector<PlacedBlock>> paginate(const std::vector<Block>& blocks, double bodyHeight)
{
    std::vector<std::vector<PlacedBlock>> pages(1);
    double top = 0;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const Block& block = blocks[i];
        const bool tied = i > 0 && blocks[i - 1].keepWithNext; // its group was already found to fit, or has a page of its own
        const bool full = tied ? top + block.height > bodyHeight : top + heightOfGroup(blocks, i) > bodyHeight;
        if (!pages.back().empty() && (block.newPage || full)) {
            pages.emplace_back();
            top = 0;
            if (block.repeatedHead) {
                pages.back().push_back({block.repeatedHead.get(), 0});
                top = block.repeatedHead->height;
            }
        }
        pages.back().push_back({&block, top});
        top += block.height;
    }
    return pages;
}

void paintBlocks(QPainter& painter, const std::vector<PlacedBlock>& blocks, const QRectF& body)
{
    for (const PlacedBlock& placed : blocks) {
        painter.save();
        placed.block->paint(painter, QRectF(body.left(), body.top() + placed.top, body.width(), placed.block->height));
        painter.restore();
    }
}

double heightOf(const std::vector<Block>& blocks)
{
    return std::accumulate(blocks.begin(), blocks.end(), 0.0, [](double sum, const Block& block) { return sum + block.height; });
}

void append(std::vector<Block>& blocks, std::vector<Block> more) { std::move(more.begin(), more.end(), std::back_inserter(blocks)); }

} // namespace lubberline::ui
