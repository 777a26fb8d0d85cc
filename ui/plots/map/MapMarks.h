#pragma once
/// Marks of places on a map or a surface: ▲ and ▼ with their values, crosses with words.

#include <QFont>
#include <QPointF>
#include <QRectF>
#include <QString>

#include <vector>

class QPainter;

namespace lubberline::ui {

/// Marks and their texts keep inside and clear of each other; a text without room is left out, its mark is not.
struct MarkRoom {
    QRectF within;
    std::vector<QRectF>& taken;
};

/// Points up for a maximum, down for a minimum; its middle at the place, but whole inside the room.
void paintExtreme(QPainter& painter, QPointF place, bool maximum, const QString& text, const MarkRoom& room, const QFont& font);
void paintCross(QPainter& painter, QPointF place, const QString& text, const MarkRoom& room, const QFont& font);
/// A text on an opaque white box, centred at the place as far as there is room.
void paintTag(QPainter& painter, QPointF centre, const QString& text, const MarkRoom& room, const QFont& font);

} // namespace lubberline::ui
