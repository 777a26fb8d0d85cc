#include "ui/kit/OpenSwings.h"

#include <QCoreApplication>

#include <algorithm>

#include "core/procedure/JobState.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

struct OpenWords {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::OpenSwings)
};

} // namespace

QString stateWords(SwingState state, db::SignedMark mark)
{
    switch (mark) {
    case db::SignedMark::ByStateAlone: return OpenWords::tr("NOT SIGNED (no signatures stand)");
    case db::SignedMark::NotChecked: return OpenWords::tr("%1 (not checked)").arg(wordFor(state));
    case db::SignedMark::No:
    case db::SignedMark::Stands: break;
    }
    return wordFor(state);
}

QString standingWords(const SwingJob& job)
{
    const auto state = stateOf(job);
    if (!state)
        return OpenWords::tr("a step that does not read");
    switch (state->phase) {
    case JobPhase::Prepare: return OpenWords::tr("its preparation");
    case JobPhase::Stations: return OpenWords::tr("step %1 of %2").arg(state->current + 1).arg(state->stations.size());
    case JobPhase::Index: return OpenWords::tr("its index");
    case JobPhase::Review:
    case JobPhase::Card: return OpenWords::tr("its review");
    case JobPhase::Fault: return OpenWords::tr("a fault (%1)").arg(toText(state->fault));
    case JobPhase::Abandoned: return OpenWords::tr("its end: abandoned, %1").arg(toText(state->abandoned));
    }
    return {};
}

Result<std::vector<OpenSwing>> openSwings(db::Stores& stores)
{
    const auto rows = stores.jobs.open();
    if (!rows)
        return rows.error();
    std::vector<OpenSwing> all;
    for (const JobRow& row : *rows) {
        OpenSwing one{row.swing, {}, QStringLiteral("%1 · %2").arg(toText(row.registration), toText(row.compass)), {}};
        QString standing = OpenWords::tr("a step that does not read");
        if (const auto job = stores.jobs.jobOf(row.swing); job && *job) {
            one.compass = (*job)->job.particulars.compass;
            standing = standingWords((*job)->job);
        }
        one.words = OpenWords::tr("%1 %2 stands at %3: go on").arg(toText(row.registration), toText(row.compass), standing);
        all.push_back(std::move(one));
    }
    return all;
}

bool isOpenJob(db::Stores& stores, SwingId swing)
{
    const auto jobs = stores.jobs.open();
    return jobs && std::any_of(jobs->begin(), jobs->end(), [swing](const JobRow& job) { return job.swing == swing; });
}

QString abandonedWords(db::Stores& stores, SwingId swing)
{
    const auto job = stores.jobs.jobOf(swing);
    if (!job || !*job || (*job)->swing != swing)
        return {};
    const auto state = stateOf((*job)->job);
    if (!state || state->phase != JobPhase::Abandoned)
        return {};
    return OpenWords::tr("Guided swing abandoned: %1").arg(toText(state->abandoned));
}

} // namespace lubberline::ui
