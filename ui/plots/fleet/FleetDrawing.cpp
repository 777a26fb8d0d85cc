#include "ui/plots/fleet/FleetDrawing.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <QPolygonF>

#include <cmath>

#include "ui/plots/base/NiceScale.h"
#include "ui/plots/fleet/FleetAxes.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::FleetDrawing)
};

/// The figures of a point that are drawn; the spread between aircraft where it is told, else as found.
struct Bounds {
    double mean, low, high, p5, p95;
};
std::optional<Bounds> boundsOf(const PatternPoint& point)
{
    if (!point.mean_deg)
        return {};
    const double mean = *point.mean_deg, spread = point.between_deg.value_or(point.standardDeviation_deg.value_or(0.0));
    return Bounds{mean, mean - spread, mean + spread, point.percentile5_deg.value_or(mean), point.percentile95_deg.value_or(mean)};
}

double largestDrawn(const PopulationDrawing& drawing)
{
    double largest = drawing.limit_deg.value_or(0.0);
    for (const auto& point : drawing.pattern->points)
        if (const auto b = boundsOf(point))
            largest = std::max({largest, std::abs(b->low), std::abs(b->high), std::abs(b->p5), std::abs(b->p95)});
    return largest;
}

/// The closed row of points: north again at 360°.
template <class Use>
void around(const PopulationPattern& pattern, Use use)
{
    for (std::size_t i = 0; i <= pattern.points.size(); ++i) {
        const auto& point = pattern.points[i % pattern.points.size()];
        if (const auto b = boundsOf(point))
            use(i == pattern.points.size() ? 360.0 : point.heading_deg, *b);
    }
}

struct Lines {
    QPolygonF mean, p5, p95, tint;
};
template <class Place>
Lines linesOf(const PopulationPattern& pattern, Place place)
{
    Lines lines;
    QPolygonF back;
    around(pattern, [&](double heading, const Bounds& b) {
        lines.mean << place(heading, b.mean);
        lines.p5 << place(heading, b.p5);
        lines.p95 << place(heading, b.p95);
        lines.tint << place(heading, b.high);
        back.prepend(place(heading, b.low));
    });
    lines.tint << back;
    return lines;
}

void paintLines(QPainter& painter, const Lines& lines, const FleetLook& look)
{
    painter.setBrush(Qt::NoBrush);
    painter.setPen(penOf(look.colours.previous, look, 1, Qt::DashLine));
    painter.drawPolyline(lines.p5);
    painter.drawPolyline(lines.p95);
    painter.setPen(penOf(look.colours.approximate, look, 2.2));
    painter.drawPolyline(lines.mean);
    const double dot = 0.22 * lineHeight(look);
    painter.setBrush(look.colours.approximate);
    painter.setPen(Qt::NoPen);
    for (const auto& at : lines.mean)
        painter.drawEllipse(at, dot, dot);
}

void paintTint(QPainter& painter, const Lines& lines, const FleetLook& look)
{
    painter.setPen(Qt::NoPen);
    painter.setBrush(look.colours.band);
    painter.drawPolygon(lines.tint);
}

struct Circle {
    QPointF centre;
    double radius = 0, scale_deg = 1, step_deg = 1; ///< zero deviation is half-way out
    [[nodiscard]] QPointF at(double heading_deg, double deviation_deg) const
    {
        const double r = radius * 0.5 * (1 + deviation_deg / scale_deg), a = toRadians(heading_deg);
        return centre + QPointF(r * std::sin(a), -r * std::cos(a));
    }
};
Circle circleOf(const QRectF& rect, const PopulationDrawing& drawing, const FleetLook& look)
{
    const NiceScale scale = niceScale(largestDrawn(drawing), 3, 0.5);
    Circle circle;
    circle.centre = rect.center();
    circle.radius = std::max(1.0, 0.5 * std::min(rect.width(), rect.height()) - 1.6 * lineHeight(look));
    circle.scale_deg = scale.end;
    circle.step_deg = scale.step;
    return circle;
}

void paintCircleGrid(QPainter& painter, const Circle& circle, const FleetLook& look)
{
    static const char* const names[] = {"N", "NE", "E", "SE", "S", "SW", "W", "NW"};
    const double line = lineHeight(look);
    painter.setFont(look.font);
    painter.setBrush(Qt::NoBrush);
    for (int i = 0; i < 8; ++i) {
        painter.setPen(penOf(look.colours.grid, look, 0.8));
        painter.drawLine(circle.centre, circle.at(45.0 * i, circle.scale_deg));
        const double a = toRadians(45.0 * i), r = circle.radius + 0.8 * line;
        const QPointF at = circle.centre + QPointF(r * std::sin(a), -r * std::cos(a));
        painter.setPen(look.colours.text);
        painter.drawText(QRectF(at.x() - 3 * line, at.y() - line, 6 * line, 2 * line), Qt::AlignCenter, QString::fromLatin1(names[i]));
    }
    for (int i = qRound(-circle.scale_deg / circle.step_deg) + 1; i <= qRound(circle.scale_deg / circle.step_deg); ++i) {
        const double r = circle.radius * 0.5 * (1 + i * circle.step_deg / circle.scale_deg);
        painter.setPen(penOf(i == 0 ? look.colours.axis : look.colours.grid, look, i == 0 ? 2 : 0.8));
        painter.drawEllipse(circle.centre, r, r);
        const QPointF at = circle.at(22.5, i * circle.step_deg);
        painter.setPen(look.colours.faint);
        painter.drawText(
            QRectF(at.x() - 3 * line, at.y() - line, 6 * line, 2 * line), Qt::AlignCenter, angleTick(i * circle.step_deg, circle.step_deg));
    }
}

QString wordsForNothing(const QString& given)
{
    return given.isEmpty() ? Texts::tr("Nothing to draw: no swing of the selection tells a deviation here.") : given;
}

/// A legend in one line at the top of the room: a swatch and its words, one after the other.
void paintLegend(QPainter& painter, const QRectF& rect, const std::vector<std::pair<QPen, QString>>& entries, const FleetLook& look)
{
    const double line = lineHeight(look);
    const QFontMetricsF metrics(look.font);
    double x = rect.left() + 0.6 * line, y = rect.top() + 0.9 * line;
    painter.setFont(look.font);
    for (const auto& [pen, words] : entries) {
        const double width = metrics.horizontalAdvance(words);
        if (x + width + 3 * line > rect.right()) {
            x = rect.left() + 0.6 * line;
            y += 1.1 * line;
        }
        painter.setPen(pen);
        painter.drawLine(QPointF(x, y), QPointF(x + 1.6 * line, y));
        painter.setPen(look.colours.text);
        painter.drawText(QPointF(x + 2 * line, y + 0.32 * line), words);
        x += width + 3.4 * line;
    }
}

std::optional<double> onGrid(double heading_deg, const PopulationPattern& pattern)
{
    const double step = 360.0 / static_cast<double>(pattern.points.size());
    return wrap360(std::round(heading_deg / step) * step);
}

} // namespace

void paintNothing(QPainter& painter, const QRectF& rect, const QString& words, const FleetLook& look)
{
    painter.setFont(look.font);
    painter.setPen(look.colours.faint);
    painter.drawText(rect, Qt::AlignCenter | Qt::TextWordWrap, words);
}

void paintPopulationCurve(QPainter& painter, const QRectF& rect, const PopulationDrawing& drawing, const FleetLook& look)
{
    if (!drawing.pattern || drawing.pattern->points.empty() || largestDrawn(drawing) <= 0)
        return paintNothing(painter, rect, wordsForNothing(drawing.nothing), look);
    const FleetAxes axes = headingAxes(rect, 1.15 * largestDrawn(drawing), look);
    const auto lines = linesOf(*drawing.pattern, [&](double heading, double deviation) { return axes.at(heading, deviation); });
    paintTint(painter, lines, look);
    paintHeadingAxes(painter, axes, look);
    if (drawing.limit_deg)
        for (const double limit : {-*drawing.limit_deg, *drawing.limit_deg}) {
            painter.setPen(penOf(look.colours.limitEdge, look, 1.6));
            painter.drawLine(axes.at(0, limit), axes.at(360, limit));
        }
    if (drawing.chosen_deg) {
        painter.setPen(penOf(look.colours.selected, look, 2));
        painter.drawLine(axes.at(*drawing.chosen_deg, axes.yFrom), axes.at(*drawing.chosen_deg, axes.yTo));
    }
    paintLines(painter, lines, look);
    std::vector<std::pair<QPen, QString>> legend{{penOf(look.colours.approximate, look, 2.2), Texts::tr("mean")},
        {penOf(look.colours.band, look, 8), Texts::tr("± 1 sd between aircraft")},
        {penOf(look.colours.previous, look, 1, Qt::DashLine), Texts::tr("5 and 95 %")}};
    if (drawing.limit_deg)
        legend.emplace_back(penOf(look.colours.limitEdge, look, 1.6), Texts::tr("limit"));
    paintLegend(painter, axes.room, legend, look);
}

void paintPopulationPolar(QPainter& painter, const QRectF& rect, const PopulationDrawing& drawing, const FleetLook& look)
{
    if (!drawing.pattern || drawing.pattern->points.empty() || largestDrawn(drawing) <= 0)
        return paintNothing(painter, rect, wordsForNothing(drawing.nothing), look);
    const Circle circle = circleOf(rect, drawing, look);
    const auto lines = linesOf(*drawing.pattern, [&](double heading, double deviation) { return circle.at(heading, deviation); });
    paintTint(painter, lines, look);
    paintCircleGrid(painter, circle, look);
    if (drawing.chosen_deg) {
        painter.setPen(penOf(look.colours.selected, look, 2));
        painter.drawLine(circle.centre, circle.at(*drawing.chosen_deg, circle.scale_deg));
    }
    paintLines(painter, lines, look);
}

std::optional<double> curveHeadingAt(const QRectF& rect, const PopulationDrawing& drawing, const FleetLook& look, QPointF at)
{
    if (!drawing.pattern || drawing.pattern->points.empty())
        return {};
    const FleetAxes axes = headingAxes(rect, 1.15 * largestDrawn(drawing), look);
    if (!axes.room.contains(at))
        return {};
    return onGrid(360.0 * (at.x() - axes.room.left()) / axes.room.width(), *drawing.pattern);
}

std::optional<double> polarHeadingAt(const QRectF& rect, const PopulationDrawing& drawing, const FleetLook& look, QPointF at)
{
    if (!drawing.pattern || drawing.pattern->points.empty())
        return {};
    const Circle circle = circleOf(rect, drawing, look);
    const QPointF out = at - circle.centre;
    if (std::hypot(out.x(), out.y()) > circle.radius)
        return {};
    return onGrid(wrap360(toDegrees(std::atan2(out.x(), -out.y()))), *drawing.pattern);
}

void paintFleetSpectrum(QPainter& painter, const QRectF& rect, const std::vector<HarmonicOrder>& found,
    const std::vector<HarmonicOrder>& left, const FleetLook& look)
{
    const std::size_t orders = std::max(found.size(), left.size());
    if (orders == 0)
        return paintNothing(painter, rect, wordsForNothing({}), look);
    double largest = 0;
    for (const auto* each : {&found, &left})
        for (const auto& order : *each)
            largest = std::max(largest, toDegrees(order.amplitude_rad()));
    const double line = lineHeight(look);
    const NiceScale scale = niceScale(1.2 * largest, 5, 0.1);
    FleetAxes axes;
    axes.room = rect.adjusted(QFontMetricsF(look.font).horizontalAdvance(QStringLiteral("+88.8°")), 0.8 * line, -line, -1.6 * line);
    axes.xFrom = -0.5;
    axes.xTo = static_cast<double>(orders) - 0.5;
    axes.yFrom = 0;
    axes.yTo = scale.end;
    axes.yStep = scale.step;
    paintYGrid(painter, axes, look);
    const auto bars = [&](const std::vector<HarmonicOrder>& all, double from, const QColor& colour) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(colour);
        for (const auto& order : all)
            painter.drawRect(QRectF(axes.at(order.order + from, toDegrees(order.amplitude_rad())), axes.at(order.order + from + 0.32, 0)));
    };
    bars(found, -0.34, look.colours.exact);
    bars(left, 0.02, look.colours.approximate);
    painter.setPen(look.colours.text);
    static const char* const names[] = {"0: A", "1: B, C", "2: D, E"};
    for (std::size_t i = 0; i < orders; ++i) {
        const double x = axes.at(static_cast<double>(i), 0).x();
        painter.drawText(QRectF(x - 4 * line, axes.room.bottom() + 0.2 * line, 8 * line, 1.2 * line), Qt::AlignHCenter | Qt::AlignTop,
            i < 3 ? QString::fromLatin1(names[i]) : QString::number(i));
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(penOf(look.colours.axis, look));
    painter.drawRect(axes.room);
    std::vector<std::pair<QPen, QString>> legend;
    if (!found.empty())
        legend.emplace_back(penOf(look.colours.exact, look, 6), Texts::tr("as found"));
    if (!left.empty())
        legend.emplace_back(penOf(look.colours.approximate, look, 6), Texts::tr("as left"));
    paintLegend(painter, axes.room, legend, look);
}

} // namespace lubberline::ui
