#include "ui/plots/base/HeadingScale.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

#include <qwt_text.h>

namespace lubberline::ui {

namespace {

constexpr int kMostTicks = 9;
constexpr double kLabelGap_px = 4;

QList<double> multiplesWithin(double from, double to, double step)
{
    QList<double> multiples;
    for (double i = std::ceil(from / step - 1e-9); i * step <= to + 1e-9 * step; i += 1)
        multiples.append(i * step);
    return multiples;
}

struct Steps {
    double major, minor;
};

Steps stepsFor(double range)
{
    for (const Steps& steps : {Steps{1, 0.5}, {2, 1}, {5, 1}, {10, 5}, {15, 5}, {30, 10}}) {
        if (range / steps.major <= kMostTicks)
            return steps;
    }
    return {45, 15};
}

} // namespace

QwtScaleDiv HeadingScaleEngine::divideScale(double from, double to, int, int, double) const
{
    const auto [low, high] = std::minmax(from, to);
    const Steps steps = stepsFor(high - low);
    return QwtScaleDiv(low, high, multiplesWithin(low, high, steps.minor), {}, multiplesWithin(low, high, steps.major));
}

/// How many ticks a label is for, that none of them touches the next.
int CentredScaleDraw::ticksPerLabel(const QFont& font) const
{
    const auto ticks = scaleDiv().ticks(QwtScaleDiv::MajorTick);
    if (orientation() != Qt::Horizontal || ticks.size() < 3)
        return 1;
    double widest_px = 0;
    for (const double tick : ticks)
        widest_px = std::max(widest_px, label(tick).textSize(font).width());
    const double step_px = std::abs(scaleMap().transform(ticks[1]) - scaleMap().transform(ticks[0]));
    int each = 1;
    while (each < ticks.size() && each * step_px < widest_px + kLabelGap_px)
        each *= 2; // every second of eight points are the cardinals
    return each;
}

void CentredScaleDraw::drawLabel(QPainter* painter, double value) const
{
    const auto ticks = scaleDiv().ticks(QwtScaleDiv::MajorTick);
    if (ticks.indexOf(value) % ticksPerLabel(painter->font()) != 0)
        return;
    QwtText text = tickLabel(painter->font(), value);
    if (text.isEmpty())
        return;
    const QSizeF size = text.textSize(painter->font());
    painter->save();
    painter->setWorldTransform(labelTransformation(labelPosition(value), size), true);
    text.setRenderFlags(Qt::AlignHCenter | Qt::AlignTop);
    text.draw(painter, QRectF(QPointF(), size));
    painter->restore();
}

QString pointName(int heading_deg)
{
    static const std::array<QString, 8> kNames{"N", "NE", "E", "SE", "S", "SW", "W", "NW"};
    return heading_deg % 45 == 0 ? kNames[static_cast<std::size_t>(heading_deg / 45 % 8)] : QString();
}

QwtText HeadingScaleDraw::label(double heading_deg) const
{
    const int whole_deg = static_cast<int>(std::lround(heading_deg));
    const QString digits = QStringLiteral("%1").arg(whole_deg, 3, 10, QChar('0'));
    const QString name = pointName(whole_deg);
    return name.isEmpty() ? digits : digits + "\n" + name;
}

} // namespace lubberline::ui
