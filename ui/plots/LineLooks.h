#pragma once
/// The pens of the curves, the same in every plot and told apart in grey too.

#include <QPen>

#include "ui/plots/PlotColours.h"
#include "ui/plots/PlotLegend.h"

namespace lubberline::ui {

struct LineLooks {
    QPen approximate, exact, previous, noise;
};
[[nodiscard]] LineLooks lineLooks(const PlotColours& colours);

void styleEntry(LegendEntry& entry, const QColor& edge, const QBrush& fill);

} // namespace lubberline::ui
