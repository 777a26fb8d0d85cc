#include "ui/swing/RecordDocuments.h"

#include <QCoreApplication>
#include <algorithm>
#include <cstdlib>

#include "core/due/DueRules.h"
#include "core/procedure/Checklist.h"
#include "core/procedure/JobState.h"
#include "core/procedure/LoadNotes.h"
#include "core/record/Signature.h"
#include "core/swing/CardRemarks.h"
#include "db/stores/SwingMarks.h"
#include "ui/kit/Words.h"
#include "ui/report/page/Figures.h"
#include "ui/report/page/SignedAs.h"
#include "ui/text/Translated.h"

namespace lubberline::ui {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::RecordDocuments)
};

constexpr int kDaysOfOneJob = 7;

QString columnHeading(RadioState radio)
{
    switch (radio) {
    case RadioState::On: return Words::tr("RADIO ON");
    case RadioState::Off: return Words::tr("RADIO OFF");
    case RadioState::NotStated: break;
    }
    return Words::tr("STEER");
}

/// Without a date: farther than any job.
int daysApart(const Swing& one, const Swing& other)
{
    return one.date.empty() || other.date.empty() ? kDaysOfOneJob + 1 : std::abs(daysBetween(one.date, other.date));
}

/// Two swings stand on one card when they differ in the radio and were made in the same days.
bool belongTogether(const Swing& swing, const Swing& other)
{
    const bool opposite = (swing.configuration.radio == RadioState::On && other.configuration.radio == RadioState::Off)
        || (swing.configuration.radio == RadioState::Off && other.configuration.radio == RadioState::On);
    return opposite && swing.stage == other.stage && daysApart(swing, other) <= kDaysOfOneJob;
}

bool countsAsSigned(db::Stores& stores, const Swing& swing)
{
    return db::signedMark(stores.database(), swing.id, swing.state) == db::SignedMark::Stands;
}

/// By a revision that is signed: one that is in work leaves the signed one in force.
Result<bool> isSuperseded(db::Stores& stores, const SwingRecord& record)
{
    const auto rows = stores.swings.swingsOf(record.compass.id);
    if (!rows)
        return rows.error();
    for (const auto& row : *rows) {
        if (row.state != SwingState::Signed || row.revision <= record.swing.revision)
            continue;
        const auto later = stores.swings.record(row.id);
        if (!later)
            return later.error();
        if (later->swing.supersedes == record.swing.record && countsAsSigned(stores, later->swing))
            return true;
    }
    return false;
}

/// The nearest in days; of these a signed one, and the newest.
Result<std::optional<SwingRecord>> radioPartner(db::Stores& stores, const SwingRecord& record)
{
    std::optional<SwingRecord> best;
    if (record.swing.configuration.radio == RadioState::NotStated)
        return best;
    const auto rows = stores.swings.swingsOf(record.compass.id);
    if (!rows)
        return rows.error();
    const auto weight
        = [&](const SwingRecord& one) { return std::pair(daysApart(one.swing, record.swing), !countsAsSigned(stores, one.swing)); };
    for (const auto& row : *rows) {
        if (row.id == record.swing.id)
            continue;
        auto other = stores.swings.record(row.id);
        if (!other)
            return other.error();
        if (!belongTogether(record.swing, other->swing) || (best && !(weight(*other) < weight(*best))))
            continue;
        const auto superseded = isSuperseded(stores, *other);
        if (!superseded)
            return superseded.error();
        if (!*superseded)
            best = std::move(*other);
    }
    return best;
}

bool areVerified(const std::vector<SignatureState>& states)
{
    return std::all_of(states.begin(), states.end(), [](const SignatureState& one) { return isVerified(one.key); });
}

Result<CardColumn> columnOf(db::Stores& stores, const SwingRecord& record, const CardOptions& options, const Progress& progress)
{
    const auto analysis = stores.results.resultOf(record);
    auto card = analysis ? makeCard(*analysis, options) : Result<Card>(analysis.error());
    if (!card)
        return card.error();
    const auto states = stores.signing.checkedStates(record.swing.id, progress);
    const auto superseded = isSuperseded(stores, record);
    if (!states || !superseded)
        return states ? superseded.error() : states.error();
    const auto stands = stores.signing.stands(record.swing, *states);
    if (!stands)
        return stands.error();
    return CardColumn{columnHeading(record.swing.configuration.radio), std::move(card.value()), record, *stands, *superseded,
        signedAs(*states), areVerified(*states)};
}

QString nextDue(db::Stores& stores, const SwingRecord& record)
{
    const auto rules = stores.due.rules();
    if (!rules || record.swing.date.empty())
        return {};
    const auto rule = ruleFor(*rules, record.type.record);
    return rule ? toText(addMonths(record.swing.date, rule->months)) : QString();
}

/// Of the guided swing that the card is of, by what its interference check read.
Result<QStringList> loadsToName(db::Stores& stores, const SwingRecord& record)
{
    const auto job = stores.jobs.jobOf(record.swing.id);
    if (!job)
        return job.error();
    QStringList loads;
    const auto analysis = stores.results.resultOf(record);
    if (!*job || !analysis)
        return loads;
    for (const auto& note : loadsPast((*job)->job, *analysis))
        loads += Words::tr("%1 (%2° on %3)")
                     .arg(QString::fromStdString(note.load), signedFigure(note.deviation_deg, 0), figure(note.heading_deg, 0));
    return loads;
}

/// The swing by which the compass was compensated: the nearest before this one, in the days of one job, that is a correction swing, or
/// as found where this one is as left.
Result<std::optional<SwingRecord>> compensatingSwing(db::Stores& stores, const SwingRecord& record)
{
    if (record.swing.kind == SwingKind::Correction)
        return std::optional<SwingRecord>();
    const auto rows = stores.swings.swingsOf(record.compass.id);
    if (!rows)
        return rows.error();
    std::optional<SwingRecord> best;
    for (const auto& row : *rows) { // newest first
        const bool compensates
            = row.kind == SwingKind::Correction || (row.stage == SwingStage::AsFound && record.swing.stage == SwingStage::AsLeft);
        if (row.id == record.swing.id || !compensates || row.superseded || row.date.empty() || record.swing.date.empty()
            || row.date > record.swing.date || daysBetween(row.date, record.swing.date) > kDaysOfOneJob)
            continue;
        auto other = stores.swings.record(row.id);
        if (!other)
            return other.error();
        // A correction swing before a check, and the same radio before another.
        const auto weight = [&](const SwingRecord& one) {
            return (one.swing.kind == SwingKind::Correction ? 2 : 0)
                + (one.swing.configuration.radio == record.swing.configuration.radio ? 1 : 0);
        };
        if (!best || (row.date == best->swing.date && weight(*other) > weight(*best)))
            best = std::move(*other);
    }
    return best;
}

Result<std::optional<Swing>> withRecord(db::Stores& stores, CompassId compass, const RecordId& wanted)
{
    if (wanted.empty())
        return std::optional<Swing>();
    const auto rows = stores.swings.swingsOf(compass);
    if (!rows)
        return rows.error();
    for (const auto& row : *rows) {
        auto record = stores.swings.record(row.id);
        if (!record)
            return record.error();
        if (record->swing.record == wanted)
            return std::optional(std::move(record->swing));
    }
    return std::optional<Swing>();
}

} // namespace

Result<SignedStanding> standingOf(db::Stores& stores, const SwingRecord& record, const std::vector<KeyVerdict>& verdicts)
{
    auto states = stores.signing.states(record.swing.id);
    const auto superseded = isSuperseded(stores, record);
    if (!states || !superseded)
        return states ? superseded.error() : states.error();
    for (std::size_t i = 0; i < states->size() && i < verdicts.size(); ++i)
        (*states)[i].key = verdicts[i];
    const auto stands = stores.signing.stands(record.swing, *states);
    return stands ? Result<SignedStanding>({*stands, *superseded}) : stands.error();
}

Result<ReportInput> reportOf(db::Stores& stores, SwingId id, const QString& madeAtUtc, const Progress& progress)
{
    auto record = stores.swings.record(id);
    if (!record)
        return record.error();
    auto analysis = stores.results.resultOf(*record);
    if (!analysis)
        return analysis.error();
    auto previous = stores.swings.previous(id);
    auto sensors = stores.sensors.of(record->compass.id);
    auto job = stores.jobs.jobOf(id);
    auto superseded = withRecord(stores, record->compass.id, record->swing.supersedes);
    if (!previous || !sensors || !job || !superseded)
        return !previous ? previous.error() : !sensors ? sensors.error() : !job ? job.error() : superseded.error();
    auto states = stores.signing.checkedStates(id, progress);
    const auto head = stores.signing.trailHead();
    if (!states || !head)
        return states ? head.error() : states.error();
    const auto stands = stores.signing.stands(record->swing, *states);
    if (!stands)
        return stands.error();
    auto previousJob = *previous ? stores.jobs.jobOf((*previous)->id) : Result<std::optional<JobRecord>>(std::nullopt);
    if (!previousJob)
        return previousJob.error();
    ReportInput input;
    input.record = std::move(record.value());
    input.signaturesStand = *stands;
    input.previousJob = std::move(previousJob.value());
    input.analysis = std::move(analysis.value());
    input.previous = std::move(previous.value());
    input.sensors = std::move(sensors.value());
    input.job = std::move(job.value());
    input.superseded = std::move(superseded.value());
    input.signatures = std::move(states.value());
    input.audit = {QString::fromStdString(head->head), head->entries};
    input.madeAtUtc = madeAtUtc;
    return input;
}

Result<CardInput> cardOf(
    db::Stores& stores, SwingId id, const CardOptions& options, const QString& madeAtUtc, bool again, const Progress& progress)
{
    const auto record = stores.swings.record(id);
    if (!record)
        return record.error();
    const auto column = columnOf(stores, *record, options, progress);
    if (!column)
        return column.error();
    CardInput input{{*column}, madeAtUtc};
    input.nextDue = nextDue(stores, *record);
    const auto loads = loadsToName(stores, *record);
    if (!loads)
        return loads.error();
    input.loadsToName = *loads;
    const auto written = stores.signing.cardWasWritten(id);
    if (!written)
        return written.error();
    if (again && *written && column->isSigned() && !record->swing.signatures.empty())
        input.reprintOf = QString::fromStdString(record->swing.signatures.back().timeUtc.substr(0, 10));
    const auto other = radioPartner(stores, *record);
    if (!other)
        return other.error();
    if (!*other)
        return input;
    const auto second = columnOf(stores, **other, options, progress);
    if (!second && (*other)->swing.state == SwingState::Draft)
        return input; // it is still being read: the card has one column
    if (!second) {
        Error error = second.error();
        error.message = said(Words::tr("the swing with the radio in the other state (record %1): %2")
                                 .arg(QString::fromStdString((*other)->swing.record), translated(error.message)));
        return error;
    }
    if (const QString due = nextDue(stores, **other); !due.isEmpty() && (input.nextDue.isEmpty() || due < input.nextDue))
        input.nextDue = due;
    if (!second->isSigned())
        input.reprintOf.clear(); // of a card that was never signed whole
    input.columns.insert((*other)->swing.configuration.radio == RadioState::On ? input.columns.begin() : input.columns.end(), *second);
    return input;
}

Result<void> noteCards(db::Stores& stores, const CardInput& input)
{
    for (const CardColumn& column : input.columns)
        if (column.isSigned())
            if (const auto noted = stores.signing.noteCard(column.record.swing.id); !noted)
                return noted;
    return {};
}

Result<JobCardInput> jobCardOf(db::Stores& stores, SwingId id, const QString& madeAtUtc)
{
    auto record = stores.swings.record(id);
    auto job = stores.jobs.jobOf(id);
    if (!record || !job)
        return record ? job.error() : record.error();
    JobCardInput input{std::move(record.value()), {}, madeAtUtc};
    if (*job) {
        input.job = (*job)->job;
    } else {
        const CompassSystem& compass = input.record.compass;
        const bool remote = compass.kind == CompassKind::RemoteUnstabilised || compass.kind == CompassKind::RemoteStabilised;
        input.job.plan.kind = compass.compensator == Compensator::None ? ProcedureKind::CheckOnly
            : remote                                                   ? ProcedureKind::FluxValve
                                                                       : ProcedureKind::Coefficient;
        input.job.checklist = usualChecklist(compass);
        input.job.datum.name = input.record.swing.datum.instrument;
    }
    input.job.events.clear();
    input.record.swing.indexRemoved_deg.reset(); // the form is of a swing that is to be made
    return input;
}

Result<StyleSheet1613> sheet1613Of(db::Stores& stores, SwingId id, const QString& madeAtUtc, const Progress& progress)
{
    auto record = stores.swings.record(id);
    auto job = stores.jobs.jobOf(id);
    if (!record || !job)
        return record ? job.error() : record.error();
    const auto states = stores.signing.checkedStates(id, progress);
    const auto superseded = isSuperseded(stores, *record);
    if (!states || !superseded)
        return states ? superseded.error() : states.error();
    const auto stands = stores.signing.stands(record->swing, *states);
    if (!stands)
        return stands.error();
    StyleSheet1613 sheet;
    sheet.record = std::move(record.value());
    sheet.holds = *stands;
    sheet.verified = areVerified(*states);
    sheet.superseded = *superseded;
    sheet.madeAtUtc = madeAtUtc;
    constexpr std::size_t kLeastOfACurve = 3;
    if (usedReadings(sheet.record.swing).size() >= kLeastOfACurve) { // a compass that has no card has none of this form, either
        const auto analysis = stores.results.resultOf(sheet.record);
        if (!analysis)
            return analysis.error();
        const auto card = makeCard(*analysis, {45, CardSource::Readings, {}});
        if (!card)
            return card.error();
        sheet.remarks = remarksOn(*card, sheet.record);
        sheet.outOfLimits = outOfLimits(*card, sheet.record.limits);
        sheet.gaps = card->gaps;
    }
    if (*job && (*job)->swing == id && (*job)->job.plan.kind != ProcedureKind::CheckOnly)
        if (const auto state = stateOf((*job)->job))
            sheet.asFound = asFoundSwing((*job)->job, *state);
    if (sheet.asFound)
        return sheet;
    auto compensating = compensatingSwing(stores, sheet.record);
    if (!compensating)
        return compensating.error();
    if (!*compensating)
        return sheet;
    const auto theirs = stores.signing.checkedStates((*compensating)->swing.id, progress);
    if (!theirs)
        return theirs.error();
    const auto theirsStand = stores.signing.stands((*compensating)->swing, *theirs);
    if (!theirsStand)
        return theirsStand.error();
    sheet.asFound = (*compensating)->swing;
    sheet.compensating = std::move(**compensating);
    sheet.compensatingHolds = *theirsStand;
    return sheet;
}

} // namespace lubberline::ui
