#include "db/FleetRepository.h"

#include <sstream>

#include "db/ResultCache.h"
#include "db/Saving.h"

namespace lubberline::db {

namespace {

Error noSuch(const char* what, const Database& database)
{
    return {ErrorCode::NotFound, std::string("there is no such ") + what + " in the database", database.path().toStdString()};
}

/// Runs a statement and makes a value of each row.
template <class Row, class Make>
Result<std::vector<Row>> rowsOf(Statement& statement, Make make)
{
    if (const auto done = statement.run(); !done)
        return done.error();
    std::vector<Row> rows;
    while (statement.next())
        rows.push_back(make(statement));
    return rows;
}

template <class Row, class Make>
Result<Row> oneOf(Statement& statement, const Database& database, const char* what, Make make)
{
    if (const auto done = statement.run(); !done)
        return done.error();
    if (!statement.next())
        return noSuch(what, database);
    return make(statement);
}

/// `like` pattern of one word, with LIKE's own signs escaped.
std::string patternOf(const std::string& word)
{
    std::string pattern = "%";
    for (const char c : word) {
        if (c == '%' || c == '_' || c == '\\')
            pattern += '\\';
        pattern += c;
    }
    return pattern + "%";
}

} // namespace

Result<Totals> FleetRepository::totals()
{
    Statement statement(m_database, "SELECT (SELECT COUNT(*) FROM aircraft_type), (SELECT COUNT(*) FROM aircraft), (SELECT COUNT(*) FROM compass),"
                                    " (SELECT COUNT(*) FROM swing)");
    return oneOf<Totals>(statement, m_database, "fleet", [](Statement& row) {
        return Totals{static_cast<int>(row.integer(0)), static_cast<int>(row.integer(1)), static_cast<int>(row.integer(2)), row.integer(3)};
    });
}

Result<std::vector<TypeRow>> FleetRepository::types()
{
    Statement statement(m_database, "SELECT t.id, t.name, COUNT(DISTINCT a.id), COALESCE(MAX(c.status), 0) FROM aircraft_type t"
                                    " LEFT JOIN aircraft a ON a.type_id = t.id LEFT JOIN compass c ON c.aircraft_id = a.id GROUP BY t.id, t.name ORDER BY t.name");
    return rowsOf<TypeRow>(statement, [](Statement& row) {
        return TypeRow{row.id<AircraftTypeId>(0), row.text(1), static_cast<int>(row.integer(2)), row.as<Status>(3)};
    });
}

Result<std::vector<AircraftRow>> FleetRepository::aircraftOf(AircraftTypeId type)
{
    Statement statement(m_database, "SELECT a.id, a.type_id, a.registration, a.demonstration, COALESCE(MAX(c.status), 0) FROM aircraft a"
                                    " LEFT JOIN compass c ON c.aircraft_id = a.id WHERE a.type_id = ? GROUP BY a.id, a.type_id, a.registration, a.demonstration"
                                    " ORDER BY a.registration");
    statement << type;
    return rowsOf<AircraftRow>(statement, [](Statement& row) {
        return AircraftRow{row.id<AircraftId>(0), row.id<AircraftTypeId>(1), row.text(2), row.integer(3) != 0, row.as<Status>(4)};
    });
}

Result<std::vector<CompassRow>> FleetRepository::compassesOf(AircraftId aircraft)
{
    Statement statement(m_database, "SELECT c.id, c.aircraft_id, c.name, (SELECT COUNT(*) FROM swing s WHERE s.compass_id = c.id), c.status"
                                    " FROM compass c WHERE c.aircraft_id = ? ORDER BY c.name");
    statement << aircraft;
    return rowsOf<CompassRow>(statement, [](Statement& row) {
        return CompassRow{row.id<CompassId>(0), row.id<AircraftId>(1), row.text(2), static_cast<int>(row.integer(3)), row.as<Status>(4)};
    });
}

Result<std::vector<SearchHit>> FleetRepository::search(const std::string& words, int limit)
{
    std::vector<std::string> patterns;
    std::istringstream stream(words);
    for (std::string word; stream >> word;)
        patterns.push_back(patternOf(word));
    if (patterns.empty())
        return std::vector<SearchHit>{};

    // Aircraft and compasses first, then swings; each word must be somewhere in the line's text.
    QString where;
    for (std::size_t i = 0; i < patterns.size(); ++i)
        where += (i ? " AND" : "") + QStringLiteral(" line LIKE ? ESCAPE '\\'");
    Statement statement(m_database, "SELECT line, aircraft_id, compass_id, swing_id FROM ("
        " SELECT t.name || ' · ' || a.registration AS line, a.id AS aircraft_id, NULL AS compass_id, NULL AS swing_id, 0 AS rank, '' AS date"
        "  FROM aircraft a JOIN aircraft_type t ON t.id = a.type_id"
        " UNION ALL SELECT t.name || ' · ' || a.registration || ' · ' || c.name, a.id, c.id, NULL, 1, ''"
        "  FROM compass c JOIN aircraft a ON a.id = c.aircraft_id JOIN aircraft_type t ON t.id = a.type_id"
        " UNION ALL SELECT t.name || ' · ' || a.registration || ' · ' || c.name || ' · ' || s.date || ' ' || COALESCE(si.name, '') || ' ' || s.inspector"
        "   || ' ' || s.note, a.id, c.id, s.id, 2, s.date FROM swing s JOIN compass c ON c.id = s.compass_id JOIN aircraft a ON a.id = c.aircraft_id"
        "   JOIN aircraft_type t ON t.id = a.type_id LEFT JOIN site si ON si.id = s.site_id"
        ") WHERE" + where + " ORDER BY rank, date DESC, line LIMIT ?");
    for (const auto& pattern : patterns)
        statement << pattern;
    statement << limit;
    return rowsOf<SearchHit>(statement, [](Statement& row) {
        return SearchHit{row.text(0), row.id<AircraftId>(1), row.id<CompassId>(2), row.id<SwingId>(3)};
    });
}

Result<AircraftType> FleetRepository::type(AircraftTypeId id)
{
    Statement statement(m_database, "SELECT id, record, name, maker, note FROM aircraft_type WHERE id = ?");
    statement << id;
    return oneOf<AircraftType>(statement, m_database, "aircraft type", [](Statement& row) {
        return AircraftType{row.id<AircraftTypeId>(0), row.text(1), row.text(2), row.text(3), row.text(4)};
    });
}

Result<Aircraft> FleetRepository::aircraft(AircraftId id)
{
    Statement statement(m_database, "SELECT id, record, type_id, registration, serial_number, operator_name, built_year, note, demonstration FROM aircraft WHERE id = ?");
    statement << id;
    return oneOf<Aircraft>(statement, m_database, "aircraft", [](Statement& row) {
        return Aircraft{row.id<AircraftId>(0), row.text(1), row.id<AircraftTypeId>(2), row.text(3), row.text(4), row.text(5), row.optionalInteger(6),
            row.text(7), row.integer(8) != 0};
    });
}

Result<CompassSystem> FleetRepository::compass(CompassId id)
{
    Statement statement(m_database, "SELECT id, record, aircraft_id, name, kind, compensator, maker, part_number, serial_number, location, resolution_deg, limits_id"
                                    " FROM compass WHERE id = ?");
    statement << id;
    return oneOf<CompassSystem>(statement, m_database, "compass", [](Statement& row) {
        return CompassSystem{row.id<CompassId>(0), row.text(1), row.id<AircraftId>(2), row.text(3), row.as<CompassKind>(4), row.as<Compensator>(5), row.text(6),
            row.text(7), row.text(8), row.text(9), row.real(10), row.id<LimitsProfileId>(11)};
    });
}

Result<std::vector<Event>> FleetRepository::eventsOf(AircraftId id)
{
    Statement statement(m_database, "SELECT id, record, aircraft_id, date, kind, note FROM event WHERE aircraft_id = ? ORDER BY date DESC, id DESC");
    statement << id;
    return rowsOf<Event>(statement, [](Statement& row) {
        return Event{row.id<EventId>(0), row.text(1), row.id<AircraftId>(2), row.text(3), row.text(4), row.text(5)};
    });
}

Result<AircraftId> FleetRepository::aircraftNamed(const std::string& registration)
{
    Statement statement(m_database, "SELECT id FROM aircraft WHERE registration = ?");
    statement << registration;
    if (const auto done = statement.run(); !done)
        return done.error();
    if (!statement.next())
        return Error{ErrorCode::NotFound, "there is no aircraft " + registration + " in the database", m_database.path().toStdString()};
    return statement.id<AircraftId>(0);
}

Result<AircraftTypeId> FleetRepository::save(const AircraftType& type)
{
    if (const auto named = requireName(type.name, "the aircraft type"); !named)
        return named.error();
    return saveRecord(m_database, "aircraft type", type.id, type.record, type.name,
        "INSERT INTO aircraft_type (record, name, maker, note) VALUES (?, ?, ?, ?)",
        "UPDATE aircraft_type SET name = ?, maker = ?, note = ? WHERE id = ?",
        [&](Statement& statement) { statement << type.name << type.maker << type.note; });
}

Result<AircraftId> FleetRepository::save(const Aircraft& aircraft)
{
    if (const auto named = requireName(aircraft.registration, "the registration"); !named)
        return named.error();
    return saveRecord(m_database, "aircraft", aircraft.id, aircraft.record, aircraft.registration,
        "INSERT INTO aircraft (record, type_id, registration, serial_number, operator_name, built_year, note, demonstration) VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
        "UPDATE aircraft SET type_id = ?, registration = ?, serial_number = ?, operator_name = ?, built_year = ?, note = ?, demonstration = ? WHERE id = ?",
        [&](Statement& statement) {
            statement << aircraft.type << aircraft.registration << aircraft.serialNumber << aircraft.operatorName << aircraft.builtYear << aircraft.note
                      << aircraft.demonstration;
        });
}

Result<CompassId> FleetRepository::save(const CompassSystem& compass)
{
    if (const auto named = requireName(compass.name, "the compass"); !named)
        return named.error();
    auto transaction = Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    const auto saved = saveRecord(m_database, "compass", compass.id, compass.record, compass.name,
        "INSERT INTO compass (record, aircraft_id, name, kind, compensator, maker, part_number, serial_number, location, resolution_deg, limits_id)"
        " VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
        "UPDATE compass SET aircraft_id = ?, name = ?, kind = ?, compensator = ?, maker = ?, part_number = ?, serial_number = ?, location = ?,"
        " resolution_deg = ?, limits_id = ? WHERE id = ?",
        [&](Statement& statement) {
            statement << compass.aircraft << compass.name << static_cast<int>(compass.kind) << static_cast<int>(compass.compensator) << compass.maker
                      << compass.partNumber << compass.serialNumber << compass.location << compass.resolution_deg << compass.limits;
        });
    if (!saved)
        return saved.error();
    if (compass.id.valid()) // other limits may now apply to its swings
        if (const auto refreshed = refreshSwingsOf(m_database, compass.id); !refreshed)
            return refreshed.error();
    if (const auto committed = transaction->commit(); !committed)
        return committed.error();
    return *saved;
}

Result<EventId> FleetRepository::save(const Event& event)
{
    return saveRecord(m_database, "event", event.id, event.record, event.date + " " + event.kind,
        "INSERT INTO event (record, aircraft_id, date, kind, note) VALUES (?, ?, ?, ?, ?)",
        "UPDATE event SET aircraft_id = ?, date = ?, kind = ?, note = ? WHERE id = ?",
        [&](Statement& statement) { statement << event.aircraft << event.date << event.kind << event.note; });
}

} // namespace lubberline::db
