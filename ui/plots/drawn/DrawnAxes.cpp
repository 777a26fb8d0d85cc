#include "ui/plots/drawn/DrawnAxes.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

#include "ui/plots/base/NiceScale.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

double partOf(const DrawnScale& scale, double value)
{
    if (!scale.logarithmic)
        return (value - scale.from) / (scale.to - scale.from);
    return std::log(std::max(value, scale.from * 1e-6) / scale.from) / std::log(scale.to / scale.from);
}

double valueOf(const DrawnScale& scale, double part)
{
    return scale.logarithmic ? scale.from * std::pow(scale.to / scale.from, part) : scale.from + part * (scale.to - scale.from);
}

struct Tick {
    double value;
    QString text;
};

std::vector<Tick> ticksOf(const DrawnScale& scale, double most)
{
    std::vector<Tick> ticks;
    if (scale.logarithmic) {
        const int first = static_cast<int>(std::ceil(std::log10(scale.from) - 1e-9));
        const int last = static_cast<int>(std::floor(std::log10(scale.to) + 1e-9)), every = std::max(1, int((last - first) / most) + 1);
        for (int decade = first; decade <= last; decade += every)
            ticks.push_back({std::pow(10.0, decade), QString::number(std::pow(10.0, decade), 'g', 6)});
        return ticks;
    }
    double step = 45;
    if (!scale.headings)
        step = niceStep((scale.to - scale.from) / std::max(most, 1.0));
    else if (most < 8)
        step = 90;
    for (double i = std::ceil(scale.from / step - 1e-9); i * step <= scale.to + 1e-9 * step; ++i)
        ticks.push_back({i * step,
            scale.headings                                     ? QStringLiteral("%1").arg(i * step, 3, 'f', 0, QChar('0'))
                : scale.withSign && scale.title.contains(u'°') ? angleTick(i * step, step)
                : scale.withSign                               ? signedTick(i * step, step)
                                                               : plainTick(i * step, step)});
    return ticks;
}

} // namespace

DrawnScale scaleAbout0(double most, double floor, QString title)
{
    const NiceScale scale = niceScale(most, 4, floor);
    return {-scale.end, scale.end, std::move(title), false, true, false};
}

DrawnScale scaleFrom0(double most, double floor, QString title) { return {0, niceScale(most, 5, floor).end, std::move(title)}; }

DrawnScale decades(double least, double most, QString title)
{
    const double from = std::pow(10.0, std::floor(std::log10(least))), to = std::pow(10.0, std::ceil(std::log10(most)));
    return {from, std::max(to, 10 * from), std::move(title), true};
}

DrawnAxes::DrawnAxes(const QRectF& rect, const QFont& font, DrawnScale x, DrawnScale y)
    : m_rect(rect)
    , m_x(std::move(x))
    , m_y(std::move(y))
    , m_line(QFontMetricsF(font).height())
{
    if (!(m_x.to > m_x.from))
        m_x.to = m_x.from + 1;
    if (!(m_y.to > m_y.from))
        m_y.to = m_y.from + 1;
    const QFontMetricsF metrics(font);
    double wide = metrics.horizontalAdvance(QStringLiteral("+00.0"));
    for (const Tick& tick : ticksOf(m_y, 8))
        wide = std::max(wide, metrics.horizontalAdvance(tick.text));
    const auto more = [&](const QString& title) { // what is wider than the picture goes on below
        return metrics.boundingRect(QRectF(0, 0, rect.width(), 9 * m_line), Qt::TextWordWrap, title).height() - m_line;
    };
    // Beginning left of the axis it stands above the highest figure, too.
    m_aboveAxis = metrics.horizontalAdvance(m_y.title) > rect.width() - wide - 0.9 * m_line;
    const double top = 1.7 * m_line + more(m_y.title) + (m_aboveAxis ? 0.5 * m_line : 0.0);
    m_inside = rect.adjusted(wide + 0.9 * m_line, top, -1.5 * m_line, -2.5 * m_line - more(m_x.title));
    m_inside.setWidth(std::max(m_inside.width(), 1.0));
    m_inside.setHeight(std::max(m_inside.height(), 1.0));
}

QPointF DrawnAxes::at(double x, double y) const
{
    return {m_inside.left() + partOf(m_x, x) * m_inside.width(), m_inside.bottom() - partOf(m_y, y) * m_inside.height()};
}

QPointF DrawnAxes::valueAt(const QPointF& at) const
{
    return {valueOf(m_x, (at.x() - m_inside.left()) / m_inside.width()), valueOf(m_y, (m_inside.bottom() - at.y()) / m_inside.height())};
}

void DrawnAxes::paintFigures(QPainter& painter, const PlotColours& colours, bool upright) const
{
    const DrawnScale& scale = upright ? m_x : m_y;
    const QFontMetricsF metrics(painter.font());
    const double most = upright ? m_inside.width() / std::max(4.2 * m_line, metrics.horizontalAdvance(QStringLiteral("00000000")))
                                : m_inside.height() / (2.2 * m_line);
    for (const Tick& tick : ticksOf(scale, std::clamp(most, 1.0, 9.0))) {
        const double part = partOf(scale, tick.value);
        painter.setPen(QPen(tick.value == 0 && !scale.logarithmic ? colours.axis : colours.grid, 0));
        if (upright) {
            const double x = m_inside.left() + part * m_inside.width();
            painter.drawLine(QPointF(x, m_inside.top()), QPointF(x, m_inside.bottom()));
            painter.setPen(colours.text);
            painter.drawText(QRectF(x - 6 * m_line, m_inside.bottom() + 0.15 * m_line, 12 * m_line, 1.1 * m_line),
                Qt::AlignHCenter | Qt::AlignTop, tick.text);
        } else {
            const double y = m_inside.bottom() - part * m_inside.height();
            painter.drawLine(QPointF(m_inside.left(), y), QPointF(m_inside.right(), y));
            painter.setPen(colours.text);
            painter.drawText(
                QRectF(m_inside.left() - 20.4 * m_line, y - m_line, 20 * m_line, 2 * m_line), Qt::AlignRight | Qt::AlignVCenter, tick.text);
        }
    }
}

void DrawnAxes::paint(QPainter& painter, const PlotColours& colours) const
{
    painter.setBrush(Qt::NoBrush);
    paintFigures(painter, colours, true);
    paintFigures(painter, colours, false);
    painter.setPen(QPen(colours.axis, 0));
    painter.drawRect(m_inside);
    painter.setPen(colours.text);
    // A title stands at its axis; one that is wider takes the width of the picture.
    const QFontMetricsF metrics(painter.font());
    const bool xFits = metrics.horizontalAdvance(m_x.title) <= m_inside.width();
    painter.drawText(QRectF({m_aboveAxis ? m_rect.left() : m_inside.left(), m_rect.top()},
                         QPointF(m_rect.right(), m_inside.top() - (m_aboveAxis ? 0.65 : 0.15) * m_line)),
        Qt::AlignLeft | Qt::AlignBottom | Qt::TextWordWrap, m_y.title);
    const QRectF& across = xFits ? m_inside : m_rect;
    painter.drawText(QRectF({across.left(), m_inside.bottom() + 1.2 * m_line}, QPointF(across.right(), m_rect.bottom())),
        Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, m_x.title);
}

QPen curvePen(const QColor& colour, const QFont& font, double weight, Qt::PenStyle style)
{
    return {colour, weight * QFontMetricsF(font).height() / 14, style, Qt::RoundCap, Qt::RoundJoin};
}

} // namespace lubberline::ui
