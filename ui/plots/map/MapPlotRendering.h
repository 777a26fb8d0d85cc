#pragma once
/// Maps of deviation on paper: contours, text and surface in vector form, the colours of the flat map as a lossless image;
/// opaque light colours on white. As in PlotRendering.h `target` is in the painter's own units, text has 8 pt, a QApplication
/// must exist.

#include <QRectF>

#include "ui/plots/map/MapPicture.h"

class QPainter;

namespace lubberline::ui {

void renderMap(QPainter& painter, const QRectF& target, const MapPicture& picture);

/// Where the eye stands.
struct SurfaceView {
    double azimuth_deg = 35;   ///< the box turned clockwise, seen from above
    double elevation_deg = 30; ///< above the plane of the two axes, 5…75
    friend bool operator==(const SurfaceView&, const SurfaceView&) = default;
};

void renderSurface(QPainter& painter, const QRectF& target, const MapPicture& picture, const SurfaceView& view = {});

} // namespace lubberline::ui
