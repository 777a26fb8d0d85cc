#include "ui/reference/ManoeuvreLine.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/plots/base/NiceScale.h"
#include "ui/plots/base/PlotColours.h"
#include "ui/text/NumberText.h"

namespace lubberline::ui {

namespace {

constexpr double kReach_px = 5, kLeastDrawn_px = 4, kLeast_s = 1;

/// What a lane is of.
struct LaneKind {
    double Manoeuvre::*value;
    double most, step, usual; ///< of the lane, of a key, of a block that is inserted
    int decimals;
};
const std::array<LaneKind, ManoeuvreLine::kLanes> kLaneKinds{
    {{&Manoeuvre::turnRate_deg_s, 6, 0.5, 3, 1}, {&Manoeuvre::acceleration_m_s2, 5, 0.1, 1, 1}, {&Manoeuvre::climb_m_s, 20, 0.5, 5, 1}}};

double& valueOf(Manoeuvre& one, int lane) { return one.*kLaneKinds[static_cast<std::size_t>(lane)].value; }
double valueOf(const Manoeuvre& one, int lane) { return one.*kLaneKinds[static_cast<std::size_t>(lane)].value; }
double stepped(double value, double step) { return std::round(value / step) * step; }
bool isEmpty(const Manoeuvre& one) { return one.turnRate_deg_s == 0 && one.acceleration_m_s2 == 0 && one.climb_m_s == 0; }

QString laneName(int lane)
{
    return lane == ManoeuvreLine::Turn        ? ManoeuvreLine::tr("turn, °/s")
        : lane == ManoeuvreLine::Acceleration ? ManoeuvreLine::tr("speed, m/s²")
                                              : ManoeuvreLine::tr("climb, m/s");
}

QString unitOf(int lane)
{
    return lane == ManoeuvreLine::Turn        ? QStringLiteral("°/s")
        : lane == ManoeuvreLine::Acceleration ? QStringLiteral("m/s²")
                                              : QStringLiteral("m/s");
}

} // namespace

ManoeuvreLine::ManoeuvreLine(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("manoeuvreLine"));
    setAccessibleName(tr("Time line of manoeuvres"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setToolTip(
        tr("Draw a block in a lane: right of north, faster and up are above the line. Drag it to move or raise it, its ends to stretch it. "
           "Keys: Insert, Page Up and Down, arrows, Shift with arrows, Delete."));
}

void ManoeuvreLine::show(const std::vector<Manoeuvre>& manoeuvres, double duration_s)
{
    m_manoeuvres = manoeuvres;
    m_duration_s = std::max(duration_s, kLeast_s);
    if (m_chosen && (m_chosen->manoeuvre >= m_manoeuvres.size() || valueOf(m_manoeuvres[m_chosen->manoeuvre], m_chosen->lane) == 0))
        if (m_grip == Grip::None)
            m_chosen.reset();
    update();
}

QSize ManoeuvreLine::sizeHint() const
{
    const int line = fontMetrics().height();
    return {20 * line, 3 * static_cast<int>(1.9 * line) + static_cast<int>(1.4 * line)};
}

QRectF ManoeuvreLine::laneRect(int lane) const
{
    const double line = fontMetrics().height();
    int widest = 0;
    for (int name = 0; name < kLanes; ++name)
        widest = std::max(widest, fontMetrics().horizontalAdvance(laneName(name)));
    const double left = widest + line;
    const double high = (height() - 1.4 * line) / static_cast<double>(kLanes);
    return {left, lane * high, std::max(width() - left - line, 1.0), high};
}

double ManoeuvreLine::xOf(double time_s) const
{
    const QRectF lane = laneRect(0);
    return lane.left() + time_s / m_duration_s * lane.width();
}

double ManoeuvreLine::timeAt(double x) const
{
    const QRectF lane = laneRect(0);
    return std::clamp(std::round((x - lane.left()) / lane.width() * m_duration_s), 0.0, m_duration_s);
}

double ManoeuvreLine::valueAt(int lane, double y) const
{
    const QRectF rect = laneRect(lane);
    const LaneKind& kind = kLaneKinds[static_cast<std::size_t>(lane)];
    return stepped(std::clamp((rect.center().y() - y) / (rect.height() / 2), -1.0, 1.0) * kind.most, kind.step);
}

QRectF ManoeuvreLine::blockRect(const Block& block) const
{
    const Manoeuvre& one = m_manoeuvres[block.manoeuvre];
    const QRectF lane = laneRect(block.lane);
    const double part = std::clamp(valueOf(one, block.lane) / kLaneKinds[static_cast<std::size_t>(block.lane)].most, -1.0, 1.0);
    const double left = std::clamp(xOf(one.from_s), lane.left(), lane.right()),
                 right = std::clamp(xOf(one.to_s), lane.left(), lane.right());
    return QRectF(QPointF(left, lane.center().y()), QPointF(right, lane.center().y() - part * lane.height() / 2)).normalized();
}

std::vector<ManoeuvreLine::Block> ManoeuvreLine::blocks() const
{
    std::vector<Block> all;
    for (int lane = 0; lane < kLanes; ++lane)
        for (std::size_t i = 0; i < m_manoeuvres.size(); ++i)
            if (valueOf(m_manoeuvres[i], lane) != 0)
                all.push_back({i, lane});
    std::stable_sort(all.begin(), all.end(),
        [this](const Block& a, const Block& b) { return m_manoeuvres[a.manoeuvre].from_s < m_manoeuvres[b.manoeuvre].from_s; });
    return all;
}

ManoeuvreLine::Hit ManoeuvreLine::hitAt(const QPointF& at) const
{
    for (const Block& block : blocks()) {
        const QRectF rect = blockRect(block), lane = laneRect(block.lane);
        if (at.y() < lane.top() || at.y() > lane.bottom() || at.x() < rect.left() - kReach_px || at.x() > rect.right() + kReach_px)
            continue;
        if (std::abs(at.x() - rect.left()) <= kReach_px)
            return {block, Grip::From};
        if (std::abs(at.x() - rect.right()) <= kReach_px)
            return {block, Grip::To};
        return {block, Grip::Whole};
    }
    for (int lane = 0; lane < kLanes; ++lane)
        if (laneRect(lane).contains(at))
            return {{m_manoeuvres.size(), lane}, Grip::New};
    return {};
}

QString ManoeuvreLine::textOf(const Block& block) const
{
    const Manoeuvre& one = m_manoeuvres[block.manoeuvre];
    return tr("%1 to %2 s: %3 %4")
        .arg(plainNumber(one.from_s, 0), plainNumber(one.to_s, 0),
            signedNumber(valueOf(one, block.lane), kLaneKinds[static_cast<std::size_t>(block.lane)].decimals), unitOf(block.lane));
}

void ManoeuvreLine::tell()
{
    if (m_chosen && m_chosen->manoeuvre < m_manoeuvres.size())
        emit readOut(textOf(*m_chosen));
    update();
    emit drawn(m_manoeuvres);
}

/// What the hand or a key wants, kept within the flight.
void ManoeuvreLine::take(Block block, double from_s, double to_s, double value)
{
    Manoeuvre& one = m_manoeuvres[block.manoeuvre];
    from_s = std::clamp(from_s, 0.0, std::max(0.0, m_duration_s - kLeast_s));
    to_s = std::clamp(to_s, from_s + kLeast_s, std::max(m_duration_s, from_s + kLeast_s));
    const double most = kLaneKinds[static_cast<std::size_t>(block.lane)].most;
    const Manoeuvre before = one;
    one.from_s = from_s;
    one.to_s = to_s;
    valueOf(one, block.lane) = std::clamp(value, -most, most);
    if (!(one == before))
        tell();
}

void ManoeuvreLine::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return;
    const Hit hit = hitAt(event->position());
    m_pressedAt = event->position();
    m_grip = hit.grip;
    if (hit.grip == Grip::New || hit.grip == Grip::None) {
        m_chosen.reset();
    } else {
        m_chosen = hit.block;
        m_before = m_manoeuvres[hit.block.manoeuvre];
        emit readOut(textOf(hit.block));
    }
    update();
}

void ManoeuvreLine::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF at = event->position();
    if (!(event->buttons() & Qt::LeftButton) || m_grip == Grip::None) {
        const Hit hit = hitAt(at);
        setCursor(hit.grip == Grip::From || hit.grip == Grip::To ? Qt::SizeHorCursor
                : hit.grip == Grip::Whole                        ? Qt::SizeAllCursor
                : hit.grip == Grip::New                          ? Qt::CrossCursor
                                                                 : Qt::ArrowCursor);
        emit readOut(hit.grip == Grip::None ? QString()
                : hit.grip == Grip::New     ? tr("%1 s").arg(plainNumber(timeAt(at.x()), 0))
                                            : textOf(hit.block));
        return;
    }
    if (m_grip == Grip::New) {
        if (std::abs(at.x() - m_pressedAt.x()) < kLeastDrawn_px)
            return;
        const int lane = hitAt(m_pressedAt).block.lane;
        m_chosen = Block{m_manoeuvres.size(), lane};
        const double from = timeAt(std::min(m_pressedAt.x(), at.x())), value = valueAt(lane, at.y());
        Manoeuvre made{from, std::max(timeAt(std::max(m_pressedAt.x(), at.x())), from + kLeast_s), 0, 0, 0};
        valueOf(made, lane) = value != 0 ? value : kLaneKinds[static_cast<std::size_t>(lane)].usual;
        m_manoeuvres.push_back(made);
        m_before = made;
        m_grip = at.x() >= m_pressedAt.x() ? Grip::To : Grip::From;
        tell();
        return;
    }
    const double value = valueOf(m_before, m_chosen->lane), byTime = timeAt(at.x()) - timeAt(m_pressedAt.x());
    if (m_grip == Grip::From) {
        take(*m_chosen, std::min(timeAt(at.x()), m_before.to_s - kLeast_s), m_before.to_s, value);
    } else if (m_grip == Grip::To) {
        take(*m_chosen, m_before.from_s, std::max(timeAt(at.x()), m_before.from_s + kLeast_s), value);
    } else {
        const double moved = std::clamp(byTime, -m_before.from_s, std::max(0.0, m_duration_s - m_before.to_s));
        take(*m_chosen, m_before.from_s + moved, m_before.to_s + moved,
            value + valueAt(m_chosen->lane, at.y()) - valueAt(m_chosen->lane, m_pressedAt.y()));
    }
}

/// A block that was pushed down to nothing is gone.
void ManoeuvreLine::mouseReleaseEvent(QMouseEvent*)
{
    m_grip = Grip::None;
    if (m_chosen && valueOf(m_manoeuvres[m_chosen->manoeuvre], m_chosen->lane) == 0)
        remove();
}

void ManoeuvreLine::choose(int step)
{
    const std::vector<Block> all = blocks();
    if (all.empty())
        return;
    const auto now = m_chosen ? std::find(all.begin(), all.end(), *m_chosen) : all.end();
    const auto count = static_cast<std::ptrdiff_t>(all.size());
    const std::ptrdiff_t place = now == all.end() ? (step > 0 ? 0 : count - 1) : (now - all.begin() + step + count) % count;
    m_chosen = all[static_cast<std::size_t>(place)];
    emit readOut(textOf(*m_chosen));
    update();
}

/// In the lane of the chosen block, or of turns, behind it.
void ManoeuvreLine::insert()
{
    const int lane = m_chosen ? m_chosen->lane : Turn;
    const double length = std::max(kLeast_s, std::round(m_duration_s / 20));
    double from = m_chosen ? m_manoeuvres[m_chosen->manoeuvre].to_s + length : 0;
    from = std::clamp(from, 0.0, std::max(0.0, m_duration_s - length));
    Manoeuvre made{from, from + length, 0, 0, 0};
    valueOf(made, lane) = kLaneKinds[static_cast<std::size_t>(lane)].usual;
    m_manoeuvres.push_back(made);
    m_chosen = Block{m_manoeuvres.size() - 1, lane};
    tell();
}

void ManoeuvreLine::remove()
{
    if (!m_chosen)
        return;
    Manoeuvre& one = m_manoeuvres[m_chosen->manoeuvre];
    valueOf(one, m_chosen->lane) = 0;
    if (isEmpty(one))
        m_manoeuvres.erase(m_manoeuvres.begin() + static_cast<std::ptrdiff_t>(m_chosen->manoeuvre));
    m_chosen.reset();
    tell();
}

void ManoeuvreLine::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Insert: insert(); return;
    case Qt::Key_PageDown: choose(1); return;
    case Qt::Key_PageUp: choose(-1); return;
    default: break;
    }
    if (!m_chosen) {
        QWidget::keyPressEvent(event);
        return;
    }
    const Manoeuvre one = m_manoeuvres[m_chosen->manoeuvre];
    const double value = valueOf(one, m_chosen->lane), step = kLaneKinds[static_cast<std::size_t>(m_chosen->lane)].step;
    double along = event->modifiers() & Qt::ControlModifier ? 1 : 5;
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
        along = event->key() == Qt::Key_Left ? -along : along;
        if (event->modifiers() & Qt::ShiftModifier)
            take(*m_chosen, one.from_s, std::max(one.to_s + along, one.from_s + kLeast_s), value);
        else if (one.from_s + along >= 0 && one.to_s + along <= m_duration_s)
            take(*m_chosen, one.from_s + along, one.to_s + along, value);
        return;
    case Qt::Key_Up:
    case Qt::Key_Down: {
        // Through nothing to the other side: a block of nothing would be gone.
        const double by = event->key() == Qt::Key_Up ? step : -step, raised = stepped(value + by, step);
        take(*m_chosen, one.from_s, one.to_s, std::abs(raised) < step / 2 ? by : raised);
        return;
    }
    case Qt::Key_Delete:
    case Qt::Key_Backspace: remove(); return;
    default: QWidget::keyPressEvent(event);
    }
}

void ManoeuvreLine::focusInEvent(QFocusEvent* event)
{
    QWidget::focusInEvent(event);
    update();
}

void ManoeuvreLine::focusOutEvent(QFocusEvent* event)
{
    QWidget::focusOutEvent(event);
    update();
}

void ManoeuvreLine::leaveEvent(QEvent*) { emit readOut({}); }

void ManoeuvreLine::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const PlotColours colours = coloursFor(palette());
    painter.fillRect(rect(), colours.ground);
    const double line = fontMetrics().height();
    for (int lane = 0; lane < kLanes; ++lane) {
        const QRectF room = laneRect(lane);
        painter.setPen(colours.text);
        painter.drawText(QRectF(0, room.top(), room.left() - 0.5 * line, room.height()), Qt::AlignRight | Qt::AlignVCenter, laneName(lane));
        painter.setPen(QPen(colours.grid, 0));
        painter.drawRect(room);
        painter.setPen(QPen(colours.axis, 0));
        painter.drawLine(QPointF(room.left(), room.center().y()), QPointF(room.right(), room.center().y()));
    }
    const double step = niceStep(m_duration_s / std::max(2.0, laneRect(0).width() / (5 * line))), low = laneRect(kLanes - 1).bottom();
    for (double time = 0; time <= m_duration_s * (1 + 1e-9); time += step) {
        painter.setPen(QPen(colours.grid, 0));
        painter.drawLine(QPointF(xOf(time), 0), QPointF(xOf(time), low));
        painter.setPen(colours.text);
        const QString text = time + step > m_duration_s * (1 + 1e-9) ? tr("%1 s").arg(plainTick(time, step)) : plainTick(time, step);
        QRectF box(0, low + 0.1 * line, fontMetrics().horizontalAdvance(text) + 2, 1.2 * line);
        box.moveCenter({xOf(time), box.center().y()});
        box.moveRight(std::min(box.right(), static_cast<double>(width()))); // the last one and its unit
        painter.drawText(box, Qt::AlignHCenter | Qt::AlignTop, text);
    }
    for (const Block& block : blocks()) {
        const bool chosen = m_chosen && *m_chosen == block;
        painter.setBrush(colours.coefficient[static_cast<std::size_t>(block.lane) + 1]);
        painter.setPen(QPen(chosen ? colours.exact : colours.axis, chosen ? 2 : 0));
        painter.drawRect(blockRect(block));
    }
    painter.setBrush(Qt::NoBrush);
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

} // namespace lubberline::ui
