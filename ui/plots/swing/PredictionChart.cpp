#include "ui/plots/swing/PredictionChart.h"

#include <algorithm>
#include <cmath>

#include <qwt_plot_curve.h>
#include <qwt_plot_intervalcurve.h>

#include "core/angle/AngleText.h"
#include "ui/plots/base/CartesianPlot.h"
#include "ui/plots/base/LineLooks.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

/// A curve round the compass, closed at 360; a point without deviation is passed over.
QPolygonF predictedSamples(const std::optional<Prediction>& prediction)
{
    QPolygonF samples;
    if (!prediction)
        return samples;
    for (const auto& point : prediction->points)
        if (point.deviation)
            samples.append({point.magnetic.degrees(), point.deviation->degrees()});
    if (!prediction->points.empty() && prediction->points.front().deviation)
        samples.append({360.0, prediction->points.front().deviation->degrees()});
    return samples;
}

QVector<QwtIntervalSample> bandOf(const std::optional<Prediction>& prediction)
{
    QVector<QwtIntervalSample> samples;
    if (!prediction || prediction->maxAbsPossible_rad <= prediction->maxAbs_rad)
        return samples;
    const auto add = [&samples](double heading_deg, const PredictedPoint& point) {
        if (point.deviation)
            samples.append(QwtIntervalSample(heading_deg, toDegrees(*point.lowest_rad), toDegrees(*point.highest_rad)));
    };
    for (const auto& point : prediction->points)
        add(point.magnetic.degrees(), point);
    if (!prediction->points.empty())
        add(360.0, prediction->points.front());
    return samples;
}

/// What the band rests on goes where the plot goes, to paper too.
QString bandTitle(const std::optional<Prediction>& prediction)
{
    if (!prediction || !prediction->assumed)
        return PredictionChart::tr("possible there");
    return PredictionChart::tr("possible there: %1 % if c, f ~ %2; P, Q ~ %3 nT; magnets ~ %4 nT")
        .arg(100 * kBoundProbability, 0, 'f', 0)
        .arg(prediction->assumed->verticalSoft)
        .arg(prediction->assumed->hardIron_nT, 0, 'f', 0)
        .arg(prediction->assumed->compensator_nT, 0, 'f', 0);
}

double largestPredicted(const PredictionPicture& picture)
{
    double largest = 0;
    if (picture.there)
        largest = std::max(picture.there->maxAbs_rad, picture.there->maxAbsPossible_rad);
    if (picture.here)
        largest = std::max(largest, picture.here->maxAbs_rad);
    return std::min(180.0, toDegrees(largest));
}

QString signedAngle(double angle_deg) { return shownAngle(angle_deg); }

} // namespace

PredictionChart::PredictionChart(QWidget* parent)
    : Chart(parent)
    , m_plot(new CartesianPlot(this))
    , m_limit(m_plot)
    , m_band(new QwtPlotIntervalCurve(tr("possible")))
{
    m_plot->setObjectName("predictionPlot");
    makeHeadingAxis(*m_plot);
    m_plot->setTitles(tr("magnetic heading (°)"), tr("deviation (°, east +)"));
    m_band->setZ(2);
    m_band->setStyle(QwtPlotIntervalCurve::Tube);
    m_band->setRenderHint(QwtPlotItem::RenderAntialiased);
    m_band->attach(m_plot);
    m_here = attachedCurve(m_plot, tr("here"), 20);
    m_there = attachedCurve(m_plot, tr("there"), 21);
    m_thereEntry = addEntry({tr("expected there")}, [this](bool on) { m_there->setVisible(on); });
    m_bandEntry = addEntry({tr("possible there"), LegendEntry::Key::Area}, [this](bool on) { m_band->setVisible(on); });
    m_hereEntry = addEntry({tr("here")}, [this](bool on) { m_here->setVisible(on); });
    m_limitEntry = addEntry({tr("limit"), LegendEntry::Key::Area}, [this](bool on) { m_limit.setShown(on); });
    styleItems();
    setPicture({});
}

void PredictionChart::setPicture(const PredictionPicture& picture)
{
    m_picture = picture;
    m_there->setSamples(predictedSamples(picture.there));
    m_here->setSamples(predictedSamples(picture.here));
    m_band->setSamples(bandOf(picture.there));
    m_limit.setLimit(picture.limit_deg);
    entry(m_thereEntry).present = m_there->dataSize() > 0;
    entry(m_hereEntry).present = m_here->dataSize() > 0;
    entry(m_bandEntry).present = m_band->dataSize() > 0;
    entry(m_bandEntry).title = bandTitle(picture.there);
    entry(m_limitEntry).present = picture.limit_deg.has_value();
    entry(m_limitEntry).title = picture.limit_deg ? tr("limit ±%1°").arg(*picture.limit_deg) : QString();
    const double largest = largestPredicted(picture);
    const NiceScale scale
        = niceScale(picture.limit_deg && *picture.limit_deg < 3 * largest ? std::max(largest, *picture.limit_deg) : largest);
    m_plot->setBase(0, 360, -scale.end, scale.end, scale.step);
    m_plot->setNotice(picture.there ? QString() : picture.notice);
    updateLegend();
    replotAll();
}

std::vector<QWidget*> PredictionChart::canvases() const { return {m_plot->canvas()}; }

QString PredictionChart::readOutAt(const CanvasPlace& place) const
{
    if (!m_picture.there || m_picture.there->points.empty())
        return {};
    const auto count = static_cast<double>(m_picture.there->points.size());
    const auto nearest
        = static_cast<std::size_t>(std::lround(wrap360(m_plot->valueAt(place.at).x()) / 360.0 * count)) % m_picture.there->points.size();
    const PredictedPoint& point = m_picture.there->points[nearest];
    const QString heading = tr("magnetic %1").arg(shownHeading(point.magnetic.degrees(), 0));
    if (!point.deviation)
        return heading + tr(" · the horizontal field vanishes");
    QString text = heading + tr(" · there %1").arg(signedAngle(point.deviation->degrees()));
    if (*point.highest_rad > *point.lowest_rad)
        text += tr(" (%1 … %2)").arg(signedAngle(toDegrees(*point.lowest_rad)), signedAngle(toDegrees(*point.highest_rad)));
    if (m_picture.here && nearest < m_picture.here->points.size() && m_picture.here->points[nearest].deviation)
        text += tr(" · here %1").arg(signedAngle(m_picture.here->points[nearest].deviation->degrees()));
    return text;
}

void PredictionChart::zoomInto(const QWidget*, const QRectF& rect) { m_plot->zoomInto(rect); }
void PredictionChart::zoomAt(const CanvasPlace& place, double factor) { m_plot->zoomAt(place.at, factor); }
void PredictionChart::panBy(const QWidget*, const QPointF& by) { m_plot->panBy(by); }
void PredictionChart::resetZoom() { m_plot->resetZoom(); }

void PredictionChart::takeView(const Chart& other)
{
    Chart::takeView(other);
    m_plot->takeView(*static_cast<const PredictionChart&>(other).m_plot);
}

void PredictionChart::styleItems()
{
    const LineLooks looks = lineLooks(colours());
    m_plot->setLook(colours(), font());
    m_there->setPen(looks.exact);
    m_here->setPen(looks.previous);
    m_band->setPen(QPen(Qt::NoPen));
    m_band->setBrush(colours().band);
    m_limit.setLook(colours());
    entry(m_thereEntry).pen = looks.exact;
    entry(m_hereEntry).pen = looks.previous;
    styleEntry(entry(m_bandEntry), colours().band, colours().band);
    styleEntry(entry(m_limitEntry), colours().limitEdge, colours().limit);
}

void PredictionChart::layoutPlots(const QRect& rect) { m_plot->setGeometry(rect); }

void PredictionChart::paintPlots(QPainter& painter, const QRectF& device)
{
    m_plot->replot();
    m_plot->paintInto(painter, device);
}

void PredictionChart::replotAll() { m_plot->replot(); }

} // namespace lubberline::ui
