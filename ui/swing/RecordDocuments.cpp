#include "ui/swing/RecordDocuments.h"

#include <QCoreApplication>
#include <cstdlib>

#include "core/due/DueRules.h"
#include "core/procedure/Checklist.h"
#include "core/procedure/JobState.h"
#include "core/procedure/LoadNotes.h"
#include "core/swing/Observations.h"
#include "ui/report/page/Figures.h"

namespace lubberline::ui {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::RecordDocuments)
};

constexpr qint64 kDaysOfOneJob = 7;

QString columnHeading(RadioState radio)
{
    switch (radio) {
    case RadioState::On: return Words::tr("RADIO ON");
    case RadioState::Off: return Words::tr("RADIO OFF");
    case RadioState::NotStated: break;
    }
    return Words::tr("STEER");
}

/// Two swings stand on one card when they differ in the radio and were made in the same days.
bool belongTogether(const Swing& swing, const Swing& other)
{
    const bool opposite = (swing.configuration.radio == RadioState::On && other.configuration.radio == RadioState::Off)
        || (swing.configuration.radio == RadioState::Off && other.configuration.radio == RadioState::On);
    return opposite && swing.stage == other.stage && !swing.date.empty() && !other.date.empty()
        && std::abs(daysBetween(swing.date, other.date)) <= kDaysOfOneJob;
}

/// The nearest by the list's order (newest first), which is one job in practice.
Result<std::optional<SwingRecord>> radioPartner(db::Stores& stores, const SwingRecord& record)
{
    if (record.swing.configuration.radio == RadioState::NotStated)
        return std::optional<SwingRecord>();
    const auto rows = stores.swings.swingsOf(record.compass.id);
    if (!rows)
        return rows.error();
    for (const auto& row : *rows) {
        if (row.id == record.swing.id || row.superseded)
            continue;
        auto other = stores.swings.record(row.id);
        if (!other)
            return other.error();
        if (belongTogether(record.swing, other->swing))
            return std::optional(std::move(*other));
    }
    return std::optional<SwingRecord>();
}

Result<CardColumn> columnOf(db::Stores& stores, const SwingRecord& record, const CardOptions& options)
{
    const auto analysis = stores.jobs.resultOf(record);
    auto card = analysis ? makeCard(*analysis, options) : Result<Card>(analysis.error());
    if (!card)
        return card.error();
    return CardColumn{columnHeading(record.swing.configuration.radio), std::move(card.value())};
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
    const auto analysis = analyse(observationsOf(record.swing));
    if (!*job || !analysis)
        return loads;
    for (const auto& note : loadsPast((*job)->job, *analysis))
        loads += Words::tr("%1 (%2° on %3)")
                     .arg(QString::fromStdString(note.load), signedFigure(note.deviation_deg, 0), figure(note.heading_deg, 0));
    return loads;
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

Result<ReportInput> reportOf(db::Stores& stores, SwingId id, const QString& madeAtUtc)
{
    auto record = stores.swings.record(id);
    if (!record)
        return record.error();
    auto analysis = stores.jobs.resultOf(*record);
    if (!analysis)
        return analysis.error();
    auto previous = stores.swings.previous(id);
    auto sensors = stores.sensors.of(record->compass.id);
    auto job = stores.jobs.jobOf(id);
    auto superseded = withRecord(stores, record->compass.id, record->swing.supersedes);
    if (!previous || !sensors || !job || !superseded)
        return !previous ? previous.error() : !sensors ? sensors.error() : !job ? job.error() : superseded.error();
    ReportInput input;
    input.record = std::move(record.value());
    input.analysis = std::move(analysis.value());
    input.previous = std::move(previous.value());
    input.sensors = std::move(sensors.value());
    input.job = std::move(job.value());
    input.superseded = std::move(superseded.value());
    input.madeAtUtc = madeAtUtc;
    return input;
}

Result<CardInput> cardOf(db::Stores& stores, SwingId id, const CardOptions& options, const QString& madeAtUtc, bool again)
{
    const auto record = stores.swings.record(id);
    if (!record)
        return record.error();
    const auto column = columnOf(stores, *record, options);
    if (!column)
        return column.error();
    CardInput input{*record, {*column}, madeAtUtc, options};
    input.nextDue = nextDue(stores, *record);
    const auto loads = loadsToName(stores, *record);
    if (!loads)
        return loads.error();
    input.loadsToName = *loads;
    if (again && !record->swing.signatures.empty()) // before it is signed there was no card to lose
        input.reprintOf = QString::fromStdString(record->swing.signatures.back().timeUtc.substr(0, 10));
    const auto other = radioPartner(stores, *record);
    if (!other)
        return other.error();
    if (!*other)
        return input;
    const auto second = columnOf(stores, **other, options);
    if (!second)
        return second.error();
    input.columns.insert((*other)->swing.configuration.radio == RadioState::On ? input.columns.begin() : input.columns.end(), *second);
    return input;
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
        input.job.plan.kind
            = input.record.compass.kind == CompassKind::DirectReading ? ProcedureKind::Coefficient : ProcedureKind::FluxValve;
        input.job.checklist = usualChecklist();
        input.job.datum.name = input.record.swing.datum.instrument;
    }
    input.job.events.clear();
    input.record.swing.indexRemoved_deg.reset(); // the form is of a swing that is to be made
    return input;
}

Result<StyleSheet1613> sheet1613Of(db::Stores& stores, SwingId id, const QString& madeAtUtc)
{
    auto record = stores.swings.record(id);
    auto job = stores.jobs.jobOf(id);
    if (!record || !job)
        return record ? job.error() : record.error();
    StyleSheet1613 sheet{std::move(record.value()), {}, madeAtUtc};
    if (*job)
        if (const auto state = stateOf((*job)->job); state && (*job)->job.plan.kind != ProcedureKind::CheckOnly)
            sheet.asFound = asFoundSwing((*job)->job, *state);
    return sheet;
}

} // namespace lubberline::ui
