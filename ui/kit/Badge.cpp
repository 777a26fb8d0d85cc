#include "ui/kit/Badge.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPixmap>

#include <array>

namespace lubberline::ui {

namespace {

struct BadgeTexts {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::Badge)
};

constexpr int kSize = 32; // drawn large and shown at 16: sharp on screens of high density

void drawShape(QPainter& painter, Status status)
{
    const QRectF frame(5, 5, kSize - 10, kSize - 10);
    painter.setPen(QPen(badgeColour(status), 4));
    switch (status) {
    case Status::InLimits:
        painter.setBrush(badgeColour(status));
        painter.drawEllipse(frame);
        break;
    case Status::OutOfLimits:
        painter.setBrush(badgeColour(status));
        painter.drawPolygon(QPolygonF({frame.bottomLeft(), frame.bottomRight(), {frame.center().x(), frame.top()}}));
        break;
    case Status::NotKnown:
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(frame);
        break;
    }
}

QIcon drawn(Status status)
{
    QPixmap pixmap(kSize, kSize);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    drawShape(painter, status);
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected); // a selected line must not tint what the colour says
    return icon;
}

} // namespace

QString badgeWord(Status status)
{
    switch (status) {
    case Status::InLimits: return BadgeTexts::tr("in limits");
    case Status::OutOfLimits: return BadgeTexts::tr("out of limits");
    case Status::NotKnown: break;
    }
    return BadgeTexts::tr("not known");
}

QString badgeMeaning(Status status)
{
    switch (status) {
    case Status::InLimits: return BadgeTexts::tr("In limits: the newest swing of every compass keeps the limits set for it");
    case Status::OutOfLimits: return BadgeTexts::tr("Out of limits: the newest swing of a compass exceeds the limits set for it");
    case Status::NotKnown: break;
    }
    return BadgeTexts::tr("Not known: no limits are set, or no swing with a result is on record");
}

QColor badgeColour(Status status)
{
    switch (status) { // Okabe and Ito's green and vermilion: apart with every kind of colour vision
    case Status::InLimits: return QColor(0x00, 0x9E, 0x73);
    case Status::OutOfLimits: return QColor(0xD5, 0x5E, 0x00);
    case Status::NotKnown: break;
    }
    return QColor(0x80, 0x80, 0x80);
}

QIcon badgeIcon(Status status)
{
    static const std::array<QIcon, 3> icons{drawn(Status::NotKnown), drawn(Status::InLimits), drawn(Status::OutOfLimits)};
    return icons[static_cast<std::size_t>(status)];
}

} // namespace lubberline::ui
