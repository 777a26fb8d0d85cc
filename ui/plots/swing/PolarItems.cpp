#include "ui/plots/swing/PolarItems.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <qwt_interval.h>
#include <qwt_polar.h>
#include <qwt_scale_map.h>

#include "core/angle/Angle.h"
#include "ui/plots/base/Chart.h"
#include "ui/plots/swing/PictureText.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

constexpr double kScaleGap = 9; ///< between the line to the north and the labels of the scale: a reading at 000 has room
constexpr double kTick = 4;

QString rimName(int heading_deg)
{
    switch (heading_deg) {
    case 0: return QStringLiteral("N");
    case 90: return QStringLiteral("E");
    case 180: return QStringLiteral("S");
    case 270: return QStringLiteral("W");
    default: return QStringLiteral("%1°").arg(heading_deg, 3, 10, QChar('0'));
    }
}

QFont boldOf(QFont font)
{
    font.setBold(true);
    return font;
}

/// Where the name of a heading stands outside the rim.
QRectF rimPlace(const QPointF& pole, double radius, int heading_deg, const QFont& font)
{
    const QFontMetricsF metrics(font);
    const QSizeF size(metrics.horizontalAdvance(rimName(heading_deg)) + 2, metrics.height());
    const double heading_rad = toRadians(heading_deg);
    const double reach = std::abs(std::sin(heading_rad)) * size.width() / 2 + std::abs(std::cos(heading_rad)) * size.height() / 2;
    QRectF place(QPointF(), size);
    place.moveCenter(polarPlace(pole, heading_deg, radius + kTick + 2 + reach));
    return place;
}

struct Caption {
    QString text;
    std::array<Qt::Alignment, 2> corners; ///< the better one first
};

double nearestTo(const QPointF& point, const QRectF& box)
{
    return std::hypot(
        point.x() - std::clamp(point.x(), box.left(), box.right()), point.y() - std::clamp(point.y(), box.top(), box.bottom()));
}

/// Valid and inside the scale: otherwise Qwt clips by a region of whole pixels.
QwtInterval noClipping(int scaleId) { return scaleId == QwtPolar::Radius ? QwtInterval(0, 0) : QwtInterval(); }

} // namespace

QPointF polarPlace(const QPointF& pole, double heading_deg, double distance)
{
    const double heading_rad = toRadians(heading_deg);
    return pole + distance * QPointF(std::sin(heading_rad), -std::cos(heading_rad));
}

PolarGround::PolarGround()
{
    setZ(0);
    setRenderHint(RenderAntialiased);
}

void PolarGround::setLook(const PlotColours& colours, const QFont& font)
{
    m_colours = colours;
    m_font = pixelFont(font);
}

QwtInterval PolarGround::boundingInterval(int scaleId) const { return noClipping(scaleId); }

int PolarGround::marginHint() const
{
    const QFontMetricsF metrics(m_font);
    return static_cast<int>(std::ceil(std::max(metrics.horizontalAdvance(QStringLiteral("000°")), metrics.height()) + kTick + 4));
}

void PolarGround::draw(
    QPainter* painter, const QwtScaleMap&, const QwtScaleMap& radialMap, const QPointF& pole, double radius, const QRectF& canvasRect) const
{
    painter->setRenderHint(QPainter::Antialiasing);
    const bool limit = m_limit_deg && m_limitShown;
    if (limit)
        drawLimit(*painter, radialMap, pole);
    drawGrid(*painter, radialMap, pole, radius);
    if (limit)
        drawLimitEdge(*painter, radialMap, pole);
    drawHeadings(*painter, pole, radius);
    drawScale(*painter, radialMap, pole, radius);
    drawCaptions(*painter, canvasRect, pole, radius);
}

void PolarGround::drawLimit(QPainter& painter, const QwtScaleMap& radialMap, const QPointF& pole) const
{
    const double limit_deg = std::min(*m_limit_deg, m_scale.end);
    const double outer = radialMap.transform(limit_deg), inner = radialMap.transform(-limit_deg);
    QPainterPath band;
    band.addEllipse(pole, outer, outer);
    if (inner > 0.5) {
        QPainterPath hole;
        hole.addEllipse(pole, inner, inner);
        band = band.subtracted(hole);
    }
    painter.fillPath(band, m_colours.limit);
}

void PolarGround::drawLimitEdge(QPainter& painter, const QwtScaleMap& radialMap, const QPointF& pole) const
{
    if (*m_limit_deg > m_scale.end)
        return;
    painter.setPen(QPen(m_colours.limitEdge, 1.4));
    painter.setBrush(Qt::NoBrush);
    for (const double edge_deg : {*m_limit_deg, -*m_limit_deg}) {
        const double ring = radialMap.transform(edge_deg);
        painter.drawEllipse(pole, ring, ring);
    }
}

void PolarGround::drawGrid(QPainter& painter, const QwtScaleMap& radialMap, const QPointF& pole, double radius) const
{
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(m_colours.grid, 1));
    const int steps = static_cast<int>(std::lround(m_scale.end / m_scale.step));
    for (int i = -steps + 1; i < steps; ++i) {
        const double ring = radialMap.transform(i * m_scale.step);
        painter.drawEllipse(pole, ring, ring);
    }
    const double innermost = radialMap.transform(-m_scale.end + m_scale.step);
    for (int heading_deg = 0; heading_deg < 360; heading_deg += 30) {
        const double from = heading_deg % 90 == 0 ? 0 : innermost; // twelve lines meeting at the pole would make a blot
        painter.drawLine(polarPlace(pole, heading_deg, from), polarPlace(pole, heading_deg, radius));
    }
    painter.setPen(QPen(m_colours.axis, 1));
    painter.drawEllipse(pole, radius, radius);
    for (int heading_deg = 0; heading_deg < 360; heading_deg += 10) {
        const double length = heading_deg % 30 == 0 ? kTick : kTick / 2;
        painter.drawLine(polarPlace(pole, heading_deg, radius), polarPlace(pole, heading_deg, radius + length));
    }
    painter.setPen(QPen(m_colours.axis, 2.2));
    const double zero = radialMap.transform(0);
    painter.drawEllipse(pole, zero, zero);
}

void PolarGround::drawHeadings(QPainter& painter, const QPointF& pole, double radius) const
{
    const QFont bold = boldOf(m_font);
    painter.setPen(m_colours.text);
    for (int heading_deg = 0; heading_deg < 360; heading_deg += 30) {
        painter.setFont(heading_deg % 90 == 0 ? bold : m_font);
        painter.drawText(rimPlace(pole, radius, heading_deg, painter.font()), Qt::AlignCenter | Qt::TextSingleLine, rimName(heading_deg));
    }
}

/// The names of the rim have their places first: where the outermost label would stand in one, it stands beneath, or nowhere.
void PolarGround::drawScale(QPainter& painter, const QwtScaleMap& radialMap, const QPointF& pole, double radius) const
{
    painter.setFont(m_font);
    const QFontMetricsF metrics(m_font);
    const int steps = static_cast<int>(std::lround(m_scale.end / m_scale.step));
    const double spacing = radialMap.transform(m_scale.step) - radialMap.transform(0);
    const int every = spacing < 1.1 * metrics.height() ? 2 : 1;
    for (int i = -steps; i <= steps; ++i) {
        if (i % every != 0)
            continue;
        const QString label = degreeTick(i * m_scale.step, m_scale.step);
        QRectF place(0, 0, metrics.horizontalAdvance(label) + 4, metrics.height() - 3);
        const double ring = radialMap.transform(i * m_scale.step);
        place.moveLeft(pole.x() + kScaleGap);
        place.moveTop(pole.y() - std::sqrt(std::max(0.0, ring * ring - kScaleGap * kScaleGap)) - place.height() / 2);
        double beneath = place.top();
        for (const int named_deg : {0, 30})
            if (const QRectF rim = rimPlace(pole, radius, named_deg, named_deg == 0 ? boldOf(m_font) : m_font); rim.intersects(place))
                beneath = std::max(beneath, rim.bottom());
        if (beneath - place.top() > std::max(0.0, spacing * every - metrics.height()))
            continue;
        place.moveTop(beneath);
        painter.setPen(Qt::NoPen);
        const bool tinted = m_limit_deg && m_limitShown && std::abs(i * m_scale.step) < *m_limit_deg - 0.3 * m_scale.step;
        painter.setBrush(tinted ? m_colours.limit : m_colours.ground);
        painter.drawRoundedRect(place, 3, 3);
        painter.setPen(m_colours.faint);
        painter.drawText(place, Qt::AlignCenter | Qt::TextSingleLine, label);
    }
}

/// In corners that the circle and the names of its headings leave free; where none is, a caption is left out.
void PolarGround::drawCaptions(QPainter& painter, const QRectF& within, const QPointF& pole, double radius) const
{
    std::vector<QRectF> taken;
    for (int heading_deg = 0; heading_deg < 360; heading_deg += 30)
        taken.push_back(rimPlace(pole, radius, heading_deg, m_font));
    const QRectF room = within.adjusted(4, 2, -4, -2);
    painter.setFont(m_font);
    painter.setPen(m_colours.faint);
    for (const Caption& caption : {Caption{deviationCaption(), {Qt::AlignLeft | Qt::AlignBottom, Qt::AlignLeft | Qt::AlignTop}},
             Caption{headingCaption(), {Qt::AlignRight | Qt::AlignBottom, Qt::AlignRight | Qt::AlignTop}}})
        for (const Qt::Alignment corner : caption.corners) {
            const QRectF box = painter.boundingRect(room, static_cast<int>(corner), caption.text);
            if (!room.contains(box) || nearestTo(pole, box) < radius + kTick
                || std::any_of(taken.begin(), taken.end(), [&](const QRectF& other) { return other.intersects(box); }))
                continue;
            painter.drawText(box, static_cast<int>(corner), caption.text);
            taken.push_back(box);
            break;
        }
}

PolarReadings::PolarReadings()
{
    setZ(30);
    setRenderHint(RenderAntialiased);
}

void PolarReadings::setLook(const PlotColours& colours, const QFont& font)
{
    m_colours = colours;
    m_font = pixelFont(font);
}

QwtInterval PolarReadings::boundingInterval(int scaleId) const { return noClipping(scaleId); }

void PolarReadings::draw(
    QPainter* painter, const QwtScaleMap&, const QwtScaleMap& radialMap, const QPointF& pole, double radius, const QRectF& canvasRect) const
{
    LabelRoom room{canvasRect};
    for (int heading_deg = 0; heading_deg < 360; heading_deg += 30)
        room.taken.push_back(rimPlace(pole, radius, heading_deg, m_font));
    const auto project = [&](double heading_deg, double value_deg) {
        return polarPlace(pole, heading_deg, std::max(0.0, radialMap.transform(value_deg)));
    };
    paintReadings(*painter, m_points, m_selectedRow, project, room, m_colours, m_font);
}

PolarNotice::PolarNotice() { setZ(40); }

void PolarNotice::setLook(const PlotColours& colours, const QFont& font)
{
    m_colours = colours;
    m_font = pixelFont(font);
}

QwtInterval PolarNotice::boundingInterval(int scaleId) const { return noClipping(scaleId); }

void PolarNotice::draw(QPainter* painter, const QwtScaleMap&, const QwtScaleMap&, const QPointF&, double, const QRectF& canvasRect) const
{
    paintNotice(*painter, canvasRect, m_text, m_colours, m_font);
}

} // namespace lubberline::ui
