#include "ui/plots/ChartPlot.h"
#include "ui/plots/PlotRendering.h"
#include "ui/plots/SpectrumChart.h"
#include "ui/plots/SwingPlot.h"

namespace lubberline::ui {

SwingPlot* makeSpectrumPlot(QWidget* parent)
{
    return new ChartPlot(ChartPlot::tr("Spectrum"), [] { return std::make_unique<SpectrumChart>(); }, parent);
}

void renderSpectrum(QPainter& painter, const QRectF& target, const SwingPicture& picture)
{
    SpectrumChart chart;
    renderChart(chart, painter, target, picture);
}

} // namespace lubberline::ui
