#include "ui/plots/base/ChartOnPaper.h"
#include "ui/plots/swing/ChartPlot.h"
#include "ui/plots/swing/PlotRendering.h"
#include "ui/plots/swing/PolarChart.h"
#include "ui/plots/swing/SwingPlot.h"

namespace lubberline::ui {

SwingPlot* makePolarPlot(QWidget* parent)
{
    return new ChartPlot(
        ChartPlot::tr("Polar"), [] { return std::make_unique<PolarChart>(); }, parent);
}

void renderPolar(QPainter& painter, const QRectF& target, const SwingPicture& picture)
{
    drawOnPaper(painter, target, [&picture](QPainter& paper, const QRectF& room) {
        PolarChart chart;
        renderChart(chart, paper, room, picture);
    });
}

} // namespace lubberline::ui
