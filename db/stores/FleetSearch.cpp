// FleetStore::search(): aircraft first, then compasses, then swings.

#include <sstream>

#include "db/engine/Statement.h"
#include "db/engine/Transaction.h"
#include "db/stores/FleetStore.h"

namespace lubberline::db {

namespace {

/// The LIKE pattern of one word, with LIKE's own signs escaped.
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

std::vector<std::string> patternsOf(const std::string& words)
{
    std::vector<std::string> patterns;
    std::istringstream stream(words);
    for (std::string word; stream >> word;)
        patterns.push_back(patternOf(word));
    return patterns;
}

const QString kLike = QStringLiteral(" LIKE ? ESCAPE '\\'");
const QString kAircraftLine = QStringLiteral("t.name || ' · ' || a.registration");
const QString kCompassLine = kAircraftLine + " || ' · ' || c.name";
const QString kCompasses
    = QStringLiteral(" FROM compass c JOIN aircraft a ON a.id = c.aircraft_id JOIN aircraft_type t ON t.id = a.type_id ");

/// Where one word may be found on a swing. Each part is a text of its own or a list made once: a line put together of six
/// tables for each of 100,000 swings takes four times as long.
QString swingHasWord()
{
    QString condition = "(s.compass_id IN (SELECT c.id" + kCompasses + "WHERE " + kCompassLine + kLike
        + ") OR s.site_id IN (SELECT id FROM site WHERE name" + kLike + ")";
    for (const char* field : {"date", "note", "datum_reader", "cockpit_reader", "adjuster", "inspector"})
        condition += QStringLiteral(" OR s.") + field + kLike;
    return condition + ")";
}

QString forEachWord(const std::vector<std::string>& patterns, const QString& condition)
{
    return QStringList(static_cast<qsizetype>(patterns.size()), condition).join(" AND ");
}

/// Runs `sql` (line, aircraft, compass, swing; each word `perWord` times, then a limit) and appends what it finds.
Result<void> append(std::vector<SearchHit>& hits, const Database& database, const QString& sql, const std::vector<std::string>& patterns,
    qsizetype perWord, int limit)
{
    const int room = limit - static_cast<int>(hits.size());
    if (room <= 0)
        return {};
    Statement statement(database, sql);
    for (const auto& pattern : patterns)
        for (qsizetype i = 0; i < perWord; ++i)
            statement << pattern;
    statement << room;
    const auto found = rowsOf<SearchHit>(statement, [](Statement& row) {
        return SearchHit{row.anything(0), row.id<AircraftId>(1), row.optionalId<CompassId>(2), row.optionalId<SwingId>(3)};
    });
    if (!found)
        return found.error();
    hits.insert(hits.end(), found->begin(), found->end());
    return {};
}

} // namespace

Result<std::vector<SearchHit>> FleetStore::search(const std::string& words, int limit)
{
    const auto patterns = patternsOf(words);
    std::vector<SearchHit> hits;
    if (patterns.empty())
        return hits;
    const auto snapshot = Transaction::beginReading(m_database);
    if (!snapshot)
        return snapshot.error();
    const QString aircraft = "SELECT " + kAircraftLine
        + " AS line, a.id, NULL, NULL FROM aircraft a JOIN aircraft_type t ON t.id = a.type_id WHERE "
        + forEachWord(patterns, kAircraftLine + kLike) + " ORDER BY line LIMIT ?";
    const QString compasses = "SELECT " + kCompassLine + " AS line, a.id, c.id, NULL" + kCompasses + "WHERE "
        + forEachWord(patterns, kCompassLine + kLike) + " ORDER BY line LIMIT ?";
    const QString condition = swingHasWord();
    const QString swings = "SELECT " + kCompassLine
        + " || CASE WHEN s.date = '' THEN '' ELSE ' · ' || s.date END || CASE WHEN s.revision > 1 THEN ' · rev. ' || s.revision ELSE '' END || CASE WHEN si.name IS NULL THEN '' ELSE ' · ' || si.name END, a.id, c.id, s.id"
          " FROM (SELECT s.id FROM swing s WHERE "
        + forEachWord(patterns, condition)
        + " ORDER BY s.date DESC, s.id DESC LIMIT ?) hit"
          " JOIN swing s ON s.id = hit.id JOIN compass c ON c.id = s.compass_id JOIN aircraft a ON a.id = c.aircraft_id"
          " JOIN aircraft_type t ON t.id = a.type_id LEFT JOIN site si ON si.id = s.site_id ORDER BY s.date DESC, s.id DESC";
    for (const QString& sql : {aircraft, compasses, swings}) {
        const qsizetype perWord = sql == swings ? condition.count('?') : 1;
        if (const auto done = append(hits, m_database, sql, patterns, perWord, limit); !done)
            return done.error();
    }
    return hits;
}

} // namespace lubberline::db
