#include <QFontMetricsF>
#include <QPainter>
#include <QPolygonF>

#include <cmath>
#include <limits>

#include "core/base/Normal.h"
#include "ui/plots/base/NiceScale.h"
#include "ui/plots/fleet/FleetAxes.h"

namespace lubberline::ui {

namespace {

double yearOf(int day) { return 1970.0 + day / kDaysPerYear; }

std::size_t shownOf(const HistoryDrawing& drawing)
{
    return std::min(drawing.shown == 0 ? drawing.points.size() : drawing.shown, drawing.points.size());
}

/// Years on the axis: so many that they do not run into one another.
int yearStep(double years, double room, double label)
{
    for (const int step : {1, 2, 5, 10, 20})
        if (room / (years / step + 1) > label)
            return step;
    return 50;
}

void paintYears(QPainter& painter, const FleetAxes& axes, bool labels, const FleetLook& look)
{
    const double line = lineHeight(look);
    const int step = yearStep(axes.xTo - axes.xFrom, axes.room.width(), 3.2 * line);
    for (int year = static_cast<int>(std::ceil(axes.xFrom / step)) * step; year <= axes.xTo; year += step) {
        const double x = axes.at(year, 0).x();
        painter.setPen(penOf(look.colours.grid, look, 0.8));
        painter.drawLine(QPointF(x, axes.room.top()), QPointF(x, axes.room.bottom()));
        if (!labels)
            continue;
        painter.setPen(look.colours.text);
        painter.drawText(QRectF(x - 3 * line, axes.room.bottom() + 0.2 * line, 6 * line, 1.2 * line), Qt::AlignHCenter | Qt::AlignTop,
            QString::number(year));
    }
}

void paintStrip(QPainter& painter, const FleetAxes& axes, const HistoryDrawing& drawing, std::size_t c, const FleetLook& look)
{
    const double line = lineHeight(look);
    for (const auto& jump : drawing.jumps)
        if (jump.coefficient == c) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(look.colours.band);
            painter.drawRect(QRectF(axes.at(yearOf(jump.after_day), axes.yTo), axes.at(yearOf(jump.before_day), axes.yFrom)));
        }
    paintYGrid(painter, axes, look);
    paintYears(painter, axes, c == 4, look);
    painter.setPen(penOf(look.colours.suspect, look, 1, Qt::DashLine));
    for (const auto& event : drawing.events)
        if (const double x = axes.at(yearOf(event.day), 0).x(); axes.room.left() <= x && x <= axes.room.right())
            painter.drawLine(QPointF(x, axes.room.top()), QPointF(x, axes.room.bottom()));
    const std::size_t shown = shownOf(drawing);
    for (std::size_t i = 0; i < shown; ++i) {
        const auto& point = drawing.points[i];
        if (std::isnan(point.value_deg[c]))
            continue;
        const double x = yearOf(point.day), value = point.value_deg[c], half = point.half95_deg[c];
        painter.setPen(penOf(look.colours.coefficient[c], look, 1.4));
        painter.drawLine(axes.at(x, std::max(axes.yFrom, value - half)), axes.at(x, std::min(axes.yTo, value + half)));
        painter.setBrush(point.left ? look.colours.ground : look.colours.text); // as found filled, as left open
        painter.setPen(penOf(look.colours.text, look, 1.2));
        painter.drawEllipse(axes.at(x, value), 0.24 * line, 0.24 * line);
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(penOf(look.colours.axis, look));
    painter.drawRect(axes.room);
    painter.setPen(look.colours.text);
    QFont bold = look.font;
    bold.setBold(true);
    painter.setFont(bold);
    painter.drawText(QPointF(axes.room.left() + 0.4 * line, axes.room.top() + line), QString(QLatin1Char(letterOf(kCoefficients[c]))));
    painter.setFont(look.font);
}

} // namespace

HistoryDrawing historyDrawing(
    const FleetSwings& fleet, const FleetCurves& curves, const CompassHistory& history, const FleetChanges& changes)
{
    const auto& compass = fleet.compasses[static_cast<std::size_t>(history.compass)];
    HistoryDrawing drawing;
    for (const auto row : history.rows) {
        const auto& swing = fleet.swings[row];
        HistoryDrawing::Point point;
        point.day = swing.day;
        point.left = swing.stage == SwingStage::AsLeft;
        for (std::size_t c = 0; c < 5; ++c) {
            const bool known = curves.curves[row].known(c);
            point.value_deg[c] = known ? curves.curves[row].value_deg[c] : std::numeric_limits<double>::quiet_NaN();
            point.half95_deg[c] = known ? kNormal95 * std::sqrt(curves.variance_deg2(swing, row, c)) : 0.0;
        }
        drawing.points.push_back(point);
    }
    for (const auto& jump : changes.jumps)
        if (jump.compass == history.compass)
            drawing.jumps.push_back({fleet.swings[jump.afterRow].day, fleet.swings[jump.beforeRow].day, jump.coefficient});
    drawing.events = compass.events;
    drawing.limit_deg = compass.limit_deg;
    return drawing;
}

void paintCoefficientHistory(QPainter& painter, const QRectF& rect, const HistoryDrawing& drawing, const FleetLook& look)
{
    if (drawing.points.empty())
        return;
    const double line = lineHeight(look), left = QFontMetricsF(look.font).horizontalAdvance(QStringLiteral("+88.8°"));
    const double top = rect.top() + (drawing.events.empty() ? 0.4 : 1.4) * line, height = (rect.bottom() - 1.6 * line - top) / 5;
    FleetAxes axes;
    axes.xFrom = yearOf(drawing.points.front().day) - 0.3;
    axes.xTo = yearOf(drawing.points.back().day) + 0.3;
    painter.setFont(look.font);
    for (std::size_t c = 0; c < 5; ++c) {
        double low = 0, high = 0;
        bool first = true;
        for (const auto& point : drawing.points)
            if (!std::isnan(point.value_deg[c])) {
                const double a = point.value_deg[c] - point.half95_deg[c], b = point.value_deg[c] + point.half95_deg[c];
                low = first ? a : std::min(low, a);
                high = first ? b : std::max(high, b);
                first = false;
            }
        axes.yStep = niceStep(std::max(0.1, (high - low) / 3));
        axes.yFrom = std::floor(low / axes.yStep) * axes.yStep;
        axes.yTo = std::max(std::ceil(high / axes.yStep) * axes.yStep, axes.yFrom + axes.yStep);
        axes.room = QRectF(rect.left() + left, top + static_cast<double>(c) * height, rect.width() - left - line, height - 0.3 * line);
        paintStrip(painter, axes, drawing, c, look);
    }
    double free = rect.left() + left;
    painter.setPen(look.colours.suspect);
    for (const auto& event : drawing.events) { // words that have room
        const double x = axes.at(yearOf(event.day), 0).x();
        const QString words = QString::fromStdString(event.text);
        const double width = QFontMetricsF(look.font).horizontalAdvance(words);
        if (x < free || x > axes.room.right())
            continue;
        const double at = std::min(x, std::max(free, axes.room.right() - width));
        painter.drawText(QPointF(at, rect.top() + line), words);
        free = at + width + line;
    }
}

void paintCurveHistory(QPainter& painter, const QRectF& rect, const HistoryDrawing& drawing, const FleetLook& look)
{
    const std::size_t shown = shownOf(drawing);
    double largest = drawing.limit_deg.value_or(0.0);
    const auto curveOf = [](const HistoryDrawing::Point& point) {
        FiveTerms value{};
        for (std::size_t c = 0; c < 5; ++c)
            value[c] = std::isnan(point.value_deg[c]) ? 0.0 : point.value_deg[c];
        return value;
    };
    for (const auto& point : drawing.points)
        largest = std::max(largest, largestOf_deg(curveOf(point)));
    const FleetAxes axes = headingAxes(rect, 1.1 * largest, look);
    paintHeadingAxes(painter, axes, look);
    if (drawing.limit_deg)
        for (const double limit : {-*drawing.limit_deg, *drawing.limit_deg}) {
            painter.setPen(penOf(look.colours.limitEdge, look, 1.6));
            painter.drawLine(axes.at(0, limit), axes.at(360, limit));
        }
    painter.setBrush(Qt::NoBrush);
    for (std::size_t i = 0; i < shown; ++i) {
        const auto& point = drawing.points[i];
        if (std::isnan(point.value_deg[0]))
            continue;
        QPolygonF line;
        for (int heading = 0; heading <= 360; heading += 5)
            line << axes.at(heading, curveAtMagnetic(curveOf(point), heading).deviation_deg);
        const bool newest = i + 1 == shown;
        painter.setPen(
            penOf(newest ? look.colours.exact : look.colours.previous, look, newest ? 2.4 : 1, point.left ? Qt::DashLine : Qt::SolidLine));
        painter.drawPolyline(line);
    }
    if (shown > 0) {
        painter.setPen(look.colours.exact);
        painter.setFont(look.font);
        painter.drawText(axes.room.adjusted(0, 0.2 * lineHeight(look), -0.5 * lineHeight(look), 0), Qt::AlignRight | Qt::AlignTop,
            QString::fromStdString(dateOfDay(drawing.points[shown - 1].day)));
    }
}

} // namespace lubberline::ui
