#pragma once
/// The pens of the curves, the same in every plot and told apart in grey too.

#include <QPen>

#include <cstddef>

#include "ui/plots/base/PlotColours.h"
#include "ui/plots/base/PlotLegend.h"

namespace lubberline::ui {

struct LineLooks {
    QPen approximate, exact, previous, noise;
};
[[nodiscard]] LineLooks lineLooks(const PlotColours& colours);

/// Of one of A…E (0…4): told apart by colour and by dashes.
[[nodiscard]] QPen componentPen(const PlotColours& colours, std::size_t index);

void styleEntry(LegendEntry& entry, const QColor& edge, const QBrush& fill);

} // namespace lubberline::ui
