#include "ui/guided/GuidedStation.h"

#include <QLabel>
#include <QLineEdit>

#include <cmath>

#include "core/angle/AngleText.h"
#include "ui/guided/GuidedWords.h"
#include "ui/kit/Words.h"
#include "ui/swing/SlipWords.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

/// When it is stored the page shows the next step.
void GuidedStation::tell(job::What what)
{
    if (const auto told = m_job.tell(std::move(what)); !told) {
        say(messageOf(told.error()), true);
        emit failed(messageOf(told.error()));
    }
}

void GuidedStation::next()
{
    if (m_asks != Asks::Nothing)
        takeReason();
    else if (turning())
        takeTurn();
    else if (m_datum->text().trimmed().isEmpty())
        m_datum->setFocus();
    else if (m_compass->text().trimmed().isEmpty())
        m_compass->setFocus();
    else
        takeReading();
}

Result<Entry> GuidedStation::entry() const
{
    Entry entry;
    const auto read = [](const QLineEdit& line, std::vector<double>& into) -> Result<void> {
        auto figures = parseFigures(line.text());
        if (!figures)
            return figures.error();
        into = std::move(figures.value());
        return {};
    };
    if (const auto done = read(*m_datum, entry.datum_deg); !done)
        return done.error();
    if (const auto done = read(*m_astern, entry.astern_deg); !done)
        return done.error();
    if (const auto done = read(*m_compass, entry.compass_deg); !done)
        return done.error();
    return entry;
}

/// What is more likely wrong than right is taken only when Enter comes again with the same figures.
void GuidedStation::takeReading()
{
    const auto typed = entry();
    if (!typed) {
        say(messageOf(typed.error()), true);
        return;
    }
    auto prepared = m_job.prepare(*typed);
    if (!prepared) {
        say(messageOf(prepared.error()), true);
        return;
    }
    const QString figures = m_datum->text() + '|' + m_astern->text() + '|' + m_compass->text();
    QStringList doubts;
    if (prepared->judgement.lookAgain()) {
        Reading reading;
        reading.magnetic = MagneticHeading::fromDegrees(prepared->reading.magnetic_deg);
        reading.compass = CompassHeading::fromDegrees(prepared->reading.compass_deg);
        doubts += slipSentence(prepared->judgement, reading, shownAngles());
    }
    if (!prepared->note.empty())
        doubts += toText(prepared->note);
    if (!doubts.isEmpty() && figures != m_kept) {
        m_kept = figures;
        say(doubts.join(QStringLiteral(". ")) + tr(". Enter keeps it as it is read."), true);
        m_compass->setFocus();
        m_compass->selectAll();
        return;
    }
    if (!doubts.isEmpty())
        prepared->reading.note = prepared->keptNote();
    tell(std::move(prepared->reading));
}

void GuidedStation::takeTurn()
{
    const auto& turn = m_job.state().turn;
    if (!turn) {
        leaveAsIs();
        return;
    }
    const auto figures = parseFigures(m_after->text());
    if (!figures || figures->size() != 1) {
        say(figures ? tr("What does the compass read now? One figure is expected.") : messageOf(figures.error()), true);
        m_after->setFocus();
        return;
    }
    const double after = figures->front(), off = std::abs(wrap180(after - turn->makeCompassRead_deg));
    if (off > m_job.job().resolution_deg + 1e-9 && m_after->text() != m_kept) {
        m_kept = m_after->text();
        say(tr("%1° is wanted, it reads %2°: turn again and type what it reads, or Enter keeps it.")
                .arg(figureText(turn->makeCompassRead_deg), figureText(after)),
            true);
        m_after->selectAll();
        return;
    }
    if (m_job.state().phase == JobPhase::Index)
        tell(job::IndexRemoved{turn->compassReads_deg, turn->makeCompassRead_deg, after});
    else
        tell(job::Adjusted{m_job.state().current, turn->control, turn->compassReads_deg, turn->makeCompassRead_deg, after,
            m_turnNote->text().trimmed().toStdString()});
}

void GuidedStation::readAgain()
{
    const StationState* here = m_job.station();
    const int last = here && here->reading && here->correctionsDone == 0 ? m_job.state().current : m_job.lastRead();
    if (last < 0) {
        say(tr("There is no reading that can be read again: a control was turned on it."), true);
        return;
    }
    readAgainAt(last);
}

void GuidedStation::readAgainAt(int station)
{
    m_shown = {-2, -1};
    if (const auto told = m_job.readAgain(station); !told) {
        say(messageOf(told.error()), true);
        emit failed(messageOf(told.error()));
    }
}

void GuidedStation::ask(Asks what, const QString& question)
{
    m_asks = what;
    m_question->setText(question);
    m_reason->clear();
    m_reasonRow->show();
    m_reason->setFocus();
}

void GuidedStation::skip()
{
    if (turning())
        return;
    if (const QString cost = m_job.skipCostWords(); !cost.isEmpty())
        say(cost + tr(" It can be read later: F2, or its place in the strip below."));
    ask(Asks::SkipReason, tr("Why can this heading not be read?"));
}

void GuidedStation::leaveAsIs()
{
    if (turning())
        ask(Asks::LeaveReason, tr("Why is it left as it is?"));
}

void GuidedStation::takeReason()
{
    const std::string reason = m_reason->text().trimmed().toStdString();
    if (reason.empty()) {
        say(tr("A reason is expected; Escape goes back."), true);
        return;
    }
    const Asks asked = m_asks;
    m_asks = Asks::Nothing;
    m_reasonRow->hide();
    if (asked == Asks::SkipReason) {
        tell(job::StationSkipped{m_job.state().current, reason});
    } else if (m_job.state().phase == JobPhase::Index) {
        tell(job::IndexLeft{reason});
    } else {
        const StationState& here = *m_job.station();
        tell(job::NotAdjusted{m_job.state().current, here.station.corrections[here.correctionsDone].control, reason});
    }
}

} // namespace lubberline::ui
