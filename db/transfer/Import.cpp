#include "db/transfer/Transfer.h"

#include <algorithm>
#include <map>

#include "core/swing/SwingField.h"
#include "db/engine/Statement.h"
#include "db/engine/Transaction.h"
#include "db/stores/DueStore.h"
#include "db/stores/ElectricalStore.h"
#include "db/stores/FleetStore.h"
#include "db/stores/JobStore.h"
#include "db/stores/SensorStore.h"
#include "db/stores/Signatures.h"
#include "db/stores/SiteStore.h"
#include "db/stores/SwingStore.h"
#include "db/transfer/ImportChecks.h"

namespace lubberline::db {

namespace {

/// Ids of the fleet's own numbering → ids in the database.
struct Known {
    std::map<LimitsProfileId, LimitsProfileId> limits;
    std::map<SiteId, SiteId> sites;
    std::map<AircraftTypeId, AircraftTypeId> types;
    std::map<AircraftId, AircraftId> aircraft;
    std::map<CompassId, CompassId> compasses;
    std::map<EventId, EventId> events;
};

template <class IdType>
IdType translated(const std::map<IdType, IdType>& known, IdType id)
{
    const auto found = known.find(id);
    return found == known.end() ? IdType{} : found->second;
}

class Importer {
public:
    Importer(Database& database, const Fleet& fleet) : m_database(database), m_fleet(fleet) {}

    Result<void> particulars()
    {
        for (const auto& step :
            {&Importer::limits, &Importer::sites, &Importer::types, &Importer::aircraft, &Importer::compasses, &Importer::sensors,
                &Importer::events, &Importer::instruments, &Importer::dueRules, &Importer::waivers, &Importer::electrical})
            if (const auto done = (this->*step)(); !done)
                return done;
        return {};
    }
    Result<void> swing(const Swing& swing);
    Imported imported;
    int signedByNobody = 0; ///< before signatures were kept, or they were taken out: told once for all

private:
    Result<void> limits();
    Result<void> sites();
    Result<void> types();
    Result<void> aircraft();
    Result<void> compasses();
    Result<void> sensors();
    Result<void> events();
    Result<void> instruments();
    Result<void> dueRules();
    Result<void> waivers();
    Result<void> electrical();
    Result<SwingId> add(Swing swing, const JobRecord* job);
    Result<void> goOn(const Swing& incoming, const JobRecord& job, const SwingRecord& stored);
    [[nodiscard]] const JobRecord* jobOf(SwingId id) const;

    /// The id of the record with this RecordId, else of the one that `where` finds by name; not valid: none.
    template <class IdType, class... Values>
    Result<IdType> find(const QString& table, const RecordId& record, const QString& where, const Values&... values)
    {
        for (const bool byRecord : {true, false}) {
            Statement statement(m_database, "SELECT id FROM " + table + " WHERE " + (byRecord ? QStringLiteral("record = ?") : where));
            if (byRecord)
                statement << record;
            else
                static_cast<void>((statement << ... << values));
            const auto found = firstOf<IdType>(statement, [](Statement& row) { return row.id<IdType>(0); });
            if (!found)
                return found.error();
            if (*found)
                return **found;
        }
        return IdType{};
    }

    /// Finds or stores each of `records`, and remembers under which id.
    template <class Record, class IdType, class Find, class Save>
    Result<void> each(const std::vector<Record>& records, std::map<IdType, IdType>& known, Find findOne, Save save, int* added = nullptr)
    {
        for (const auto& record : records) {
            const Result<IdType> found = findOne(record);
            if (!found)
                return found.error();
            IdType id = *found;
            if (!id.valid()) {
                const Result<IdType> stored = save(record);
                if (!stored)
                    return stored.error();
                id = *stored;
                if (added)
                    ++*added;
            }
            known[record.id] = id;
        }
        return {};
    }

    Database& m_database;
    const Fleet& m_fleet;
    Known m_known;
};

Result<void> Importer::limits()
{
    return each(
        m_fleet.limits, m_known.limits,
        [this](const LimitsProfile& one) { return find<LimitsProfileId>("limits_profile", one.record, "name = ?", one.name); },
        [this](LimitsProfile one) {
            one.id = {};
            return SiteStore(m_database).add(one);
        });
}

Result<void> Importer::sites()
{
    return each(
        m_fleet.sites, m_known.sites, [this](const Site& one) { return find<SiteId>("site", one.record, "name = ?", one.name); },
        [this](Site one) {
            one.id = {};
            return SiteStore(m_database).add(one);
        });
}

Result<void> Importer::types()
{
    return each(
        m_fleet.types, m_known.types,
        [this](const AircraftType& one) { return find<AircraftTypeId>("aircraft_type", one.record, "name = ?", one.name); },
        [this](AircraftType one) {
            one.id = {};
            return FleetStore(m_database).add(one);
        });
}

Result<void> Importer::aircraft()
{
    return each(
        m_fleet.aircraft, m_known.aircraft,
        [this](const Aircraft& one) { return find<AircraftId>("aircraft", one.record, "registration = ?", one.registration); },
        [this](Aircraft one) {
            one.id = {};
            one.type = translated(m_known.types, one.type);
            one.base = translated(m_known.sites, one.base);
            return FleetStore(m_database).add(one);
        },
        &imported.aircraft);
}

Result<void> Importer::compasses()
{
    return each(
        m_fleet.compasses, m_known.compasses,
        [this](const CompassSystem& one) {
            return find<CompassId>(
                "compass", one.record, "aircraft_id = ? AND name = ?", translated(m_known.aircraft, one.aircraft), one.name);
        },
        [this](CompassSystem one) {
            one.id = {};
            one.aircraft = translated(m_known.aircraft, one.aircraft);
            one.limits = translated(m_known.limits, one.limits);
            return FleetStore(m_database).add(one);
        });
}

Result<void> Importer::sensors()
{
    std::map<SensorModelId, SensorModelId> none;
    return each(
        m_fleet.sensors, none,
        [this](const SensorRecord& one) {
            return find<SensorModelId>(
                "sensor_model", one.record, "compass_id = ? AND name = ?", translated(m_known.compasses, one.compass), one.name);
        },
        [this](SensorRecord one) {
            one.id = {};
            one.compass = translated(m_known.compasses, one.compass);
            return SensorStore(m_database).add(one);
        });
}

Result<void> Importer::events()
{
    return each(
        m_fleet.events, m_known.events, [this](const Event& one) { return find<EventId>("event", one.record, "1 = 0"); },
        [this](Event one) {
            one.id = {};
            one.aircraft = translated(m_known.aircraft, one.aircraft);
            return FleetStore(m_database).add(one);
        });
}

/// What is not known by its record or its name is added.
Result<void> Importer::instruments()
{
    for (const auto& one : m_fleet.instruments) {
        const auto found = find<Id<struct InstrumentRow>>("datum_instrument", one.record, "name = ?", one.name);
        if (!found)
            return found.error();
        if (!found->valid())
            if (const auto saved = SiteStore(m_database).add(one); !saved)
                return saved.error();
    }
    return {};
}

Result<void> Importer::dueRules()
{
    for (DueRule one : m_fleet.dueRules) {
        const auto found = find<Id<struct RuleRow>>("due_rule", one.record, "name = ?", one.name);
        if (!found)
            return found.error();
        if (found->valid())
            continue;
        if (const auto type
            = std::find_if(m_fleet.types.begin(), m_fleet.types.end(), [&](const AircraftType& each) { return each.record == one.type; });
            type != m_fleet.types.end()) { // the type may be known here under another record, by its name
            const auto here = FleetStore(m_database).type(translated(m_known.types, type->id));
            if (!here)
                return here.error();
            one.type = here->record;
        }
        if (const auto saved = DueStore(m_database).add(one); !saved)
            return saved.error();
    }
    return {};
}

Result<void> Importer::waivers()
{
    for (const auto& one : m_fleet.waivers) {
        const auto found = find<Id<struct WaiverRow>>("waiver", one.record, "1 = 0");
        if (!found)
            return found.error();
        if (!found->valid())
            if (const auto saved = DueStore(m_database).add(one); !saved)
                return saved.error();
    }
    return {};
}

Result<void> Importer::electrical()
{
    for (const auto& one : m_fleet.electrical) {
        const auto found = find<Id<struct ElectricalRow>>("electrical_swing", one.swing.record, "1 = 0");
        if (!found)
            return found.error();
        if (!found->valid())
            if (const auto saved = ElectricalStore(m_database).add(translated(m_known.compasses, one.compass), one.swing); !saved)
                return saved.error();
    }
    return {};
}

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
    const auto found = find<SwingId>("swing", one.record, "1 = 0");
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
        signedByNobody += one.state == SwingState::Signed && one.signatures.empty();
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
    Importer importer(database, fleet);
    if (const auto done = importer.particulars(); !done)
        return done.error();
    for (std::size_t i = 0; i < fleet.swings.size(); ++i) {
        if (progress && i % 64 == 0 && !progress(static_cast<double>(i) / static_cast<double>(fleet.swings.size())))
            return Error{ErrorCode::Cancelled, MARKED("db", "cancelled; nothing was stored"), database.path().toStdString()};
        if (const auto done = importer.swing(fleet.swings[i]); !done)
            return done.error();
    }
    if (importer.signedByNobody > 0)
        importer.imported.warnings.push_back(
            {MARKED_N("db", "%n new swing(s) are signed, and the file does not say by whom"), importer.signedByNobody});
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
