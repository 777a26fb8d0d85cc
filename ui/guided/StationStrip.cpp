#include "ui/guided/StationStrip.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>

#include "ui/guided/GuidedWords.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

constexpr double kGap_px = 3;

void drawTick(QPainter& painter, const QRectF& box)
{
    painter.drawLine(QPointF(box.left() + box.width() * 0.3, box.bottom() - 9), QPointF(box.center().x() - 1, box.bottom() - 5));
    painter.drawLine(QPointF(box.center().x() - 1, box.bottom() - 5), QPointF(box.right() - box.width() * 0.25, box.bottom() - 13));
}

} // namespace

StationStrip::StationStrip(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("stationStrip"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Headings of this swing"));
}

void StationStrip::show(const JobState& state)
{
    m_state = state;
    QStringList words;
    for (std::size_t i = 0; i < state.stations.size(); ++i)
        words += wordsOf(state.stations[i], static_cast<int>(i) == state.current);
    setAccessibleDescription(words.join(QStringLiteral("; ")));
    if (m_chosen >= static_cast<int>(state.stations.size()))
        m_chosen = -1;
    update();
}

void StationStrip::choose(int station)
{
    m_chosen = station;
    update();
    const bool known = station >= 0 && station < static_cast<int>(m_state.stations.size());
    emit chosen(known ? wordsOf(m_state.stations[static_cast<std::size_t>(station)], station == m_state.current) : QString());
}

/// A skipped heading is gone to at once; what was read is chosen, and read again only when that is said.
void StationStrip::mousePressEvent(QMouseEvent* event)
{
    for (std::size_t i = 0; i < m_state.stations.size(); ++i)
        if (boxOf(i).contains(event->position())) {
            choose(static_cast<int>(i));
            if (!m_state.stations[i].skipped.empty())
                emit wanted(static_cast<int>(i));
        }
}

void StationStrip::keyPressEvent(QKeyEvent* event)
{
    const int last = static_cast<int>(m_state.stations.size()) - 1, from = m_chosen >= 0 ? m_chosen : m_state.current;
    if (event->key() == Qt::Key_Left || event->key() == Qt::Key_Right)
        choose(std::clamp(from + (event->key() == Qt::Key_Left ? -1 : 1), 0, std::max(last, 0)));
    else if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter || event->key() == Qt::Key_F2) && m_chosen >= 0)
        emit wanted(m_chosen);
    else
        QWidget::keyPressEvent(event);
}

void StationStrip::focusOutEvent(QFocusEvent* event)
{
    QWidget::focusOutEvent(event);
    update();
}

QRectF StationStrip::boxOf(std::size_t station) const
{
    const double each = (width() - kGap_px) / static_cast<double>(std::max<std::size_t>(m_state.stations.size(), 1));
    return {kGap_px + each * static_cast<double>(station), kGap_px, each - kGap_px, height() - 2 * kGap_px};
}

QString StationStrip::wordsOf(const StationState& station, bool now) const
{
    const QString heading = stationHeading(station.station.nominal_deg);
    if (!station.skipped.empty())
        return tr("%1: skipped, %2").arg(heading, toText(station.skipped));
    if (station.voided)
        return tr("%1: void, to be read again").arg(heading);
    if (station.reading)
        return tr("%1: compass read %2").arg(heading, figureText(station.reading->compass.degrees()));
    return now ? tr("%1: now").arg(heading) : tr("%1: to come").arg(heading);
}

void StationStrip::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor ink = palette().color(QPalette::WindowText), accent = palette().color(QPalette::Highlight);
    QFont small = font();
    small.setPixelSize(13);
    painter.setFont(small);
    for (std::size_t i = 0; i < m_state.stations.size(); ++i) {
        const auto& station = m_state.stations[i];
        const QRectF box = boxOf(i);
        const bool now = static_cast<int>(i) == m_state.current;
        QColor ground = palette().color(QPalette::Base);
        if (station.done())
            ground = palette().color(QPalette::Midlight);
        const bool chosen = static_cast<int>(i) == m_chosen && hasFocus();
        if (chosen) {
            painter.setPen(QPen(ink, 1, Qt::DotLine));
            painter.setBrush(Qt::NoBrush);
            painter.drawRect(box.adjusted(-2, -2, 2, 2));
        }
        painter.setPen(QPen(now ? accent : palette().color(QPalette::Mid), now ? 3 : 1));
        painter.setBrush(station.skipped.empty() ? QBrush(ground) : QBrush(palette().color(QPalette::Mid), Qt::BDiagPattern));
        painter.drawRoundedRect(box, 3, 3);
        painter.setPen(QPen(ink, 2));
        if (station.voided) {
            painter.drawLine(box.topLeft(), box.bottomRight());
            painter.drawLine(box.topRight(), box.bottomLeft());
        } else if (station.reading && station.done()) {
            drawTick(painter, box);
        }
        painter.setPen(ink);
        if (box.width() > 22)
            painter.drawText(box.adjusted(0, 2, 0, 0), Qt::AlignHCenter | Qt::AlignTop,
                QStringLiteral("%1").arg(station.station.nominal_deg, 3, 'f', 0, QChar('0')));
    }
}

bool StationStrip::event(QEvent* event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto& help = static_cast<QHelpEvent&>(*event);
    for (std::size_t i = 0; i < m_state.stations.size(); ++i)
        if (boxOf(i).contains(help.pos()))
            QToolTip::showText(help.globalPos(), wordsOf(m_state.stations[i], static_cast<int>(i) == m_state.current), this);
    return true;
}

} // namespace lubberline::ui
