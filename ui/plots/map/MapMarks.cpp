#include "ui/plots/map/MapMarks.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPen>

#include <algorithm>
#include <optional>

#include "ui/plots/map/DivergingMap.h"

namespace lubberline::ui {

namespace {

constexpr double kMark = 5; ///< half its size

QRectF around(QPointF at, double half) { return {at.x() - half, at.y() - half, 2 * half, 2 * half}; }

void drawBox(QPainter& painter, const QRectF& box, const QString& text, const QFont& font)
{
    painter.setPen(Qt::NoPen);
    painter.setBrush(Qt::white);
    painter.drawRect(box);
    painter.setPen(inkOnMap());
    painter.setFont(font);
    painter.drawText(box, Qt::AlignCenter, text);
}

QSizeF boxSize(const QString& text, const QFont& font)
{
    const QFontMetricsF metrics(font);
    return {metrics.horizontalAdvance(text) + 6, metrics.height()};
}

/// A mark at the edge is still seen whole.
QPointF keptInside(QPointF at, const QRectF& within)
{
    const QRectF inner = within.adjusted(kMark, kMark, -kMark, -kMark);
    return {std::clamp(at.x(), inner.left(), std::max(inner.left(), inner.right())),
        std::clamp(at.y(), inner.top(), std::max(inner.top(), inner.bottom()))};
}

bool isFree(const QRectF& box, const MarkRoom& room)
{
    return room.within.contains(box)
        && std::none_of(room.taken.begin(), room.taken.end(), [&box](const QRectF& other) { return other.intersects(box); });
}

void paintTextBeside(QPainter& painter, QPointF at, const QString& text, const MarkRoom& room, const QFont& font)
{
    const QSizeF size = boxSize(text, font);
    const double aside = size.width() / 2 + kMark + 2, above = size.height() / 2 + kMark + 2;
    for (const QPointF& offset : {QPointF(0, -above), QPointF(0, above), QPointF(aside, 0), QPointF(-aside, 0), QPointF(aside, -above),
             QPointF(-aside, -above), QPointF(aside, above), QPointF(-aside, above)}) {
        QRectF box(QPointF(), size);
        box.moveCenter(at + offset);
        if (!isFree(box, room))
            continue;
        room.taken.push_back(box);
        return drawBox(painter, box, text, font);
    }
}

} // namespace

void paintExtreme(QPainter& painter, QPointF place, bool maximum, const QString& text, const MarkRoom& room, const QFont& font)
{
    const QPointF at = keptInside(place, room.within);
    room.taken.push_back(around(at, kMark));
    const double tip = maximum ? -kMark : kMark;
    painter.setPen(QPen(Qt::white, 1));
    painter.setBrush(inkOnMap());
    painter.drawPolygon(QPolygonF({at + QPointF(0, tip), at + QPointF(kMark, -tip), at + QPointF(-kMark, -tip)}));
    paintTextBeside(painter, at, text, room, font);
}

void paintCross(QPainter& painter, QPointF place, const QString& text, const MarkRoom& room, const QFont& font)
{
    const QPointF at = keptInside(place, room.within);
    room.taken.push_back(around(at, kMark));
    for (const QPen& pen : {QPen(Qt::white, 4), QPen(inkOnMap(), 2)}) {
        painter.setPen(pen);
        painter.drawLine(at + QPointF(-kMark, -kMark), at + QPointF(kMark, kMark));
        painter.drawLine(at + QPointF(-kMark, kMark), at + QPointF(kMark, -kMark));
    }
    paintTextBeside(painter, at, text, room, font);
}

void paintTag(QPainter& painter, QPointF centre, const QString& text, const MarkRoom& room, const QFont& font)
{
    QRectF box(QPointF(), boxSize(text, font));
    box.moveCenter(centre);
    box.moveLeft(std::clamp(box.left(), room.within.left(), std::max(room.within.left(), room.within.right() - box.width())));
    box.moveTop(std::clamp(box.top(), room.within.top(), std::max(room.within.top(), room.within.bottom() - box.height())));
    room.taken.push_back(box);
    drawBox(painter, box, text, font);
}

} // namespace lubberline::ui
