#include "db/stores/DueStore.h"

#include <map>
#include <tuple>

#include "core/record/Completeness.h"
#include "core/record/Ranges.h"
#include "db/saving/Saving.h"
#include "db/stores/SwingMarks.h"
#include "db/stores/Tables.h"

namespace lubberline::db {

namespace {

DueRule ruleFrom(const Statement& row)
{
    return {row.record(1), row.name(2), row.integer(3, kMonthsRange), row.integer(4, kDaysRange), row.integer(5, kDaysRange), row.text(6),
        row.text(7), row.optionalRecord(8)};
}

const QString kSelectWaiver
    = "SELECT w.record, e.record, w.date, w.reason, w.signed_by, e.aircraft_id FROM waiver w JOIN event e ON e.id = w.event_id ";

Waiver waiverFrom(const Statement& row) { return {row.record(0), row.record(1), row.day(2), row.name(3), row.name(4)}; }

template <class Key, class Value, class MakeKey, class MakeValue>
Result<std::map<Key, std::vector<Value>>> groups(Statement& statement, MakeKey key, MakeValue value)
{
    auto rows = rowsOf<std::pair<Key, Value>>(statement, [&](Statement& row) { return std::pair(key(row), value(row)); });
    if (!rows)
        return rows.error();
    std::map<Key, std::vector<Value>> all;
    for (auto& [owner, one] : *rows)
        all[owner].push_back(std::move(one));
    return all;
}

template <class Key, class Value>
std::vector<Value> of(const std::map<Key, std::vector<Value>>& groups, Key key)
{
    const auto found = groups.find(key);
    return found == groups.end() ? std::vector<Value>{} : found->second;
}

/// The day of the newest swing of each compass that counts as signed: hashing takes its time, and the older ones decide nothing. A
/// two-minute check says that the card holds; it is no swing.
Result<std::map<CompassId, std::vector<Date>>> newestSigned(Database& database, StandingSwings& standing)
{
    Statement statement(database,
        "SELECT compass_id, date, id FROM swing WHERE state = 2 AND date <> '' AND procedure_name <> ? ORDER BY date DESC, id DESC");
    statement << std::string(kCheckProcedure);
    const auto days = rowsOf<std::tuple<CompassId, Date, SwingId>>(
        statement, [](Statement& row) { return std::tuple(row.id<CompassId>(0), row.day(1), row.id<SwingId>(2)); });
    if (!days)
        return days.error();
    std::map<CompassId, std::vector<Date>> newest;
    for (const auto& [compass, day, swing] : *days)
        if (!newest.contains(compass) && standing.has(swing))
            newest[compass] = {day};
    return newest;
}

/// Of each compass down to the newest day of a signed one that says something: what is older decides nothing. Of an amended swing only
/// while no revision of it counts as signed.
Result<std::map<CompassId, std::vector<LimitsFinding>>> newestFindings(Database& database, StandingSwings& standing)
{
    struct Found {
        SwingId swing, amendment;
        CompassId compass;
        LimitsFinding finding;
    };
    Statement statement(database,
        "SELECT s.compass_id, s.date, s.stage, s.state, s.status, s.max_abs_deviation_deg, s.id,"
        " (SELECT n.id FROM swing n WHERE n.supersedes = s.record AND n.state = 2) FROM swing s"
        " WHERE s.state >= 1 AND s.date <> '' AND s.max_abs_deviation_deg IS NOT NULL AND s.procedure_name <> ?"
        " ORDER BY s.date DESC, s.id DESC");
    statement << std::string(kCheckProcedure);
    auto rows = rowsOf<Found>(statement, [](Statement& row) {
        return Found{row.id<SwingId>(6), row.optionalId<SwingId>(7), row.id<CompassId>(0),
            {row.day(1), row.as(2, SwingStage::AsLeft), row.as(3, SwingState::Signed) == SwingState::Signed, row.as(4, Status::OutOfLimits),
                row.optionalReal(5, {0, 180})}};
    });
    if (!rows)
        return rows.error();
    std::map<CompassId, Date> decided;
    std::map<CompassId, std::vector<LimitsFinding>> newest;
    for (auto& [swing, amendment, compass, finding] : *rows) {
        const auto decides = decided.find(compass);
        if ((decides != decided.end() && finding.date < decides->second) || (amendment.valid() && standing.has(amendment)))
            continue;
        finding.isSigned = finding.isSigned && standing.has(swing);
        if (finding.isSigned && finding.status != Status::NotKnown)
            decided.try_emplace(compass, finding.date);
        newest[compass].push_back(finding);
    }
    return newest;
}

void bindRule(Statement& statement, const DueRule& rule)
{
    statement << rule.name << rule.months << rule.graceDays << rule.warnDays << rule.document << rule.issue << rule.type;
}

} // namespace

const Table& ruleTable()
{
    static const Table table{MARKED("db", "due rule"), "due_rule",
        {"name", "months", "grace_days", "warn_days", "document", "issue", "type_record"},
        [](const Statement& row) { (void)ruleFrom(row); }};
    return table;
}

const Table& waiverTable()
{
    static const Table table{MARKED("db", "waiver"), "waiver", {"event_id", "date", "reason", "signed_by"}, [](const Statement& row) {
                                 (void)row.record(1);
                                 (void)row.id<EventId>(2);
                                 (void)row.day(3);
                                 (void)row.name(4);
                                 (void)row.name(5);
                             }};
    return table;
}

Result<std::vector<DueRule>> DueStore::rules()
{
    Statement statement(m_database, selectFrom(ruleTable()) + "ORDER BY name");
    return rowsOf<DueRule>(statement, ruleFrom);
}

Result<RecordId> DueStore::add(const DueRule& rule)
{
    if (const auto named = requireName(rule.name, MARKED("db", "the name of the rule")); !named)
        return named.error();
    DueRule whole = rule;
    if (whole.record.empty())
        whole.record = newRecordId();
    const auto store = [&]() -> Result<RecordId> {
        const auto added = addRecord<RowId>(m_database, ruleTable(), whole, bindRule);
        return added ? Result<RecordId>(whole.record) : added.error();
    };
    return noting(m_database, store, [&](const RecordId&) { noteDue(); });
}

Result<void> DueStore::change(const DueRule& known, const DueRule& rule)
{
    if (const auto named = requireName(rule.name, MARKED("db", "the name of the rule")); !named)
        return named.error();
    const auto id = rowWith(m_database, ruleTable(), known.record);
    if (!id)
        return id.error();
    return noting(
        m_database, [&] { return changeRecord(m_database, ruleTable(), *id, known, rule, bindRule); }, [&] { noteDue(); });
}

Result<void> DueStore::removeRule(const RecordId& record)
{
    return noting(
        m_database, [&] { return removeRecord(m_database, ruleTable(), record); }, [&] { noteDue(); });
}

void DueStore::noteDue() { m_database.changes().note(change::Due{}); }

Result<std::vector<Waiver>> DueStore::waiversOf(AircraftId aircraft)
{
    Statement statement(m_database, kSelectWaiver + "WHERE e.aircraft_id = ? ORDER BY w.date DESC, w.id DESC");
    statement << aircraft;
    return rowsOf<Waiver>(statement, waiverFrom);
}

Result<void> DueStore::add(const Waiver& waiver)
{
    if (const auto named = requireName(waiver.by, MARKED("db", "the name of who waives")); !named)
        return named.error();
    if (waiver.reason.find_first_not_of(' ') == std::string::npos)
        return Error{ErrorCode::InvalidInput, MARKED("db", "the reason of the waiver is empty; expected why no swing is needed")};
    const auto known = rowWith(m_database, waiverTable(), waiver.record);
    if (!known)
        return known.error();
    if (known->valid())
        return Error{
            ErrorCode::Conflict, MARKED("db", "the waiver is on record already; a waiver is not changed"), m_database.path().toStdString()};
    Statement event(m_database, "SELECT id FROM event WHERE record = ?");
    event << waiver.event;
    const auto answered = oneOf<EventId>(event, m_database, MARKED("db", "event"), [](Statement& row) { return row.id<EventId>(0); });
    if (!answered)
        return answered.error();
    const auto bind = [&](Statement& statement, const Waiver& one) { statement << *answered << one.date << one.reason << one.by; };
    const auto added = noting(
        m_database, [&] { return addRecord<RowId>(m_database, waiverTable(), waiver, bind); }, [&](RowId) { noteDue(); });
    return added ? Result<void>() : added.error();
}

Result<std::vector<DueCompass>> DueStore::compasses()
{
    Statement events(m_database, "SELECT id, record, aircraft_id, date, kind, cause, note FROM event ORDER BY date DESC, id DESC");
    const auto eventsOf = groups<AircraftId, Event>(
        events, [](Statement& row) { return row.id<AircraftId>(2); },
        [](Statement& row) {
            return Event{row.id<EventId>(0), row.record(1), row.id<AircraftId>(2), row.day(3), row.text(4),
                row.as(5, DueCause::AccuracySuspected), row.text(6)};
        });
    if (!eventsOf)
        return eventsOf.error();
    Statement waivers(m_database, kSelectWaiver + "ORDER BY w.date DESC, w.id DESC");
    const auto waiversOf = groups<AircraftId, Waiver>(
        waivers, [](Statement& row) { return row.id<AircraftId>(5); }, waiverFrom);
    if (!waiversOf)
        return waiversOf.error();
    StandingSwings standing(m_database);
    const auto signedOf = newestSigned(m_database, standing);
    const auto findingsOf = signedOf ? newestFindings(m_database, standing) : signedOf.error();
    if (!findingsOf)
        return findingsOf.error();
    Statement statement(m_database,
        "SELECT t.id, a.id, c.id, t.record, c.record, t.name, a.registration, c.name, c.installed, a.base_id, l.max_deviation_deg,"
        " COALESCE(NULLIF(l.document, ''), l.name, '')"
        " FROM compass c JOIN aircraft a ON a.id = c.aircraft_id JOIN aircraft_type t ON t.id = a.type_id"
        " LEFT JOIN limits_profile l ON l.id = c.limits_id"
        " ORDER BY t.name, a.registration, c.name");
    return rowsOf<DueCompass>(statement, [&](Statement& row) {
        const auto aircraft = row.id<AircraftId>(1);
        const auto compass = row.id<CompassId>(2);
        return DueCompass{row.id<AircraftTypeId>(0), aircraft, compass, row.record(3), row.record(4), row.text(5), row.text(6), row.text(7),
            row.day(8), row.optionalId<SiteId>(9), of(*signedOf, compass), of(*eventsOf, aircraft), of(*waiversOf, aircraft),
            of(*findingsOf, compass), row.optionalReal(10, kPositiveRange), row.optionalText(11)};
    });
}

} // namespace lubberline::db
