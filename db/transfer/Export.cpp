#include "db/transfer/Transfer.h"

#include <algorithm>
#include <optional>
#include <set>

#include "db/engine/Transaction.h"
#include "db/stores/CoilStore.h"
#include "db/stores/DueStore.h"
#include "db/stores/ElectricalStore.h"
#include "db/stores/FleetStore.h"
#include "db/stores/JobStore.h"
#include "db/stores/SensorStore.h"
#include "db/stores/SiteStore.h"
#include "db/stores/SwingStore.h"

namespace lubberline::db {

namespace {

Result<std::vector<AircraftId>> wholeFleet(Database& database)
{
    FleetStore repository(database);
    std::vector<AircraftId> ids;
    const auto types = repository.types();
    if (!types)
        return types.error();
    for (const auto& type : *types) {
        const auto rows = repository.aircraftOf(type.id);
        if (!rows)
            return rows.error();
        for (const auto& row : *rows)
            ids.push_back(row.id);
    }
    return ids;
}

/// One aircraft with its type (once), compasses, their sensor models, events and swings.
Result<void> append(Database& database, Fleet& fleet, std::set<AircraftTypeId>& types, AircraftId id)
{
    FleetStore repository(database);
    SwingStore swings(database);
    const auto aircraft = repository.aircraft(id);
    if (!aircraft)
        return aircraft.error();
    fleet.aircraft.push_back(*aircraft);
    if (types.insert(aircraft->type).second) {
        const auto type = repository.type(aircraft->type);
        if (!type)
            return type.error();
        fleet.types.push_back(*type);
    }
    const auto events = repository.eventsOf(id);
    if (!events)
        return events.error();
    fleet.events.insert(fleet.events.end(), events->begin(), events->end());
    const auto waivers = DueStore(database).waiversOf(id);
    if (!waivers)
        return waivers.error();
    fleet.waivers.insert(fleet.waivers.end(), waivers->begin(), waivers->end());
    const auto compasses = repository.compassesOf(id);
    if (!compasses)
        return compasses.error();
    for (const auto& row : *compasses) {
        const auto compass = repository.compass(row.id);
        if (!compass)
            return compass.error();
        fleet.compasses.push_back(*compass);
        const auto sensors = SensorStore(database).of(row.id);
        if (!sensors)
            return sensors.error();
        fleet.sensors.insert(fleet.sensors.end(), sensors->begin(), sensors->end());
        const auto electrical = ElectricalStore(database).of(row.id);
        if (!electrical)
            return electrical.error();
        for (const auto& one : *electrical)
            fleet.electrical.push_back({row.id, one});
        auto benches = CoilStore(database).of(row.id);
        if (!benches)
            return benches.error();
        for (auto& one : *benches)
            fleet.coilBenches.push_back({row.id, std::move(one)});
        const auto rows = swings.swingsOf(row.id);
        if (!rows)
            return rows.error();
        for (const auto& swing : *rows) {
            auto whole = swings.swing(swing.id);
            if (!whole)
                return whole.error();
            auto job = JobStore(database).jobOf(swing.id);
            if (!job)
                return job.error();
            if (*job && (*job)->swing == swing.id) {
                (*job)->job.particulars = {};
                fleet.jobs.push_back(std::move(**job));
            }
            fleet.swings.push_back(std::move(whole.value()));
        }
    }
    return {};
}

/// The due rules of its types (and those for all), and with a whole fleet the instruments.
Result<void> appendRules(Database& database, Fleet& fleet, bool all)
{
    const auto rules = DueStore(database).rules();
    if (!rules)
        return rules.error();
    for (const auto& rule : *rules)
        if (std::any_of(fleet.types.begin(), fleet.types.end(), [&](const AircraftType& type) { return type.record == rule.type; })
            || (all && rule.type.empty()))
            fleet.dueRules.push_back(rule);
    if (!all)
        return {};
    const auto instruments = SiteStore(database).instruments();
    if (!instruments)
        return instruments.error();
    fleet.instruments = *instruments;
    return {};
}

/// The sites and limits profiles that the fleet refers to.
Result<void> appendReferences(Database& database, Fleet& fleet, bool all)
{
    SiteStore repository(database);
    const auto sites = repository.sites();
    if (!sites)
        return sites.error();
    for (const auto& site : *sites)
        if (all || std::any_of(fleet.swings.begin(), fleet.swings.end(), [&](const Swing& swing) { return swing.site == site.id; })
            || std::any_of(fleet.aircraft.begin(), fleet.aircraft.end(), [&](const Aircraft& one) { return one.base == site.id; }))
            fleet.sites.push_back(site);
    const auto limits = repository.limitsProfiles();
    if (!limits)
        return limits.error();
    for (const auto& profile : *limits)
        if (all || std::any_of(fleet.compasses.begin(), fleet.compasses.end(), [&](const CompassSystem& compass) {
                return compass.limits == profile.id;
            }))
            fleet.limits.push_back(profile);
    return appendRules(database, fleet, all);
}

/// Of a damaged database. @return the record that refers to what is not there.
template <class Record, class Target, class IdType>
std::optional<RecordId> dangling(const std::vector<Record>& records, IdType Record::*reference, const std::vector<Target>& targets)
{
    std::set<IdType> known;
    for (const auto& target : targets)
        known.insert(target.id);
    for (const auto& record : records)
        if ((record.*reference).valid() && !known.contains(record.*reference))
            return record.record;
    return {};
}

Result<void> checkReferences(const Database& database, const Fleet& fleet)
{
    for (const auto& [column, record] : {std::pair(std::string("swing.site_id"), dangling(fleet.swings, &Swing::site, fleet.sites)),
             std::pair(std::string("aircraft.base_id"), dangling(fleet.aircraft, &Aircraft::base, fleet.sites)),
             std::pair(std::string("compass.limits_id"), dangling(fleet.compasses, &CompassSystem::limits, fleet.limits))})
        if (record)
            return Error{ErrorCode::Corrupt,
                {MARKED("db",
                     "%1 of the record %2 refers to a row that is not there; expected a whole database: `lubberline db verify` lists"
                     " what is wrong"),
                    column, *record},
                database.path().toStdString()};
    return {};
}

} // namespace

Result<Fleet> exportFleet(Database& database, const std::vector<AircraftId>& aircraft, const Progress& progress)
{
    const auto snapshot = Transaction::beginReading(database);
    if (!snapshot)
        return snapshot.error();
    const auto ids = aircraft.empty() ? wholeFleet(database) : Result<std::vector<AircraftId>>(aircraft);
    if (!ids)
        return ids.error();
    Fleet fleet;
    std::set<AircraftTypeId> types;
    for (std::size_t i = 0; i < ids->size(); ++i) {
        if (progress && !progress(static_cast<double>(i) / static_cast<double>(ids->size())))
            return Error{ErrorCode::Cancelled, MARKED("db", "cancelled; nothing was exported"), database.path().toStdString()};
        if (const auto done = append(database, fleet, types, (*ids)[i]); !done)
            return done.error();
    }
    if (const auto done = appendReferences(database, fleet, aircraft.empty()); !done)
        return done.error();
    if (const auto whole = checkReferences(database, fleet); !whole)
        return whole.error();
    if (progress)
        progress(1.0);
    return fleet;
}

} // namespace lubberline::db
