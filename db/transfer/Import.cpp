#include "db/transfer/Transfer.h"

#include <algorithm>

#include "core/swing/SwingField.h"
#include "db/engine/Transaction.h"
#include "db/stores/JobStore.h"
#include "db/stores/Signatures.h"
#include "db/stores/SiteStore.h"
#include "db/stores/SwingStore.h"
#include "db/transfer/ImportChecks.h"
#include "db/transfer/ImportParticulars.h"
#include "db/transfer/RowWhere.h"

namespace lubberline::db {

namespace {

class Importer {
public:
    Importer(Database& database, const Fleet& fleet, const ImportedIds& known) : m_database(database), m_fleet(fleet), m_known(known) {}

    Result<void> swing(const Swing& swing);
    Imported imported;

private:
    Result<SwingId> add(Swing swing, const JobRecord* job);
    Result<void> goOn(const Swing& incoming, const JobRecord& job, const SwingRecord& stored);
    [[nodiscard]] const JobRecord* jobOf(SwingId id) const;

    Database& m_database;
    const Fleet& m_fleet;
    const ImportedIds& m_known;
};

const JobRecord* Importer::jobOf(SwingId id) const
{
    const auto found = std::find_if(m_fleet.jobs.begin(), m_fleet.jobs.end(), [&](const JobRecord& one) { return one.swing == id; });
    return found == m_fleet.jobs.end() ? nullptr : &*found;
}

/// Equal but for the ids of rows and the figures of a field stamp: those follow from its place and date by the model of the
/// day.
bool sameContents(Swing incoming, const Swing& stored)
{
    incoming.id = stored.id;
    if (incoming.kind == SwingKind::NotStated) // a file that says nothing contradicts nobody
        incoming.kind = stored.kind;
    if (incoming.stage == SwingStage::NotStated)
        incoming.stage = stored.stage;
    if (!incoming.field || (stored.field && incoming.field->place == stored.field->place && incoming.field->date == stored.field->date))
        incoming.field = stored.field;
    if (incoming.readings.size() == stored.readings.size())
        for (std::size_t i = 0; i < incoming.readings.size(); ++i)
            incoming.readings[i].id = stored.readings[i].id;
    return incoming == stored;
}

Result<SwingId> Importer::add(Swing swing, const JobRecord* job)
{
    const auto site = SiteStore(m_database).site(swing.site);
    if (!site)
        return site.error();
    stampUnlessSigned(swing, *site);
    // A guided swing comes in before its swing is frozen.
    const SwingState state = swing.state;
    if (job && state == SwingState::Signed)
        swing.state = SwingState::Complete;
    SwingStore swings(m_database);
    const auto id = swings.addAsIs(swing);
    if (!id || !job)
        return id;
    if (const auto added = JobStore(m_database).add(*id, job->job, !swing.readings.empty()); !added)
        return added.error();
    if (swing.state == state)
        return id;
    auto whole = swings.swing(*id);
    if (!whole)
        return whole.error();
    const Swing complete = *whole;
    whole->state = state;
    const auto frozen = swings.replace(complete, *whole);
    return frozen ? id : frozen.error();
}

bool isBeginningOf(const std::vector<JobEvent>& shorter, const std::vector<JobEvent>& longer)
{
    return shorter.size() <= longer.size() && std::equal(shorter.begin(), shorter.end(), longer.begin());
}

/// A guided swing that has gone on elsewhere: what was added there is added here; the readings that it made come with it.
/// Errors: Conflict when both have gone on.
Result<void> Importer::goOn(const Swing& incoming, const JobRecord& job, const SwingRecord& stored)
{
    JobStore jobs(m_database);
    const auto here = jobs.jobOf(stored.swing.id);
    if (!here)
        return here.error();
    const bool same = *here && (*here)->job.record == job.job.record && stored.swing.state == SwingState::Draft;
    if (!same || (!isBeginningOf((*here)->job.events, job.job.events) && !isBeginningOf(job.job.events, (*here)->job.events)))
        return Error{ErrorCode::Conflict,
            {MARKED(
                 "db", "the guided swing of %1, %2, %3 has gone on here and elsewhere in different ways (record %4); nothing was stored"),
                stored.aircraft.registration, stored.compass.name, stored.swing.date, stored.swing.record},
            m_database.path().toStdString()};
    if (job.job.events.size() <= (*here)->job.events.size() && incoming.readings.empty())
        return {}; // it is as far here, or farther
    for (std::size_t place = (*here)->job.events.size(); place < job.job.events.size(); ++place)
        if (const auto added = jobs.append(stored.swing.id, place, job.job.events[place]); !added)
            return added;
    SwingStore swings(m_database);
    Swing now = incoming;
    now.id = stored.swing.id;
    if (!now.field)
        now.field = stored.swing.field;
    if (!incoming.readings.empty()) {
        if (const auto replaced = swings.replaceReadings(stored.swing.id, incoming.readings); !replaced)
            return replaced;
        if (const auto closed = jobs.close(stored.swing.id, true); !closed)
            return closed;
    }
    for (const auto& signature : incoming.signatures) // before the swing is frozen
        if (const auto kept = addSignature(m_database, stored.swing.id, stored.swing.record, signature, kSignedElsewhere); !kept)
            return kept;
    const auto before = swings.swing(stored.swing.id);
    return before ? swings.replace(*before, now) : before.error();
}

Result<void> Importer::swing(const Swing& original)
{
    Swing one = original;
    one.id = {};
    one.compass = translated(m_known.compasses, one.compass);
    one.site = translated(m_known.sites, one.site);
    const JobRecord* job = jobOf(original.id);
    if (const auto whole = checkSigned(m_database, m_fleet, original, job); !whole)
        return whole;
    SwingStore swings(m_database);
    const auto found = rowWhere<SwingId>(m_database, "swing", "record = ?", one.record);
    if (!found)
        return found.error();
    if (!found->valid()) {
        const auto stored = add(one, job);
        if (!stored)
            return stored.error();
        ++imported.swings;
        imported.swingIds.push_back(*stored);
        auto told = checkStored(m_database, m_fleet, *stored, original, job);
        if (!told)
            return told.error();
        imported.warnings.insert(imported.warnings.end(), told->begin(), told->end());
        return {};
    }
    const auto record = swings.record(*found);
    if (!record)
        return record.error();
    if (!sameContents(one, record->swing)) {
        const Error conflict{ErrorCode::Conflict,
            {MARKED("db", "the swing of %1, %2, %3 is in the database already with other contents (record %4); nothing was stored"),
                record->aircraft.registration, record->compass.name, record->swing.date, one.record},
            m_database.path().toStdString()};
        if (!job || !record->swing.readings.empty())
            return conflict;
    }
    if (job && record->swing.readings.empty())
        if (const auto done = goOn(one, *job, *record); !done)
            return done;
    ++imported.alreadyThere;
    imported.swingIds.push_back(*found);
    return {};
}

} // namespace

Result<Imported> importFleet(Database& database, const Fleet& fleet, const Progress& progress)
{
    auto transaction = Transaction::begin(database);
    if (!transaction)
        return transaction.error();
    const auto known = importParticulars(database, fleet);
    if (!known)
        return known.error();
    Importer importer(database, fleet, *known);
    importer.imported.aircraft = known->newAircraft;
    for (std::size_t i = 0; i < fleet.swings.size(); ++i) {
        if (progress && i % 64 == 0 && !progress(static_cast<double>(i) / static_cast<double>(fleet.swings.size())))
            return Error{ErrorCode::Cancelled, MARKED("db", "cancelled; nothing was stored"), database.path().toStdString()};
        if (const auto done = importer.swing(fleet.swings[i]); !done)
            return done.error();
    }
    if (progress && !progress(1.0)) // the last moment at which nothing has been stored
        return Error{ErrorCode::Cancelled, MARKED("db", "cancelled; nothing was stored"), database.path().toStdString()};
    if (const auto committed = transaction->commit(); !committed)
        return committed.error();
    return importer.imported;
}

Result<Imported> importAll(Database& database, const std::vector<Fleet>& fleets, const Progress& progress)
{
    auto transaction = Transaction::begin(database);
    if (!transaction)
        return transaction.error();
    Imported all;
    for (const auto& fleet : fleets) {
        const auto one = importFleet(database, fleet, progress);
        if (!one)
            return one.error();
        all.aircraft += one->aircraft;
        all.swings += one->swings;
        all.alreadyThere += one->alreadyThere;
        all.swingIds.insert(all.swingIds.end(), one->swingIds.begin(), one->swingIds.end());
        all.warnings.insert(all.warnings.end(), one->warnings.begin(), one->warnings.end());
    }
    if (const auto committed = transaction->commit(); !committed)
        return committed.error();
    return all;
}

} // namespace lubberline::db
