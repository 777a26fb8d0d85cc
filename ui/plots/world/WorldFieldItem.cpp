#include "ui/plots/world/WorldFieldItem.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

#include <qwt_scale_map.h>

#include "core/earth/Coastlines.h"
#include "ui/plots/base/Chart.h"
#include "ui/plots/map/MapMarks.h"
#include "ui/plots/world/WorldFieldText.h"

namespace lubberline::ui {

namespace {

constexpr double kAngleStep_deg = 10;
constexpr int kWantedLevels = 25; ///< over both signs: a field's size takes half of them

std::vector<double> levelsOf(const FieldGrid& grid)
{
    double largest = 0;
    for (const double value : grid.values)
        largest = std::max(largest, std::abs(value));
    if (largest == 0)
        return {};
    if (!isAngle(grid.element))
        return niceLevels(largest, kWantedLevels);
    std::vector<double> levels;
    for (double level = -180; level <= 180; level += kAngleStep_deg) {
        if (std::abs(level) <= largest)
            levels.push_back(level);
    }
    return levels;
}

QPolygonF polygonOf(const ContourLine& line, const QwtScaleMap& xMap, const QwtScaleMap& yMap)
{
    QPolygonF polygon;
    polygon.reserve(static_cast<qsizetype>(line.points.size()));
    for (const ContourPoint& point : line.points)
        polygon.append({xMap.transform(point.x), yMap.transform(point.y)});
    return polygon;
}

void drawCoasts(QPainter& painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap, const QRectF& canvas)
{
    for (const Coastline& coast : coastlines()) {
        QPolygonF line;
        line.reserve(static_cast<qsizetype>(coast.size()));
        for (const CoastPoint& point : coast)
            line.append({xMap.transform(point.longitude_deg), yMap.transform(point.latitude_deg)});
        for (const QPolygonF& piece : clippedLine(line, canvas))
            painter.drawPolyline(piece);
    }
}

} // namespace

double jumpOf(FieldElement element) { return element == FieldElement::Declination ? 180 : 0; }

WorldFieldItem::WorldFieldItem() : QwtPlotItem(QStringLiteral("field"))
{
    setZ(10);
    setRenderHint(RenderAntialiased);
}

void WorldFieldItem::setGrid(std::shared_ptr<const FieldGrid> grid)
{
    m_grid = std::move(grid);
    m_isolines.clear();
    if (!m_grid)
        return;
    m_isolines = contoursOf({m_grid->values, {}, m_grid->columns, m_grid->rows, jumpOf(m_grid->element)}, levelsOf(*m_grid));
    for (ContourLine& line : m_isolines) {
        for (ContourPoint& point : line.points)
            point = {-180 + 360 * point.x / (m_grid->columns - 1), -90 + 180 * point.y / (m_grid->rows - 1)};
    }
}

void WorldFieldItem::setPlace(const std::optional<Place>& place, const QString& label)
{
    m_place = place;
    m_label = label;
}

void WorldFieldItem::setLook(const PlotColours& colours, const QFont& font)
{
    m_colours = colours;
    m_font = pixelFont(font);
    m_font.setPixelSize(std::max(8, m_font.pixelSize() - 1));
}

/// As on charts: east (or down) in the warm colour, west (or up) in the cold one, heavy where it is zero.
QPen WorldFieldItem::penOf(double level) const
{
    const bool isSigned = m_grid->element != FieldElement::Horizontal && m_grid->element != FieldElement::Total;
    if (std::abs(level) < 1e-6)
        return QPen(m_colours.text, 2);
    return QPen(!isSigned ? m_colours.text : level > 0 ? m_colours.exact : m_colours.approximate, 1.1);
}

void WorldFieldItem::draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap, const QRectF& canvasRect) const
{
    m_labels.clear();
    std::vector<QRectF> taken;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const auto pixelOf
        = [&](const Place& place) { return QPointF(xMap.transform(place.longitude_deg), yMap.transform(place.latitude_deg)); };
    if (m_place)
        taken.push_back(QRectF(pixelOf(*m_place) - QPointF(8, 8), QSizeF(16, 16)));
    painter->setPen(QPen(m_colours.faint, 0.8));
    drawCoasts(*painter, xMap, yMap, canvasRect);
    std::vector<ContourStroke> strokes;
    for (const ContourLine& line : m_isolines)
        strokes.push_back({polygonOf(line, xMap, yMap), penOf(line.level), isolineText(m_grid->element, line.level)});
    m_labels = paintContours(*painter, strokes, canvasRect, m_font, taken);
    if (m_place && canvasRect.contains(pixelOf(*m_place))) {
        const QPointF at = pixelOf(*m_place);
        painter->setPen(QPen(m_colours.text, 1.5));
        painter->setBrush(m_colours.selected);
        painter->drawEllipse(at, 5, 5);
        std::vector<QRectF> alone;
        if (!m_label.isEmpty())
            paintTag(*painter, at + QPointF(0, -16), m_label, {canvasRect, alone}, m_font);
    }
    painter->restore();
}

} // namespace lubberline::ui
