#include "ui/plots/ChartPlot.h"
#include "ui/plots/CurveChart.h"
#include "ui/plots/PlotRendering.h"
#include "ui/plots/SwingPlot.h"

namespace lubberline::ui {

SwingPlot* makeCurvePlot(QWidget* parent)
{
    return new ChartPlot(ChartPlot::tr("Curve"), [] { return std::make_unique<CurveChart>(); }, parent);
}

void renderCurve(QPainter& painter, const QRectF& target, const SwingPicture& picture)
{
    CurveChart chart;
    renderChart(chart, painter, target, picture);
}

} // namespace lubberline::ui
