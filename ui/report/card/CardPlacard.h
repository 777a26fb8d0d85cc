#pragma once
/// The card itself, as it is cut out: FOR and STEER in two halves, large digits.

#include <QRectF>

#include "ui/report/card/CardDocument.h"

class QPainter;

namespace lubberline::ui {

/// About 60 × 85 mm for 30° steps, 60 × 72 mm for 45°; wider with two STEER columns, higher with finer steps and with what has to be
/// said beneath. [units of the page]
[[nodiscard]] QSizeF placardSize(const CardInput& input, const QString& family);
void paintPlacard(QPainter& painter, const QRectF& rect, const CardInput& input, const QString& family);

/// Marks outside the corners, clear of the card itself.
void paintCropMarks(QPainter& painter, const QRectF& rect);

} // namespace lubberline::ui
