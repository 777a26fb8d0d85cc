#include "ui/plots/base/LineLooks.h"

namespace lubberline::ui {

namespace {

QPen dashed(const QColor& colour, double width, const QList<qreal>& pattern)
{
    QPen pen(colour, width);
    pen.setDashPattern(pattern);
    pen.setCapStyle(Qt::FlatCap);
    return pen;
}

} // namespace

LineLooks lineLooks(const PlotColours& colours)
{
    // Where both fits agree, the blue line shows through the gaps of the vermilion one.
    return {QPen(colours.approximate, 2.4), dashed(colours.exact, 1.8, {5, 3}), dashed(colours.previous, 1.4, {2.5, 2.5}),
        dashed(colours.noise, 1.6, {6, 3})};
}

QPen componentPen(const PlotColours& colours, std::size_t index)
{
    const QColor colour = colours.coefficient.at(index);
    switch (index) {
    case 0: return dashed(colour, 1.8, {1.5, 1.5});
    case 3:
    case 4: return dashed(colour, 1.8, {6, 2.5});
    default: return QPen(colour, 1.8);
    }
}

void styleEntry(LegendEntry& entry, const QColor& edge, const QBrush& fill)
{
    entry.pen = QPen(edge, 1);
    entry.fill = fill;
}

} // namespace lubberline::ui
