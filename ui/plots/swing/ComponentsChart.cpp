#include "ui/plots/swing/ComponentsChart.h"

#include <algorithm>
#include <cmath>

#include <qwt_plot_curve.h>

#include "ui/plots/base/CartesianLines.h"
#include "ui/plots/base/CartesianPlot.h"
#include "ui/plots/base/LineLooks.h"
#include "ui/plots/swing/CartesianReadings.h"
#include "ui/plots/swing/PictureCurves.h"
#include "ui/plots/swing/PictureText.h"

namespace lubberline::ui {

namespace {

/// The readings stand at their compass headings here.
std::vector<ReadingPoint> pointsAtCompass(const SwingPicture& picture)
{
    std::vector<ReadingPoint> points = readingPoints(picture);
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i].heading_deg = picture.readings[i].compass.degrees();
    return points;
}

double maxAbs(const QPolygonF& curve, double least)
{
    double most = least;
    for (const QPointF& point : curve)
        most = std::max(most, std::abs(point.y()));
    return most;
}

} // namespace

ComponentsChart::ComponentsChart(QWidget* parent)
    : CartesianChart(parent)
    , m_sum(attachedCurve(&plot(), tr("sum"), 21))
    , m_readings(new CartesianReadings)
{
    plot().setObjectName("componentsPlot");
    makeHeadingAxis(plot());
    plot().setTitles(tr("compass heading (°)"), deviationAxisTitle());
    m_readings->attach(&plot());
    m_readingsEntry = addEntry({tr("readings"), LegendEntry::Key::Dot}, [this](bool on) { m_readings->setVisible(on); });
    for (const Coefficient which : kCoefficients) {
        QwtPlotCurve* curve = attachedCurve(&plot(), componentName(which), 20 - static_cast<double>(indexOf(which)) / 10);
        m_components[indexOf(which)] = curve;
        m_componentEntries[indexOf(which)] = addEntry({componentName(which)}, [curve](bool on) { curve->setVisible(on); });
    }
    m_sumEntry = addEntry({tr("sum")}, [this](bool on) { m_sum->setVisible(on); });
    styleItems();
    setPicture({});
}

void ComponentsChart::setPicture(const SwingPicture& picture)
{
    keepPicture(picture);
    const Analysis* analysis = picture.analysis.get();
    double most = 0;
    for (const Coefficient which : kCoefficients) {
        const QPolygonF curve = analysis ? componentCurve(analysis->approximate, which) : QPolygonF();
        m_components[indexOf(which)]->setSamples(curve);
        entry(m_componentEntries[indexOf(which)]).present = !curve.isEmpty();
        most = maxAbs(curve, most);
    }
    const QPolygonF sum = analysis ? sumOfComponents(analysis->approximate) : QPolygonF();
    m_sum->setSamples(sum);
    m_readings->setPoints(pointsAtCompass(picture));
    for (const ReadingPoint& point : m_readings->points())
        most = std::max(most, std::abs(point.value_deg) + point.bar_deg);
    const NiceScale scale = niceScale(maxAbs(sum, most));

    entry(m_sumEntry).present = !sum.isEmpty();
    entry(m_readingsEntry).present = !picture.readings.empty();
    plot().setBase(0, 360, -scale.end, scale.end, scale.step);
    plot().setNotice(noticeFor(picture));
    updateLegend();
    replotAll();
}

void ComponentsChart::setSelectedRow(int row)
{
    if (row == m_readings->selectedRow())
        return;
    m_readings->setSelectedRow(row);
    replotAll();
}

std::vector<Chart::RowPlace> ComponentsChart::rowsOn(const QWidget*) const
{
    return m_readings->isVisible() ? rowPlaces(plot(), *m_readings) : std::vector<RowPlace>();
}

QString ComponentsChart::readOutAt(const CanvasPlace& place) const
{
    const double compass_deg = plot().valueAt(place.at).x();
    return compass_deg < 0 || compass_deg > 360 ? QString() : componentsReadOut(compass_deg, picture());
}

void ComponentsChart::styleItems()
{
    CartesianChart::styleItems();
    m_readings->setLook(colours(), font());
    for (std::size_t i = 0; i < m_components.size(); ++i) {
        const QPen pen = componentPen(colours(), i);
        m_components[i]->setPen(pen);
        entry(m_componentEntries[i]).pen = pen;
    }
    const QPen sum(colours().approximate, 2.6);
    m_sum->setPen(sum);
    entry(m_sumEntry).pen = sum;
    styleEntry(entry(m_readingsEntry), colours().readings, colours().readings);
}

} // namespace lubberline::ui
