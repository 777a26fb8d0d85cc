#include "ui/plots/swing/SpectrumBars.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>

#include <qwt_scale_map.h>

#include "ui/plots/base/Chart.h"

namespace lubberline::ui {

namespace {

constexpr double kHalfBar = 0.32; ///< in orders
constexpr double kHatchSpacing = 7;

} // namespace

SpectrumBars::SpectrumBars()
{
    setZ(10);
    setRenderHint(RenderAntialiased);
}

void SpectrumBars::setBars(std::vector<SpectrumBar> bars, int highestResolvable, int last)
{
    m_bars = std::move(bars);
    m_highestResolvable = highestResolvable;
    m_last = last;
}

void SpectrumBars::setLook(const PlotColours& colours, const QFont& font)
{
    m_colours = colours;
    m_font = pixelFont(font);
}

void SpectrumBars::draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& yMap, const QRectF& canvasRect) const
{
    painter->setRenderHint(QPainter::Antialiasing);
    if (m_hatchShown && m_last > m_highestResolvable)
        drawHatch(*painter, xMap, canvasRect);
    for (const SpectrumBar& bar : m_bars) {
        if (!bar.nyquist || m_nyquistShown) {
            drawBar(*painter, bar, xMap, yMap);
            drawValue(*painter, bar, xMap, yMap);
        }
    }
}

/// By lines of our own, cut by their ends: a brush pattern would be a raster image on paper, and SVG files know no clipping.
void SpectrumBars::drawHatch(QPainter& painter, const QwtScaleMap& xMap, const QRectF& canvasRect) const
{
    painter.save();
    const double from = xMap.transform(m_highestResolvable + 0.5), to = xMap.transform(m_last + 0.5);
    const QRectF area = QRectF(QPointF(from, canvasRect.top()), QPointF(to, canvasRect.bottom())).intersected(canvasRect);
    painter.setPen(QPen(m_colours.hatch, 0.8));
    for (double x = area.left() - area.height(); x < area.right(); x += kHatchSpacing) {
        const double left = std::max(x, area.left()), right = std::min(x + area.height(), area.right());
        painter.drawLine(QPointF(left, area.bottom() - (left - x)), QPointF(right, area.bottom() - (right - x)));
    }
    painter.restore();
}

void SpectrumBars::drawBar(QPainter& painter, const SpectrumBar& bar, const QwtScaleMap& xMap, const QwtScaleMap& yMap) const
{
    const QRectF rect(QPointF(xMap.transform(bar.order - kHalfBar), yMap.transform(bar.amplitude_deg)),
        QPointF(xMap.transform(bar.order + kHalfBar), yMap.transform(0)));
    painter.setPen(QPen(m_colours.approximate, 1));
    painter.setBrush(bar.nyquist ? m_colours.band : m_colours.approximate);
    painter.drawRect(rect);
}

/// Above the bar, where there is room for it.
void SpectrumBars::drawValue(QPainter& painter, const SpectrumBar& bar, const QwtScaleMap& xMap, const QwtScaleMap& yMap) const
{
    const QString value = QString::number(bar.amplitude_deg, 'f', 2);
    const QFontMetricsF metrics(m_font);
    const double room = xMap.transform(1) - xMap.transform(0);
    QRectF place(0, 0, metrics.horizontalAdvance(value) + 4, metrics.height());
    if (place.width() > room)
        return;
    place.moveCenter({xMap.transform(bar.order), 0});
    place.moveBottom(yMap.transform(bar.amplitude_deg) - 1);
    if (m_noise_deg)
        if (const double line = yMap.transform(*m_noise_deg); place.top() < line + 2 && place.bottom() > line - 2)
            place.moveBottom(line - 2);
    painter.setFont(m_font);
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_colours.ground);
    painter.drawRect(place);
    painter.setPen(m_colours.text);
    painter.drawText(place, Qt::AlignCenter | Qt::TextSingleLine, value);
}

} // namespace lubberline::ui
