#include "ui/guided/GuidedFault.h"

#include <QVBoxLayout>

#include "ui/guided/BigWidgets.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

GuidedFault::GuidedFault(GuidedJob& job, QWidget* parent)
    : QWidget(parent)
    , m_job(job)
    , m_text(bigLabel("faultText", kSentence_px, true))
    , m_line(new QLineEdit)
{
    build();
}

void GuidedFault::build()
{
    m_line->setObjectName(QStringLiteral("faultLine"));
    m_line->setFont(bigFont(m_line->font(), kSentence_px));
    auto* mended = bigButton(tr("Go on (Enter)"), "faultMended");
    auto* abandon = bigButton(tr("Abandon this swing"), "abandonSwing");
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(mended);
    buttons->addWidget(abandon);
    buttons->addStretch();
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_text);
    column->addWidget(m_line);
    column->addLayout(buttons);
    column->addStretch();
    connect(m_line, &QLineEdit::returnPressed, this, &GuidedFault::tell);
    connect(mended, &QPushButton::clicked, this, &GuidedFault::tell);
    connect(abandon, &QPushButton::clicked, this, &GuidedFault::giveUp);
}

void GuidedFault::say(const QString& words)
{
    m_text->setText(words);
    m_line->clear();
    m_line->setFocus();
}

void GuidedFault::ask() { say(tr("What is the fault? F8 goes back.")); }

void GuidedFault::refresh()
{
    const auto& state = m_job.state();
    say(state.phase == JobPhase::Fault ? tr("Fault: %1. What was done about it?").arg(toText(state.fault))
                                       : tr("This swing was abandoned: %1.").arg(toText(state.abandoned)));
}

std::string GuidedFault::typed() const { return m_line->text().trimmed().toStdString(); }

void GuidedFault::tell()
{
    const std::string words = typed();
    const bool known = m_job.state().phase == JobPhase::Fault;
    if (words.empty()) {
        emit failed(
            known ? tr("What was done about the fault? Some words are expected.") : tr("What is the fault? Some words are expected."));
        return;
    }
    if (const auto told = m_job.tell(known ? job::What(job::Mended{words}) : job::What(job::Faulted{words})); !told)
        emit failed(messageOf(told.error()));
}

void GuidedFault::giveUp()
{
    const std::string reason = typed();
    if (reason.empty()) {
        emit failed(tr("Why is the swing abandoned? Some words are expected; its readings stay on record."));
        m_line->setFocus();
        return;
    }
    if (const auto told = m_job.tell(job::Abandoned{reason}); !told)
        emit failed(messageOf(told.error()));
    else
        emit givenUp();
}

} // namespace lubberline::ui
