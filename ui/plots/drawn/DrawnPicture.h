#pragma once
/// A picture that one function draws, on the screen as on paper, and another reads under the pointer.

#include <QFont>
#include <QPointF>
#include <QRectF>
#include <QString>

#include <functional>
#include <vector>

#include "ui/plots/base/PlotColours.h"
#include "ui/plots/base/PlotLegend.h"

class QPainter;

namespace lubberline::ui {

/// How it is to look: the painter has the font already, and its units are pixels.
struct DrawnLook {
    PlotColours colours;
    std::vector<bool> shown; ///< one an entry of the legend; what is missing is shown
    [[nodiscard]] bool isShown(std::size_t entry) const { return entry >= shown.size() || shown[entry]; }
};

struct DrawnPicture {
    std::function<void(QPainter& painter, const QRectF& rect, const DrawnLook& look)> paint;
    /// What stands at a place of the same rectangle, in words with units; empty: nothing.
    std::function<QString(const QRectF& rect, const QFont& font, const QPointF& at)> readOut;
    std::function<std::vector<LegendEntry>(const PlotColours& colours)> legend; ///< at most kMostDrawnEntries
    QString notice = {};                                                        ///< what to do, where there is nothing to see
};
inline constexpr int kMostDrawnEntries = 8;

/// On paper: light colours on white, in the painter's own units.
void renderDrawn(QPainter& painter, const QRectF& target, const DrawnPicture& picture);

} // namespace lubberline::ui
