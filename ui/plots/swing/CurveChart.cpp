#include "ui/plots/swing/CurveChart.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

#include <qwt_plot_canvas.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_intervalcurve.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_widget.h>
#include <qwt_series_data.h>

#include "ui/plots/base/CartesianLines.h"
#include "ui/plots/base/CartesianPlot.h"
#include "ui/plots/base/HeadingScale.h"
#include "ui/plots/base/LineLooks.h"
#include "ui/plots/swing/CartesianReadings.h"
#include "ui/plots/swing/PictureCurves.h"
#include "ui/plots/swing/PictureText.h"
#include "ui/plots/swing/SwingChart.h"

namespace lubberline::ui {

namespace {

constexpr double kStripShare = 0.33, kMostStripShare = 0.48;
constexpr double kLeastStrip = 138; ///< its axis title needs this

CartesianPlot* headingPlot(QWidget* parent, const char* name)
{
    auto* plot = new CartesianPlot(parent);
    plot->setObjectName(name);
    makeHeadingAxis(*plot);
    return plot;
}

QVector<QwtIntervalSample> bandSamples(const ApproximateFit& fit)
{
    QVector<QwtIntervalSample> samples;
    for (const BandPoint& point : withinOneTurn(confidenceBand(fit)))
        samples.append(QwtIntervalSample(point.magnetic_deg, point.low_deg, point.high_deg));
    return samples;
}

std::vector<ReadingPoint> residualPoints(const SwingPicture& picture)
{
    std::vector<ReadingPoint> points = readingPoints(picture);
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i].value_deg = residual_deg(picture.readings[i], picture.analysis->approximate);
        points[i].label.clear(); // it stands in the plot above
    }
    return points;
}

} // namespace

CurveChart::CurveChart(QWidget* parent)
    : SwingChart(parent)
    , m_main(headingPlot(this, "deviationPlot"))
    , m_strip(headingPlot(this, "residualPlot"))
    , m_limit(m_main)
    , m_band(new QwtPlotIntervalCurve(tr("95 % band")))
    , m_previous(attachedCurve(m_main, tr("previous swing"), 12))
    , m_approximate(attachedCurve(m_main, tr("approximate fit"), 20))
    , m_exact(attachedCurve(m_main, tr("exact fit"), 21))
    , m_readings(new CartesianReadings)
    , m_residuals(new CartesianReadings)
{
    m_band->setZ(2);
    m_band->setStyle(QwtPlotIntervalCurve::Tube);
    m_band->setRenderHint(QwtPlotItem::RenderAntialiased);
    m_band->attach(m_main);
    m_readings->attach(m_main);
    m_residuals->attach(m_strip);
    m_main->setTitles({}, deviationAxisTitle());
    m_strip->setTitles(headingAxisTitle(), tr("residual (°)"));
    connect(m_main, &CartesianPlot::viewChanged, this, &CurveChart::setStrip);
    addEntries();
    styleItems();
    setPicture({});
}

void CurveChart::addEntries()
{
    m_readingsEntry = addEntry({tr("readings"), LegendEntry::Key::Dot}, [this](bool on) { m_readings->setVisible(on); });
    m_approximateEntry = addEntry({tr("approximate fit")}, [this](bool on) { m_approximate->setVisible(on); });
    m_bandEntry = addEntry({tr("95 % band"), LegendEntry::Key::Area}, [this](bool on) { m_band->setVisible(on); });
    m_exactEntry = addEntry({tr("exact fit")}, [this](bool on) { m_exact->setVisible(on); });
    m_previousEntry = addEntry({tr("previous swing")}, [this](bool on) { m_previous->setVisible(on); });
    m_limitEntry = addEntry({tr("limit"), LegendEntry::Key::Area}, [this](bool on) { m_limit.setShown(on); });
}

void CurveChart::setPicture(const SwingPicture& picture)
{
    keepPicture(picture);
    const NiceScale scale = deviationScale(picture);
    m_main->setBase(0, 360, -scale.end, scale.end, scale.step);
    m_main->setNotice(noticeFor(picture));
    m_hasStrip = picture.analysis && picture.analysis->approximate.fitted();
    setCurves();
    setStrip();
    setEntries(scale);
    layoutPlots(m_main->geometry().united(m_strip->geometry()));
    updateLegend();
    replotAll();
}

void CurveChart::setCurves()
{
    const Analysis* analysis = picture().analysis.get();
    const Analysis* previous = picture().previous.get();
    m_approximate->setSamples(analysis ? withinOneTurn(approximateCurve(analysis->approximate)) : QPolygonF());
    m_band->setSamples(analysis ? bandSamples(analysis->approximate) : QVector<QwtIntervalSample>());
    m_exact->setSamples(analysis ? exactCurve(analysis->exact) : QPolygonF());
    m_previous->setSamples(previous ? withinOneTurn(approximateCurve(previous->approximate)) : QPolygonF());
    m_readings->setPoints(readingPoints(picture()));
    m_limit.setLimit(picture().limit_deg);
}

void CurveChart::setStrip()
{
    std::vector<ReadingPoint> points = m_hasStrip ? residualPoints(picture()) : std::vector<ReadingPoint>();
    double largest = 0;
    for (const ReadingPoint& point : points)
        largest = std::max(largest, std::abs(point.value_deg) + point.bar_deg);
    const NiceScale scale = niceScale(largest, 2, 0.2);
    m_residuals->setPoints(std::move(points));
    const QRectF seen = m_main->view();
    m_strip->setBase(seen.left(), seen.right(), -scale.end, scale.end, scale.step);
    alignPlots();
    m_strip->replot();
}

void CurveChart::setEntries(const NiceScale& scale)
{
    entry(m_readingsEntry).present = !picture().readings.empty();
    entry(m_readingsEntry).title = picture().readingsTitle.isEmpty() ? tr("readings") : picture().readingsTitle;
    entry(m_approximateEntry).present = m_approximate->dataSize() > 0;
    entry(m_bandEntry).present = m_band->dataSize() > 0;
    entry(m_exactEntry).present = m_exact->dataSize() > 0;
    entry(m_previousEntry).present = m_previous->dataSize() > 0;
    entry(m_previousEntry).title = previousTitle(picture());
    entry(m_limitEntry).present = picture().limit_deg.has_value();
    entry(m_limitEntry).title = limitTitle(picture(), scale.end);
}

void CurveChart::setSelectedRow(int row)
{
    if (row == m_readings->selectedRow())
        return;
    m_readings->setSelectedRow(row);
    m_residuals->setSelectedRow(row);
    replotAll();
}

std::vector<QWidget*> CurveChart::canvases() const { return {m_main->canvas(), m_strip->canvas()}; }

bool CurveChart::isStrip(const QWidget* canvas) const { return canvas == m_strip->canvas(); }

std::vector<Chart::RowPlace> CurveChart::rowsOn(const QWidget* canvas) const
{
    const CartesianPlot& plot = isStrip(canvas) ? *m_strip : *m_main;
    const CartesianReadings& readings = isStrip(canvas) ? *m_residuals : *m_readings;
    return readings.isVisible() ? rowPlaces(plot, readings) : std::vector<RowPlace>();
}

QString CurveChart::readOutAt(const CanvasPlace& place) const
{
    const QPointF value = (isStrip(place.canvas) ? m_strip : m_main)->valueAt(place.at);
    if (value.x() < 0 || value.x() > 360)
        return {};
    return isStrip(place.canvas) ? residualReadOut(value.x(), value.y(), picture()) : placeReadOut(value.x(), value.y(), picture());
}

void CurveChart::zoomInto(const QWidget* canvas, const QRectF& rect)
{
    if (!isStrip(canvas)) {
        m_main->zoomInto(rect);
        return;
    }
    const QRectF seen = m_main->view(); // the strip's own scale stays: only the headings follow
    const double from = m_strip->valueAt(rect.topLeft()).x(), to = m_strip->valueAt(rect.bottomRight()).x();
    m_main->setView(QRectF(from, seen.top(), to - from, seen.height()));
}

void CurveChart::zoomAt(const CanvasPlace& place, double factor)
{
    m_main->zoomAt(isStrip(place.canvas) ? QPointF(place.at.x(), m_main->canvas()->height() / 2.0) : place.at, factor);
}

void CurveChart::panBy(const QWidget* canvas, const QPointF& by) { m_main->panBy(isStrip(canvas) ? QPointF(by.x(), 0) : by); }

void CurveChart::resetZoom() { m_main->resetZoom(); }

void CurveChart::takeView(const Chart& other)
{
    Chart::takeView(other);
    m_main->takeView(*static_cast<const CurveChart&>(other).m_main);
}

void CurveChart::styleItems()
{
    const LineLooks looks = lineLooks(colours());
    m_main->setLook(colours(), font());
    m_strip->setLook(colours(), font());
    m_readings->setLook(colours(), font());
    m_residuals->setLook(colours(), font());
    m_approximate->setPen(looks.approximate);
    m_exact->setPen(looks.exact);
    m_previous->setPen(looks.previous);
    m_band->setPen(QPen(Qt::NoPen));
    m_band->setBrush(colours().band);
    m_limit.setLook(colours());
    styleEntry(entry(m_readingsEntry), colours().readings, colours().readings);
    entry(m_approximateEntry).pen = looks.approximate;
    styleEntry(entry(m_bandEntry), colours().band, colours().band);
    entry(m_exactEntry).pen = looks.exact;
    entry(m_previousEntry).pen = looks.previous;
    styleEntry(entry(m_limitEntry), colours().limitEdge, colours().limit);
    alignPlots();
}

void CurveChart::alignPlots()
{
    // Below the strip, or below the curve when there is no strip, the headings are written once.
    m_main->axisScaleDraw(QwtAxis::XBottom)->enableComponent(QwtAbstractScaleDraw::Labels, !m_hasStrip);
    m_main->setAxisTitle(QwtAxis::XBottom, m_hasStrip ? QwtText() : m_strip->axisTitle(QwtAxis::XBottom));
    double widest = 0;
    for (CartesianPlot* plot : {m_main, m_strip}) {
        plot->updateAxes();
        plot->axisScaleDraw(QwtAxis::YLeft)->setMinimumExtent(0);
        widest = std::max(widest, plot->axisScaleDraw(QwtAxis::YLeft)->extent(plot->axisFont(QwtAxis::YLeft)));
    }
    for (CartesianPlot* plot : {m_main, m_strip}) {
        plot->axisScaleDraw(QwtAxis::YLeft)->setMinimumExtent(widest);
        plot->axisWidget(QwtAxis::YLeft)->setLabelRotation(0); // or its title would keep the place of the old extent
        plot->updateLayout();
    }
}

void CurveChart::fitTitles(double mainHeight, double stripHeight)
{
    const QFontMetricsF metrics(pixelFont(font()));
    const auto longest = [&metrics](const QStringList& titles, double room) {
        const auto fits
            = std::find_if(titles.begin(), titles.end(), [&](const QString& title) { return metrics.horizontalAdvance(title) <= room; });
        return fits == titles.end() ? titles.back() : *fits;
    };
    const double headings = m_strip->axisWidget(QwtAxis::XBottom)->sizeHint().height();
    m_main->setTitles(m_main->axisTitle(QwtAxis::XBottom).text(),
        longest({deviationAxisTitle(), tr("δ (°, east +)"), tr("δ (°)")}, mainHeight - (m_hasStrip ? 0.0 : headings)));
    m_strip->setTitles(headingAxisTitle(), longest({tr("residual (°)"), tr("res. (°)"), tr("res.")}, stripHeight - headings));
}

double CurveChart::stripHeight(double height) const
{
    return m_hasStrip ? std::min(std::max(kStripShare * height, kLeastStrip), kMostStripShare * height) : 0;
}

void CurveChart::layoutPlots(const QRect& rect)
{
    const int strip = static_cast<int>(stripHeight(rect.height()));
    fitTitles(rect.height() - strip, strip);
    m_main->setGeometry(rect.adjusted(0, 0, 0, -strip));
    m_strip->setGeometry(rect.left(), rect.bottom() + 1 - strip, rect.width(), strip);
    m_strip->setVisible(m_hasStrip);
}

void CurveChart::paintPlots(QPainter& painter, const QRectF& device)
{
    const double scale = static_cast<double>(painter.device()->logicalDpiY()) / logicalDpiY();
    const double strip = scale * stripHeight(device.height() / scale);
    fitTitles((device.height() - strip) / scale, strip / scale);
    replotAll();
    alignPlots();
    m_main->paintInto(painter, device.adjusted(0, 0, 0, -strip));
    if (m_hasStrip)
        m_strip->paintInto(painter, QRectF(device.left(), device.bottom() - strip, device.width(), strip));
}

void CurveChart::replotAll()
{
    m_main->replot();
    m_strip->replot();
}

} // namespace lubberline::ui
