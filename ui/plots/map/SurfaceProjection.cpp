#include "ui/plots/map/SurfaceProjection.h"

#include <algorithm>
#include <cmath>

#include "core/angle/Heading.h"

namespace lubberline::ui {

namespace {

// Half the sides of the box: as wide as deep nearly, lower than wide.
constexpr double kHalfX = 1.0, kHalfY = 0.85, kHalfZ = 0.5;

} // namespace

SurfaceProjection::SurfaceProjection(const SurfaceView& view, const QRectF& room, double zoom, QPointF moved)
    : m_sine(std::sin(toRadians(view.elevation_deg)))
    , m_cosine(std::cos(toRadians(view.elevation_deg)))
{
    const double sine = std::sin(toRadians(view.azimuth_deg)), cosine = std::cos(toRadians(view.azimuth_deg));
    m_rightX = kHalfX * cosine;
    m_rightY = kHalfY * sine;
    m_awayX = -kHalfX * sine;
    m_awayY = kHalfY * cosine;
    const double halfWidth = std::abs(m_rightX) + std::abs(m_rightY);
    const double halfHeight = m_sine * (std::abs(m_awayX) + std::abs(m_awayY)) + m_cosine * kHalfZ;
    m_scale = zoom * std::min(room.width() / (2 * halfWidth), room.height() / (2 * halfHeight));
    m_origin = room.center() + moved;
}

SurfaceProjection::Flat SurfaceProjection::flat(const BoxPoint& point) const
{
    return {m_rightX * point.x + m_rightY * point.y, m_sine * (m_awayX * point.x + m_awayY * point.y) + m_cosine * kHalfZ * point.z};
}

SurfaceView heldView(const SurfaceView& view)
{
    const double turns = std::floor(view.azimuth_deg / 360);
    return {view.azimuth_deg - 360 * turns, std::clamp(view.elevation_deg, 5.0, 75.0)};
}

} // namespace lubberline::ui
