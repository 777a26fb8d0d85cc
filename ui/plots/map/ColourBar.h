#pragma once
/// The key of the colours of a map: a bar from −end to +end with ticks, units and the limit.

#include <QFont>
#include <QRectF>
#include <QString>

#include <optional>

#include "ui/plots/base/NiceScale.h"
#include "ui/plots/base/PlotColours.h"

class QPainter;

namespace lubberline::ui {

struct ColourBar {
    NiceScale scale;
    QString title;
    std::optional<double> limit_deg; ///< heavy ticks at ±
};

/// The width that it needs. [units of the painter]
[[nodiscard]] double colourBarWidth(const ColourBar& bar, const QFont& font);
void paintColourBar(QPainter& painter, const QRectF& rect, const ColourBar& bar, const PlotColours& colours, const QFont& font);

} // namespace lubberline::ui
