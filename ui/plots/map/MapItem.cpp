#include "ui/plots/map/MapItem.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

#include <qwt_scale_map.h>

#include "ui/plots/base/Chart.h"
#include "ui/plots/map/DivergingMap.h"
#include "ui/plots/map/MapMarks.h"
#include "ui/plots/map/MapText.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

constexpr int kWantedLevels = 20;
constexpr double kHatchSpacing = 8;
constexpr double kCoarseImage = 0.5; ///< pixels of the image by those of the screen while a slider moves
constexpr double kSharpestImage = 2; ///< on paper, by units of 1/96 inch
constexpr double kTextScale = 0.9;   ///< of the labels on the map, by the axes' text

/// Cells in a row of which a corner is undefined, and as many rows as have the same; nodes.
struct Hole {
    int x, y, toX, toY;
    [[nodiscard]] int size() const { return (toX - x) * (toY - y); }
};

void addHole(std::vector<Hole>& holes, const Hole& run)
{
    const auto above = std::find_if(
        holes.begin(), holes.end(), [&run](const Hole& hole) { return hole.x == run.x && hole.toX == run.toX && hole.toY == run.y; });
    if (above != holes.end())
        above->toY = run.toY;
    else
        holes.push_back(run);
}

std::vector<Hole> holesOf(const MapCells& cells)
{
    std::vector<Hole> holes;
    for (int y = 0; y + 1 < cells.rows(); ++y) {
        for (int x = 0; x + 1 < cells.columns(); ++x) {
            const int from = x;
            while (x + 1 < cells.columns() && cells.kind(x, y) == MapCells::Kind::Undefined)
                ++x;
            if (x > from)
                addHole(holes, {from, y, x, y + 1});
        }
    }
    return holes;
}

} // namespace

struct MapItem::Maps {
    const QwtScaleMap &x, &y;
    QRectF canvas;
    [[nodiscard]] QPointF point(double x_deg, double y_deg) const { return {x.transform(x_deg), y.transform(y_deg)}; }
    [[nodiscard]] QRectF rect(const QRectF& deg) const
    {
        return QRectF(point(deg.left(), deg.top()), point(deg.right(), deg.bottom())).normalized();
    }
};

MapItem::MapItem() : QwtPlotItem(QStringLiteral("map"))
{
    setZ(10); // above the grid
    setRenderHint(RenderAntialiased);
}

void MapItem::setMap(const MapPicture& picture, std::shared_ptr<const MapCells> cells, const NiceScale& scale)
{
    m_picture = picture;
    m_cells = std::move(cells);
    m_scale = scale;
    m_levels_deg.clear();
    m_contours.clear();
    m_limitLines.clear();
    if (!m_cells || m_cells->flat())
        return;
    const int stride = picture.coarse && m_cells->columns() > 200 ? 2 : 1;
    m_levels_deg = niceLevels(scale.end, kWantedLevels);
    m_contours = m_cells->contours(m_levels_deg, stride);
    if (picture.limit_deg)
        m_limitLines = m_cells->contours(std::array{-*picture.limit_deg, *picture.limit_deg}, stride);
}

void MapItem::setLook(const QColor& ground, const QFont& font)
{
    m_ground = ground;
    m_font = pixelFont(font);
    m_font.setPixelSize(std::max(8, qRound(kTextScale * m_font.pixelSize())));
}

void MapItem::draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap, const QRectF& canvasRect) const
{
    m_labels.clear();
    if (!m_cells)
        return;
    const Maps maps{xMap, yMap, canvasRect};
    std::vector<QRectF> taken;
    painter->save();
    drawColours(*painter, maps);
    painter->setRenderHint(QPainter::Antialiasing);
    drawHatch(*painter, maps, taken);
    // Contours keep clear of the marks, which lie above them.
    std::vector<QRectF> marks;
    for (const MapExtreme& extreme : m_picture.extremes)
        marks.push_back(QRectF(maps.point(extreme.x_deg, extreme.y_deg) - QPointF(24, 24), QSizeF(48, 48)));
    drawContours(*painter, maps, marks);
    drawVanishing(*painter, maps, taken);
    drawExtremes(*painter, maps, taken);
    painter->restore();
}

void MapItem::drawColours(QPainter& painter, const Maps& maps) const
{
    const bool onScreen = painter.combinedTransform().type() <= QTransform::TxTranslate;
    QRectF area = maps.rect(m_cells->range_deg()).intersected(maps.canvas);
    if (onScreen)
        area = area.toAlignedRect();
    if (area.width() < 1 || area.height() < 1)
        return;
    const double units = std::abs(painter.combinedTransform().m11()) * (onScreen ? painter.device()->devicePixelRatioF() : 1);
    const double sharpness = m_picture.coarse ? kCoarseImage : std::clamp(units, 1.0, kSharpestImage);
    const QSize size = (area.size() * sharpness).toSize().expandedTo({2, 2});
    const QRectF view_deg = QRectF(QPointF(maps.x.invTransform(area.left()), maps.y.invTransform(area.bottom())),
        QPointF(maps.x.invTransform(area.right()), maps.y.invTransform(area.top())));
    painter.setRenderHint(QPainter::LosslessImageRendering); // PDF would take JPEG
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(area, m_cells->image(view_deg, size, m_scale.end, m_ground.rgb()));
}

/// By lines of our own: a brush pattern would be a raster image on paper.
void MapItem::drawHatch(QPainter& painter, const Maps& maps, std::vector<QRectF>& taken) const
{
    const std::vector<Hole> holes = holesOf(*m_cells);
    const MapAxis &xAxis = m_cells->request().x, &yAxis = m_cells->request().y;
    const auto areaOf = [&](const Hole& hole) {
        return maps
            .rect(QRectF(QPointF(xAxis.at_deg(hole.x), yAxis.at_deg(hole.y)), QPointF(xAxis.at_deg(hole.toX), yAxis.at_deg(hole.toY))))
            .intersected(maps.canvas);
    };
    painter.setPen(QPen(QColor(0x80, 0x80, 0x80), 1));
    for (const Hole& hole : holes) {
        const QRectF area = areaOf(hole);
        const double first = std::floor((area.left() + area.top()) / kHatchSpacing) * kHatchSpacing;
        for (double sum = first; sum <= area.right() + area.bottom(); sum += kHatchSpacing) {
            const QPolygonF line({QPointF(sum - area.top(), area.top()), QPointF(sum - area.bottom(), area.bottom())});
            for (const QPolygonF& piece : clippedLine(line, area))
                painter.drawPolyline(piece);
        }
    }
    const auto largest = std::max_element(holes.begin(), holes.end(), [](const Hole& a, const Hole& b) { return a.size() < b.size(); });
    if (largest != holes.end() && m_picture.vanishing.empty())
        paintTag(painter, areaOf(*largest).center(), vanishingText(), {maps.canvas, taken}, m_font);
}

void MapItem::addStrokes(std::vector<ContourStroke>& strokes, const std::vector<ContourLine>& lines, const Maps& maps) const
{
    const bool limit = &lines == &m_limitLines;
    const double step = m_levels_deg.size() > 1 ? m_levels_deg[1] - m_levels_deg[0] : 1;
    for (const ContourLine& line : lines) {
        if (!limit && limitShown && m_picture.limit_deg && std::abs(std::abs(line.level) - *m_picture.limit_deg) < step / 1000)
            continue; // the heavy line lies there, with its own label
        ContourStroke stroke;
        stroke.line.reserve(static_cast<qsizetype>(line.points.size()));
        for (const ContourPoint& point : line.points)
            stroke.line.append(maps.point(point.x, point.y));
        const bool zero = std::abs(line.level) < step / 1000;
        stroke.pen = QPen(inkOnMap(), limit ? 2.8 : zero ? 1.7 : 0.9);
        stroke.pen.setJoinStyle(Qt::RoundJoin);
        stroke.label = degreeTick(line.level, !limit ? step : line.level == std::round(line.level) ? 1 : 0.1);
        strokes.push_back(std::move(stroke));
    }
}

void MapItem::drawContours(QPainter& painter, const Maps& maps, std::vector<QRectF>& taken) const
{
    std::vector<ContourStroke> strokes;
    if (limitShown)
        addStrokes(strokes, m_limitLines, maps);
    if (contoursShown)
        addStrokes(strokes, m_contours, maps);
    m_labels = paintContours(painter, strokes, maps.canvas, m_font, taken);
}

void MapItem::drawExtremes(QPainter& painter, const Maps& maps, std::vector<QRectF>& taken) const
{
    if (!extremesShown)
        return;
    for (const MapExtreme& extreme : m_picture.extremes) {
        const QPointF at = maps.point(extreme.x_deg, extreme.y_deg);
        if (maps.canvas.adjusted(-1, -1, 1, 1).contains(at))
            paintExtreme(painter, at, extreme.maximum, mapValueText(toDegrees(extreme.deviation_rad)), {maps.canvas, taken}, m_font);
    }
}

void MapItem::drawVanishing(QPainter& painter, const Maps& maps, std::vector<QRectF>& taken) const
{
    for (const VanishingPlace& place : m_picture.vanishing) {
        const QPointF at = maps.point(place.x_deg, place.y_deg);
        if (maps.canvas.contains(at))
            paintCross(painter, at, vanishingText(), {maps.canvas, taken}, m_font);
    }
}

} // namespace lubberline::ui
