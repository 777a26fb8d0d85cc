#include "ui/plots/map/ColourBar.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

#include "ui/plots/map/DivergingMap.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

constexpr double kBar = 14, kBarTick = 4, kBarGap = 3;
constexpr int kBands = 128; ///< rectangles, not a gradient: the same on every device

double tickWidth(const ColourBar& bar, const QFont& font)
{
    return QFontMetricsF(font).horizontalAdvance(angleTick(-bar.scale.end, bar.scale.step)) + kBarTick + kBarGap;
}

void paintBands(QPainter& painter, const QRectF& bar)
{
    painter.setRenderHint(QPainter::Antialiasing, false); // no seams
    for (int i = 0; i < kBands; ++i) {
        const double top = bar.top() + bar.height() * i / kBands;
        const double fraction = 1 - (2.0 * i + 1) / kBands;
        painter.fillRect(QRectF(bar.left(), top, bar.width(), bar.bottom() - top), divergingColour(fraction));
    }
}

} // namespace

double colourBarWidth(const ColourBar& bar, const QFont& font)
{
    return kBar + tickWidth(bar, font) + QFontMetricsF(font).height() + 2 * kBarGap;
}

void paintColourBar(QPainter& painter, const QRectF& rect, const ColourBar& bar, const PlotColours& colours, const QFont& font)
{
    painter.save();
    painter.setFont(font);
    const QFontMetricsF metrics(font);
    const QRectF strip = QRectF(rect.left(), rect.top(), kBar, rect.height()).adjusted(0, metrics.height() / 2, 0, -metrics.height() / 2);
    paintBands(painter, strip);
    painter.setPen(QPen(colours.axis, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(strip);
    const auto height = [&](double value_deg) { return strip.center().y() - value_deg / bar.scale.end * strip.height() / 2; };
    for (int i = -10; i <= 10; ++i) {
        const double value_deg = i * bar.scale.step;
        if (std::abs(value_deg) > bar.scale.end * (1 + 1e-9))
            continue;
        const double y = height(value_deg);
        painter.setPen(QPen(colours.axis, 1));
        painter.drawLine(QPointF(strip.right(), y), QPointF(strip.right() + kBarTick, y));
        painter.setPen(colours.text);
        const QRectF room(strip.right() + kBarTick + kBarGap, y - metrics.height() / 2, tickWidth(bar, font), metrics.height());
        painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter, angleTick(value_deg, bar.scale.step));
    }
    if (bar.limit_deg && *bar.limit_deg <= bar.scale.end) {
        painter.setPen(QPen(inkOnMap(), 2.6));
        for (const double y : {height(*bar.limit_deg), height(-*bar.limit_deg)})
            painter.drawLine(QPointF(strip.left(), y), QPointF(strip.right(), y));
    }
    painter.setPen(colours.text);
    painter.translate(strip.right() + tickWidth(bar, font) + kBarGap, strip.center().y());
    painter.rotate(90);
    painter.drawText(QRectF(-rect.height() / 2, -metrics.height(), rect.height(), metrics.height()), Qt::AlignCenter, bar.title);
    painter.restore();
}

} // namespace lubberline::ui
