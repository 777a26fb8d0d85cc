#include "ui/report/forms/FormGrid.h"

#include <QPainter>

#include <algorithm>

#include "ui/report/page/DocumentFont.h"
#include "ui/report/page/Ink.h"
#include "ui/report/page/TableBlocks.h"

namespace lubberline::ui {

namespace {

constexpr double kHead = mm(6), kInset = mm(1), kSize_pt = 7.5, kSmallest_pt = 4.5;

std::vector<double> widthsOf(const std::vector<FormColumn>& columns, double width)
{
    double all = 0;
    for (const auto& column : columns)
        all += column.width_mm;
    std::vector<double> widths;
    for (const auto& column : columns)
        widths.push_back(width * column.width_mm / all);
    return widths;
}

/// As high as asked for, or as its words need: what has to be done is never too small to read.
double heightFor(const QStringList& cells, const std::vector<double>& widths, const QString& family, double least)
{
    double height = least;
    for (std::size_t i = 0; i < widths.size(); ++i)
        height = std::max(height,
            wrappedHeight(documentFont(family, kSize_pt), widths[i] - 2 * kInset, cells.value(static_cast<qsizetype>(i))) + mm(1.4));
    return height;
}

Block rowBlock(const QStringList& cells, const std::vector<double>& widths, const QString& family, double size_pt, double height, bool head)
{
    return {height, [=](QPainter& painter, const QRectF& rect) {
                double left = rect.left();
                for (std::size_t i = 0; i < widths.size(); ++i) {
                    const QRectF cell(left, rect.top(), widths[i], height);
                    if (head)
                        painter.fillRect(cell, Ink::shaded());
                    painter.setBrush(Qt::NoBrush);
                    painter.setPen(QPen(Ink::strong(), mm(0.15)));
                    painter.drawRect(cell);
                    painter.setPen(Ink::text());
                    const QString text = cells.value(static_cast<qsizetype>(i));
                    const QRectF room = cell.adjusted(kInset, mm(0.4), -kInset, 0);
                    double size = size_pt;
                    while (size > kSmallest_pt && wrappedHeight(documentFont(family, size, head), room.width(), text) > room.height())
                        size -= 0.25;
                    paintWrapped(painter, documentFont(family, size, head), room, text);
                    left += widths[i];
                }
            }};
}

} // namespace

std::vector<Block> formGrid(const QString& title, const std::vector<FormColumn>& columns, const std::vector<QStringList>& rows,
    double width, const QString& family, double rowHeight)
{
    const std::vector<double> widths = widthsOf(columns, width);
    QStringList heads;
    for (const auto& column : columns)
        heads += column.head;
    auto head = std::make_shared<Block>(rowBlock(heads, widths, family, 7, kHead, true));
    Block titled = titleBlock(title, family);
    titled.keepWithNext = true;
    Block first = *head;
    first.keepWithNext = true;
    std::vector<Block> blocks{titled, first};
    for (const auto& row : rows) {
        Block block = rowBlock(row, widths, family, kSize_pt, heightFor(row, widths, family, rowHeight), false);
        block.repeatedHead = head;
        blocks.push_back(std::move(block));
    }
    return blocks;
}

} // namespace lubberline::ui
