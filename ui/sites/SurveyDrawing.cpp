#include "ui/sites/SurveyDrawing.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

#include "ui/kit/Words.h"
#include "ui/plots/map/DivergingMap.h"

namespace lubberline::ui {

namespace {

constexpr double kMargin_px = 46, kDot_px = 9;

} // namespace

SurveyDrawing::SurveyDrawing(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("surveyDrawing"));
    setMinimumSize(200, 180);
}

std::optional<double> SurveyDrawing::valueOf(const SurveyPoint& point) const
{
    return m_scale.declination ? point.declination_deg : point.total_nT;
}

void SurveyDrawing::setSurvey(const std::vector<SurveyPoint>& points)
{
    m_points = points;
    m_scale = {};
    m_scale.declination
        = std::any_of(points.begin(), points.end(), [](const SurveyPoint& point) { return point.declination_deg.has_value(); });
    double sum = 0;
    int count = 0;
    double west = 0, east = 0, south = 0, north = 0;
    for (const auto& point : points) {
        if (const auto value = valueOf(point))
            sum += *value, ++count;
        west = std::min(west, point.east_m), east = std::max(east, point.east_m);
        south = std::min(south, point.north_m), north = std::max(north, point.north_m);
    }
    m_extent_m = QRectF(west, south, std::max(east - west, 1.0), std::max(north - south, 1.0));
    m_scale.mean = count > 0 ? sum / count : 0;
    for (const auto& point : points)
        if (const auto value = valueOf(point))
            m_scale.largest = std::max(m_scale.largest, std::abs(*value - m_scale.mean));
    update();
}

QString SurveyDrawing::words(const SurveyPoint& point) const
{
    const auto value = valueOf(point);
    if (!value)
        return {};
    return m_scale.declination ? tr("%1′").arg(signedNumber((*value - m_scale.mean) * 60, 1))
                               : tr("%1 nT").arg(signedNumber(*value - m_scale.mean, 1));
}

QPointF SurveyDrawing::onScreen(const SurveyPoint& point) const
{
    const double scale = std::min((width() - 2 * kMargin_px) / m_extent_m.width(), (height() - 2 * kMargin_px) / m_extent_m.height());
    const QPointF centre(width() / 2.0, height() / 2.0);
    return centre + QPointF(point.east_m - m_extent_m.center().x(), -(point.north_m - m_extent_m.center().y())) * scale;
}

void SurveyDrawing::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    painter.setPen(palette().color(QPalette::Text));
    if (m_points.empty()) {
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, tr("No survey yet: type or paste its points into the table"));
        return;
    }
    for (const auto& point : m_points) {
        const QPointF at = onScreen(point);
        const auto value = valueOf(point);
        painter.setBrush(
            value && m_scale.largest > 0 ? divergingColour((*value - m_scale.mean) / m_scale.largest) : palette().color(QPalette::Mid));
        painter.setPen(palette().color(QPalette::Text));
        painter.drawEllipse(at, kDot_px, kDot_px);
        painter.drawText(QRectF(at.x() - 40, at.y() + kDot_px, 80, 16), Qt::AlignHCenter, words(point));
    }
    painter.drawText(QRectF(6, 4, width() - 12, 18), Qt::AlignLeft,
        m_scale.declination ? tr("declination − mean (′), east +; true north up") : tr("total field − mean (nT); true north up"));
    const double scale = std::abs(onScreen({10, 0, 0, {}, {}}).x() - onScreen({0, 0, 0, {}, {}}).x());
    const double y = height() - 12.0;
    painter.drawLine(QPointF(10, y), QPointF(10 + scale, y));
    painter.drawText(QPointF(14, y - 3), tr("10 m"));
}

bool SurveyDrawing::event(QEvent* event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto& help = static_cast<QHelpEvent&>(*event);
    for (const auto& point : m_points)
        if (QLineF(onScreen(point), help.pos()).length() < kDot_px + 3) {
            QString text = tr("%1 m east, %2 m north").arg(point.east_m).arg(point.north_m);
            if (point.declination_deg)
                text += tr("\ndeclination %1° (E +)").arg(signedNumber(*point.declination_deg, 3));
            if (point.total_nT)
                text += tr("\ntotal field %1 nT").arg(*point.total_nT, 0, 'f', 1);
            QToolTip::showText(help.globalPos(), text, this);
        }
    return true;
}

} // namespace lubberline::ui
