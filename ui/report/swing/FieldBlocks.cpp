#include "ui/report/swing/FieldBlocks.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>

#include "ui/plots/map/MapPlotRendering.h"
#include "ui/report/page/DocumentFont.h"
#include "ui/report/page/Ink.h"
#include "ui/report/page/TableBlocks.h"
#include "ui/report/page/Words.h"

namespace lubberline::ui {

namespace {

constexpr double kSize_pt = 8;
constexpr double kLeastMap = mm(66), kMostMap = mm(100);

void appendFacts(std::vector<Block>& blocks, const QString& title, const std::vector<Fact>& facts, const QString& family, double width)
{
    if (facts.empty())
        return;
    blocks.push_back(titleBlock(title, family));
    append(blocks, factBlocks(facts, {family, kSize_pt, mm(28)}, width));
}

void appendList(std::vector<Block>& blocks, const QString& title, const QStringList& lines, const QString& family, double width)
{
    if (lines.isEmpty())
        return;
    blocks.push_back(titleBlock(title, family));
    append(blocks, listBlocks(lines, family, kSize_pt, width));
}

void appendTable(std::vector<Block>& blocks, const Table& table, const QString& family, double width)
{
    if (!table.rows.empty())
        append(blocks, tableBlocks(table, width, family));
}

Block mapBlock(const MapPicture& map, const QString& family, double height)
{
    const QFont font = documentFont(family, 8.5, true);
    return {height, [&map, font](QPainter& painter, const QRectF& rect) {
                painter.setPen(Ink::text());
                paintLine(painter, font, {rect.left(), rect.top() + mm(5)}, Qt::AlignLeft,
                    Words::tr("Deviation over heading and roll, modelled"));
                renderMap(painter, rect.adjusted(0, mm(6.4), 0, 0), map);
            }};
}

} // namespace

std::vector<Block> listBlocks(const QStringList& lines, const QString& family, double size_pt, double width)
{
    const QFont font = documentFont(family, size_pt);
    std::vector<Block> blocks;
    for (const QString& text : lines) {
        const QString line = QStringLiteral("• ") + text;
        blocks.push_back({wrappedHeight(font, width, line) + mm(0.5), [font, line](QPainter& painter, const QRectF& rect) {
                              painter.setPen(Ink::text());
                              paintWrapped(painter, font, rect, line);
                          }});
    }
    return blocks;
}

namespace {

std::vector<Block> earthBlocks(const FieldPage& page, const QString& family, double width)
{
    std::vector<Block> blocks{titleBlock(Words::tr("Earth's field and sensor model"), family)};
    append(blocks, factBlocks(page.field, {family, kSize_pt, mm(28)}, width));
    appendTable(blocks, page.combinations, family, width);
    appendList(blocks, Words::tr("What it cannot tell"), page.unknown, family, width);
    return blocks;
}

std::vector<Block> sensorBlocks(const FieldPage& page, const QString& family, double width)
{
    std::vector<Block> blocks;
    appendFacts(blocks, Words::tr("Sensor model of the compass"), page.sensor, family, width);
    appendTable(blocks, page.parameters, family, width);
    appendTable(blocks, page.smith, family, width);
    return blocks;
}

} // namespace

std::vector<Block> fieldBlocks(const FieldPage& page, const QString& family, QSizeF body)
{
    std::vector<Block> blocks = earthBlocks(page, family, body.width());
    std::vector<Block> sensor = sensorBlocks(page, family, body.width());
    blocks.front().newPage = true;
    const double earth = heightOf(blocks), words = heightOf(sensor);
    const bool together = earth + words + (page.map ? kLeastMap : 0) < body.height();
    if (!sensor.empty() && !together)
        sensor.front().newPage = true; // the model and its map stay on one page
    append(blocks, std::move(sensor));
    if (page.map)
        blocks.push_back(
            mapBlock(*page.map, family, std::clamp(body.height() - (together ? earth : 0) - words - mm(0.2), kLeastMap, kMostMap)));
    return blocks;
}

} // namespace lubberline::ui
