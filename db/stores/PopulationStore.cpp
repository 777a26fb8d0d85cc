#include "db/stores/PopulationStore.h"

#include <algorithm>
#include <map>
#include <unordered_map>

#include "core/base/Date.h"
#include "core/due/DueRules.h"
#include "core/record/Ranges.h"
#include "core/swing/ReadingError.h"
#include "db/engine/Statement.h"
#include "db/engine/Transaction.h"
#include "db/stores/DueStore.h"

namespace lubberline::db {

namespace {

Error cancelledReading() { return {ErrorCode::Cancelled, MARKED("db", "cancelled")}; }

/// A part of the query: its condition, and the text that is bound to it.
struct Conditions {
    QStringList texts;
    std::vector<std::string> bound;
    void add(const char* condition, const std::string& value)
    {
        if (value.empty())
            return;
        texts += QString::fromLatin1(condition);
        bound.push_back(value);
    }
    [[nodiscard]] QString where(const char* always = "1") const { return " WHERE " + (QStringList(always) + texts).join(" AND "); }
};

class ColumnReader {
public:
    ColumnReader(Database& database, const FleetSelection& selection, const Progress& progress, int most)
        : m_database(database)
        , m_selection(selection)
        , m_progress(progress)
        , m_most(most)
    {
    }

    Result<FleetSwings> read()
    {
        for (const auto step : {&ColumnReader::checkNames, &ColumnReader::readCompasses, &ColumnReader::readEvents,
                 &ColumnReader::readSwings, &ColumnReader::readDue, &ColumnReader::readReadings})
            if (const auto done = (this->*step)(); !done)
                return done.error();
        putInOrder(m_fleet);
        return std::move(m_fleet);
    }

private:
    Result<void> mustBeKnown(const std::string& name, const QString& sql, const Message& what)
    {
        if (name.empty())
            return {};
        Statement statement(m_database, sql);
        statement << name;
        return noValue(oneOf<std::int64_t>(statement, m_database, what, [](Statement& row) { return row.integer(0); }));
    }
    Result<void> checkNames()
    {
        const auto named = [](Pattern what, const std::string& name) { return Message{MARKED("db", "%1 '%2'"), what, name}; };
        for (const auto& [name, sql, what] :
            {std::tuple(&m_selection.type, "SELECT id FROM aircraft_type WHERE name = ?", MARKED("db", "aircraft type")),
                std::tuple(&m_selection.aircraft, "SELECT id FROM aircraft WHERE registration = ?", MARKED("db", "aircraft")),
                std::tuple(&m_selection.compass, "SELECT id FROM compass WHERE name = ? LIMIT 1", MARKED("db", "compass")),
                std::tuple(&m_selection.site, "SELECT id FROM site WHERE name = ?", MARKED("db", "site")),
                std::tuple(&m_selection.base, "SELECT id FROM site WHERE name = ?", MARKED("db", "site"))})
            if (const auto known = mustBeKnown(*name, sql, named(what, *name)); !known)
                return known;
        return {};
    }

    [[nodiscard]] Conditions ofCompasses() const
    {
        Conditions conditions;
        conditions.add("t.name = ?", m_selection.type);
        conditions.add("a.registration = ?", m_selection.aircraft);
        conditions.add("c.name = ?", m_selection.compass);
        conditions.add("a.base_id = (SELECT id FROM site WHERE name = ?)", m_selection.base);
        return conditions;
    }

    Result<void> readCompasses()
    {
        const auto conditions = ofCompasses();
        Statement statement(m_database,
            "SELECT c.id, a.id, t.name, a.registration, c.name, c.kind, c.resolution_deg, l.max_deviation_deg, t.record FROM compass c"
            " JOIN aircraft a ON a.id = c.aircraft_id JOIN aircraft_type t ON t.id = a.type_id LEFT JOIN limits_profile l ON l.id = c.limits_id"
                + conditions.where() + " ORDER BY c.id");
        for (const auto& text : conditions.bound)
            statement << text;
        if (const auto done = statement.run(); !done)
            return done;
        while (statement.next()) {
            FleetCompass compass;
            compass.id = statement.id<CompassId>(0);
            compass.type = statement.text(2);
            compass.aircraft = statement.text(3);
            compass.compass = statement.text(4);
            compass.kind = statement.as(5, CompassKind::RemoteStabilised);
            compass.readingError_deg = toDegrees(readingError_rad(statement.real(6, kPositiveRange)));
            compass.limit_deg = statement.optionalReal(7, kPositiveRange);
            m_place.emplace(compass.id.value, static_cast<std::int32_t>(m_fleet.compasses.size()));
            m_aircraft[statement.integer(1)].push_back(m_fleet.compasses.size());
            m_type.push_back(statement.record(8));
            m_fleet.compasses.push_back(std::move(compass));
        }
        return statement.finished();
    }

    Result<void> readEvents()
    {
        Statement statement(m_database, "SELECT aircraft_id, date, kind, id FROM event WHERE date <> '' ORDER BY date, kind");
        if (const auto done = statement.run(); !done)
            return done;
        while (statement.next()) {
            const auto found = m_aircraft.find(statement.integer(0));
            const auto day = dayOfDate(statement.day(1).text());
            if (found == m_aircraft.end() || !day)
                continue;
            for (const auto compass : found->second)
                m_fleet.compasses[compass].events.push_back({*day, statement.text(2)});
        }
        return statement.finished();
    }

    /// Names become numbers once.
    static std::int32_t levelOf(
        const std::string& name, std::vector<std::string>& names, std::unordered_map<std::string, std::int32_t>& known)
    {
        if (name.empty())
            return -1;
        const auto [found, isNew] = known.try_emplace(name, static_cast<std::int32_t>(names.size()));
        if (isNew)
            names.push_back(name);
        return found->second;
    }

    Result<void> readSites(std::unordered_map<std::int64_t, std::int32_t>& sites)
    {
        Statement statement(m_database, "SELECT id, name FROM site ORDER BY id");
        if (const auto done = statement.run(); !done)
            return done;
        while (statement.next()) {
            sites.emplace(statement.integer(0), static_cast<std::int32_t>(m_fleet.sites.size()));
            m_fleet.sites.push_back(statement.text(1));
        }
        return statement.finished();
    }

    [[nodiscard]] Conditions ofSwings() const
    {
        Conditions conditions;
        conditions.add("s.site_id = (SELECT id FROM site WHERE name = ?)", m_selection.site);
        conditions.add("s.date >= ?", m_selection.from);
        conditions.add("s.date <= ?", m_selection.to);
        if (m_selection.radio)
            conditions.texts += "s.radio = " + QString::number(static_cast<int>(*m_selection.radio));
        return conditions;
    }

    struct Names {
        std::unordered_map<std::int64_t, std::int32_t> sites;
        std::unordered_map<std::string, std::int32_t> crews;
        std::map<std::string, std::int64_t> left;
    };

    /// Amended by a revision that counts: while that one is a draft, the one that it amends stands.
    static constexpr const char* kSelectSwing
        = "SELECT s.id, s.compass_id, s.site_id, s.date, s.stage, s.state, s.radio, CASE WHEN s.datum_reader <> '' THEN s.datum_reader ELSE"
          " s.cockpit_reader END, s.record IN (SELECT supersedes FROM swing WHERE supersedes <> '' AND state > 0) FROM swing s";

    Result<void> readSwings()
    {
        Names names;
        if (const auto done = readSites(names.sites); !done)
            return done;
        if (const auto done = m_most > 0 ? readSomeSwings(names) : readAllSwings(names); !done)
            return done;
        for (const auto& [reason, swings] : names.left)
            m_fleet.leftOut.push_back({reason, swings});
        return {};
    }

    Result<void> readAllSwings(Names& names)
    {
        const auto conditions = ofSwings();
        Statement statement(m_database, kSelectSwing + conditions.where() + " ORDER BY s.id");
        for (const auto& text : conditions.bound)
            statement << text;
        if (const auto done = statement.run(); !done)
            return done;
        while (statement.next())
            takeSwing(statement, names);
        return statement.finished();
    }

    /// For a first look: where they are is asked of an index, and only those that are taken are read.
    Result<void> readSomeSwings(Names& names)
    {
        const auto conditions = ofSwings();
        Statement all(m_database, "SELECT s.id, s.compass_id FROM swing s" + conditions.where() + " ORDER BY s.compass_id, s.date, s.id");
        for (const auto& text : conditions.bound)
            all << text;
        if (const auto done = all.run(); !done)
            return done;
        std::vector<SwingId> ids;
        while (all.next())
            if (m_place.contains(all.integer(1)))
                ids.push_back(all.id<SwingId>(0));
        if (const auto whole = all.finished(); !whole)
            return whole;
        Statement one(m_database, kSelectSwing + QStringLiteral(" WHERE s.id = ?"));
        const std::size_t many = ids.size(), most = std::min(many, static_cast<std::size_t>(m_most));
        for (std::size_t i = 0; i < most; ++i) {
            one << ids[i * many / most];
            if (const auto done = one.run(); !done)
                return done;
            if (one.next())
                takeSwing(one, names);
            if (const auto whole = one.finished(); !whole)
                return whole;
        }
        return {};
    }

    void takeSwing(const Statement& row, Names& names)
    {
        const auto compass = m_place.find(row.integer(1));
        if (compass == m_place.end())
            return;
        FleetSwing swing;
        const auto day = dayOfDate(row.day(3).text());
        if (const char* why = whyLeftOut(row, day)) {
            ++names.left[why];
            return;
        }
        swing.id = row.id<SwingId>(0);
        swing.compass = compass->second;
        if (const auto site = names.sites.find(row.optionalId<SiteId>(2).value); site != names.sites.end())
            swing.site = site->second;
        swing.day = *day;
        swing.stage = row.as(4, SwingStage::AsLeft);
        swing.radio = row.as(6, RadioState::Off);
        swing.crew = levelOf(row.text(7), m_fleet.crews, names.crews);
        m_fleet.swings.push_back(swing);
    }

    static const char* whyLeftOut(const Statement& row, const std::optional<int>& day)
    {
        if (row.as(5, SwingState::Signed) == SwingState::Draft)
            return "draft";
        if (row.integer(8) != 0)
            return "superseded";
        return day ? nullptr : "no date";
    }

    /// The next date by the calendar rule of the type, from the last swing.
    Result<void> readDue()
    {
        const auto rules = DueStore(m_database).rules();
        if (!rules)
            return rules.error();
        std::vector<int> last(m_fleet.compasses.size(), 0);
        std::vector<bool> swung(m_fleet.compasses.size(), false);
        for (const auto& swing : m_fleet.swings) {
            const auto c = static_cast<std::size_t>(swing.compass);
            last[c] = swung[c] ? std::max(last[c], swing.day) : swing.day;
            swung[c] = true;
        }
        for (std::size_t c = 0; c < last.size(); ++c)
            if (const auto rule = ruleFor(*rules, m_type[c]); rule && swung[c])
                m_fleet.compasses[c].due_day = dayOfDate(addMonths(*Date::read(dateOfDay(last[c])), rule->months).text());
        return {};
    }

    Result<void> readReadings()
    {
        const auto total = number(m_database, "SELECT COUNT(*) FROM swing");
        if (!total)
            return total.error();
        // Swing by swing through the index where they are few, else the table from end to end.
        return static_cast<std::int64_t>(m_fleet.swings.size()) * 5 < *total ? readBySwing() : readAll();
    }

    static constexpr const char* kWhole
        = "exclusion_reason IS NULL AND magnetic_heading_deg IS NOT NULL AND compass_heading_deg IS NOT NULL";

    Result<void> readBySwing()
    {
        Statement statement(
            m_database, QString("SELECT magnetic_heading_deg, compass_heading_deg, id FROM reading WHERE swing_id = ? AND ") + kWhole);
        for (std::size_t i = 0; i < m_fleet.swings.size(); ++i) {
            if (m_progress && i % 256 == 0 && !m_progress(static_cast<double>(i) / static_cast<double>(m_fleet.swings.size())))
                return cancelledReading();
            FleetSwing& swing = m_fleet.swings[i];
            statement << swing.id;
            if (const auto done = statement.run(); !done)
                return done;
            swing.first = static_cast<std::uint32_t>(m_fleet.magnetic_deg.size());
            while (statement.next())
                take(swing, statement.real(0, kHeadingRange), statement.real(1, kHeadingRange));
            if (const auto whole = statement.finished(); !whole)
                return whole;
        }
        return {};
    }

    void take(FleetSwing& swing, double magnetic_deg, double compass_deg)
    {
        m_fleet.magnetic_deg.push_back(magnetic_deg);
        m_fleet.compass_deg.push_back(compass_deg);
        ++swing.count;
    }

    Result<void> readAll()
    {
        const auto done = readAll("swing_id, magnetic_heading_deg, compass_heading_deg");
        // A column more takes a tenth longer: ids are only read where a row is damaged, which is told by its id.
        if (done || done.error().code == ErrorCode::Cancelled)
            return done;
        return readAll("swing_id, magnetic_heading_deg, compass_heading_deg, id");
    }

    Result<void> readAll(const char* columns)
    {
        for (FleetSwing& swing : m_fleet.swings)
            swing.count = 0;
        m_fleet.magnetic_deg.clear();
        m_fleet.compass_deg.clear();
        std::unordered_map<std::int64_t, std::size_t> row;
        row.reserve(m_fleet.swings.size());
        for (std::size_t i = 0; i < m_fleet.swings.size(); ++i)
            row.emplace(m_fleet.swings[i].id.value, i);
        const auto most = number(m_database, "SELECT MAX(id) FROM reading");
        if (!most)
            return most.error();
        Statement statement(m_database, QString("SELECT %1 FROM reading WHERE %2").arg(columns, kWhole));
        if (const auto done = statement.run(); !done)
            return done;
        std::int64_t last = 0, read = 0;
        FleetSwing* swing = nullptr;
        while (statement.next()) {
            if (m_progress && read++ % 16384 == 0
                && !m_progress(static_cast<double>(read) / static_cast<double>(std::max<std::int64_t>(*most, read))))
                return cancelledReading();
            if (const auto id = statement.integer(0); id != last || !swing) {
                last = id;
                const auto found = row.find(id);
                swing = found == row.end() ? nullptr : &m_fleet.swings[found->second];
                if (swing && swing->count == 0)
                    swing->first = static_cast<std::uint32_t>(m_fleet.magnetic_deg.size());
            }
            if (!swing)
                continue;
            const bool inOnePiece = swing->first + swing->count == m_fleet.magnetic_deg.size();
            if (!inOnePiece)
                moveToEnd(*swing);
            take(*swing, statement.real(1, kHeadingRange), statement.real(2, kHeadingRange));
        }
        return statement.finished();
    }

    /// A row was put in later, behind those of other swings.
    void moveToEnd(FleetSwing& swing)
    {
        const auto first = static_cast<std::uint32_t>(m_fleet.magnetic_deg.size());
        for (std::uint32_t i = 0; i < swing.count; ++i) {
            m_fleet.magnetic_deg.push_back(m_fleet.magnetic_deg[swing.first + i]);
            m_fleet.compass_deg.push_back(m_fleet.compass_deg[swing.first + i]);
        }
        swing.first = first;
    }

    Database& m_database;
    const FleetSelection& m_selection;
    const Progress& m_progress;
    int m_most;
    FleetSwings m_fleet;
    std::unordered_map<std::int64_t, std::int32_t> m_place;                ///< of a compass, by its id
    std::unordered_map<std::int64_t, std::vector<std::size_t>> m_aircraft; ///< its compasses
    std::vector<RecordId> m_type;                                          ///< of each compass
};

} // namespace

Result<FleetSwings> PopulationStore::columns(const FleetSelection& selection, const Progress& progress, int most)
{
    const auto moment = Transaction::beginReading(m_database);
    if (!moment)
        return moment.error();
    return ColumnReader(m_database, selection, progress, most).read();
}

} // namespace lubberline::db
