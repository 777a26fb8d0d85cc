#include "db/stores/FleetStore.h"

#include "core/record/Ranges.h"
#include "db/saving/Saving.h"
#include "db/stores/ResultCache.h"
#include "db/stores/Tables.h"

namespace lubberline::db {

namespace {

AircraftType typeFrom(const Statement& row) { return {row.id<AircraftTypeId>(0), row.record(1), row.name(2), row.text(3), row.text(4)}; }

Aircraft aircraftFrom(const Statement& row)
{
    return {row.id<AircraftId>(0), row.record(1), row.id<AircraftTypeId>(2), row.name(3), row.text(4), row.text(5),
        row.optionalInteger(6, kYearRange), row.text(7), row.flag(8), row.optionalId<SiteId>(9)};
}

CompassSystem compassFrom(const Statement& row)
{
    const auto kind = row.as(4, CompassKind::RemoteStabilised);
    return {row.id<CompassId>(0), row.record(1), row.id<AircraftId>(2), row.name(3), row.flag(13) ? kind : CompassKind::NotStated,
        row.as(5, Compensator::Electronic), row.text(6), row.text(7), row.text(8), row.text(9), row.real(10, kPositiveRange),
        row.optionalId<LimitsProfileId>(11), row.day(12), row.flag(14)};
}

Event eventFrom(const Statement& row)
{
    return {row.id<EventId>(0), row.record(1), row.id<AircraftId>(2), row.day(3), row.text(4), row.as(6, DueCause::AccuracySuspected),
        row.text(5)};
}

void bindType(Statement& statement, const AircraftType& type) { statement << type.name << type.maker << type.note; }

void bindAircraft(Statement& statement, const Aircraft& aircraft)
{
    statement << aircraft.type << aircraft.registration << aircraft.serialNumber << aircraft.operatorName << aircraft.builtYear
              << aircraft.note << aircraft.demonstration << aircraft.base;
}

void bindCompass(Statement& statement, const CompassSystem& compass)
{
    const bool kindStated = compass.kind != CompassKind::NotStated;
    statement << compass.aircraft << compass.name << (kindStated ? static_cast<int>(compass.kind) : 0)
              << static_cast<int>(compass.compensator) << compass.maker << compass.partNumber << compass.serialNumber << compass.location
              << compass.resolution_deg << compass.limits << compass.installed << kindStated << compass.resolutionStated;
}

void bindEvent(Statement& statement, const Event& event)
{
    statement << event.aircraft << event.date << event.kind << event.note << static_cast<int>(event.cause);
}

} // namespace

const Table& typeTable()
{
    static const Table table{
        MARKED("db", "aircraft type"), "aircraft_type", {"name", "maker", "note"}, [](const Statement& row) { (void)typeFrom(row); }};
    return table;
}

const Table& aircraftTable()
{
    static const Table table{MARKED("db", "aircraft"), "aircraft",
        {"type_id", "registration", "serial_number", "operator_name", "built_year", "note", "demonstration", "base_id"},
        [](const Statement& row) { (void)aircraftFrom(row); }};
    return table;
}

const Table& compassTable()
{
    static const Table table{MARKED("db", "compass"), "compass",
        {"aircraft_id", "name", "kind", "compensator", "maker", "part_number", "serial_number", "location", "resolution_deg", "limits_id",
            "installed", "kind_stated", "resolution_stated"},
        [](const Statement& row) { (void)compassFrom(row); }};
    return table;
}

const Table& eventTable()
{
    static const Table table{MARKED("db", "event"), "event", {"aircraft_id", "date", "kind", "note", "cause"},
        [](const Statement& row) { (void)eventFrom(row); }};
    return table;
}

Result<Totals> FleetStore::totals()
{
    Statement statement(m_database,
        "SELECT (SELECT COUNT(*) FROM aircraft_type), (SELECT COUNT(*) FROM aircraft), (SELECT COUNT(*) FROM compass),"
        " (SELECT COUNT(*) FROM swing)");
    return oneOf<Totals>(statement, m_database, MARKED("db", "fleet"), [](Statement& row) {
        return Totals{static_cast<int>(row.integer(0)), static_cast<int>(row.integer(1)), static_cast<int>(row.integer(2)), row.integer(3)};
    });
}

Result<std::vector<TypeRow>> FleetStore::types()
{
    // Counted one by one, each from an index alone: a join would visit every compass's row.
    Statement statement(m_database,
        "SELECT t.id, t.name, (SELECT COUNT(*) FROM aircraft a WHERE a.type_id = t.id),"
        " COALESCE((SELECT MAX(c.status) FROM aircraft a JOIN compass c ON c.aircraft_id = a.id WHERE a.type_id = t.id), 0) AS status"
        " FROM aircraft_type t ORDER BY t.name");
    return shownRowsOf<TypeRow>(statement, [](Statement& row) {
        return TypeRow{row.id<AircraftTypeId>(0), row.text(1), static_cast<int>(row.integer(2)), row.as(3, Status::OutOfLimits)};
    });
}

Result<std::vector<AircraftRow>> FleetStore::aircraftOf(AircraftTypeId type)
{
    Statement statement(m_database,
        "SELECT a.id, a.type_id, a.registration, a.demonstration,"
        " COALESCE((SELECT MAX(c.status) FROM compass c WHERE c.aircraft_id = a.id), 0) AS status"
        " FROM aircraft a WHERE a.type_id = ? ORDER BY a.registration");
    statement << type;
    return shownRowsOf<AircraftRow>(statement, [](Statement& row) {
        return AircraftRow{row.id<AircraftId>(0), row.id<AircraftTypeId>(1), row.text(2), row.flag(3), row.as(4, Status::OutOfLimits)};
    });
}

Result<std::vector<CompassRow>> FleetStore::compassesOf(AircraftId aircraft)
{
    Statement statement(m_database,
        "SELECT c.id, c.aircraft_id, c.name, (SELECT COUNT(*) FROM swing s WHERE s.compass_id = c.id), c.status"
        " FROM compass c WHERE c.aircraft_id = ? ORDER BY c.name");
    statement << aircraft;
    return shownRowsOf<CompassRow>(statement, [](Statement& row) {
        return CompassRow{
            row.id<CompassId>(0), row.id<AircraftId>(1), row.text(2), static_cast<int>(row.integer(3)), row.as(4, Status::OutOfLimits)};
    });
}

Result<AircraftType> FleetStore::type(AircraftTypeId id)
{
    Statement statement(m_database, selectFrom(typeTable()) + "WHERE id = ?");
    statement << id;
    return oneOf<AircraftType>(statement, m_database, MARKED("db", "aircraft type"), typeFrom);
}

Result<Aircraft> FleetStore::aircraft(AircraftId id)
{
    Statement statement(m_database, selectFrom(aircraftTable()) + "WHERE id = ?");
    statement << id;
    return oneOf<Aircraft>(statement, m_database, MARKED("db", "aircraft"), aircraftFrom);
}

Result<CompassSystem> FleetStore::compass(CompassId id)
{
    Statement statement(m_database, selectFrom(compassTable()) + "WHERE id = ?");
    statement << id;
    return oneOf<CompassSystem>(statement, m_database, MARKED("db", "compass"), compassFrom);
}

Result<std::vector<Event>> FleetStore::eventsOf(AircraftId id)
{
    Statement statement(m_database, selectFrom(eventTable()) + "WHERE aircraft_id = ? ORDER BY date DESC, id DESC");
    statement << id;
    return rowsOf<Event>(statement, eventFrom);
}

Result<AircraftId> FleetStore::aircraftNamed(const std::string& registration)
{
    Statement statement(m_database, "SELECT id FROM aircraft WHERE registration = ?");
    statement << registration;
    return oneOf<AircraftId>(
        statement, m_database, {MARKED("db", "aircraft as %1"), registration}, [](Statement& row) { return row.id<AircraftId>(0); });
}

Result<AircraftTypeId> FleetStore::add(const AircraftType& type)
{
    if (const auto named = requireName(type.name, MARKED("db", "the name of the aircraft type")); !named)
        return named.error();
    return noting(
        m_database, [&] { return addRecord<AircraftTypeId>(m_database, typeTable(), type, bindType); },
        [&](AircraftTypeId) { m_database.changes().note(change::Fleet{}); });
}

Result<void> FleetStore::change(const AircraftType& known, const AircraftType& type)
{
    if (const auto named = requireName(type.name, MARKED("db", "the name of the aircraft type")); !named)
        return named.error();
    return noting(
        m_database, [&] { return changeRecord(m_database, typeTable(), type.id, known, type, bindType); },
        [&] { m_database.changes().note(change::Fleet{}); });
}

Result<AircraftId> FleetStore::add(const Aircraft& aircraft)
{
    if (const auto named = requireName(aircraft.registration, MARKED("db", "the registration")); !named)
        return named.error();
    return noting(
        m_database, [&] { return addRecord<AircraftId>(m_database, aircraftTable(), aircraft, bindAircraft); },
        [&](AircraftId id) { noteAircraft(id); });
}

Result<void> FleetStore::change(const Aircraft& known, const Aircraft& aircraft)
{
    if (const auto named = requireName(aircraft.registration, MARKED("db", "the registration")); !named)
        return named.error();
    return noting(
        m_database, [&] { return changeRecord(m_database, aircraftTable(), aircraft.id, known, aircraft, bindAircraft); },
        [&] { noteAircraft(aircraft.id); });
}

Result<CompassId> FleetStore::add(const CompassSystem& compass)
{
    if (const auto named = requireName(compass.name, MARKED("db", "the name of the compass")); !named)
        return named.error();
    return noting(
        m_database, [&] { return addRecord<CompassId>(m_database, compassTable(), compass, bindCompass); },
        [&](CompassId) { noteAircraft(compass.aircraft); });
}

Result<void> FleetStore::change(const CompassSystem& known, const CompassSystem& compass)
{
    if (const auto named = requireName(compass.name, MARKED("db", "the name of the compass")); !named)
        return named.error();
    const auto store = [&]() -> Result<void> {
        if (auto changed = changeRecord(m_database, compassTable(), compass.id, known, compass, bindCompass); !changed)
            return changed;
        return refreshSwingsOf(m_database, compass.id); // other limits may now apply to its swings
    };
    return noting(m_database, store, [&] { noteAircraft(compass.aircraft); });
}

Result<EventId> FleetStore::add(const Event& event)
{
    return noting(
        m_database, [&] { return addRecord<EventId>(m_database, eventTable(), event, bindEvent); }, [&](EventId) { noteEvent(event); });
}

Result<void> FleetStore::change(const Event& known, const Event& event)
{
    return noting(
        m_database, [&] { return changeRecord(m_database, eventTable(), event.id, known, event, bindEvent); }, [&] { noteEvent(event); });
}

void FleetStore::noteAircraft(AircraftId id)
{
    m_database.changes().note(change::Fleet{});
    m_database.changes().note(change::OfAircraft{id});
}

void FleetStore::noteEvent(const Event& event)
{
    m_database.changes().note(change::OfAircraft{event.aircraft});
    m_database.changes().note(change::Due{});
}

} // namespace lubberline::db
