#include "ui/plots/fleet/FleetAxes.h"

#include <QFontMetricsF>
#include <QPainter>

#include "ui/plots/base/NiceScale.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

double lineHeight(const FleetLook& look) { return QFontMetricsF(look.font).height(); }

QPen penOf(const QColor& colour, const FleetLook& look, double weight, Qt::PenStyle style)
{
    QPen pen(colour, weight * lineHeight(look) / 14, style, Qt::RoundCap, Qt::RoundJoin);
    return pen;
}

FleetAxes headingAxes(const QRectF& rect, double largest_deg, const FleetLook& look)
{
    const double line = lineHeight(look);
    const NiceScale scale = niceScale(largest_deg, 4, 0.5);
    FleetAxes axes;
    const QFontMetricsF metrics(look.font); // the outermost heading is not cut, the lowest figure stands clear of it
    axes.room = rect.adjusted(metrics.horizontalAdvance(QStringLiteral("+88.8°")), 0.8 * line,
        -0.5 * metrics.horizontalAdvance(QStringLiteral("NW 360°")) - 2, -2 * line);
    axes.yFrom = -scale.end;
    axes.yTo = scale.end;
    axes.yStep = scale.step;
    return axes;
}

void paintYGrid(QPainter& painter, const FleetAxes& axes, const FleetLook& look)
{
    const double line = lineHeight(look);
    painter.setFont(look.font);
    for (int i = qRound(axes.yFrom / axes.yStep); i <= qRound(axes.yTo / axes.yStep); ++i) {
        const double value = i * axes.yStep, y = axes.at(axes.xFrom, value).y();
        painter.setPen(penOf(i == 0 ? look.colours.axis : look.colours.grid, look, i == 0 ? 1.2 : 0.8));
        painter.drawLine(QPointF(axes.room.left(), y), QPointF(axes.room.right(), y));
        painter.setPen(look.colours.text);
        QString tick = degreeTick(value, axes.yStep);
        if (axes.yFrom >= 0) // amplitudes have no sign
            tick.remove(QChar('+'));
        painter.drawText(QRectF(axes.room.left() - 10 * line, y - line, 9.7 * line, 2 * line), Qt::AlignRight | Qt::AlignVCenter, tick);
    }
}

void paintHeadingAxes(QPainter& painter, const FleetAxes& axes, const FleetLook& look)
{
    static const char* const names[] = {"N", "NE", "E", "SE", "S", "SW", "W", "NW", "N"};
    const double line = lineHeight(look);
    const bool figures = axes.room.width() > 34 * line;
    paintYGrid(painter, axes, look);
    for (int i = 0; i <= 8; ++i) {
        const double x = axes.at(45.0 * i, 0).x();
        painter.setPen(penOf(look.colours.grid, look, 0.8));
        painter.drawLine(QPointF(x, axes.room.top()), QPointF(x, axes.room.bottom()));
        painter.setPen(look.colours.text);
        const QString label = figures ? QStringLiteral("%1 %2°").arg(QString::fromLatin1(names[i])).arg(45 * i, 3, 10, QChar('0'))
                                      : QString::fromLatin1(names[i]);
        painter.drawText(
            QRectF(x - 5 * line, axes.room.bottom() + 0.6 * line, 10 * line, 1.2 * line), Qt::AlignHCenter | Qt::AlignTop, label);
    }
    painter.setPen(penOf(look.colours.axis, look));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(axes.room);
}

} // namespace lubberline::ui
