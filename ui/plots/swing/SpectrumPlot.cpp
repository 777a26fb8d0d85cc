#include "ui/plots/base/ChartOnPaper.h"
#include "ui/plots/swing/ChartPlot.h"
#include "ui/plots/swing/PlotRendering.h"
#include "ui/plots/swing/SpectrumChart.h"
#include "ui/plots/swing/SwingPlot.h"

namespace lubberline::ui {

SwingPlot* makeSpectrumPlot(QWidget* parent)
{
    return new ChartPlot(
        ChartPlot::tr("Spectrum"), [] { return std::make_unique<SpectrumChart>(); }, parent);
}

void renderSpectrum(QPainter& painter, const QRectF& target, const SwingPicture& picture)
{
    drawOnPaper(painter, target, [&picture](QPainter& paper, const QRectF& room) {
        SpectrumChart chart;
        renderChart(chart, paper, room, picture);
    });
}

} // namespace lubberline::ui
