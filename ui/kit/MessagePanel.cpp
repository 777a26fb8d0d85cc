#include "ui/kit/MessagePanel.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>

#include <algorithm>

#include "ui/kit/fit/LongWords.h"

namespace lubberline::ui {

MessagePanel::MessagePanel(QWidget* parent)
    : QWidget(parent)
    , m_sign(new QLabel)
    , m_text(new QLabel)
    , m_more(new QLabel)
    , m_answers(new QWidget)
{
    setObjectName(QStringLiteral("messagePanel"));
    m_text->setObjectName(QStringLiteral("messageText"));
    m_text->setTextFormat(Qt::PlainText);
    m_text->setWordWrap(true);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_more->setObjectName(QStringLiteral("moreMessages"));
    auto* dismiss = new QToolButton;
    dismiss->setObjectName(QStringLiteral("dismissMessage"));
    dismiss->setText(QStringLiteral("✕"));
    dismiss->setAutoRaise(true);
    dismiss->setFocusPolicy(Qt::StrongFocus);
    dismiss->setToolTip(tr("Close (Esc)"));
    dismiss->setAccessibleName(tr("Close this message"));
    auto* frame = new QFrame;
    frame->setFrameShape(QFrame::StyledPanel);
    frame->setAutoFillBackground(true);
    auto* row = new QHBoxLayout(frame);
    row->setContentsMargins(8, 3, 4, 3);
    (new QHBoxLayout(m_answers))->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_sign);
    row->addWidget(m_text, 1);
    row->addWidget(m_answers);
    row->addWidget(m_more);
    row->addWidget(dismiss);
    auto* whole = new QHBoxLayout(this);
    whole->setContentsMargins(6, 4, 6, 4);
    whole->addWidget(frame);
    connect(dismiss, &QToolButton::clicked, this, &MessagePanel::closeShown);
    hide();
}

void MessagePanel::add(Kind kind, const QString& message, const std::vector<Answer>& answers, Stay stay)
{
    if (messages().contains(message))
        return;
    if (kind == Kind::Information)
        removeIf([](const Entry& entry) { return entry.kind == Kind::Information && entry.stay == Stay::OnThisPage; });
    m_entries.push_back({kind, message, answers, stay});
    showFront();
}

const MessagePanel::Entry* MessagePanel::front() const
{
    const auto failure = std::find_if(m_entries.rbegin(), m_entries.rend(), [](const Entry& entry) { return entry.kind == Kind::Failure; });
    if (failure != m_entries.rend())
        return &*failure;
    return m_entries.empty() ? nullptr : &m_entries.back();
}

void MessagePanel::showFront()
{
    const Entry* entry = front();
    setVisible(entry != nullptr);
    for (auto* button : m_answers->findChildren<QPushButton*>(QString(), Qt::FindDirectChildrenOnly)) {
        button->hide();
        button->setObjectName({}); // what goes answers nothing
        button->deleteLater();
    }
    if (!entry) {
        m_text->clear();
        return;
    }
    const bool failure = entry->kind == Kind::Failure;
    m_sign->setPixmap(style()
                          ->standardIcon(failure ? QStyle::SP_MessageBoxWarning : QStyle::SP_MessageBoxInformation)
                          .pixmap(style()->pixelMetric(QStyle::PM_SmallIconSize)));
    m_sign->setAccessibleName(failure ? tr("failure") : tr("news"));
    m_text->setText(breakable(entry->text));
    m_text->setAccessibleName(entry->text);
    const int waiting = static_cast<int>(m_entries.size()) - 1;
    m_more->setVisible(waiting > 0);
    m_more->setText(tr("%n more", nullptr, waiting));
    for (std::size_t place = 0; place < entry->answers.size(); ++place) {
        auto* button = new QPushButton(entry->answers[place].text);
        button->setObjectName(place == 0 ? QStringLiteral("answerMessage") : QStringLiteral("answerMessage%1").arg(place + 1));
        connect(button, &QPushButton::clicked, this, [this, place] { answer(place); });
        m_answers->layout()->addWidget(button);
    }
    m_answers->setVisible(!entry->answers.empty());
}

void MessagePanel::answer(std::size_t place)
{
    const Entry* entry = front();
    if (!entry || place >= entry->answers.size())
        return;
    const Answer chosen = entry->answers[place];
    if (chosen.closes)
        closeShown();
    chosen.act();
}

template <class Predicate>
void MessagePanel::removeIf(Predicate gone)
{
    m_entries.erase(std::remove_if(m_entries.begin(), m_entries.end(), gone), m_entries.end());
    showFront();
}

bool MessagePanel::closeShown()
{
    const Entry* entry = front();
    if (!entry)
        return false;
    m_entries.erase(m_entries.begin() + (entry - m_entries.data()));
    showFront();
    return true;
}

void MessagePanel::turned()
{
    removeIf([](const Entry& entry) { return entry.stay == Stay::OnThisPage; });
}

void MessagePanel::mended()
{
    removeIf([](const Entry& entry) { return entry.kind == Kind::Failure && entry.stay == Stay::OnThisPage; });
}

void MessagePanel::clear()
{
    m_entries.clear();
    showFront();
}

QString MessagePanel::shown() const
{
    const Entry* entry = front();
    return entry ? entry->text : QString();
}

QStringList MessagePanel::messages() const
{
    QStringList all;
    for (const Entry& entry : m_entries)
        all += entry.text;
    return all;
}

} // namespace lubberline::ui
