#pragma once
/// Small helpers that the rectangular plots share.

#include <QString>

#include <optional>
#include <vector>

#include "ui/plots/base/Chart.h"

class QwtPlot;
class QwtPlotCurve;
class QwtPlotZoneItem;

namespace lubberline::ui {

class CartesianPlot;

/// The limit: a tint beneath the grid with its edges above it. The plot owns the items.
class LimitBand {
public:
    explicit LimitBand(QwtPlot* plot);
    void setLimit(std::optional<double> limit_deg);
    void setShown(bool shown);
    void setLook(const PlotColours& colours);
    [[nodiscard]] bool isVisible() const;
    [[nodiscard]] double limit_deg() const;

private:
    QwtPlotZoneItem* m_fill;
    QwtPlotZoneItem* m_edge;
    bool m_present = false, m_shown = true;
};

/// Headings 0…360 below, with room at both ends for half a label.
void makeHeadingAxis(CartesianPlot& plot);
[[nodiscard]] QwtPlotCurve* attachedCurve(QwtPlot* plot, const QString& title, double z);

} // namespace lubberline::ui
