#include "ui/swing/SwingPage.h"

#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/record/ClockDates.h"
#include "ui/kit/Words.h"
#include "ui/kit/fit/ControlFit.h"
#include "ui/swing/CardPanel.h"
#include "ui/swing/DerivationPanel.h"
#include "ui/swing/KeyChecks.h"
#include "ui/swing/RecordDocuments.h"
#include "ui/swing/SigningPanel.h"
#include "ui/swing/SwingEditor.h"
#include "ui/swing/SwingParticulars.h"
#include "ui/swing/readings/ReadingsTable.h"

namespace lubberline::ui {

void SwingPage::showParticulars(bool visible)
{
    m_showParticulars->setArrowType(visible ? Qt::DownArrow : Qt::RightArrow);
    if (!m_particulars) {
        m_particulars = new SwingParticulars(*m_editor);
        finishControls(*m_particulars);
        body().insertWidget(0, m_particulars);
        setTabOrder(m_complete, m_particulars);
    }
    m_particulars->setVisible(visible);
}

void SwingPage::showSigning(bool visible)
{
    m_table->leaveCell();
    m_showSigning->setArrowType(visible ? Qt::DownArrow : Qt::RightArrow);
    if (!m_signing) {
        m_signing = new SigningPanel(m_context, *m_editor, *m_keys);
        finishControls(*m_signing);
        body().insertWidget(0, m_signing);
        setTabOrder(m_showSigning, m_signing);
        connect(m_signing, &SigningPanel::failed, this, &SwingPage::failed);
        connect(m_signing, &SigningPanel::openSwing, this, &SwingPage::openSwing);
        connect(m_showSigning, &QToolButton::clicked, m_signing, [this](bool opened) {
            if (opened)
                m_signing->focusField(); // whoever opens it types the name next
        });
    }
    m_signing->setVisible(visible);
    m_signing->show(m_meaning->text());
}

void SwingPage::showCard(bool visible)
{
    m_table->leaveCell();
    m_showCard->setArrowType(visible ? Qt::DownArrow : Qt::RightArrow);
    if (!m_card) {
        m_card = new CardPanel;
        finishControls(*m_card);
        body().insertWidget(0, m_card);
        setTabOrder(m_showCard, m_card);
        connect(m_card, &CardPanel::writeCard, this, &SwingPage::writeCard);
    }
    m_card->setVisible(visible);
    if (visible)
        showCardFigures();
}

void SwingPage::showCardFigures()
{
    m_keys->check(m_editor->record());
    const auto standing = standingOf(m_context.stores, m_editor->record(), m_keys->verdicts());
    if (!standing)
        emit failed(messageOf(standing.error()));
    const bool computing = m_editor->computing();
    m_card->show(m_editor->record(), computing ? nullptr : m_editor->analysis(),
        computing ? tr("The results are being computed") : m_editor->whyNoAnalysis(), standing && standing->holds,
        standing && standing->superseded);
}

void SwingPage::showDerivation(CoefficientPlace place)
{
    m_table->leaveCell();
    if (!m_derivation) {
        m_derivation = new DerivationPanel;
        static_cast<QVBoxLayout*>(layout())->insertWidget(1, m_derivation);
        connect(
            m_derivation, &DerivationPanel::closed, this, [this] { findChild<QTableWidget*>(QStringLiteral("coefficients"))->setFocus(); });
    }
    m_derivation->show(m_editor->analysis(), place);
}

void SwingPage::openCard() { m_showCard->setChecked(true); }

void SwingPage::openSigning()
{
    m_showSigning->setChecked(true);
    m_signing->focusField();
}

void SwingPage::toggleComplete()
{
    m_table->leaveCell();
    if (!m_editor->particularsEditable())
        return;
    if (m_editor->record().swing.state == SwingState::Draft) {
        m_editor->settle();
        const bool doubted = !doubtOfClock(m_editor->record().swing.date, m_context.stores.clock().today()).empty();
        if (m_editor->complete() || !doubted)
            return;
        m_showSigning->setChecked(true); // there it is said how the day is known
        m_signing->askReason();
        return;
    }
    // Opening again wants a reason: it is given where the swing is signed.
    m_showSigning->setChecked(true);
    m_signing->askReason();
}

} // namespace lubberline::ui
