#include "ui/plots/swing/HistoryChart.h"

#include <QStringList>

#include <algorithm>
#include <cmath>

#include <qwt_date.h>
#include <qwt_date_scale_draw.h>
#include <qwt_date_scale_engine.h>
#include <qwt_plot_curve.h>
#include <qwt_symbol.h>
#include <qwt_text.h>

#include "core/angle/AngleText.h"
#include "ui/plots/base/CartesianLines.h"
#include "ui/plots/base/CartesianPlot.h"
#include "ui/plots/base/LineLooks.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

constexpr double kDay_ms = 86'400'000.0;
constexpr std::array kSymbols{
    QwtSymbol::Ellipse, QwtSymbol::Rect, QwtSymbol::Diamond, QwtSymbol::UTriangle, QwtSymbol::DTriangle, QwtSymbol::Star1};

double when_ms(QDate date) { return QwtDate::toDouble(QDateTime(date, QTime(12, 0), Qt::UTC)); }

std::optional<double> valueOf(const HistoryPoint& point, std::size_t series)
{
    const auto value = series < point.coefficient_deg.size() ? point.coefficient_deg[series] : point.maxAbsDeviation_deg;
    return value && std::isfinite(*value) ? value : std::nullopt;
}

QString seriesName(std::size_t series)
{
    return series < kCoefficientCount ? QString(QChar::fromLatin1(letterOf(static_cast<Coefficient>(series))))
                                      : HistoryChart::tr("largest |deviation|");
}

QPolygonF samplesOf(const std::vector<HistoryPoint>& points, std::size_t series)
{
    QPolygonF samples;
    for (const HistoryPoint& point : points) {
        if (const auto value = valueOf(point, series))
            samples.append({when_ms(point.date), *value});
    }
    return samples;
}

double largestOf(const std::vector<HistoryPoint>& points)
{
    double largest = 0;
    for (const HistoryPoint& point : points) {
        for (std::size_t series = 0; series <= kCoefficientCount; ++series)
            largest = std::max(largest, std::abs(valueOf(point, series).value_or(0)));
    }
    return largest;
}

void makeDateAxis(CartesianPlot& plot)
{
    auto* draw = new QwtDateScaleDraw(Qt::UTC);
    draw->setDateFormat(QwtDate::Year, "yyyy");
    draw->setDateFormat(QwtDate::Month, "yyyy-MM");
    draw->setDateFormat(QwtDate::Week, "yyyy-MM-dd");
    draw->setDateFormat(QwtDate::Day, "yyyy-MM-dd");
    plot.setAxisScaleDraw(QwtAxis::XBottom, draw);
    plot.setAxisScaleEngine(QwtAxis::XBottom, new QwtDateScaleEngine(Qt::UTC));
    plot.setAxisMaxMajor(QwtAxis::XBottom, 6);
}

} // namespace

HistoryChart::HistoryChart(QWidget* parent) : Chart(parent), m_plot(new CartesianPlot(this)), m_limit(m_plot)
{
    m_plot->setObjectName("historyPlot");
    makeDateAxis(*m_plot);
    m_plot->setTitles(tr("date of the swing"), tr("coefficient, deviation (°)"));
    for (std::size_t series = 0; series < m_series.size(); ++series) {
        QwtPlotCurve* curve = attachedCurve(m_plot, seriesName(series), 20 + static_cast<double>(series) / 10);
        m_series[series] = curve;
        m_entries[series] = addEntry({seriesName(series)}, [curve](bool on) { curve->setVisible(on); });
    }
    m_limitEntry = addEntry({tr("limit"), LegendEntry::Key::Area}, [this](bool on) { m_limit.setShown(on); });
    styleItems();
    setHistory({}, {});
}

void HistoryChart::setHistory(const std::vector<HistoryPoint>& points, std::optional<double> limit_deg)
{
    m_points.clear();
    std::copy_if(points.begin(), points.end(), std::back_inserter(m_points), [](const HistoryPoint& p) { return p.date.isValid(); });
    std::stable_sort(m_points.begin(), m_points.end(), [](const auto& a, const auto& b) { return a.date < b.date; });
    for (std::size_t series = 0; series < m_series.size(); ++series) {
        m_series[series]->setSamples(samplesOf(m_points, series));
        entry(m_entries[series]).present = m_series[series]->dataSize() > 0;
    }
    const double largest = largestOf(m_points);
    const NiceScale scale = niceScale(limit_deg && *limit_deg < 3 * largest ? std::max(largest, *limit_deg) : largest);
    m_limit.setLimit(limit_deg);
    entry(m_limitEntry).present = limit_deg.has_value();
    entry(m_limitEntry).title = limit_deg ? tr("limit ±%1°").arg(*limit_deg) : QString();

    const double now = when_ms(QDate(2000, 1, 1)); // of an empty plot
    const double from = m_points.empty() ? now : when_ms(m_points.front().date);
    const double to = m_points.empty() ? now : when_ms(m_points.back().date);
    const double room = std::max(0.03 * (to - from), 30 * kDay_ms);
    m_plot->setBase(from - room, to + room, -scale.end, scale.end, scale.step);
    m_plot->setAxisVisible(QwtAxis::XBottom, !m_points.empty());
    m_plot->setNotice(m_points.empty() ? tr("No swings with results yet.") : QString());
    updateLegend();
    replotAll();
}

std::vector<QWidget*> HistoryChart::canvases() const { return {m_plot->canvas()}; }

std::vector<Chart::RowPlace> HistoryChart::rowsOn(const QWidget*) const
{
    std::vector<RowPlace> places;
    for (const HistoryPoint& point : m_points) {
        for (std::size_t series = 0; series < m_series.size(); ++series) {
            const auto value = valueOf(point, series);
            if (value && m_series[series]->isVisible())
                places.push_back({point.swing, m_plot->pixelOf({when_ms(point.date), *value})});
        }
    }
    return places;
}

QString HistoryChart::readOutOfRow(int swing) const
{
    const auto isIt = [swing](const HistoryPoint& point) { return point.swing == swing; };
    const auto found = std::find_if(m_points.begin(), m_points.end(), isIt);
    if (found == m_points.end())
        return {};
    QStringList parts{found->date.toString(Qt::ISODate)};
    for (std::size_t series = 0; series < m_series.size(); ++series) {
        if (const auto value = valueOf(*found, series))
            parts += seriesName(series) + " " + shownAngle(*value);
    }
    return parts.join(QStringLiteral(" · "));
}

QString HistoryChart::readOutAt(const CanvasPlace& place) const
{
    if (m_points.empty())
        return {};
    const QPointF value = m_plot->valueAt(place.at);
    return QwtDate::toDateTime(value.x(), Qt::UTC).date().toString(Qt::ISODate) + QStringLiteral(" · ") + shownAngle(value.y());
}

void HistoryChart::zoomInto(const QWidget*, const QRectF& rect) { m_plot->zoomInto(rect); }
void HistoryChart::zoomAt(const CanvasPlace& place, double factor) { m_plot->zoomAt(place.at, factor); }
void HistoryChart::panBy(const QWidget*, const QPointF& by) { m_plot->panBy(by); }
void HistoryChart::resetZoom() { m_plot->resetZoom(); }

void HistoryChart::takeView(const Chart& other)
{
    Chart::takeView(other);
    m_plot->takeView(*static_cast<const HistoryChart&>(other).m_plot);
}

void HistoryChart::styleItems()
{
    m_plot->setLook(colours(), font());
    for (std::size_t series = 0; series < m_series.size(); ++series) {
        QPen pen = series < kLargest ? componentPen(colours(), series) : QPen(colours().text, 2.2);
        m_series[series]->setPen(pen);
        entry(m_entries[series]).pen = pen;
        pen.setStyle(Qt::SolidLine);
        m_series[series]->setSymbol(new QwtSymbol(kSymbols[series], pen.color(), pen, QSize(8, 8))); // the curve owns it
    }
    m_limit.setLook(colours());
    styleEntry(entry(m_limitEntry), colours().limitEdge, colours().limit);
}

void HistoryChart::layoutPlots(const QRect& rect)
{
    m_plot->setGeometry(rect);
    const int date = QFontMetrics(font()).horizontalAdvance(QStringLiteral("0000-00-00  ")); // side by side, not into each other
    m_plot->setAxisMaxMajor(QwtAxis::XBottom, std::clamp(rect.width() / date - 1, 1, 6));
}

void HistoryChart::paintPlots(QPainter& painter, const QRectF& device)
{
    m_plot->replot();
    m_plot->paintInto(painter, device);
}

void HistoryChart::replotAll() { m_plot->replot(); }

} // namespace lubberline::ui
