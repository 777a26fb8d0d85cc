#pragma once
/// From a box in space to the plane of the picture: parallel light, so that rows walked from the far corner hide each other
/// rightly from every elevation, and lengths along an axis stay comparable.

#include <QPointF>
#include <QRectF>

#include "ui/plots/map/MapPlotRendering.h"

namespace lubberline::ui {

/// A point of the box: each −1…+1; x and y the axes of the map, z the value.
struct BoxPoint {
    double x = 0, y = 0, z = 0;
};

class SurfaceProjection {
public:
    /// The box fits into `room`, then is enlarged by `zoom` round its middle and moved.
    SurfaceProjection(const SurfaceView& view, const QRectF& room, double zoom = 1, QPointF moved = {});

    [[nodiscard]] QPointF operator()(const BoxPoint& point) const
    {
        const auto [x, y] = flat(point);
        return {m_origin.x() + m_scale * x, m_origin.y() - m_scale * y};
    }
    /// The sides (±1) of the box that are away from the eye.
    [[nodiscard]] int farX() const { return m_awayX >= 0 ? 1 : -1; }
    [[nodiscard]] int farY() const { return m_awayY >= 0 ? 1 : -1; }

private:
    struct Flat {
        double right, up;
    };
    [[nodiscard]] Flat flat(const BoxPoint& point) const;

    double m_rightX, m_rightY, m_awayX, m_awayY; ///< of a unit of the box along x and y, seen from above
    double m_sine, m_cosine;                     ///< of the elevation
    double m_scale = 1;
    QPointF m_origin;
};

/// The elevation within 5…75°, the azimuth within [0, 360).
[[nodiscard]] SurfaceView heldView(const SurfaceView& view);

} // namespace lubberline::ui
