#pragma once
/// The box round a surface: floor, back walls' edges, labelled ticks with units on all three axes, the outline of the plane of
/// zero.

#include <QPointF>
#include <QString>

class QPainter;

namespace lubberline::ui {

struct BoxPoint;
struct MapPicture;
struct SurfaceLook;
class SurfaceProjection;

class SurfaceAxes {
public:
    /// All three must outlive it.
    SurfaceAxes(const MapPicture& picture, const SurfaceProjection& project, const SurfaceLook& look);

    void paintBehind(QPainter& painter) const; ///< what the surface hides
    void paintBefore(QPainter& painter) const; ///< what hides the surface

private:
    void line(QPainter& painter, const BoxPoint& from, const BoxPoint& to) const;
    void paintAlongFloor(QPainter& painter, bool alongX) const;
    void paintUpright(QPainter& painter) const;
    void paintLabel(QPainter& painter, QPointF at, QPointF outward, const QString& text) const;

    const MapPicture& m_picture;
    const SurfaceProjection& m_project;
    const SurfaceLook& m_look;
    int m_farX, m_farY;
};

} // namespace lubberline::ui
