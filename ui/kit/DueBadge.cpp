#include "ui/kit/DueBadge.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPixmap>
#include <QStringList>

#include <array>

namespace lubberline::ui {

namespace {

struct DueBadgeTexts {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::DueBadge)
};

constexpr int kDueSize = 32;

QColor colourOf(DueState state)
{
    switch (state) { // Okabe and Ito's vermilion, orange and blue
    case DueState::Overdue: return QColor(0xD5, 0x5E, 0x00);
    case DueState::Due: return QColor(0xE6, 0x9F, 0x00);
    case DueState::DueSoon: return QColor(0x00, 0x72, 0xB2);
    case DueState::NotDue: break;
    }
    return QColor(0x80, 0x80, 0x80);
}

QIcon drawnDue(DueState state)
{
    QPixmap pixmap(kDueSize, kDueSize);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor colour = colourOf(state);
    painter.setPen(QPen(colour, 4));
    const QRectF frame(6, 6, kDueSize - 12, kDueSize - 12);
    if (state == DueState::Overdue)
        painter.fillRect(frame, colour);
    else if (state == DueState::Due)
        painter.drawRect(frame);
    else if (state == DueState::DueSoon)
        painter.fillRect(QRectF(6, 13, kDueSize - 12, 6), colour);
    else
        painter.drawEllipse(QPointF(kDueSize / 2.0, kDueSize / 2.0), 2, 2);
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected); // a selected line must not tint what the colour says
    return icon;
}

} // namespace

QString dueWord(DueState state)
{
    switch (state) {
    case DueState::Overdue: return DueBadgeTexts::tr("overdue");
    case DueState::Due: return DueBadgeTexts::tr("due");
    case DueState::DueSoon: return DueBadgeTexts::tr("due soon");
    case DueState::NotDue: break;
    }
    return DueBadgeTexts::tr("not due");
}

QString dueMark(DueState state)
{
    switch (state) {
    case DueState::Overdue: return QStringLiteral("\u25a0");
    case DueState::Due: return QStringLiteral("\u25a1");
    case DueState::DueSoon: return QStringLiteral("\u25ac");
    case DueState::NotDue: break;
    }
    return QStringLiteral("\u00b7");
}

QIcon dueIcon(DueState state)
{
    static const std::array<QIcon, 4> icons{
        drawnDue(DueState::NotDue), drawnDue(DueState::DueSoon), drawnDue(DueState::Due), drawnDue(DueState::Overdue)};
    return icons[static_cast<std::size_t>(state)];
}

} // namespace lubberline::ui
