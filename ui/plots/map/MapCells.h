#pragma once
/// The cells between the nodes of a map, in degrees: what may be interpolated and what may not.

#include <QImage>
#include <QPointF>
#include <QRectF>

#include <memory>
#include <optional>
#include <vector>

#include "core/sensor/map/Contours.h"
#include "core/sensor/map/DeviationMap.h"

namespace lubberline::ui {

/// No map changes so much from node to node; an angle that is wrapped does.
inline constexpr double kJump_deg = 180;

class MapCells {
public:
    enum class Kind : std::uint8_t { Plain, Jump, Undefined }; ///< Jump: the angle goes from +180° to −180° inside the cell

    explicit MapCells(std::shared_ptr<const DeviationMap> map);

    [[nodiscard]] const MapRequest& request() const { return m_map->request; }
    [[nodiscard]] int columns() const { return m_map->request.x.nodes; }
    [[nodiscard]] int rows() const { return m_map->request.y.nodes; }
    [[nodiscard]] double node_deg(int x, int y) const { return m_values_deg[m_map->index(x, y)]; }
    [[nodiscard]] bool defined(int x, int y) const { return m_map->defined[m_map->index(x, y)] != 0; }
    [[nodiscard]] Kind kind(int x, int y) const { return m_kinds[static_cast<std::size_t>(y) * (columns() - 1) + x]; }
    /// The axes' ranges; top() is the lowest y.
    [[nodiscard]] QRectF range_deg() const;
    [[nodiscard]] double largest_deg() const { return m_largest_deg; } ///< of |values|
    /// The values are one value but for rounding: lines of equal value would be its noise.
    [[nodiscard]] bool flat() const { return !(m_most_deg - m_least_deg > 1e-6); }

    /// Bilinear; across a jump the nearest node. None outside the map and in cells with an undefined corner.
    [[nodiscard]] std::optional<double> valueAt_deg(double x_deg, double y_deg) const;

    /// Lines of equal value, points in degrees of the axes. `stride`: every so many nodes are used.
    [[nodiscard]] std::vector<ContourLine> contours(std::span<const double> levels_deg, int stride = 1) const;

    /// Colours of the part `view_deg` (inside the range), each pixel's value at its middle; `outside` where undefined.
    [[nodiscard]] QImage image(const QRectF& view_deg, QSize size_px, double scale_deg, QRgb outside) const;

private:
    struct Place;
    [[nodiscard]] std::optional<Place> placeOf(double x_deg, double y_deg) const;
    void sortCells();

    std::shared_ptr<const DeviationMap> m_map;
    std::vector<double> m_values_deg;
    std::vector<Kind> m_kinds;
    std::vector<bool> m_plainRows; ///< rows of cells without anything special
    double m_largest_deg = 0, m_least_deg = 360, m_most_deg = -360;
};

} // namespace lubberline::ui
