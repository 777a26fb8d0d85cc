#include "ui/plots/map/MapCells.h"

#include <algorithm>
#include <cmath>

#include "core/angle/Heading.h"
#include "core/base/Contract.h"
#include "ui/plots/map/DivergingMap.h"

namespace lubberline::ui {

namespace {

double nodesPerDegree(const MapAxis& axis) { return (axis.nodes - 1) / (axis.range.to_deg - axis.range.from_deg); }

/// Of each pixel along an axis: the cell that it is in, and the part of the cell before it.
struct Step {
    int cell;
    float part;
};

std::vector<Step> stepsAlong(const MapAxis& axis, double from_deg, double to_deg, int pixels)
{
    std::vector<Step> steps(static_cast<std::size_t>(pixels));
    const double perPixel_deg = (to_deg - from_deg) / pixels;
    for (int i = 0; i < pixels; ++i) {
        const double node = (from_deg + (i + 0.5) * perPixel_deg - axis.range.from_deg) * nodesPerDegree(axis);
        const int cell = std::clamp(static_cast<int>(std::floor(node)), 0, axis.nodes - 2);
        steps[static_cast<std::size_t>(i)] = {cell, static_cast<float>(std::clamp(node - cell, 0.0, 1.0))};
    }
    return steps;
}

} // namespace

/// A cell and the part of it to the left of, and below, a point.
struct MapCells::Place {
    int x, y;
    double partX, partY;
};

MapCells::MapCells(std::shared_ptr<const DeviationMap> map) : m_map(std::move(map))
{
    LUBBERLINE_EXPECT(m_map && columns() >= 2 && rows() >= 2, "a map has at least two nodes each way");
    m_values_deg.resize(m_map->deviation_rad.size());
    for (std::size_t i = 0; i < m_values_deg.size(); ++i) {
        m_values_deg[i] = toDegrees(m_map->deviation_rad[i]);
        LUBBERLINE_EXPECT(std::isfinite(m_values_deg[i]), "a map holds finite deviations");
        if (!m_map->defined[i])
            continue;
        m_least_deg = std::min(m_least_deg, m_values_deg[i]);
        m_most_deg = std::max(m_most_deg, m_values_deg[i]);
        m_largest_deg = std::max(m_largest_deg, std::abs(m_values_deg[i]));
    }
    sortCells();
}

void MapCells::sortCells()
{
    m_kinds.resize(static_cast<std::size_t>(columns() - 1) * (rows() - 1));
    m_plainRows.assign(static_cast<std::size_t>(rows() - 1), true);
    std::size_t cell = 0;
    for (int y = 0; y + 1 < rows(); ++y) {
        const double* low = &m_values_deg[m_map->index(0, y)];
        const double* high = &m_values_deg[m_map->index(0, y + 1)];
        const std::uint8_t* lowDefined = &m_map->defined[m_map->index(0, y)];
        const std::uint8_t* highDefined = &m_map->defined[m_map->index(0, y + 1)];
        for (int x = 0; x + 1 < columns(); ++x) {
            const double least = std::min(std::min(low[x], low[x + 1]), std::min(high[x], high[x + 1]));
            const double most = std::max(std::max(low[x], low[x + 1]), std::max(high[x], high[x + 1]));
            const bool whole = lowDefined[x] && lowDefined[x + 1] && highDefined[x] && highDefined[x + 1];
            const Kind kind = !whole ? Kind::Undefined : most - least > kJump_deg ? Kind::Jump : Kind::Plain;
            m_kinds[cell++] = kind;
            if (kind != Kind::Plain)
                m_plainRows[static_cast<std::size_t>(y)] = false;
        }
    }
}

QRectF MapCells::range_deg() const
{
    const AxisRange x = request().x.range, y = request().y.range;
    return QRectF(QPointF(x.from_deg, y.from_deg), QPointF(x.to_deg, y.to_deg)).normalized();
}

std::optional<MapCells::Place> MapCells::placeOf(double x_deg, double y_deg) const
{
    const MapAxis &xAxis = request().x, &yAxis = request().y;
    const double x = (x_deg - xAxis.range.from_deg) * nodesPerDegree(xAxis);
    const double y = (y_deg - yAxis.range.from_deg) * nodesPerDegree(yAxis);
    if (!(x >= 0 && x <= columns() - 1 && y >= 0 && y <= rows() - 1))
        return std::nullopt;
    const int column = std::min(static_cast<int>(x), columns() - 2), row = std::min(static_cast<int>(y), rows() - 2);
    return Place{column, row, x - column, y - row};
}

std::optional<double> MapCells::valueAt_deg(double x_deg, double y_deg) const
{
    const auto at = placeOf(x_deg, y_deg);
    if (!at || kind(at->x, at->y) == Kind::Undefined)
        return std::nullopt;
    if (kind(at->x, at->y) == Kind::Jump)
        return node_deg(at->x + (at->partX >= 0.5), at->y + (at->partY >= 0.5));
    const double low = std::lerp(node_deg(at->x, at->y), node_deg(at->x + 1, at->y), at->partX);
    const double high = std::lerp(node_deg(at->x, at->y + 1), node_deg(at->x + 1, at->y + 1), at->partX);
    return std::lerp(low, high, at->partY);
}

std::vector<ContourLine> MapCells::contours(std::span<const double> levels_deg, int stride) const
{
    const int strideX = (columns() - 1) % stride == 0 && columns() > stride ? stride : 1;
    const int strideY = (rows() - 1) % stride == 0 && rows() > stride ? stride : 1;
    std::vector<double> values;
    std::vector<std::uint8_t> defined;
    ContourGrid grid{m_values_deg, m_map->defined, columns(), rows(), kJump_deg};
    if (strideX > 1 || strideY > 1) {
        grid.columns = (columns() - 1) / strideX + 1;
        grid.rows = (rows() - 1) / strideY + 1;
        values.reserve(static_cast<std::size_t>(grid.columns) * grid.rows);
        for (int y = 0; y < rows(); y += strideY) {
            for (int x = 0; x < columns(); x += strideX) {
                values.push_back(node_deg(x, y));
                defined.push_back(this->defined(x, y));
            }
        }
        grid.values = values;
        grid.defined = defined;
    }
    std::vector<ContourLine> lines = contoursOf(grid, levels_deg);
    const double perX = strideX / nodesPerDegree(request().x), perY = strideY / nodesPerDegree(request().y);
    for (ContourLine& line : lines) {
        for (ContourPoint& point : line.points)
            point = {request().x.range.from_deg + point.x * perX, request().y.range.from_deg + point.y * perY};
    }
    return lines;
}

QImage MapCells::image(const QRectF& view_deg, QSize size_px, double scale_deg, QRgb outside) const
{
    QImage image(size_px, QImage::Format_RGB32);
    const DivergingTable& colours = divergingTable();
    const float perDegree = static_cast<float>(kDivergingHalf / scale_deg);
    const auto colourOf = [&](float value_deg) {
        const float at = std::clamp(value_deg * perDegree, -float(kDivergingHalf), float(kDivergingHalf));
        return colours[static_cast<std::size_t>(at + (kDivergingHalf + 0.5F))];
    };
    const std::vector<Step> across = stepsAlong(request().x, view_deg.left(), view_deg.right(), size_px.width());
    const std::vector<Step> down = stepsAlong(request().y, view_deg.bottom(), view_deg.top(), size_px.height());
    std::vector<float> blended(static_cast<std::size_t>(columns()));
    for (int row = 0; row < size_px.height(); ++row) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(row));
        const auto [y, partY] = down[static_cast<std::size_t>(row)];
        const double* low = &m_values_deg[m_map->index(0, y)];
        const double* high = &m_values_deg[m_map->index(0, y + 1)];
        for (std::size_t x = 0; x < blended.size(); ++x)
            blended[x] = static_cast<float>(low[x] + (high[x] - low[x]) * partY);
        const bool plain = m_plainRows[static_cast<std::size_t>(y)];
        for (const auto& [x, partX] : across) {
            const Kind kind = plain ? Kind::Plain : this->kind(x, y);
            if (kind == Kind::Plain)
                *line++ = colourOf(blended[static_cast<std::size_t>(x)] * (1 - partX) + blended[static_cast<std::size_t>(x) + 1] * partX);
            else if (kind == Kind::Jump)
                *line++ = colourOf(static_cast<float>((partY >= 0.5F ? high : low)[x + (partX >= 0.5F)]));
            else
                *line++ = outside;
        }
    }
    return image;
}

} // namespace lubberline::ui
