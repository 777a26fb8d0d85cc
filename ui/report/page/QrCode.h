#pragma once
/// QR codes, drawn as squares: record ids to come back by. Made by libqrencode, error correction M (15 % may be soiled).

#include <QRectF>
#include <QString>

#include <vector>

#include "core/base/Result.h"

class QPainter;

namespace lubberline::ui {

struct QrMatrix {
    int width = 0;          ///< modules along a side, without the quiet zone
    std::vector<bool> dark; ///< row by row
};

/// Errors: InvalidInput (nothing to say, or more than a code holds).
Result<QrMatrix> qrOf(const QString& text);

/// With the quiet zone of four modules inside `rect`.
void paintQr(QPainter& painter, const QRectF& rect, const QrMatrix& matrix);

} // namespace lubberline::ui
