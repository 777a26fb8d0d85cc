#include "ui/plots/ChartPlot.h"
#include "ui/plots/PlotRendering.h"
#include "ui/plots/PolarChart.h"
#include "ui/plots/SwingPlot.h"

namespace lubberline::ui {

SwingPlot* makePolarPlot(QWidget* parent)
{
    return new ChartPlot(ChartPlot::tr("Polar"), [] { return std::make_unique<PolarChart>(); }, parent);
}

void renderPolar(QPainter& painter, const QRectF& target, const SwingPicture& picture)
{
    PolarChart chart;
    renderChart(chart, painter, target, picture);
}

} // namespace lubberline::ui
