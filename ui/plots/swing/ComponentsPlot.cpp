#include "ui/plots/base/ChartOnPaper.h"
#include "ui/plots/swing/ChartPlot.h"
#include "ui/plots/swing/ComponentsChart.h"
#include "ui/plots/swing/PlotRendering.h"
#include "ui/plots/swing/SwingPlot.h"

namespace lubberline::ui {

SwingPlot* makeComponentsPlot(QWidget* parent)
{
    return new ChartPlot(
        ChartPlot::tr("Components"), [] { return std::make_unique<ComponentsChart>(); }, parent);
}

void renderComponents(QPainter& painter, const QRectF& target, const SwingPicture& picture)
{
    drawOnPaper(painter, target, [&picture](QPainter& paper, const QRectF& room) {
        ComponentsChart chart;
        renderChart(chart, paper, room, picture);
    });
}

} // namespace lubberline::ui
