#include "ui/plots/CartesianLines.h"

#include <qwt_plot_curve.h>
#include <qwt_scale_widget.h>

#include "ui/plots/CartesianPlot.h"
#include "ui/plots/HeadingScale.h"

namespace lubberline::ui {

namespace {

constexpr int kHalfLabel_px = 16;

} // namespace

void makeHeadingAxis(CartesianPlot& plot)
{
    plot.setAxisScaleEngine(QwtAxis::XBottom, new HeadingScaleEngine);
    plot.setAxisScaleDraw(QwtAxis::XBottom, new HeadingScaleDraw);
    plot.axisWidget(QwtAxis::XBottom)->setMinBorderDist(kHalfLabel_px, kHalfLabel_px);
}

QwtPlotCurve* attachedCurve(QwtPlot* plot, const QString& title, double z)
{
    auto* curve = new QwtPlotCurve(title);
    curve->setZ(z);
    curve->setRenderHint(QwtPlotItem::RenderAntialiased);
    curve->attach(plot);
    return curve;
}

std::vector<Chart::RowPlace> rowPlaces(const CartesianPlot& plot, const CartesianReadings& readings)
{
    std::vector<Chart::RowPlace> places;
    for (const ReadingPoint& point : readings.points())
        places.push_back({point.row, plot.pixelOf({point.heading_deg, point.value_deg})});
    return places;
}

} // namespace lubberline::ui
