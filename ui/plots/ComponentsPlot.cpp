#include "ui/plots/ChartPlot.h"
#include "ui/plots/ComponentsChart.h"
#include "ui/plots/PlotRendering.h"
#include "ui/plots/SwingPlot.h"

namespace lubberline::ui {

SwingPlot* makeComponentsPlot(QWidget* parent)
{
    return new ChartPlot(ChartPlot::tr("Components"), [] { return std::make_unique<ComponentsChart>(); }, parent);
}

void renderComponents(QPainter& painter, const QRectF& target, const SwingPicture& picture)
{
    ComponentsChart chart;
    renderChart(chart, painter, target, picture);
}

} // namespace lubberline::ui
