#include "ui/guided/GuidedStation.h"

#include <QFormLayout>
#include <QGridLayout>
#include <QShortcut>
#include <QVBoxLayout>

#include <cmath>

#include "core/angle/AngleText.h"
#include "core/angle/PrintedHeading.h"
#include "ui/guided/BigWidgets.h"
#include "ui/guided/GuidedWords.h"
#include "ui/kit/Words.h"
#include "ui/swing/SlipWords.h"
#include "ui/text/AngleWords.h"

namespace lubberline::ui {

namespace {

constexpr int kFieldWidth_px = 150; // five figures; more scroll
constexpr int kTurnTo_px = 72, kStays_px = 36, kButton_px = 16;
constexpr double kDemagnetise_deg = 30; // procedures: beyond 30 to 35° it is no matter of the compensator

QHBoxLayout* titled(const QString& title, QLineEdit& field)
{
    auto* row = new QHBoxLayout;
    auto* label = bigLabel("", kSentence_px);
    label->setText(title);
    label->setBuddy(&field);
    row->addWidget(label);
    row->addWidget(&field);
    row->addStretch();
    return row;
}

/// Sighted from both sides only where the instrument can be.
bool sighted(const DatumInstrument& datum) { return datum.kind == DatumKind::SightingCompass || datum.kind == DatumKind::Theodolite; }

} // namespace

GuidedStation::GuidedStation(GuidedJob& job, QWidget* parent)
    : QWidget(parent)
    , m_job(job)
    , m_turnTo(bigLabel("turnTo", kTurnTo_px, true))
    , m_reading(new QWidget)
    , m_datum(bigLine("guidedDatum", kFieldWidth_px))
    , m_asternTitle(bigLabel("asternTitle", kSentence_px))
    , m_astern(bigLine("guidedAstern", kFieldWidth_px))
    , m_compass(bigLine("guidedCompass", kFieldWidth_px))
    , m_turn(new QWidget)
    , m_sentence(bigLabel("turnSentence", kSentence_px))
    , m_target(bigLabel("turnTarget", kTarget_px, true))
    , m_after(bigLine("guidedAfter", kFieldWidth_px))
    , m_turnNote(new QLineEdit)
    , m_message(bigLabel("guidedMessage", kTitle_px))
    , m_reasonRow(new QWidget)
    , m_question(bigLabel("guidedQuestion", kTitle_px))
    , m_reason(new QLineEdit)
    , m_next(bigButton(tr("Next (Enter)"), "guidedNext"))
    , m_again(bigButton(tr("Read again (F2)"), "guidedAgain"))
    , m_skip(bigButton(tr("Skip (F4)"), "guidedSkip"))
    , m_leave(bigButton(tr("Leave as it is (F5)"), "guidedLeave"))
{
    build();
}

void GuidedStation::build()
{
    auto* grid = new QGridLayout(m_reading);
    grid->setContentsMargins(0, 0, 0, 0);
    auto* datumTitle = bigLabel("datumTitle", kSentence_px);
    datumTitle->setText(tr("datum reads"));
    auto* compassTitle = bigLabel("compassTitle", kSentence_px);
    compassTitle->setText(tr("compass"));
    m_asternTitle->setText(tr("from astern"));
    grid->addWidget(datumTitle, 0, 0);
    grid->addWidget(m_datum, 0, 1);
    grid->addWidget(m_asternTitle, 0, 2);
    grid->addWidget(m_astern, 0, 3);
    grid->addWidget(compassTitle, 1, 0);
    grid->addWidget(m_compass, 1, 1);
    grid->setColumnStretch(4, 1);
    m_datum->setToolTip(tr("As the instrument shows it; up to three figures with spaces between, as 178 178.5 178"));
    m_compass->setToolTip(tr("As the compass shows it; up to three figures with spaces between"));

    auto* turn = new QVBoxLayout(m_turn);
    turn->setContentsMargins(0, 0, 0, 0);
    turn->addWidget(m_sentence);
    turn->addWidget(m_target);
    turn->addLayout(titled(tr("it now reads"), *m_after));
    m_turnNote->setObjectName(QStringLiteral("guidedTurnNote"));
    m_turnNote->setPlaceholderText(tr("turns of the screw, magnets (may stay empty)"));
    m_turnNote->setMaximumWidth(3 * kFieldWidth_px);
    turn->addWidget(m_turnNote);

    auto* reason = new QHBoxLayout(m_reasonRow);
    reason->setContentsMargins(0, 0, 0, 0);
    m_reason->setObjectName(QStringLiteral("guidedReason"));
    m_reason->setFont(bigFont(m_reason->font(), kSentence_px));
    reason->addWidget(m_question);
    reason->addWidget(m_reason, 1);

    auto* buttons = new QHBoxLayout;
    for (QPushButton* button : {m_next, m_again, m_skip, m_leave}) {
        button->setFont(bigFont(button->font(), kButton_px)); // three of them side by side on a small screen
        buttons->addWidget(button);
    }
    buttons->addStretch();
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_turnTo);
    column->addWidget(m_reading);
    column->addWidget(m_turn);
    column->addWidget(m_message);
    column->addWidget(m_reasonRow);
    column->addStretch();
    column->addLayout(buttons);
    m_turnTo->setWordWrap(true);
    m_reasonRow->hide();
    m_turn->hide(); // it would ask for room beside the reading

    for (QLineEdit* line : {m_datum, m_astern, m_compass, m_after, m_turnNote, m_reason})
        connect(line, &QLineEdit::returnPressed, this, &GuidedStation::next);
    connect(m_next, &QPushButton::clicked, this, &GuidedStation::next);
    connect(m_again, &QPushButton::clicked, this, &GuidedStation::readAgain);
    connect(m_skip, &QPushButton::clicked, this, &GuidedStation::skip);
    connect(m_leave, &QPushButton::clicked, this, &GuidedStation::leaveAsIs);
    const auto key = [this](Qt::Key code, void (GuidedStation::*act)()) {
        auto* shortcut = new QShortcut(QKeySequence(code), this);
        shortcut->setContext(Qt::WidgetWithChildrenShortcut);
        connect(shortcut, &QShortcut::activated, this, act);
    };
    key(Qt::Key_F2, &GuidedStation::readAgain);
    key(Qt::Key_F4, &GuidedStation::skip);
    key(Qt::Key_F5, &GuidedStation::leaveAsIs);
    key(Qt::Key_Escape, &GuidedStation::refresh);
}

bool GuidedStation::turning() const
{
    const auto& state = m_job.state();
    if (state.phase == JobPhase::Index)
        return true;
    const StationState* here = m_job.station();
    return here && here->reading && !here->voided && here->correctionsDone < here->station.corrections.size();
}

void GuidedStation::refresh()
{
    m_asks = Asks::Nothing;
    m_reasonRow->hide();
    const auto& state = m_job.state();
    const StationState* here = m_job.station();
    const std::pair shown{
        state.phase == JobPhase::Index ? -1 : state.current, here && turning() ? static_cast<int>(here->correctionsDone) : -1};
    if (shown != m_shown) {
        for (QLineEdit* line : {m_datum, m_astern, m_compass, m_after, m_turnNote})
            line->clear();
        say({});
        m_kept.clear();
    }
    m_shown = shown;
    const bool turn = turning();
    m_turnTo->setFont(bigFont(m_turnTo->font(), state.phase == JobPhase::Index ? kStays_px : kTurnTo_px, true));
    m_reading->setVisible(!turn);
    m_turn->setVisible(turn);
    m_skip->setVisible(!turn);
    m_leave->setVisible(turn);
    m_again->setEnabled(!turn || m_job.lastRead() >= 0);
    if (here)
        showReading(*here);
    if (turn && state.turn)
        showTurn(*state.turn);
    else if (turn)
        showNoTurn();
}

void GuidedStation::showReading(const StationState& station)
{
    const QString heading = stationHeading(station.station.nominal_deg);
    m_turnTo->setText(turning() ? tr("On %1").arg(heading) : tr("Turn to %1").arg(heading));
    const bool both = sighted(m_job.datum());
    m_astern->setVisible(both);
    m_asternTitle->setVisible(both);
    if (m_job.datum().kind == DatumKind::RoseLine && m_datum->text().isEmpty())
        m_datum->setText(figureText(station.station.nominal_deg)); // the aircraft is set on the line
    if (const Message doubt = m_job.clockDoubt(); !doubt.empty())
        say(toText(doubt), true);
    else if (m_message->text().isEmpty())
        say(m_job.astroSetting());
    if (station.voided)
        say(tr("The reading of before is void: a control was turned since. Read it again."), true);
}

void GuidedStation::showTurn(const MakeCompassRead& turn)
{
    if (m_job.state().phase == JobPhase::Index)
        m_turnTo->setText(tr("Index: the aircraft stays where it is"));
    m_sentence->setText(inAngleStyle(turnSentence(turn)));
    m_target->setText(inAngleStyle(figureText(turn.makeCompassRead_deg) + QStringLiteral("°")));
    m_target->setVisible(true);
    m_after->setEnabled(true);
    if (std::abs(turn.coefficient_deg) > kDemagnetise_deg && m_message->text().isEmpty())
        say(tr("More than %1°: find magnetised parts and demagnetise them before anything is corrected (Tecnam P2002-JF MM 34-20). F8 reports the fault.")
                .arg(kDemagnetise_deg),
            true);
}

void GuidedStation::showNoTurn()
{
    m_sentence->setText(tr("Nothing can be turned here: %1. F5 leaves it as it is, with a reason.").arg(toText(m_job.state().whyNoTurn)));
    m_target->setVisible(false);
    m_after->setEnabled(false);
}

QWidget* GuidedStation::firstEmpty() const
{
    if (m_asks != Asks::Nothing)
        return m_reason;
    if (turning())
        return m_after;
    return m_datum->text().trimmed().isEmpty() ? m_datum : m_compass;
}

void GuidedStation::focusField() { firstEmpty()->setFocus(Qt::OtherFocusReason); }

void GuidedStation::setDatum(double heading_deg)
{
    if (!turning())
        m_datum->setText(QString::number(printedHeading_deg(heading_deg, 1), 'f', 1));
}

void GuidedStation::setCompass(double heading_deg)
{
    (turning() ? m_after : m_compass)->setText(QString::number(printedHeading_deg(heading_deg, 1), 'f', 1));
}

void GuidedStation::say(const QString& message, bool urgent)
{
    m_message->setText(inAngleStyle(message));
    QPalette colours = palette();
    if (urgent)
        colours.setColor(QPalette::WindowText, urgentColour(colours));
    m_message->setPalette(colours);
    m_message->setFont(bigFont(m_message->font(), kTitle_px, urgent));
}

} // namespace lubberline::ui
