#pragma once
/// The card itself, as it is cut out: FOR and STEER in two halves, large digits.

#include <QRectF>

#include "ui/report/card/CardDocument.h"

class QPainter;

namespace lubberline::ui {

/// About 60 × 82 mm for 30° steps, 60 × 69 mm for 45°; wider with two STEER columns. [units of the page]
[[nodiscard]] QSizeF placardSize(const CardInput& input);
void paintPlacard(QPainter& painter, const QRectF& rect, const CardInput& input, const QString& family);

/// Marks outside the corners, clear of the card itself.
void paintCropMarks(QPainter& painter, const QRectF& rect);

/// "030", "360" never: north is 000.
[[nodiscard]] QString threeDigits(int heading_deg);

} // namespace lubberline::ui
