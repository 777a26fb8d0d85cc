#include "ui/plots/series/SeriesChart.h"

#include <algorithm>
#include <cmath>

#include <qwt_plot_curve.h>
#include <qwt_symbol.h>

#include "ui/plots/base/CartesianLines.h"
#include "ui/plots/base/CartesianPlot.h"
#include "ui/plots/base/NiceScale.h"
#include "ui/text/NumberText.h"

namespace lubberline::ui {

namespace {

constexpr int kSteps = 1200;      ///< across the view: more than a screen has pixels for
constexpr int kMostDots = 20'000; ///< of a cloud

double xOf(const Series& series, std::size_t row) { return series.x ? (*series.x)[row] : static_cast<double>(row); }

/// The first row at or behind x, of a line whose x rises.
std::size_t rowAt(const Series& series, double x)
{
    if (!series.x)
        return static_cast<std::size_t>(std::clamp(std::ceil(x), 0.0, static_cast<double>(series.y->size())));
    return static_cast<std::size_t>(std::lower_bound(series.x->begin(), series.x->end(), x) - series.x->begin());
}

/// The largest and smallest of every step, in the order in which they come.
QPolygonF thinnedLine(const Series& series, double from, double to)
{
    QPolygonF points;
    std::size_t first = rowAt(series, from), last = std::min(rowAt(series, to) + 1, series.y->size());
    first = first > 0 ? first - 1 : 0;
    const std::size_t count = last > first ? last - first : 0;
    const auto add = [&](std::size_t row) {
        if (std::isfinite((*series.y)[row]))
            points.append({xOf(series, row), (*series.y)[row]});
    };
    if (count <= 2 * kSteps) {
        for (std::size_t row = first; row < last; ++row)
            add(row);
        return points;
    }
    for (int step = 0; step < kSteps; ++step) {
        const std::size_t begin = first + count * static_cast<std::size_t>(step) / kSteps;
        const std::size_t end = first + count * static_cast<std::size_t>(step + 1) / kSteps;
        std::size_t low = begin, high = begin;
        for (std::size_t row = begin; row < end; ++row) {
            if ((*series.y)[row] < (*series.y)[low] || std::isnan((*series.y)[low]))
                low = row;
            if ((*series.y)[row] > (*series.y)[high] || std::isnan((*series.y)[high]))
                high = row;
        }
        add(std::min(low, high));
        if (low != high)
            add(std::max(low, high));
    }
    return points;
}

QPolygonF thinnedDots(const Series& series)
{
    QPolygonF points;
    const std::size_t step = series.y->size() / kMostDots + 1;
    for (std::size_t row = 0; row < series.y->size(); row += step)
        if (std::isfinite((*series.y)[row]) && std::isfinite(xOf(series, row)))
            points.append({xOf(series, row), (*series.y)[row]});
    return points;
}

struct Range {
    double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
    void take(double value)
    {
        if (!std::isfinite(value))
            return;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    [[nodiscard]] bool empty() const { return low > high; }
};

} // namespace

SeriesChart::SeriesChart(QWidget* parent) : Chart(parent), m_plot(new CartesianPlot(this))
{
    for (int i = 0; i < kMostSeries; ++i) {
        auto* curve = attachedCurve(m_plot, {}, 10 + i);
        m_curves.push_back(curve);
        m_entries.push_back(addEntry({}, [this, curve](bool shown) {
            curve->setVisible(shown);
            m_plot->replot();
        }));
    }
    connect(m_plot, &CartesianPlot::viewChanged, this, &SeriesChart::thin);
}

void SeriesChart::setPicture(const SeriesPicture& picture)
{
    m_picture = picture;
    m_plot->setTitles(picture.xTitle, picture.yTitle);
    Range x, y;
    for (const auto& series : picture.series) {
        for (const double value : *series.y)
            y.take(value);
        if (!series.x) {
            x.take(0);
            x.take(static_cast<double>(series.y->size()));
        } else {
            for (const double value : *series.x)
                x.take(value);
        }
    }
    const bool nothing = x.empty() || y.empty();
    m_plot->setNotice(nothing ? picture.notice : QString());
    if (nothing) {
        x = {0, 1};
        y = {-1, 1};
    }
    const double step = niceStep(std::max(y.high - y.low, 1e-9) / 6);
    const double low = std::floor(y.low / step) * step, high = std::max(std::ceil(y.high / step) * step, low + step);
    m_plot->setBase(x.low, x.high > x.low ? x.high : x.low + 1, low, high, step);
    for (int i = 0; i < kMostSeries; ++i) {
        const auto at = static_cast<std::size_t>(i);
        entry(m_entries[at]).title = at < picture.series.size() ? picture.series[at].title : QString();
        entry(m_entries[at]).present = at < picture.series.size();
    }
    thin();
    updateLegend();
    styleItems();
    replotAll();
}

QRectF SeriesChart::view() const { return m_plot->view(); }
bool SeriesChart::zoomed() const { return m_plot->zoomed(); }
std::size_t SeriesChart::drawnPoints(int series) const { return m_curves[static_cast<std::size_t>(series)]->dataSize(); }

void SeriesChart::thin()
{
    const QRectF view = m_plot->view();
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        if (i >= m_picture.series.size())
            m_curves[i]->setSamples(QPolygonF());
        else if (const Series& series = m_picture.series[i]; series.dots)
            m_curves[i]->setSamples(thinnedDots(series));
        else
            m_curves[i]->setSamples(thinnedLine(series, view.left(), view.right()));
    }
}

std::vector<QWidget*> SeriesChart::canvases() const { return {m_plot->canvas()}; }

QString SeriesChart::readOutAt(const CanvasPlace& place) const
{
    const double x = m_plot->valueAt(place.at).x();
    QString text = QStringLiteral("%1 %2").arg(plainNumber(x, 2), m_picture.xUnit);
    for (const auto& series : m_picture.series) {
        if (series.dots)
            continue;
        const std::size_t row = rowAt(series, x);
        if (row < series.y->size() && std::isfinite((*series.y)[row]))
            text += QStringLiteral(" · %1 %2 %3").arg(series.title, plainNumber((*series.y)[row], 1), m_picture.yUnit);
    }
    return text;
}

void SeriesChart::zoomInto(const QWidget*, const QRectF& rect) { m_plot->zoomInto(rect); }
void SeriesChart::zoomAt(const CanvasPlace& place, double factor) { m_plot->zoomAt(place.at, factor); }
void SeriesChart::panBy(const QWidget*, const QPointF& by) { m_plot->panBy(by); }
void SeriesChart::resetZoom() { m_plot->resetZoom(); }

void SeriesChart::takeView(const Chart& other)
{
    Chart::takeView(other);
    m_plot->takeView(*static_cast<const SeriesChart&>(other).m_plot);
    thin();
}

void SeriesChart::styleItems()
{
    m_plot->setLook(colours(), font());
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        const QColor colour = colours().coefficient[i + 1];
        const bool dots = i < m_picture.series.size() && m_picture.series[i].dots;
        m_curves[i]->setStyle(dots ? QwtPlotCurve::NoCurve : QwtPlotCurve::Lines);
        m_curves[i]->setPen(QPen(colour, 1));
        m_curves[i]->setSymbol(
            dots ? new QwtSymbol(i == 0 ? QwtSymbol::Ellipse : QwtSymbol::Diamond, colour, QPen(colour), QSize(4, 4)) : nullptr);
        entry(m_entries[i]).pen = QPen(colour, dots ? 4 : 2);
    }
}

void SeriesChart::layoutPlots(const QRect& rect) { m_plot->setGeometry(rect); }

void SeriesChart::paintPlots(QPainter& painter, const QRectF& device)
{
    m_plot->replot();
    m_plot->paintInto(painter, device);
}

void SeriesChart::replotAll() { m_plot->replot(); }

} // namespace lubberline::ui
