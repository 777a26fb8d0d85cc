#include "ui/plots/map/SurfaceAxes.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

#include "ui/plots/map/MapText.h"
#include "ui/plots/map/SurfacePainting.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

constexpr double kTick = 5, kGap = 3, kLift = 5;

double tickStep(double range_deg)
{
    for (const double step : {5.0, 10.0, 15.0, 30.0, 45.0}) {
        if (range_deg / step <= 6)
            return step;
    }
    return 90;
}

QPointF unit(QPointF v)
{
    const double length = std::hypot(v.x(), v.y());
    return length > 0 ? v / length : QPointF(0, 1);
}

} // namespace

SurfaceAxes::SurfaceAxes(const MapPicture& picture, const SurfaceProjection& project, const SurfaceLook& look)
    : m_picture(picture)
    , m_project(project)
    , m_look(look)
    , m_farX(project.farX())
    , m_farY(project.farY())
{
}

void SurfaceAxes::line(QPainter& painter, const BoxPoint& from, const BoxPoint& to) const
{
    painter.drawLine(m_project(from), m_project(to));
}

void SurfaceAxes::paintBehind(QPainter& painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    const double x = m_farX, y = m_farY;
    painter.setPen(QPen(m_look.colours.grid, 1));
    for (const double z : {-1.0, 1.0}) {
        line(painter, {-1, y, z}, {1, y, z});
        line(painter, {x, -1, z}, {x, 1, z});
    }
    line(painter, {x, y, -1}, {x, y, 1});
    line(painter, {-x, y, -1}, {-x, y, 1});
    line(painter, {x, -y, -1}, {x, -y, 1});
    painter.setPen(QPen(m_look.colours.axis, 1, Qt::DashLine));
    line(painter, {-1, y, 0}, {1, y, 0});
    line(painter, {x, -1, 0}, {x, 1, 0});
}

void SurfaceAxes::paintBefore(QPainter& painter) const
{
    const double x = -m_farX, y = -m_farY;
    painter.setPen(QPen(m_look.colours.axis, 1, Qt::DashLine));
    line(painter, {-1, y, 0}, {1, y, 0});
    line(painter, {x, -1, 0}, {x, 1, 0});
    painter.setPen(QPen(m_look.colours.axis, 1));
    line(painter, {-1, y, -1}, {1, y, -1});
    line(painter, {x, -1, -1}, {x, 1, -1});
    paintAlongFloor(painter, true);
    paintAlongFloor(painter, false);
    paintUpright(painter);
}

/// The floor's edge nearest to the eye carries the axis.
void SurfaceAxes::paintAlongFloor(QPainter& painter, bool alongX) const
{
    const MapAxis& axis = alongX ? m_picture.map->request.x : m_picture.map->request.y;
    const double side = alongX ? -m_farY : -m_farX;
    const auto place = [&](double along, double across) { return alongX ? BoxPoint{along, across, -1} : BoxPoint{across, along, -1}; };
    const QPointF outward = unit(m_project(place(0, side)) - m_project(place(0, 0)));
    const double range_deg = axis.range.to_deg - axis.range.from_deg;
    const double step_deg = tickStep(std::abs(range_deg));
    for (double i = std::ceil(std::min(axis.range.from_deg, axis.range.to_deg) / step_deg - 1e-9);
         i * step_deg <= std::max(axis.range.from_deg, axis.range.to_deg) + 1e-9; i += 1) {
        const QPointF at = m_project(place(2 * (i * step_deg - axis.range.from_deg) / range_deg - 1, side));
        painter.setPen(QPen(m_look.colours.axis, 1));
        painter.drawLine(at, at + kTick * outward);
        paintLabel(painter, at + (kTick + kGap) * outward, outward, attitudeTick(axis.axis, i * step_deg));
    }
    const QFontMetricsF metrics(m_look.font);
    const double beyond = kTick + 2 * kGap + metrics.height() + std::abs(outward.x()) * metrics.horizontalAdvance(QStringLiteral("000 N"));
    paintLabel(painter, m_project(place(0, side)) + beyond * outward, outward, attitudeTitle(axis.axis));
}

/// The box's edge that lies furthest to the left.
void SurfaceAxes::paintUpright(QPainter& painter) const
{
    BoxPoint foot{-1, -1, 0};
    for (const double x : {-1.0, 1.0}) {
        for (const double y : {-1.0, 1.0}) {
            if (m_project({x, y, 0}).x() < m_project(foot).x())
                foot = {x, y, 0};
        }
    }
    const auto at = [&](double value_deg) { return m_project({foot.x, foot.y, value_deg / m_look.scale.end}); };
    painter.setPen(QPen(m_look.colours.axis, 1));
    painter.drawLine(at(-m_look.scale.end), at(m_look.scale.end));
    const double step = m_look.scale.step;
    double widest = 0;
    for (double i = std::ceil(-m_look.scale.end / step - 1e-9); i * step <= m_look.scale.end * (1 + 1e-9); i += 1) {
        painter.setPen(QPen(m_look.colours.axis, 1));
        painter.drawLine(at(i * step), at(i * step) - QPointF(kTick, 0));
        const QString text = angleTick(i * step, step);
        widest = std::max(widest, QFontMetricsF(m_look.font).horizontalAdvance(text));
        const double lifted = i * step < -0.99 * m_look.scale.end ? kLift : 0; // the floor's first label stands beneath
        paintLabel(painter, at(i * step) - QPointF(kTick + kGap, lifted), {-1, 0}, text);
    }
    painter.save();
    painter.setPen(m_look.colours.text);
    const double height = QFontMetricsF(m_look.font).height(),
                 length = QFontMetricsF(m_look.font).horizontalAdvance(mapValueTitle(m_picture));
    QPointF foot_px = at(0) - QPointF(kTick + 3 * kGap + widest, 0);
    if (const QRectF& within = m_look.within; within.isValid()) {
        foot_px.setX(std::max(foot_px.x(), within.left() + height));
        foot_px.setY(std::clamp(foot_px.y(), within.top() + length / 2, std::max(within.top() + length / 2, within.bottom() - length / 2)));
    }
    painter.translate(foot_px);
    painter.rotate(-90);
    painter.drawText(QRectF(-400, -height, 800, height), Qt::AlignCenter, mapValueTitle(m_picture));
    painter.restore();
}

/// The side of the text that faces the axis touches the place.
void SurfaceAxes::paintLabel(QPainter& painter, QPointF at, QPointF outward, const QString& text) const
{
    const QFontMetricsF metrics(m_look.font);
    QRectF box(0, 0, metrics.horizontalAdvance(text) + 1, metrics.height());
    box.moveCenter(at + QPointF(outward.x() * box.width() / 2, outward.y() * box.height() / 2));
    if (const QRectF& within = m_look.within; within.isValid()) {
        box.moveLeft(std::clamp(box.left(), within.left(), std::max(within.left(), within.right() - box.width())));
        box.moveTop(std::clamp(box.top(), within.top(), std::max(within.top(), within.bottom() - box.height())));
    }
    painter.setPen(m_look.colours.text);
    painter.drawText(box, Qt::AlignCenter, text);
}

} // namespace lubberline::ui
