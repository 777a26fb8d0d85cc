#pragma once
/// The plots of a swing on paper: in vector form, light colours on white, without a widget being shown. `target` is in the
/// painter's own units; text has 8 pt at the painter's resolution whatever the target's size. A QApplication must exist.

#include <QRectF>

#include "ui/plots/swing/SwingPicture.h"

class QPainter;

namespace lubberline::ui {

void renderPolar(QPainter& painter, const QRectF& target, const SwingPicture& picture);
void renderCurve(QPainter& painter, const QRectF& target, const SwingPicture& picture);
void renderSpectrum(QPainter& painter, const QRectF& target, const SwingPicture& picture);
void renderComponents(QPainter& painter, const QRectF& target, const SwingPicture& picture);

} // namespace lubberline::ui
