#include "ui/plots/swing/ReadingMarks.h"

#include <QFontMetricsF>
#include <QLineF>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "ui/plots/swing/PictureText.h"

namespace lubberline::ui {

namespace {

constexpr double kDensityCell = 4, kLightest = 0.12, kDarkest = 0.55; ///< of the density; never so dark that a curve is lost in it
constexpr double kRadius = 3.5, kRing = 7.5, kHalo = 10, kCap = 3, kGap = kHalo + 3;
/// More readings than this are a log: they would hide each other, and take longer to draw than a keystroke may. One in a cell of this
/// side is drawn, without its bar; suspect, excluded and chosen ones always are.
constexpr std::size_t kMostMarks = 1000;
constexpr double kCell = 3;

void paintBar(QPainter& painter, const QPointF& from, const QPointF& to)
{
    const QLineF bar(from, to);
    if (bar.length() < 2 * kRadius + 3)
        return; // it would hide behind the point
    painter.drawLine(bar);
    const QLineF across = bar.normalVector().unitVector();
    const QPointF cap = kCap * QPointF(across.dx(), across.dy());
    painter.drawLine(from - cap, from + cap);
    painter.drawLine(to - cap, to + cap);
}

std::vector<const ReadingPoint*> marksOf(
    const std::vector<ReadingPoint>& points, int selectedRow, const Projection& project, const QRectF& within)
{
    std::vector<const ReadingPoint*> marks;
    const bool log = points.size() > kMostMarks;
    const int columns = static_cast<int>(within.width() / kCell) + 1, rows = static_cast<int>(within.height() / kCell) + 1;
    std::vector<bool> taken(log ? static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows) : 0);
    for (const ReadingPoint& point : points) {
        if (log && !point.suspect && !point.excluded && point.row != selectedRow) {
            const QPointF at = (project(point.heading_deg, point.value_deg) - within.topLeft()) / kCell;
            if (at.x() < 0 || at.y() < 0 || at.x() >= columns || at.y() >= rows)
                continue;
            const auto cell = static_cast<std::size_t>(at.y()) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(at.x());
            if (taken[cell])
                continue;
            taken[cell] = true;
        }
        marks.push_back(&point);
    }
    return marks;
}

void paintMark(QPainter& painter, const ReadingPoint& point, bool selected, bool bar, const Projection& project, const PlotColours& colours)
{
    const QPointF at = project(point.heading_deg, point.value_deg);
    const QColor colour = point.excluded ? colours.faint : colours.readings;
    if (selected) {
        painter.setPen(QPen(colours.selected, 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(at, kHalo, kHalo);
    }
    painter.setPen(QPen(colour, 1));
    if (bar && point.bar_deg > 0) {
        paintBar(painter, project(point.heading_deg, point.value_deg - point.bar_deg),
            project(point.heading_deg, point.value_deg + point.bar_deg));
    }
    painter.setPen(QPen(colour, 1.4));
    painter.setBrush(point.excluded ? colours.ground : colour);
    painter.drawEllipse(at, kRadius, kRadius);
    if (point.suspect) {
        painter.setPen(QPen(colours.suspect, 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(at, kRing, kRing);
    }
}

/// Of so many readings that their marks would hide each other, and the curve: how many there are in each place, from light to dark.
void paintDensity(
    QPainter& painter, const std::vector<ReadingPoint>& points, const Projection& project, const QRectF& within, const PlotColours& colours)
{
    std::map<std::pair<int, int>, int> counts;
    int most = 1;
    for (const ReadingPoint& point : points) {
        const QPointF at = project(point.heading_deg, point.value_deg);
        if (!point.excluded && within.contains(at))
            most = std::max(
                most, ++counts[{static_cast<int>(std::floor(at.x() / kDensityCell)), static_cast<int>(std::floor(at.y() / kDensityCell))}]);
    }
    painter.setPen(Qt::NoPen);
    for (const auto& [cell, count] : counts) {
        const double share = kLightest + (kDarkest - kLightest) * std::log1p(count) / std::log1p(most);
        const auto mixed = [share](int ground, int ink) { return static_cast<int>(std::lround(ground + share * (ink - ground))); };
        const QColor &ground = colours.ground, &ink = colours.readings;
        painter.setBrush(
            QColor(mixed(ground.red(), ink.red()), mixed(ground.green(), ink.green()), mixed(ground.blue(), ink.blue()))); // opaque: PDF/A
        painter.drawRect(QRectF(cell.first * kDensityCell, cell.second * kDensityCell, kDensityCell, kDensityCell));
    }
}

/// The first of the places around the point that is free, beside it or, in a crowd, further off.
std::optional<QRectF> freePlace(const QPointF& at, const QSizeF& size, const QRectF& within, const std::vector<QRectF>& taken)
{
    for (const double far : {1.0, 2.5, 4.5, 7.0}) {
        const double gap = far * kGap;
        const std::array<QPointF, 8> corners{QPointF(gap, -size.height() / 2), QPointF(-gap - size.width(), -size.height() / 2),
            QPointF(gap * 0.7, -gap * 0.7 - size.height()), QPointF(gap * 0.7, gap * 0.7),
            QPointF(-gap * 0.7 - size.width(), -gap * 0.7 - size.height()), QPointF(-gap * 0.7 - size.width(), gap * 0.7),
            QPointF(-size.width() / 2, -gap - size.height()), QPointF(-size.width() / 2, gap)};
        for (const QPointF& corner : corners) {
            const QRectF place(at + corner, size);
            const auto collides = [&place](const QRectF& other) { return other.intersects(place); };
            if (within.contains(place) && std::none_of(taken.begin(), taken.end(), collides))
                return place;
        }
    }
    return {};
}

/// From the ring to a label that stands further off.
void paintLeader(QPainter& painter, const QPointF& at, const QRectF& place, const PlotColours& colours)
{
    const QPointF end(std::clamp(at.x(), place.left(), place.right()), std::clamp(at.y(), place.top(), place.bottom()));
    QLineF leader(at, end);
    if (leader.length() <= kGap + 1)
        return;
    leader.setP1(leader.pointAt(kRing / leader.length()));
    painter.setPen(QPen(colours.suspect, 1));
    painter.drawLine(leader);
}

void paintLabels(QPainter& painter, const std::vector<const ReadingPoint*>& marks, const Projection& project, const LabelRoom& room,
    const PlotColours& colours, const QFont& font)
{
    painter.setFont(font);
    const auto placed = placesOfLabels(marks, project, room, font);
    for (const auto& [point, place] : placed)
        paintLeader(painter, project(point->heading_deg, point->value_deg), place, colours);
    for (const auto& [point, place] : placed) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(colours.ground);
        painter.drawRoundedRect(place, 3, 3);
        painter.setPen(colours.text);
        painter.drawText(place, Qt::AlignCenter | Qt::TextSingleLine, point->label);
    }
}

} // namespace

std::vector<ReadingPoint> readingPoints(const SwingPicture& picture)
{
    std::vector<ReadingPoint> points;
    points.reserve(picture.readings.size());
    for (const PlottedReading& reading : picture.readings) {
        points.push_back({reading.row, reading.magnetic.degrees(), reading.deviation.degrees(), picture.resolution_deg / 2,
            reading.excluded, reading.suspect, reading.suspect ? suspectLabel(reading) : QString()});
    }
    return points;
}

std::vector<PlacedLabel> placesOfLabels(
    const std::vector<const ReadingPoint*>& marks, const Projection& project, const LabelRoom& room, const QFont& font)
{
    std::vector<QRectF> taken = room.taken;
    for (const ReadingPoint* point : marks) {
        const QPointF at = project(point->heading_deg, point->value_deg);
        const double clear = point->suspect ? kRing + 1 : kRadius + 1;
        taken.emplace_back(at.x() - clear, at.y() - clear, 2 * clear, 2 * clear);
    }
    const QFontMetricsF metrics(font);
    std::vector<PlacedLabel> placed;
    for (const ReadingPoint* point : marks) {
        const QPointF at = project(point->heading_deg, point->value_deg);
        if (!point->suspect || point->label.isEmpty() || !room.within.contains(at))
            continue;
        const QSizeF size(metrics.horizontalAdvance(point->label) + 6, metrics.height());
        if (const auto place = freePlace(at, size, room.within, taken)) {
            placed.push_back({point, *place});
            taken.push_back(*place);
        }
    }
    return placed;
}

void paintReadings(QPainter& painter, const std::vector<ReadingPoint>& points, int selectedRow, const Projection& project,
    const LabelRoom& room, const PlotColours& colours, const QFont& font)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const auto marks = marksOf(points, selectedRow, project, room.within);
    const bool dense = points.size() > kMostSeenApart;
    if (dense)
        paintDensity(painter, points, project, room.within, colours);
    for (const ReadingPoint* point : marks)
        if (!dense || point->suspect || point->excluded || point->row == selectedRow)
            paintMark(painter, *point, point->row == selectedRow, points.size() <= kMostMarks, project, colours);
    paintLabels(painter, marks, project, room, colours, font);
    painter.restore();
}

} // namespace lubberline::ui
