#include "ui/kit/MessagePanel.h"

#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/kit/LongWords.h"

namespace lubberline::ui {

MessagePanel::MessagePanel(QWidget* parent) : QWidget(parent), m_rows(new QVBoxLayout(this))
{
    setObjectName(QStringLiteral("messagePanel"));
    m_rows->setContentsMargins(6, 4, 6, 4);
    m_rows->setSpacing(3);
    hide();
}

QWidget* MessagePanel::makeRow(Kind kind, const QString& message)
{
    auto* row = new QFrame;
    row->setFrameShape(QFrame::StyledPanel);
    row->setAutoFillBackground(true);
    row->setProperty("message", message);
    row->setProperty("news", kind == Kind::Information);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(8, 3, 4, 3);
    auto* sign = new QLabel;
    const int size = style()->pixelMetric(QStyle::PM_SmallIconSize);
    sign->setPixmap(
        style()->standardIcon(kind == Kind::Failure ? QStyle::SP_MessageBoxWarning : QStyle::SP_MessageBoxInformation).pixmap(size));
    auto* text = new QLabel(breakable(message));
    text->setObjectName(QStringLiteral("messageText"));
    text->setTextFormat(Qt::PlainText);
    text->setWordWrap(true);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    auto* dismiss = new QToolButton;
    dismiss->setObjectName(QStringLiteral("dismissMessage"));
    dismiss->setText(QStringLiteral("✕"));
    dismiss->setAutoRaise(true);
    dismiss->setFocusPolicy(Qt::StrongFocus);
    dismiss->setToolTip(tr("Dismiss"));
    dismiss->setAccessibleName(tr("Dismiss this message"));
    layout->addWidget(sign);
    layout->addWidget(text, 1);
    layout->addWidget(dismiss);
    connect(dismiss, &QToolButton::clicked, this, [this, row] { remove(row); });
    return row;
}

void MessagePanel::add(Kind kind, const QString& message)
{
    if (messages().contains(message))
        return;
    for (int i = m_rows->count() - 1; kind == Kind::Information && i >= 0; --i)
        if (QWidget* row = m_rows->itemAt(i)->widget(); row->property("news").toBool())
            remove(row);
    m_rows->addWidget(makeRow(kind, message));
    show();
}

void MessagePanel::add(Kind kind, const QString& message, const QString& answer, const std::function<void()>& act)
{
    QWidget* row = makeRow(kind, message);
    auto* button = new QPushButton(answer);
    button->setObjectName(QStringLiteral("answerMessage"));
    auto* layout = static_cast<QHBoxLayout*>(row->layout());
    layout->insertWidget(layout->count() - 1, button);
    connect(button, &QPushButton::clicked, this, [this, row, act] {
        remove(row);
        act();
    });
    m_rows->addWidget(row);
    show();
}

void MessagePanel::remove(QWidget* row)
{
    m_rows->removeWidget(row);
    row->hide();
    row->deleteLater();
    setVisible(m_rows->count() > 0);
}

QStringList MessagePanel::messages() const
{
    QStringList all;
    for (int i = 0; i < m_rows->count(); ++i)
        all += m_rows->itemAt(i)->widget()->property("message").toString();
    return all;
}

void MessagePanel::clear()
{
    while (m_rows->count() > 0)
        remove(m_rows->itemAt(0)->widget());
}

} // namespace lubberline::ui
