#include "ui/plots/swing/PolarChart.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

#include <qwt_point_polar.h>
#include <qwt_polar_canvas.h>
#include <qwt_polar_curve.h>
#include <qwt_polar_plot.h>
#include <qwt_polar_renderer.h>
#include <qwt_scale_map.h>
#include <qwt_series_data.h>

#include "ui/plots/base/LineLooks.h"
#include "ui/plots/swing/PictureCurves.h"
#include "ui/plots/swing/PictureText.h"
#include "ui/plots/swing/PolarItems.h"
#include "ui/plots/swing/SwingChart.h"

namespace lubberline::ui {

namespace {

constexpr double kClosest = 0.03; ///< a thirtieth of the radius fills the plot

QwtPolarCurve* attachedCurve(QwtPolarPlot* plot, const QString& title, double z)
{
    auto* curve = new QwtPolarCurve(QwtText(title));
    curve->setZ(z);
    curve->setRenderHint(QwtPolarItem::RenderAntialiased);
    curve->attach(plot);
    return curve;
}

void setSamples(QwtPolarCurve* curve, const QPolygonF& points)
{
    QVector<QwtPointPolar> samples;
    samples.reserve(points.size());
    for (const QPointF& point : points)
        samples.append(QwtPointPolar(point.x(), point.y()));
    curve->setData(new QwtArraySeriesData<QwtPointPolar>(samples)); // the curve owns it
}

} // namespace

PolarChart::PolarChart(QWidget* parent)
    : SwingChart(parent)
    , m_plot(new QwtPolarPlot(this))
    , m_ground(new PolarGround)
    , m_previous(attachedCurve(m_plot, tr("previous swing"), 12))
    , m_approximate(attachedCurve(m_plot, tr("approximate fit"), 20))
    , m_exact(attachedCurve(m_plot, tr("exact fit"), 21))
    , m_readings(new PolarReadings)
    , m_notice(new PolarNotice)
{
    m_ground->attach(m_plot);
    m_readings->attach(m_plot);
    m_notice->attach(m_plot);
    m_plot->setAutoReplot(false);
    m_plot->setAzimuthOrigin(kPi / 2);
    m_plot->setScale(QwtPolar::Azimuth, 360, 0, 30);
    m_plot->setPlotBackground(Qt::NoBrush);
    m_plot->canvas()->setFrameStyle(QFrame::NoFrame);
    m_plot->canvas()->setObjectName("polarCanvas");
    m_plot->canvas()->setCursor(Qt::CrossCursor);
    m_readingsEntry = addEntry({tr("readings"), LegendEntry::Key::Dot}, [this](bool on) { m_readings->setVisible(on); });
    m_approximateEntry = addEntry({tr("approximate fit")}, [this](bool on) { m_approximate->setVisible(on); });
    m_exactEntry = addEntry({tr("exact fit")}, [this](bool on) { m_exact->setVisible(on); });
    m_previousEntry = addEntry({tr("previous swing")}, [this](bool on) { m_previous->setVisible(on); });
    m_limitEntry = addEntry({tr("limit"), LegendEntry::Key::Area}, [this](bool on) { m_ground->setLimitShown(on); });
    styleItems();
    setPicture({});
}

void PolarChart::setPicture(const SwingPicture& picture)
{
    keepPicture(picture);
    m_scale = deviationScale(picture);
    m_ground->setScale(m_scale);
    m_ground->setLimit(picture.limit_deg);
    m_plot->setScale(QwtPolar::Radius, -m_scale.end, m_scale.end, m_scale.step);
    const Analysis* analysis = picture.analysis.get();
    setSamples(m_approximate, analysis ? approximateCurve(analysis->approximate) : QPolygonF());
    setSamples(m_exact, analysis ? exactCurve(analysis->exact) : QPolygonF());
    setSamples(m_previous, picture.previous ? approximateCurve(picture.previous->approximate) : QPolygonF());
    m_readings->setPoints(readingPoints(picture));
    m_notice->setText(noticeFor(picture));

    entry(m_readingsEntry).present = !picture.readings.empty();
    entry(m_approximateEntry).present = m_approximate->dataSize() > 0;
    entry(m_exactEntry).present = m_exact->dataSize() > 0;
    entry(m_previousEntry).present = m_previous->dataSize() > 0;
    entry(m_previousEntry).title = previousTitle(picture);
    entry(m_limitEntry).present = picture.limit_deg.has_value();
    entry(m_limitEntry).title = limitTitle(picture, m_scale.end);
    updateLegend();
    replotAll();
}

void PolarChart::setSelectedRow(int row)
{
    if (row == m_readings->selectedRow())
        return;
    m_readings->setSelectedRow(row);
    replotAll();
}

std::vector<QWidget*> PolarChart::canvases() const { return {m_plot->canvas()}; }

std::vector<Chart::RowPlace> PolarChart::rowsOn(const QWidget*) const
{
    if (!m_readings->isVisible())
        return {};
    const QwtScaleMap radial = m_plot->scaleMap(QwtPolar::Radius);
    const QPointF pole = m_plot->plotRect().center();
    std::vector<RowPlace> places;
    for (const ReadingPoint& point : m_readings->points())
        places.push_back({point.row, polarPlace(pole, point.heading_deg, radial.transform(point.value_deg))});
    return places;
}

QString PolarChart::readOutAt(const CanvasPlace& place) const
{
    const QPointF radii = inRadii(place.at);
    const double distance = std::hypot(radii.x(), radii.y());
    if (distance > 1)
        return {};
    const double heading_deg = wrap360(toDegrees(std::atan2(radii.x(), radii.y())));
    return placeReadOut(heading_deg, m_scale.end * (2 * distance - 1), this->picture());
}

QPointF PolarChart::inRadii(const QPointF& at) const
{
    const QRectF whole = m_plot->plotRect();
    const QPointF fromPole = (at - whole.center()) / (whole.width() / 2);
    return {fromPole.x(), -fromPole.y()};
}

void PolarChart::setView(View view)
{
    view.factor = std::clamp(view.factor, kClosest, 1.0);
    const double farthest = 1 - view.factor;
    const double distance = std::hypot(view.centre.x(), view.centre.y());
    if (distance > farthest)
        view.centre *= distance > 0 ? farthest / distance : 0;
    m_view = view;
    // Qwt takes the azimuth of a zoom position in radians, counter-clockwise from the right, its radius from the scale's start.
    m_plot->zoom(
        QwtPointPolar(std::atan2(view.centre.y(), view.centre.x()), 2 * m_scale.end * std::hypot(view.centre.x(), view.centre.y())),
        view.factor);
    replotAll();
}

void PolarChart::zoomInto(const QWidget* canvas, const QRectF& rect)
{
    const double part = std::max(rect.width() / canvas->width(), rect.height() / canvas->height());
    setView({inRadii(rect.center()), m_view.factor * part});
}

void PolarChart::zoomAt(const CanvasPlace& place, double factor)
{
    const double changed = std::clamp(m_view.factor * factor, kClosest, 1.0) / m_view.factor;
    const QPointF kept = inRadii(place.at);
    setView({kept + (m_view.centre - kept) * changed, m_view.factor * changed});
}

void PolarChart::panBy(const QWidget*, const QPointF& by)
{
    const double radius = m_plot->plotRect().width() / 2;
    setView({m_view.centre - QPointF(by.x(), -by.y()) / radius, m_view.factor});
}

void PolarChart::resetZoom() { setView({}); }

void PolarChart::takeView(const Chart& other)
{
    Chart::takeView(other);
    setView(static_cast<const PolarChart&>(other).m_view);
}

void PolarChart::styleItems()
{
    const LineLooks looks = lineLooks(colours());
    m_ground->setLook(colours(), font());
    m_readings->setLook(colours(), font());
    m_notice->setLook(colours(), font());
    m_approximate->setPen(looks.approximate);
    m_exact->setPen(looks.exact);
    m_previous->setPen(looks.previous);
    styleEntry(entry(m_readingsEntry), colours().readings, colours().readings);
    entry(m_approximateEntry).pen = looks.approximate;
    entry(m_exactEntry).pen = looks.exact;
    entry(m_previousEntry).pen = looks.previous;
    styleEntry(entry(m_limitEntry), colours().limitEdge, colours().limit);
    QPalette ground = palette();
    ground.setColor(QPalette::Window, colours().ground);
    m_plot->setPalette(ground);
    m_plot->canvas()->setPalette(ground);
    m_plot->setAutoFillBackground(true);
}

void PolarChart::layoutPlots(const QRect& rect)
{
    QRect square(0, 0, std::min(rect.width(), rect.height()), std::min(rect.width(), rect.height()));
    square.moveCenter(rect.center());
    m_plot->setGeometry(square);
}

void PolarChart::replotAll() { m_plot->replot(); }

void PolarChart::paintPlots(QPainter& painter, const QRectF& device)
{
    const double side = std::min(device.width(), device.height());
    QRectF square(0, 0, side, side);
    square.moveCenter(device.center());
    m_plot->replot();
    QwtPolarRenderer().render(m_plot, &painter, square);
}

} // namespace lubberline::ui
