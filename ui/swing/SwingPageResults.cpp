#include "ui/swing/SwingPage.h"

#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include "ui/kit/Words.h"
#include "ui/plots/swing/PictureOf.h"
#include "ui/swing/CoefficientsPanel.h"
#include "ui/swing/DerivationPanel.h"
#include "ui/swing/PlotTabs.h"
#include "ui/swing/SlipWords.h"
#include "ui/swing/SwingEditor.h"
#include "ui/swing/SwingWords.h"
#include "ui/swing/readings/ReadingsModel.h"
#include "ui/swing/readings/ReadingsTable.h"
#include "ui/text/NumberText.h"

namespace lubberline::ui {

/// One row of a log is another: a keystroke waits for no plot. What is shown stays, said to be of before, until results are computed.
void SwingPage::showComputing()
{
    const bool panel = (m_signing && m_showSigning->isChecked()) || (m_card && m_showCard->isChecked())
        || (m_derivation && m_derivation->isVisibleTo(this));
    if (panel || !m_editor->computing()) { // what is signed or printed follows each figure; or nothing can be computed of it now
        showRecord();
        return;
    }
    m_coefficients->setEnabled(false);
    m_computing->show();
    m_meaning->setText(computingWords(m_meant));
    showMessageLine();
    emit stateChanged();
}

QString SwingPage::computingWords(const QString& meant) const
{
    return m_editor->analysis() ? tr("Being computed anew; of the readings before the last change: %1").arg(meant) : meant;
}

void SwingPage::showResults()
{
    const auto& analysis = m_editor->analysis();
    const QString previousLabel = m_editor->previous() ? toText(m_editor->previous()->date) : QString();
    const bool computing = m_editor->computing();
    SwingPicture picture = pictureOf(m_editor->record(), computing ? nullptr : analysis, m_editor->whyNoAnalysis(),
        m_editor->previousAnalysis(), previousLabel, m_style);
    picture.analysis = analysis; // while computing the curves of before, and no mark on any reading
    m_plots->setPicture(picture);
    m_coefficients->show(analysis, m_editor->whyNoAnalysis());
    m_coefficients->setEnabled(!computing);
    m_computing->setVisible(computing);
    if (m_derivation && m_derivation->isVisibleTo(this))
        m_derivation->refresh(analysis);
    if (m_card && m_showCard->isChecked())
        showCardFigures();
    m_meant = inAngleStyle(meaning());
    m_meaning->setText(computing ? computingWords(m_meant) : m_meant);
    showMessageLine();
}

QString SwingPage::meaning() const
{
    const auto& analysis = m_editor->analysis();
    if (!analysis)
        return tr("No result yet: %1.").arg(m_editor->whyNoAnalysis());
    QString words = meaningOf(*analysis, m_editor->record().limits, m_style);
    if (const auto& index_deg = m_editor->record().swing.indexRemoved_deg)
        words
            = tr("After these readings A = %1° was taken out by turning the compass: plots, coefficients and card are as it stands since. ")
                  .arg(signedNumber(*index_deg, 1))
            + words;
    return words;
}

QString SwingPage::suspicion() const
{
    const auto& analysis = m_editor->analysis();
    if (m_editor->computing())
        return {};
    if (currentRow() >= 0)
        if (const QString own = slipOfRow(*m_editor, currentRow(), m_style); !own.isEmpty())
            return own;
    if (analysis && !analysis->slips.slips.empty()) {
        const int current = m_editor->analysedIndex(currentRow());
        if (current >= 0 && analysis->readings[static_cast<std::size_t>(current)].suspect)
            return suspicionOf(*analysis, static_cast<std::size_t>(current), m_style);
        return suspicionOf(*analysis, analysis->slips.slips.front().reading, m_style);
    }
    // Few readings tell little against each other: the last swing and the headings that were wanted are held against them, too.
    if (const auto row = likeliestSlip(*m_editor))
        return slipSentence(judgeRow(*m_editor, *row), m_editor->readings()[static_cast<std::size_t>(*row)], m_style);
    return {};
}

/// Of the magnetic heading that was typed last, before its compass is read: the chosen row, else the first that is far off.
QString SwingPage::remark() const
{
    const auto& readings = m_editor->readings();
    if (const int row = currentRow(); row >= 0)
        if (const QString own = farFromNominal(readings[static_cast<std::size_t>(row)], m_style); !own.isEmpty())
            return own;
    for (const Reading& reading : readings)
        if (!reading.exclusion)
            if (const QString words = farFromNominal(reading, m_style); !words.isEmpty())
                return words;
    return {};
}

void SwingPage::showMessageLine()
{
    QString rejected = m_model->rejection(m_table->currentIndex());
    if (rejected.isEmpty())
        rejected = m_model->rejection(m_model->firstRejected());
    if (!rejected.isEmpty()) {
        refuse(tr("Not stored: %1 (Esc: the stored value)").arg(rejected));
        return;
    }
    if (const QString far = remark(); !far.isEmpty()) {
        say(tr("◉ %1").arg(far));
        return;
    }
    if (const QString suspect = suspicion(); !suspect.isEmpty()) {
        say(tr("◉ %1").arg(suspect));
        return;
    }
    say(m_editor->editable() ? tr("Enter: next cell · = accepts the nominal heading · deviation may be typed as 3.5W") : QString());
}

} // namespace lubberline::ui
