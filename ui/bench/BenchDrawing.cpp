#include "ui/bench/BenchDrawing.h"

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/iron/ShapeGeometry.h"
#include "core/sensor/Attitude.h"
#include "ui/kit/Words.h"
#include "ui/plots/base/NiceScale.h"
#include "ui/plots/base/PlotColours.h"

namespace lubberline::ui {

namespace {

/// Which of its placements a part is in: the chosen state, or the first.
int placementIn(const FerrousPart& part, const BenchStates& states)
{
    const auto chosen = states.find(part.group);
    for (std::size_t i = 0; i < part.placements.size(); ++i)
        if (chosen != states.end() && part.placements[i].state == chosen->second)
            return static_cast<int>(i);
    return 0;
}

/// More names would only cover one another.
constexpr std::size_t kMostNames = 60;
constexpr double kReach_px = 30;

/// The corners of the box round a part, in body axes.
std::vector<Eigen::Vector3d> cornersOf(const FerrousPart& part, const Placement& at)
{
    const Eigen::Matrix3d toBody = rotation(at.roll_rad, at.pitch_rad, at.yaw_rad).transpose();
    const Eigen::Vector3d half = sizeOf(part.shape) / 2;
    std::vector<Eigen::Vector3d> corners;
    for (int i = 0; i < 8; ++i)
        corners.push_back(at.centre_m
            + toBody * Eigen::Vector3d(i & 1 ? half.x() : -half.x(), i & 2 ? half.y() : -half.y(), i & 4 ? half.z() : -half.z()));
    return corners;
}

/// The hull of points in the plane, by Andrew's monotone chain.
QPolygonF hullOf(std::vector<QPointF> points)
{
    std::sort(
        points.begin(), points.end(), [](const QPointF& a, const QPointF& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
    const auto turns = [](const QPointF& o, const QPointF& a, const QPointF& b) {
        return (a.x() - o.x()) * (b.y() - o.y()) - (a.y() - o.y()) * (b.x() - o.x());
    };
    QPolygonF hull;
    for (int pass = 0; pass < 2; ++pass) {
        const int begin = hull.size();
        for (const QPointF& point : points) {
            while (hull.size() >= begin + 2 && turns(hull[hull.size() - 2], hull.back(), point) <= 0)
                hull.pop_back();
            hull.append(point);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

/// Finds room for names: beside their place where there is some, else above or below, as near as can be.
class NamePlaces {
public:
    NamePlaces(const QRectF& within, const QFontMetricsF& metrics) : m_within(within), m_metrics(metrics) {}

    QRectF place(const QPointF& at, const QString& text)
    {
        const QSizeF size(m_metrics.horizontalAdvance(text) + 2, m_metrics.height());
        QRectF best;
        double least = std::numeric_limits<double>::max();
        for (int step = -6; step <= 6; ++step)
            for (const double left : {at.x() + kGap_px, at.x() - kGap_px - size.width()}) {
                const QRectF box(QPointF(left, at.y() - size.height() / 2 + step * size.height() * 0.6), size);
                if (const double cost = costOf(box, step); cost < least) {
                    least = cost;
                    best = box;
                }
            }
        m_taken.push_back(best);
        return best;
    }

private:
    static constexpr double kGap_px = 12;
    /// What is covered counts most, then what is cut off, then the way.
    [[nodiscard]] double costOf(const QRectF& box, int step) const
    {
        double cost = std::abs(step);
        const QRectF seen = box & m_within;
        cost += (box.width() * box.height() - seen.width() * seen.height()) / 2;
        for (const QRectF& other : m_taken) {
            const QRectF both = box & other;
            cost += both.width() * both.height();
        }
        return cost;
    }

    QRectF m_within;
    QFontMetricsF m_metrics;
    std::vector<QRectF> m_taken;
};

} // namespace

/// One of the two views: where body axes fall on the screen.
struct BenchDrawing::View {
    QRectF area;
    bool fromAbove = true;
    double scale = 1;    ///< pixels a metre
    QPointF centre = {}; ///< of the drawing, in the view's metres
    [[nodiscard]] QPointF flat(const Eigen::Vector3d& at) const { return {-at.x(), fromAbove ? -at.y() : at.z()}; }
    /// A way on the screen, in metres of body axes.
    [[nodiscard]] Eigen::Vector3d inBody(const QPointF& way) const
    {
        return {-way.x() / scale, fromAbove ? -way.y() / scale : 0, fromAbove ? 0 : way.y() / scale};
    }
    [[nodiscard]] QPointF onScreen(const Eigen::Vector3d& at) const { return area.center() + (flat(at) - centre) * scale; }
};

BenchDrawing::BenchDrawing(QWidget* parent) : QWidget(parent)
{
    setMinimumSize(240, 240);
    setAccessibleName(tr("The bench from above and from the side"));
    setFocusPolicy(Qt::ClickFocus); // Escape gives a part back
}

void BenchDrawing::setBench(const IronBench& bench, const BenchStates& states)
{
    m_bench = bench;
    m_states = states;
    m_drag.reset();
    update();
}

void BenchDrawing::setSelected(int part)
{
    m_selected = part;
    update();
}

std::vector<BenchDrawing::View> BenchDrawing::views() const
{
    std::vector<Eigen::Vector3d> all{m_bench.sensor_m};
    for (const auto& part : m_bench.parts)
        if (!part.placements.empty()) {
            const auto corners = cornersOf(part, part.placements[static_cast<std::size_t>(placementIn(part, m_states))]);
            all.insert(all.end(), corners.begin(), corners.end());
        }
    for (const auto& circuit : m_bench.circuits)
        for (const auto& conductor : circuit.conductors) {
            if (const auto* wire = std::get_if<WirePath>(&conductor))
                all.insert(all.end(), wire->points_m.begin(), wire->points_m.end());
            else
                all.push_back(std::get<CurrentLoop>(conductor).centre_m);
        }
    const double half = height() / 2.0;
    std::vector<View> both{{QRectF(0, 0, width(), half), true, 1, {}}, {QRectF(0, half, width(), height() - half), false, 1, {}}};
    double scale = 1e9;
    for (View& view : both) {
        QPointF least = view.flat(all.front()), most = least;
        for (const auto& point : all) {
            const QPointF at = view.flat(point);
            least = {std::min(least.x(), at.x()), std::min(least.y(), at.y())};
            most = {std::max(most.x(), at.x()), std::max(most.y(), at.y())};
        }
        view.centre = (least + most) / 2;
        scale = std::min({scale, (view.area.width() - 60) / std::max(0.5, most.x() - least.x()),
            (view.area.height() - 56) / std::max(0.5, most.y() - least.y())});
    }
    for (View& view : both)
        view.scale = std::max(1.0, scale); // the same for both
    return both;
}

Placement BenchDrawing::placementOf(std::size_t part) const
{
    Placement at = m_bench.parts[part].placements[static_cast<std::size_t>(placementIn(m_bench.parts[part], m_states))];
    if (m_drag && m_drag->part == static_cast<int>(part))
        at.centre_m = m_drag->to_m;
    return at;
}

QPointF BenchDrawing::onScreen(const Eigen::Vector3d& at_m, bool fromAbove) const { return views()[fromAbove ? 0 : 1].onScreen(at_m); }

void BenchDrawing::paintView(QPainter& painter, const View& view) const
{
    const PlotColours colours = coloursFor(palette());
    painter.setPen(colours.faint);
    painter.drawText(view.area.adjusted(8, 4, -8, -4), Qt::AlignTop | Qt::AlignLeft,
        view.fromAbove ? tr("from above (nose left, starboard up)") : tr("from the port side (nose left)"));
    NamePlaces names(view.area.adjusted(4, 20, -4, -4), QFontMetricsF(painter.font()));
    const auto name = [&](const QPointF& at, const QString& text) {
        painter.drawText(names.place(at, text), Qt::AlignCenter | Qt::TextDontClip, text);
    };
    for (std::size_t i = 0; i < m_bench.parts.size(); ++i) {
        const FerrousPart& part = m_bench.parts[i];
        if (part.placements.empty())
            continue;
        const Placement at = placementOf(i);
        std::vector<QPointF> corners;
        for (const auto& corner : cornersOf(part, at))
            corners.push_back(view.onScreen(corner));
        const bool selected = static_cast<int>(i) == m_selected;
        painter.setPen(QPen(selected ? colours.suspect : colours.text, selected ? 2.4 : 1.2));
        painter.setBrush(colours.band);
        if (std::holds_alternative<Box>(part.shape) || std::holds_alternative<Cylinder>(part.shape))
            painter.drawPolygon(hullOf(corners));
        else
            painter.drawEllipse(hullOf(corners).boundingRect());
        painter.setPen(colours.text);
        if (selected || m_bench.parts.size() <= kMostNames)
            name(view.onScreen(at.centre_m), toText(part.name));
    }
    for (const auto& circuit : m_bench.circuits) {
        painter.setPen(QPen(colours.exact, circuit.on ? 2.2 : 1.2, circuit.on ? Qt::SolidLine : Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        for (const auto& conductor : circuit.conductors) {
            if (const auto* wire = std::get_if<WirePath>(&conductor)) {
                QPolygonF line;
                for (const auto& point : wire->points_m)
                    line.append(view.onScreen(point));
                painter.drawPolyline(line);
                if (!line.isEmpty())
                    name((line.first() + line.last()) / 2, toText(circuit.name));
            } else {
                const auto& loop = std::get<CurrentLoop>(conductor);
                const double radius = std::max(4.0, loop.diameter_m / 2 * view.scale);
                painter.drawEllipse(view.onScreen(loop.centre_m), radius, radius);
                name(view.onScreen(loop.centre_m), toText(circuit.name));
            }
        }
    }
    const QPointF sensor = view.onScreen(m_bench.sensor_m);
    painter.setPen(QPen(colours.approximate, 2.5));
    painter.drawLine(sensor - QPointF(9, 0), sensor + QPointF(9, 0));
    painter.drawLine(sensor - QPointF(0, 9), sensor + QPointF(0, 9));
    name(sensor, tr("sensor"));
}

void BenchDrawing::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const PlotColours colours = coloursFor(palette());
    painter.fillRect(rect(), colours.ground);
    const auto both = views();
    for (const View& view : both) {
        painter.save();
        painter.setClipRect(view.area);
        paintView(painter, view);
        painter.restore();
    }
    painter.setPen(colours.grid);
    painter.drawLine(QPointF(0, both[1].area.top()), QPointF(width(), both[1].area.top()));
    const double bar_m = niceStep(70.0 / both[0].scale); // some 70 pixels
    painter.setPen(QPen(colours.text, 2));
    const QPointF end(width() - 12.0, height() - 12.0), begin(end.x() - bar_m * both[0].scale, end.y());
    painter.drawLine(begin, end);
    painter.drawText(QRectF(begin.x() - 60, begin.y() - 20, end.x() - begin.x() + 60, 16), Qt::AlignRight, tr("%1 m").arg(bar_m));
}

void BenchDrawing::mousePressEvent(QMouseEvent* event)
{
    std::optional<Drag> nearest;
    double least = kReach_px;
    for (const View& view : views()) {
        if (!view.area.contains(event->position()))
            continue;
        for (std::size_t i = 0; i < m_bench.parts.size(); ++i) {
            if (m_bench.parts[i].placements.empty())
                continue;
            const Placement at = placementOf(i);
            const QPointF off = view.onScreen(at.centre_m) - event->position();
            if (const double far = std::hypot(off.x(), off.y()); far < least) {
                least = far;
                nearest = Drag{static_cast<int>(i), placementIn(m_bench.parts[i], m_states), view.fromAbove, event->position(), at.centre_m,
                    at.centre_m};
            }
        }
    }
    if (!nearest || event->button() != Qt::LeftButton)
        return;
    setSelected(nearest->part);
    emit partChosen(nearest->part);
    if (m_movable)
        m_drag = nearest;
}

void BenchDrawing::mouseMoveEvent(QMouseEvent* event)
{
    if (!m_drag)
        return;
    const QPointF way = event->position() - m_drag->begin;
    m_drag->moved = m_drag->moved || way.manhattanLength() >= QApplication::startDragDistance();
    if (!m_drag->moved)
        return;
    const Eigen::Vector3d to_m = m_drag->from_m + views()[m_drag->fromAbove ? 0 : 1].inBody(way);
    m_drag->to_m = (to_m * 1000).array().round() / 1000;
    const auto& at = m_drag->to_m;
    emit readOut(tr("%1: %2 m forward, %3 m starboard, %4 m down")
                     .arg(toText(m_bench.parts[static_cast<std::size_t>(m_drag->part)].name))
                     .arg(at.x(), 0, 'f', 3)
                     .arg(at.y(), 0, 'f', 3)
                     .arg(at.z(), 0, 'f', 3));
    update();
}

void BenchDrawing::mouseReleaseEvent(QMouseEvent*)
{
    const auto drag = std::exchange(m_drag, std::nullopt);
    update();
    if (drag && drag->moved)
        emit partMoved(drag->part, drag->placement, drag->to_m);
}

void BenchDrawing::keyPressEvent(QKeyEvent* event)
{
    if (event->key() != Qt::Key_Escape || !m_drag)
        return QWidget::keyPressEvent(event);
    m_drag.reset();
    update();
}

} // namespace lubberline::ui
