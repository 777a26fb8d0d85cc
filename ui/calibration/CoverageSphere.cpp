#include "ui/calibration/CoverageSphere.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "core/angle/Angle.h"
#include "ui/plots/base/PlotColours.h"

namespace lubberline::ui {

namespace {

constexpr int kRingSteps = 72;

enum class DotKind { Fits, Strong, Weak };

DotKind kindOf(double residual) { return std::abs(residual) < 1.5 ? DotKind::Fits : residual > 0 ? DotKind::Strong : DotKind::Weak; }

QColor dotColour(const PlotColours& colours, DotKind kind)
{
    return kind == DotKind::Fits ? colours.approximate : kind == DotKind::Strong ? colours.exact : colours.suspect;
}

/// What the dots and the ring mean, in one line at the foot.
void paintKey(QPainter& painter, const QRect& rect, const PlotColours& colours, bool gap)
{
    const std::array<std::pair<QString, QColor>, 4> entries{{{CoverageSphere::tr("fits"), dotColour(colours, DotKind::Fits)},
        {CoverageSphere::tr("field too strong"), dotColour(colours, DotKind::Strong)},
        {CoverageSphere::tr("too weak"), dotColour(colours, DotKind::Weak)}, {CoverageSphere::tr("no samples in the ring"), colours.text}}};
    const QFontMetrics metrics = painter.fontMetrics();
    const int dot = metrics.height() / 2, space = metrics.height();
    int wide = -space;
    for (std::size_t i = 0; i < (gap ? 4U : 3U); ++i)
        wide += 2 * dot + metrics.horizontalAdvance(entries[i].first) + space;
    int x = rect.center().x() - wide / 2;
    const int y = rect.bottom() - metrics.height();
    for (std::size_t i = 0; i < (gap ? 4U : 3U); ++i) {
        painter.setPen(i == 3 ? QPen(entries[i].second, 2) : QPen(Qt::NoPen));
        painter.setBrush(i == 3 ? QBrush(Qt::NoBrush) : QBrush(entries[i].second));
        painter.drawEllipse(QRect(x, y - dot, dot, dot));
        painter.setPen(colours.text);
        painter.drawText(x + 2 * dot, y, entries[i].first);
        x += 2 * dot + metrics.horizontalAdvance(entries[i].first) + space;
    }
}

} // namespace

CoverageSphere::CoverageSphere(QWidget* parent) : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Directions of the field that the log has seen"));
    setToolTip(tr("Turn it with the mouse or the arrow keys."));
}

void CoverageSphere::setDots(std::vector<SphereDot> dots, const Eigen::Vector3d& gap, double gap_deg)
{
    m_dots = std::move(dots);
    m_gap = gap;
    m_gap_deg = gap_deg;
    update();
}

Eigen::Matrix3d CoverageSphere::turn() const
{
    const double a = toRadians(m_azimuth_deg), e = toRadians(m_elevation_deg);
    // Looking at the sphere with z (down) downwards on the screen: right is y, towards the eye is x, then turned.
    Eigen::Matrix3d about;
    about << -std::sin(a), std::cos(a), 0, -std::cos(a) * std::sin(e), -std::sin(a) * std::sin(e), -std::cos(e), std::cos(a) * std::cos(e),
        std::sin(a) * std::cos(e), -std::sin(e);
    return about;
}

void CoverageSphere::turnBy(double azimuth_deg, double elevation_deg)
{
    m_azimuth_deg = wrap360(m_azimuth_deg + azimuth_deg);
    m_elevation_deg = std::clamp(m_elevation_deg + elevation_deg, -90.0, 90.0);
    update();
}

void CoverageSphere::paintEvent(QPaintEvent*)
{
    const PlotColours colours = coloursFor(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), colours.ground);
    const double radius = 0.38 * std::min(width(), height());
    const QPointF middle = QRectF(rect()).center();
    const Eigen::Matrix3d view = turn();
    const auto place = [&](const Eigen::Vector3d& direction) {
        const Eigen::Vector3d at = view * direction;
        return QPointF(middle.x() + radius * at.x(), middle.y() - radius * at.y());
    };
    painter.setPen(QPen(colours.axis, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(middle, radius, radius);
    // Those behind first, faint.
    for (const bool front : {false, true})
        for (const auto& dot : m_dots) {
            if ((view.row(2).dot(dot.direction) >= 0) != front)
                continue;
            painter.setPen(Qt::NoPen);
            painter.setBrush(front ? dotColour(colours, kindOf(dot.residual)) : colours.grid);
            painter.drawEllipse(place(dot.direction), front ? 2.5 : 1.5, front ? 2.5 : 1.5);
        }
    if (m_gap_deg > 0) {
        const Eigen::Vector3d side = m_gap.unitOrthogonal(), other = m_gap.cross(side);
        const double size = toRadians(m_gap_deg);
        QPolygonF ring;
        for (int i = 0; i <= kRingSteps; ++i) {
            const double a = 2 * kPi * i / kRingSteps;
            ring.append(place(std::cos(size) * m_gap + std::sin(size) * (std::cos(a) * side + std::sin(a) * other)));
        }
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colours.text, 2, view.row(2).dot(m_gap) >= 0 ? Qt::SolidLine : Qt::DotLine));
        painter.drawPolyline(ring);
    }
    const std::array<std::pair<QString, Eigen::Vector3d>, 6> ends{{{tr("nose"), {1, 0, 0}}, {tr("tail"), {-1, 0, 0}},
        {tr("right"), {0, 1, 0}}, {tr("left"), {0, -1, 0}}, {tr("belly"), {0, 0, 1}}, {tr("roof"), {0, 0, -1}}}};
    for (const auto& [word, direction] : ends) {
        painter.setPen(view.row(2).dot(direction) >= 0 ? colours.text : colours.faint);
        const QPointF at = middle + 1.12 * (place(direction) - middle);
        painter.drawText(QRectF(at - QPointF(40, 12), QSizeF(80, 24)), Qt::AlignCenter, word);
    }
    if (!m_dots.empty())
        paintKey(painter, rect(), colours, m_gap_deg > 0);
    if (hasFocus()) {
        painter.setPen(QPen(palette().highlight().color(), 1, Qt::DashLine));
        painter.drawRect(rect().adjusted(1, 1, -2, -2));
    }
}

void CoverageSphere::mousePressEvent(QMouseEvent* event) { m_last = event->pos(); }

void CoverageSphere::mouseMoveEvent(QMouseEvent* event)
{
    const QPoint by = event->pos() - m_last;
    m_last = event->pos();
    turnBy(-0.5 * by.x(), 0.5 * by.y());
}

void CoverageSphere::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Left: turnBy(-10, 0); break;
    case Qt::Key_Right: turnBy(10, 0); break;
    case Qt::Key_Up: turnBy(0, 10); break;
    case Qt::Key_Down: turnBy(0, -10); break;
    default: QWidget::keyPressEvent(event);
    }
}

} // namespace lubberline::ui
