#include "ui/report/swing/JobTables.h"

#include "core/procedure/JobState.h"
#include "core/record/SwingDifferences.h"
#include "core/swing/Observations.h"
#include "ui/report/page/Figures.h"
#include "ui/report/page/Words.h"

namespace lubberline::ui {

namespace {

TableColumn words(const QString& head, double width_mm) { return {head, {}, {}, width_mm, TableColumn::Align::Left}; }

TableColumn degrees(const QString& head, double width_mm = 18)
{
    return {head, {}, QStringLiteral("°"), width_mm, TableColumn::Align::Point};
}

QString controlWord(Control control)
{
    switch (control) {
    case Control::NorthSouth: return Words::tr("N–S (C)");
    case Control::EastWest: return Words::tr("E–W (B)");
    case Control::Index: return Words::tr("index (A)");
    }
    return {};
}

QString timeOf(const JobEvent& event) { return printable(event.timeUtc); }

QString figures(const std::vector<double>& values)
{
    QStringList all;
    for (const double value : values)
        all += QString::number(value, 'g', 7);
    return all.join(QStringLiteral("  "));
}

std::optional<double> nominalOf(const JobState& state, int station)
{
    if (station < 0 || station >= static_cast<int>(state.stations.size()))
        return {};
    return state.stations[static_cast<std::size_t>(station)].station.nominal_deg;
}

/// The deviation that was left on the heading that the crew turned to before.
std::optional<double> leftOn(const Swing& left, std::optional<double> nominal_deg)
{
    for (const auto& reading : left.readings)
        if (nominal_deg && reading.used() && reading.nominal_deg == nominal_deg) {
            const Observation seen = observationOf(left, reading);
            return deviationOf(seen.magnetic, seen.compass).degrees();
        }
    return {};
}

Table asFoundTable(const SwingJob& job, const JobState& state, const Swing& left)
{
    Table table{Words::tr("As found, before a control was turned on it, and what was left there"),
        {degrees(Words::tr("nominal")), degrees(Words::tr("magnetic")), degrees(Words::tr("compass", "heading")),
            degrees(Words::tr("deviation")), degrees(Words::tr("as left")), words(Words::tr("note"), 60)},
        {}};
    if (job.plan.kind == ProcedureKind::CheckOnly)
        return table;
    for (const auto& reading : asFoundSwing(job, state).readings) {
        std::optional<double> magnetic, compass, deviation;
        if (reading.complete()) {
            magnetic = reading.magnetic->degrees();
            compass = reading.compass->degrees();
            deviation = deviationOf(*reading.magnetic, *reading.compass).degrees();
        }
        table.rows.push_back({{headingFigure(reading.nominal_deg, 0), headingFigure(magnetic, 1), headingFigure(compass, 1),
            signedFigure(deviation, 1), signedFigure(leftOn(left, reading.nominal_deg), 1), printable(reading.note)}});
    }
    return table;
}

Table adjustmentsTable(const SwingJob& job, const JobState& state)
{
    Table table{Words::tr("Adjustments: what the compass read, was to read, and read after"),
        {words(Words::tr("time (UTC)"), 38), degrees(Words::tr("on")), words(Words::tr("control"), 20), degrees(Words::tr("read")),
            degrees(Words::tr("to read")), degrees(Words::tr("after")), words(Words::tr("note"), 50)},
        {}};
    for (const auto& event : job.events) {
        if (const auto* turned = std::get_if<job::Adjusted>(&event.what))
            table.rows.push_back({{timeOf(event), figure(nominalOf(state, turned->station), 0), controlWord(turned->control),
                figure(turned->before_deg, 1), figure(turned->target_deg, 1), figure(turned->after_deg, 1), printable(turned->note)}});
        else if (const auto* left = std::get_if<job::NotAdjusted>(&event.what))
            table.rows.push_back({{timeOf(event), figure(nominalOf(state, left->station), 0), controlWord(left->control), dash(), dash(),
                dash(), Words::tr("left as it is: %1").arg(printable(left->reason))}});
        else if (const auto* index = std::get_if<job::IndexRemoved>(&event.what))
            table.rows.push_back({{timeOf(event), dash(), controlWord(Control::Index), figure(index->before_deg, 1),
                figure(index->target_deg, 1), figure(index->after_deg, 1), Words::tr("after the check swing")}});
        else if (const auto* kept = std::get_if<job::IndexLeft>(&event.what))
            table.rows.push_back({{timeOf(event), dash(), controlWord(Control::Index), dash(), dash(), dash(),
                Words::tr("left in: %1").arg(printable(kept->reason))}});
    }
    return table;
}

Table checklistTable(const SwingJob& job)
{
    Table table{Words::tr("Before the first reading"), {words(Words::tr("check"), 120), words(Words::tr("done (UTC)"), 38)}, {}};
    for (const auto& item : job.checklist) {
        QString done = dash();
        for (const auto& event : job.events)
            if (const auto* ticked = std::get_if<job::Ticked>(&event.what); ticked && ticked->item == item)
                done = ticked->done ? timeOf(event) : dash();
        table.rows.push_back({{printable(item), done}});
    }
    return table;
}

Table interferenceTable(const SwingJob& job)
{
    Table table{Words::tr("Interference: the compass with a load off and on"),
        {degrees(Words::tr("heading")), words(Words::tr("load"), 60), degrees(Words::tr("off")), degrees(Words::tr("on")),
            degrees(Words::tr("change"))},
        {}};
    for (const auto& event : job.events)
        if (const auto* read = std::get_if<job::InterferenceRead>(&event.what))
            table.rows.push_back({{headingFigure(read->heading_deg, 0), printable(read->load), figure(read->off_deg, 1),
                figure(read->on_deg, 1), signedFigure(wrap180(read->on_deg - read->off_deg), 1)}});
    return table;
}

Table otherStepsTable(const SwingJob& job, const JobState& state)
{
    Table table{Words::tr("Put aside, skipped, faults and review"),
        {words(Words::tr("time (UTC)"), 38), degrees(Words::tr("on")), words(Words::tr("what"), 30), words(Words::tr("why"), 90)}, {}};
    const auto add = [&](const JobEvent& event, std::optional<int> station, const QString& what, const std::string& why) {
        table.rows.push_back({{timeOf(event), station ? figure(nominalOf(state, *station), 0) : dash(), what, printable(why)}});
    };
    for (const auto& event : job.events) {
        if (const auto* again = std::get_if<job::ReadingRejected>(&event.what))
            add(event, again->station, Words::tr("put aside"), again->reason);
        else if (const auto* skipped = std::get_if<job::StationSkipped>(&event.what))
            add(event, skipped->station, Words::tr("skipped"), skipped->reason);
        else if (const auto* fault = std::get_if<job::Faulted>(&event.what))
            add(event, {}, Words::tr("fault"), fault->cause);
        else if (const auto* mended = std::get_if<job::Mended>(&event.what))
            add(event, {}, Words::tr("mended"), mended->action);
        else if (const auto* changed = std::get_if<job::DatumChanged>(&event.what))
            add(event, {}, Words::tr("other instrument"), changed->datum.name);
        else if (const auto* accepted = std::get_if<job::Accepted>(&event.what))
            add(event, {}, Words::tr("accepted"), accepted->by);
    }
    return table;
}

/// Where more was read than the two headings say.
Table figuresTable(const Swing& swing)
{
    Table table{Words::tr("Figures as they were read"),
        {{Words::tr("no."), {}, {}, 10, TableColumn::Align::Point}, words(Words::tr("time (UTC)"), 38), words(Words::tr("datum (°)"), 40),
            words(Words::tr("datum from astern (°)"), 40), words(Words::tr("compass (°)"), 40)},
        {}};
    for (std::size_t i = 0; i < swing.readings.size(); ++i) {
        const auto& reading = swing.readings[i];
        if (!reading.raw.empty())
            table.rows.push_back({{QString::number(i + 1), printable(reading.timeUtc), figures(reading.raw.datum_deg),
                figures(reading.raw.astern_deg), figures(reading.raw.compass_deg)}});
    }
    return table;
}

Table revisionTable(const Swing& before, const Swing& after)
{
    Table table{Words::tr("What this revision changes: %1").arg(printable(after.amendment)),
        {words(Words::tr("what"), 50), words(Words::tr("before"), 60), words(Words::tr("now"), 60)}, {}};
    for (const auto& one : differencesBetween(before, after))
        table.rows.push_back({{printable(one.what), printable(one.before), printable(one.after)}});
    return table;
}

} // namespace

std::vector<Table> jobTables(const ReportInput& input)
{
    std::vector<Table> tables;
    if (input.superseded)
        tables.push_back(revisionTable(*input.superseded, input.record.swing));
    if (input.job)
        if (const auto state = stateOf(input.job->job))
            for (auto& table : {checklistTable(input.job->job), asFoundTable(input.job->job, *state, input.record.swing),
                     adjustmentsTable(input.job->job, *state), interferenceTable(input.job->job), otherStepsTable(input.job->job, *state)})
                tables.push_back(table);
    tables.push_back(figuresTable(input.record.swing));
    std::erase_if(tables, [](const Table& table) { return table.rows.empty(); });
    return tables;
}

} // namespace lubberline::ui
