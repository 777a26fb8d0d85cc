#include "ui/plots/inflight/InflightDrawing.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/angle/Angle.h"
#include "core/angle/PrintedHeading.h"
#include "core/fleet/Proportion.h"
#include "core/inflight/WindVector.h"
#include "ui/plots/drawn/DrawnAxes.h"
#include "ui/text/NumberText.h"
#include "ui/text/Translated.h"

namespace lubberline::ui {

namespace {

struct InflightWords {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::InflightWords)
};

QString headingText(double heading_deg) { return QStringLiteral("%1°").arg(printedHeading_deg(heading_deg, 0), 3, 'f', 0, QChar('0')); }

WindRow rowOfHeading(double heading_deg, int columns)
{
    const double heading = toRadians(heading_deg);
    WindRow row;
    row << 1.0, std::sin(heading), std::cos(heading), std::sin(2 * heading), std::cos(2 * heading);
    for (int i = columns; i < kWindColumns; ++i)
        row(i) = 0;
    return row;
}

/// Half of the 95 % interval of the fitted curve [deg]; none where the errors are not told.
std::optional<double> halfBand(const ClusteredFit& fit, double heading_deg)
{
    if (!fit.errorsTold || fit.flights < 2)
        return {};
    const WindRow row = rowOfHeading(heading_deg, fit.columns);
    return studentFactor(fit.flights - 1) * std::sqrt(std::max(0.0, row.dot(fit.covariance * row)));
}

DrawnAxes scatterAxes(const AircraftWinds& one, const QRectF& rect, const QFont& font)
{
    double most = 0;
    for (const WindDot& dot : one.dots)
        most = std::max(most, std::abs(dot.error_deg));
    for (int heading = 0; heading < 360; heading += 10)
        most = std::max(most, std::abs(one.errorAt_deg(heading)));
    DrawnScale headings{0, 360, InflightWords::tr("heading read (°)")};
    headings.headings = true;
    return {rect, font, headings, scaleAbout0(std::min(most, 20.0), 1, InflightWords::tr("deviation = magnetic − compass (°, east +)"))};
}

void paintScatter(QPainter& painter, const QRectF& rect, const AircraftWinds& one, const DrawnLook& look)
{
    const DrawnAxes axes = scatterAxes(one, rect, painter.font());
    const double dot = QFontMetricsF(painter.font()).height() / 9;
    QPolygonF upper, lower, curve;
    for (int heading = 0; heading <= 360; heading += 3) {
        const double value = -one.errorAt_deg(heading);
        curve << axes.at(heading, value);
        if (const auto half = halfBand(one.fit.fit, heading)) {
            upper << axes.at(heading, value + *half);
            lower << axes.at(heading, value - *half);
        }
    }
    std::reverse(lower.begin(), lower.end());
    painter.save();
    painter.setClipRect(axes.inside());
    painter.setPen(Qt::NoPen);
    if (look.isShown(3)) {
        painter.setBrush(look.colours.band);
        painter.drawPolygon(upper + lower);
    }
    painter.restore();
    axes.paint(painter, look.colours);
    painter.save();
    painter.setClipRect(axes.inside());
    painter.setPen(Qt::NoPen);
    painter.setBrush(look.colours.faint);
    if (look.isShown(0))
        for (const WindDot& report : one.dots)
            painter.drawEllipse(axes.at(report.heading_deg, -report.error_deg), 0.6 * dot, 0.6 * dot);
    painter.setBrush(look.colours.readings);
    if (look.isShown(1))
        for (const WindSector& sector : one.sectors)
            if (sector.count > 0)
                painter.drawEllipse(axes.at(sector.heading_deg, -sector.error_deg), 1.5 * dot, 1.5 * dot);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(curvePen(look.colours.approximate, painter.font(), 2));
    if (look.isShown(2) && one.fitted)
        painter.drawPolyline(curve);
    painter.restore();
}

QString scatterReadOut(const AircraftWinds& one, const QRectF& rect, const QFont& font, const QPointF& at)
{
    const DrawnAxes axes = scatterAxes(one, rect, font);
    if (!axes.contains(at))
        return {};
    const double heading = axes.valueAt(at).x();
    const WindSector& sector = one.sectors[static_cast<std::size_t>(heading / 10) % one.sectors.size()];
    QString text = InflightWords::tr("%1: ").arg(headingText(heading));
    if (one.fitted) {
        text += InflightWords::tr("fit %1°").arg(signedNumber(-one.errorAt_deg(heading), 2));
        if (const auto half = halfBand(one.fit.fit, heading))
            text += InflightWords::tr(" ± %1° (95 %)").arg(plainNumber(*half, 2));
        text += QStringLiteral("; ");
    }
    return text
        + (sector.count > 0 ? InflightWords::tr("mean of %1 reports %2°").arg(sector.count).arg(signedNumber(-sector.error_deg, 2))
                            : InflightWords::tr("no report in these 10°"));
}

struct RosePlace {
    QPointF centre;
    double radius;
};

RosePlace rosePlace(const QRectF& rect, const QFont& font)
{
    const double line = QFontMetricsF(font).height();
    return {rect.center() + QPointF(0, 0.6 * line), std::max(1.0, std::min(rect.width(), rect.height() - 1.4 * line) / 2 - 1.6 * line)};
}

std::int64_t largestSector(const AircraftWinds& one)
{
    std::int64_t most = 1;
    for (const WindSector& sector : one.sectors)
        most = std::max(most, sector.count);
    return most;
}

/// Area stands for reports: the radius is the root of the share.
void paintRose(QPainter& painter, const QRectF& rect, const AircraftWinds& one, const DrawnLook& look)
{
    const double line = QFontMetricsF(painter.font()).height();
    const auto [centre, radius] = rosePlace(rect, painter.font());
    const auto most = static_cast<double>(largestSector(one));
    painter.setPen(QPen(look.colours.grid, 0));
    painter.setBrush(Qt::NoBrush);
    for (const double part : {0.5, 1.0})
        painter.drawEllipse(centre, radius * part, radius * part);
    const QRectF circle(centre - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius));
    painter.setPen(QPen(look.colours.ground, 0));
    painter.setBrush(look.colours.approximate);
    for (std::size_t i = 0; i < one.sectors.size(); ++i) {
        const double part = std::sqrt(static_cast<double>(one.sectors[i].count) / most), reach = part * radius;
        if (one.sectors[i].count > 0) // Qt counts sixteenths of a degree from east, anticlockwise
            painter.drawPie(
                QRectF(centre - QPointF(reach, reach), QSizeF(2 * reach, 2 * reach)), (90 - 10 * static_cast<int>(i)) * 16, -10 * 16);
    }
    painter.setPen(look.colours.text);
    painter.setBrush(Qt::NoBrush);
    static constexpr const char* kNames[] = {"N", "E", "S", "W"};
    for (int i = 0; i < 4; ++i) {
        const double angle = toRadians(90.0 * i);
        const QPointF at = centre + QPointF(std::sin(angle), -std::cos(angle)) * (radius + 0.8 * line);
        painter.drawText(QRectF(at.x() - line, at.y() - line, 2 * line, 2 * line), Qt::AlignCenter, QString::fromLatin1(kNames[i]));
    }
    painter.drawText(QRectF(rect.left(), rect.top(), rect.width(), 1.4 * line), Qt::AlignCenter,
        InflightWords::tr("headings read; full radius: %1 reports in 10°").arg(largestSector(one)));
}

QString roseReadOut(const AircraftWinds& one, const QRectF& rect, const QFont& font, const QPointF& at)
{
    const auto [centre, radius] = rosePlace(rect, font);
    const QPointF off = at - centre;
    if (std::hypot(off.x(), off.y()) > radius)
        return {};
    const auto sector = static_cast<std::size_t>(wrap360(toDegrees(std::atan2(off.x(), -off.y()))) / 10) % one.sectors.size();
    return InflightWords::tr("%1 to %2: %3 reports")
        .arg(headingText(10.0 * static_cast<double>(sector)), headingText(10.0 * static_cast<double>(sector) + 10))
        .arg(one.sectors[sector].count);
}

constexpr std::size_t kShownStates = 5;
constexpr double kBandOfErrors = 2; ///< standard errors drawn either way

QColor colourOfState(std::size_t state, const PlotColours& colours) { return state == 0 ? colours.text : colours.coefficient[state]; }

DrawnAxes convergenceAxes(const ContinuousResult& result, const QRectF& rect, const QFont& font)
{
    // What was not told yet would squeeze all that came after: the later three quarters say how high it is.
    double most = 0;
    for (std::size_t i = result.history.size() / 4; i < result.history.size(); ++i)
        for (std::size_t state = 0; state < kShownStates; ++state) {
            const auto place = static_cast<Eigen::Index>(state);
            const ContinuousPoint& point = result.history[i];
            most = std::max(most, std::abs(point.state_deg(place)) + kBandOfErrors * std::min(point.standardError_deg(place), 2.0));
        }
    const double first = result.history.empty() ? 0 : result.history.front().time_s,
                 last = result.history.empty() ? 1 : result.history.back().time_s;
    return {rect, font, {first, last, InflightWords::tr("time (s)")}, scaleAbout0(most, 0.5, InflightWords::tr("coefficient (°, east +)"))};
}

QColor tint(const QColor& colour, const QColor& ground)
{
    constexpr double kShare = 0.22;
    const auto channel = [](int a, int b) { return qRound(kShare * a + (1 - kShare) * b); };
    return QColor(channel(colour.red(), ground.red()), channel(colour.green(), ground.green()), channel(colour.blue(), ground.blue()));
}

void paintConvergence(QPainter& painter, const QRectF& rect, const ContinuousResult& result, const DrawnLook& look)
{
    const DrawnAxes axes = convergenceAxes(result, rect, painter.font());
    painter.save();
    painter.setClipRect(axes.inside());
    for (std::size_t state = 0; state < kShownStates; ++state) {
        if (!look.isShown(state))
            continue;
        const auto place = static_cast<Eigen::Index>(state);
        QPolygonF band, lower;
        for (const ContinuousPoint& point : result.history) {
            band << axes.at(point.time_s, point.state_deg(place) + kBandOfErrors * point.standardError_deg(place));
            lower << axes.at(point.time_s, point.state_deg(place) - kBandOfErrors * point.standardError_deg(place));
        }
        std::reverse(lower.begin(), lower.end());
        painter.setPen(Qt::NoPen);
        painter.setBrush(tint(colourOfState(state, look.colours), look.colours.ground));
        painter.drawPolygon(band + lower);
    }
    painter.restore();
    axes.paint(painter, look.colours);
    painter.save();
    painter.setClipRect(axes.inside());
    for (std::size_t state = 0; state < kShownStates; ++state) {
        if (!look.isShown(state))
            continue;
        QPolygonF curve;
        for (const ContinuousPoint& point : result.history)
            curve << axes.at(point.time_s, point.state_deg(static_cast<Eigen::Index>(state)));
        painter.setPen(curvePen(colourOfState(state, look.colours), painter.font(), 1.6));
        painter.drawPolyline(curve);
    }
    painter.setPen(curvePen(look.colours.exact, painter.font(), 1, Qt::DashLine));
    for (const ContinuousAlarm& alarm : result.alarms)
        painter.drawLine(
            QPointF(axes.at(alarm.time_s, 0).x(), axes.inside().top()), QPointF(axes.at(alarm.time_s, 0).x(), axes.inside().bottom()));
    painter.restore();
}

QString convergenceReadOut(const ContinuousResult& result, const QRectF& rect, const QFont& font, const QPointF& at)
{
    const DrawnAxes axes = convergenceAxes(result, rect, font);
    if (!axes.contains(at) || result.history.empty())
        return {};
    const double time_s = axes.valueAt(at).x();
    const auto found = std::min_element(result.history.begin(), result.history.end(),
        [time_s](const ContinuousPoint& a, const ContinuousPoint& b) { return std::abs(a.time_s - time_s) < std::abs(b.time_s - time_s); });
    QStringList values;
    for (std::size_t state = 0; state < kShownStates; ++state) {
        const auto place = static_cast<Eigen::Index>(state);
        values += QStringLiteral("%1 %2° ± %3°")
                      .arg(QString::fromStdString(result.names[state]), signedNumber(found->state_deg(place), 2),
                          plainNumber(found->standardError_deg(place), 2));
    }
    return InflightWords::tr("%1 s: %2 (± one standard error)").arg(plainNumber(found->time_s, 0), values.join(QStringLiteral(", ")));
}

struct CirclePlace {
    QPointF origin; ///< of no velocity
    double perKnot;
    [[nodiscard]] QPointF at(const Eigen::Vector2d& v_kt) const { return origin + QPointF(v_kt.x(), -v_kt.y()) * perKnot; }
};

Eigen::Vector2d windOf(const LegsSolution& solution) { return velocityOf(solution.air.from_deg() + 180, solution.air.speed_kt()); }

CirclePlace circlePlace(const LegsSolution& solution, const QRectF& rect, const QFont& font)
{
    const double line = QFontMetricsF(font).height(), reach = std::max(1.0, solution.air.airspeed_kt);
    const double perKnot = std::max(1e-6, (std::min(rect.width(), rect.height()) / 2 - 2.2 * line) / reach);
    const Eigen::Vector2d wind = windOf(solution);
    return {rect.center() - QPointF(wind.x(), -wind.y()) * perKnot, perKnot};
}

void paintCircle(QPainter& painter, const QRectF& rect, const LegsSolution& solution, const DrawnLook& look)
{
    const double line = QFontMetricsF(painter.font()).height();
    const CirclePlace place = circlePlace(solution, rect, painter.font());
    const QPointF centre = place.at(windOf(solution));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(curvePen(look.colours.approximate, painter.font()));
    if (look.isShown(1))
        painter.drawEllipse(centre, solution.air.airspeed_kt * place.perKnot, solution.air.airspeed_kt * place.perKnot);
    painter.setPen(curvePen(look.colours.exact, painter.font(), 2));
    if (look.isShown(2))
        painter.drawLine(place.origin, centre);
    for (const SolvedLeg& leg : solution.legs) {
        const QPointF end = place.at(velocityOf(leg.leg.track_deg, leg.leg.groundSpeed_kt));
        painter.setPen(QPen(look.colours.grid, 0));
        painter.drawLine(place.origin, end);
        painter.setPen(Qt::NoPen);
        painter.setBrush(look.colours.readings);
        if (look.isShown(0))
            painter.drawEllipse(end, 0.3 * line, 0.3 * line);
        painter.setPen(look.colours.text);
        painter.drawText(
            QRectF(end.x() - 5 * line, end.y() - 1.6 * line, 10 * line, 1.3 * line), Qt::AlignCenter, headingText(leg.trueHeading_deg));
    }
}

} // namespace

DrawnPicture windScatter(const AircraftWinds& aircraft)
{
    const auto one = std::make_shared<const AircraftWinds>(aircraft);
    DrawnPicture picture;
    picture.paint = [one](QPainter& painter, const QRectF& rect, const DrawnLook& look) { paintScatter(painter, rect, *one, look); };
    picture.readOut = [one](const QRectF& rect, const QFont& font, const QPointF& at) { return scatterReadOut(*one, rect, font, at); };
    picture.legend = [one](const PlotColours& colours) {
        return std::vector<LegendEntry>{{InflightWords::tr("reports (some of them)"), LegendEntry::Key::Dot, Qt::NoPen, colours.faint},
            {InflightWords::tr("means over 10°"), LegendEntry::Key::Dot, Qt::NoPen, colours.readings},
            {InflightWords::tr("fit"), LegendEntry::Key::Line, QPen(colours.approximate, 2), {}, one->fitted},
            {InflightWords::tr("95 % band, by flights"), LegendEntry::Key::Area, Qt::NoPen, colours.band,
                one->fitted && halfBand(one->fit.fit, 0).has_value()}};
    };
    if (one->dots.empty())
        picture.notice = InflightWords::tr("no report of this aircraft can be used");
    return picture;
}

DrawnPicture windRose(const AircraftWinds& aircraft)
{
    const auto one = std::make_shared<const AircraftWinds>(aircraft);
    DrawnPicture picture;
    picture.paint = [one](QPainter& painter, const QRectF& rect, const DrawnLook& look) { paintRose(painter, rect, *one, look); };
    picture.readOut = [one](const QRectF& rect, const QFont& font, const QPointF& at) { return roseReadOut(*one, rect, font, at); };
    if (one->dots.empty())
        picture.notice = InflightWords::tr("no headings");
    return picture;
}

DrawnPicture convergence(const ContinuousResult& result)
{
    const auto shown = std::make_shared<const ContinuousResult>(result);
    DrawnPicture picture;
    picture.paint
        = [shown](QPainter& painter, const QRectF& rect, const DrawnLook& look) { paintConvergence(painter, rect, *shown, look); };
    picture.readOut
        = [shown](const QRectF& rect, const QFont& font, const QPointF& at) { return convergenceReadOut(*shown, rect, font, at); };
    picture.legend = [shown](const PlotColours& colours) {
        std::vector<LegendEntry> entries;
        for (std::size_t state = 0; state < kShownStates; ++state)
            entries.push_back(
                {state == 0 ? InflightWords::tr("A (bands: two standard errors)") : QString::fromStdString(shown->names[state]),
                    LegendEntry::Key::Line, QPen(colourOfState(state, colours), 2)});
        entries.push_back(
            {InflightWords::tr("alarm"), LegendEntry::Key::Line, QPen(colours.exact, 1, Qt::DashLine), {}, !shown->alarms.empty()});
        return entries;
    };
    if (shown->history.empty())
        picture.notice = InflightWords::tr("the headings so far do not tell the coefficients");
    return picture;
}

DrawnPicture legCircle(const LegsSolution& solution)
{
    const auto shown = std::make_shared<const LegsSolution>(solution);
    DrawnPicture picture;
    picture.paint = [shown](QPainter& painter, const QRectF& rect, const DrawnLook& look) { paintCircle(painter, rect, *shown, look); };
    picture.readOut = [shown](const QRectF& rect, const QFont& font, const QPointF& at) {
        const CirclePlace place = circlePlace(*shown, rect, font);
        const QPointF off = (at - place.origin) / place.perKnot;
        const Eigen::Vector2d velocity(off.x(), -off.y());
        return InflightWords::tr("ground velocity %1 kt towards %2")
            .arg(plainNumber(velocity.norm(), 1), headingText(directionOf_deg(velocity)));
    };
    picture.legend = [](const PlotColours& colours) {
        return std::vector<LegendEntry>{
            {InflightWords::tr("ground velocity of a leg, with its true heading"), LegendEntry::Key::Dot, Qt::NoPen, colours.readings},
            {InflightWords::tr("airspeed about the wind"), LegendEntry::Key::Line, QPen(colours.approximate, 2)},
            {InflightWords::tr("wind"), LegendEntry::Key::Line, QPen(colours.exact, 2)}};
    };
    return picture;
}

} // namespace lubberline::ui
