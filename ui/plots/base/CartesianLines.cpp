#include "ui/plots/base/CartesianLines.h"

#include <qwt_plot_curve.h>
#include <qwt_plot_zoneitem.h>
#include <qwt_scale_widget.h>

#include "ui/plots/base/CartesianPlot.h"
#include "ui/plots/base/HeadingScale.h"

namespace lubberline::ui {

namespace {

constexpr int kHalfLabel_px = 16;

QwtPlotZoneItem* attachedZone(QwtPlot* plot, double z)
{
    auto* zone = new QwtPlotZoneItem;
    zone->setOrientation(Qt::Horizontal);
    zone->setZ(z);
    zone->setVisible(false);
    zone->attach(plot);
    return zone;
}

} // namespace

LimitBand::LimitBand(QwtPlot* plot) : m_fill(attachedZone(plot, 1)), m_edge(attachedZone(plot, 7))
{
    m_fill->setPen(QPen(Qt::NoPen));
    m_edge->setBrush(Qt::NoBrush);
}

void LimitBand::setLimit(std::optional<double> limit_deg)
{
    m_present = limit_deg.has_value();
    for (QwtPlotZoneItem* zone : {m_fill, m_edge})
        zone->setInterval(-limit_deg.value_or(0), limit_deg.value_or(0));
    setShown(m_shown);
}

void LimitBand::setShown(bool shown)
{
    m_shown = shown;
    m_fill->setVisible(m_present && shown);
    m_edge->setVisible(m_present && shown);
}

void LimitBand::setLook(const PlotColours& colours)
{
    m_fill->setBrush(colours.limit);
    m_edge->setPen(colours.limitEdge, 1.4);
}

bool LimitBand::isVisible() const { return m_fill->isVisible(); }
double LimitBand::limit_deg() const { return m_fill->interval().maxValue(); }

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

} // namespace lubberline::ui
