#include "ui/swing/readings/ExclusionPanel.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace lubberline::ui {

ExclusionPanel::ExclusionPanel(QWidget* parent)
    : QFrame(parent)
    , m_question(new QLabel)
    , m_reason(new QLineEdit)
    , m_exclude(new QPushButton(tr("E&xclude")))
{
    setObjectName(QStringLiteral("exclusionPanel"));
    setFrameShape(StyledPanel);
    m_reason->setObjectName(QStringLiteral("exclusionReason"));
    m_reason->setPlaceholderText(tr("the reason stays on the record"));
    m_exclude->setObjectName(QStringLiteral("excludeButton"));
    m_exclude->setEnabled(false);
    auto* cancel = new QPushButton(tr("Cancel"));
    auto* answer = new QHBoxLayout;
    answer->addWidget(m_reason, 1);
    answer->addWidget(m_exclude);
    answer->addWidget(cancel);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 4, 6, 4);
    layout->addWidget(m_question);
    layout->addLayout(answer);
    connect(m_reason, &QLineEdit::textChanged, this, [this](const QString& text) { m_exclude->setEnabled(!text.trimmed().isEmpty()); });
    connect(m_reason, &QLineEdit::returnPressed, m_exclude, &QPushButton::click);
    connect(m_exclude, &QPushButton::clicked, this, [this] {
        emit reasonGiven(m_reading, m_reason->text().trimmed());
        finish();
    });
    connect(cancel, &QPushButton::clicked, this, &ExclusionPanel::finish);
    hide();
}

void ExclusionPanel::ask(ReadingId reading, const QString& place)
{
    m_reading = reading;
    m_question->setText(tr("Why is the reading on %1 left out?").arg(place));
    m_reason->clear();
    show();
    m_reason->setFocus();
}

void ExclusionPanel::finish()
{
    hide();
    emit closed();
}

void ExclusionPanel::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape)
        finish();
    else
        QFrame::keyPressEvent(event);
}

} // namespace lubberline::ui
