#include "ui/plots/swing/SpectrumChart.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

#include <qwt_plot_curve.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_engine.h>
#include <qwt_scale_map.h>
#include <qwt_text.h>

#include "ui/plots/base/CartesianLines.h"
#include "ui/plots/base/CartesianPlot.h"
#include "ui/plots/base/HeadingScale.h"
#include "ui/plots/base/LineLooks.h"
#include "ui/plots/swing/PictureText.h"
#include "ui/plots/swing/SpectrumBars.h"

namespace lubberline::ui {

namespace {

constexpr int kLeastLastOrder = 12; ///< hatched up to here when the headings resolve fewer
constexpr int kMostOrders = 60;     ///< drawn: of a log there are thousands, and higher ones say nothing of a compass

/// Whole orders only, with "A", "B/C", "D/E" beneath: in two or three lines where the orders stand close. Figures that would touch are left out.
class OrderScaleDraw : public CentredScaleDraw {
public:
    void setFont(const QFont& font) { m_font = font; }
    [[nodiscard]] QwtText label(double order) const override
    {
        const int whole = static_cast<int>(std::lround(order));
        const QFontMetricsF metrics(m_font);
        const double room = length() / std::max(1.0, std::abs(scaleDiv().range()));
        const int every = room <= 0 ? 1 : static_cast<int>(std::ceil((metrics.horizontalAdvance(QStringLiteral("00")) + 4) / room));
        const QString number = whole % std::max(1, every) == 0 || (whole <= 2 && every <= 2) ? QString::number(whole) : QString();
        const QString name = orderName(whole);
        if (name.isEmpty())
            return number;
        // Beneath each other where they would touch: the next one, and of many orders the one after it, too.
        const double width = metrics.horizontalAdvance(QStringLiteral("D/E")) + 4;
        const int line = whole == 1 && width > room ? 2 : whole == 2 && width > 2 * room ? 3 : 1;
        return number + QString(line, u'\n') + name;
    }

private:
    QFont m_font = paperFont();
};

class OrderScaleEngine : public QwtLinearScaleEngine {
public:
    [[nodiscard]] QwtScaleDiv divideScale(double from, double to, int, int, double) const override
    {
        const auto [low, high] = std::minmax(from, to);
        const int every = high - low > 20 ? 2 : 1;
        QList<double> orders;
        for (int order = static_cast<int>(std::ceil(low)); order <= high; ++order) {
            if (order % every == 0 || order <= 2)
                orders.append(order);
        }
        return QwtScaleDiv(low, high, {}, {}, orders);
    }
};

class PlainScaleDraw : public QwtScaleDraw {
public:
    [[nodiscard]] QwtText label(double value) const override
    {
        const QList<double> ticks = scaleDiv().ticks(QwtScaleDiv::MajorTick);
        return plainTick(value, ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0);
    }
};

int lastOrder(const Harmonics& harmonics)
{
    const int found = std::min(static_cast<int>(harmonics.orders.size()) - 1, kMostOrders);
    if (found < harmonics.highestResolvable)
        return found; // cut short on request: what follows is neither drawn nor called unresolved
    return std::max(found, kLeastLastOrder);
}

std::vector<SpectrumBar> barsOf(const Harmonics& harmonics)
{
    std::vector<SpectrumBar> bars;
    for (const HarmonicOrder& order : harmonics.orders)
        if (order.order <= kMostOrders)
            bars.push_back({order.order, toDegrees(order.amplitude_rad()), order.nyquist});
    return bars;
}

double highest(const std::vector<SpectrumBar>& bars, double noise_deg)
{
    double most = noise_deg;
    for (const SpectrumBar& bar : bars)
        most = std::max(most, bar.amplitude_deg);
    return most;
}

bool hasNyquist(const std::vector<SpectrumBar>& bars)
{
    return std::any_of(bars.begin(), bars.end(), [](const SpectrumBar& bar) { return bar.nyquist; });
}

} // namespace

SpectrumChart::SpectrumChart(QWidget* parent)
    : CartesianChart(parent)
    , m_bars(new SpectrumBars)
    , m_noise(attachedCurve(&plot(), tr("noise floor (95 %)"), 25))
{
    plot().setObjectName("spectrumPlot");
    plot().setAxisScaleEngine(QwtAxis::XBottom, new OrderScaleEngine);
    plot().setAxisScaleDraw(QwtAxis::XBottom, new OrderScaleDraw);
    plot().setAxisScaleDraw(QwtAxis::YLeft, new PlainScaleDraw);
    plot().setTitles(tr("order of the harmonic (per turn)"), tr("amplitude (°)"));
    m_bars->attach(&plot());
    m_barsEntry = addEntry({tr("amplitude"), LegendEntry::Key::Bar}, [this](bool on) { m_bars->setVisible(on); });
    m_nyquistEntry = addEntry({tr("cosine only"), LegendEntry::Key::Bar}, [this](bool on) { m_bars->setNyquistShown(on); });
    m_noiseEntry = addEntry({tr("noise floor (95 %)")}, [this](bool on) { m_noise->setVisible(on); });
    m_hatchEntry = addEntry({tr("not resolved by these headings"), LegendEntry::Key::Area}, [this](bool on) { m_bars->setHatchShown(on); });
    styleItems();
    setPicture({});
}

void SpectrumChart::setPicture(const SwingPicture& picture)
{
    keepPicture(picture);
    const Harmonics none{HarmonicsMethod::Fft, kLeastLastOrder, 1, {}, {}};
    const Harmonics& harmonics = picture.analysis ? picture.analysis->harmonics : none;
    const int last = picture.analysis ? lastOrder(harmonics) : kLeastLastOrder;
    std::vector<SpectrumBar> bars = barsOf(harmonics);
    const double noise_deg = toDegrees(harmonics.noiseFloor_rad.value_or(0));
    const NiceScale scale = niceScale(1.06 * highest(bars, noise_deg), 5, 0.5);
    m_noise->setSamples(harmonics.noiseFloor_rad ? QPolygonF(QList<QPointF>{{-0.6, noise_deg}, {last + 0.6, noise_deg}}) : QPolygonF());

    entry(m_barsEntry).present = !bars.empty();
    entry(m_nyquistEntry).present = hasNyquist(bars);
    entry(m_noiseEntry).present = harmonics.noiseFloor_rad.has_value();
    entry(m_hatchEntry).present = last > harmonics.highestResolvable;
    m_bars->setNoise(harmonics.noiseFloor_rad ? std::optional(noise_deg) : std::nullopt);
    m_bars->setBars(std::move(bars), harmonics.highestResolvable, last);
    plot().setBase(-0.6, last + 0.6, 0, scale.end, scale.step);
    plot().setNotice(noticeFor(picture));
    updateLegend();
    replotAll();
}

QString SpectrumChart::readOutAt(const CanvasPlace& place) const
{
    return orderReadOut(static_cast<int>(std::lround(plot().valueAt(place.at).x())), picture());
}

void SpectrumChart::styleItems()
{
    CartesianChart::styleItems();
    const LineLooks looks = lineLooks(colours());
    m_bars->setLook(colours(), font());
    static_cast<OrderScaleDraw*>(plot().axisScaleDraw(QwtAxis::XBottom))->setFont(pixelFont(font()));
    m_noise->setPen(looks.noise);
    styleEntry(entry(m_barsEntry), colours().approximate, colours().approximate);
    styleEntry(entry(m_nyquistEntry), colours().approximate, colours().band);
    entry(m_noiseEntry).pen = looks.noise;
    styleEntry(entry(m_hatchEntry), colours().hatch, QBrush(colours().hatch, Qt::BDiagPattern));
}

} // namespace lubberline::ui
