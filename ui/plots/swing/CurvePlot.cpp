#include "ui/plots/base/ChartOnPaper.h"
#include "ui/plots/swing/ChartPlot.h"
#include "ui/plots/swing/CurveChart.h"
#include "ui/plots/swing/PlotRendering.h"
#include "ui/plots/swing/SwingPlot.h"

namespace lubberline::ui {

SwingPlot* makeCurvePlot(QWidget* parent)
{
    return new ChartPlot(
        ChartPlot::tr("Curve"), [] { return std::make_unique<CurveChart>(); }, parent);
}

void renderCurve(QPainter& painter, const QRectF& target, const SwingPicture& picture)
{
    drawOnPaper(painter, target, [&picture](QPainter& paper, const QRectF& room) {
        CurveChart chart;
        renderChart(chart, paper, room, picture);
    });
}

} // namespace lubberline::ui
