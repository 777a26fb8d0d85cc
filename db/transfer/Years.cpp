#include "db/transfer/Years.h"

#include <unordered_map>
#include <unordered_set>

#include "core/record/Completeness.h"
#include "core/record/DerivedId.h"
#include "core/swing/SwingField.h"
#include "core/swing/SwingResult.h"
#include "db/engine/Changes.h"
#include "db/engine/Statement.h"
#include "db/engine/Transaction.h"
#include "db/saving/Saving.h"
#include "db/stores/FleetStore.h"
#include "db/stores/ResultCache.h"
#include "db/stores/SiteStore.h"
#include "db/stores/SwingRows.h"
#include "db/transfer/RowWhere.h"
#include "db/transfer/YearsSigns.h"

namespace lubberline::db {

namespace {

constexpr std::size_t kMostTold = 20;

/// Where a name leads: a row, or none yet in a look that stores nothing.
template <class IdType>
using KnownNames = std::unordered_map<std::string, IdType>;

template <class IdType>
void noteRow(MadeRows& rows, IdType id)
{
    if (rows.first == 0)
        rows.first = id.value;
    rows.last = id.value;
}

QString insertOfSwing()
{
    const QStringList fields = QStringList{"record"} + swingFields()
        + QStringList{"reading_count", "max_abs_deviation_deg", "a_deg", "b_deg", "c_deg", "d_deg", "e_deg", "status"};
    return "INSERT INTO swing (id, " + fields.join(", ") + ") VALUES (" + nextNumber("swing") + ", " + placeholders(fields.size()) + ")";
}

QString insertOfReading()
{
    return "INSERT INTO reading (id, swing_id, position, " + readingFields().join(", ") + ") VALUES (" + nextNumber("reading") + ", "
        + placeholders(readingFields().size() + 2) + ")";
}

/// A registration without what people write now so and now otherwise.
std::string bareName(const std::string& registration)
{
    std::string bare;
    for (const QChar letter : QString::fromStdString(registration))
        if (letter.isLetterOrNumber())
            bare += QString(letter.toUpper()).toStdString();
    return bare;
}

class YearsImporter {
public:
    YearsImporter(Database& database, YearsStep step, Date today)
        : m_database(database)
        , m_store(step == YearsStep::Store)
        , m_today(today)
        , m_findSwing(database, "SELECT 1 FROM swing WHERE record = ?")
        , m_swing(database, insertOfSwing())
        , m_reading(database, insertOfReading())
    {
    }

    Result<YearsOutcome> import(YearsReader& reader)
    {
        m_outcome.made.name = reader.name();
        for (;;) {
            auto swing = reader.next();
            if (!swing)
                return swing.error();
            if (!*swing)
                break;
            if (const auto taken = take(std::move(**swing)); !taken)
                return taken.error();
        }
        auto suspicions = m_signs.suspicions(m_database, m_outcome.made.swings.first);
        if (!suspicions)
            return suspicions.error();
        m_outcome.suspicions = std::move(suspicions.value());
        m_outcome.warnings.insert(m_outcome.warnings.begin(), reader.warnings().begin(), reader.warnings().end());
        if (m_outcome.drafts > 0)
            m_outcome.warnings.push_back(
                {MARKED_N("db", "%n swing(s) in draft, the first in line %1: %2"), m_outcome.drafts, m_firstDraftLine, m_firstDraft});
        return m_store ? finish() : std::move(m_outcome);
    }

private:
    Result<void> take(YearsSwing swing)
    {
        auto& file = swing.file;
        const auto type = typeOf(file.type.empty() ? "type not stated" : file.type);
        const auto aircraft = type ? aircraftOf(swing, *type) : Result<AircraftId>(type.error());
        const auto site = aircraft ? siteOf(file) : Result<SiteId>(aircraft.error());
        if (!site)
            return site.error();
        const auto compass = compassOf(file, *aircraft);
        if (!compass)
            return compass.error();
        m_findSwing << file.swing.record;
        const auto there = exists(m_findSwing);
        if (!there)
            return there.error();
        if (*there || (!m_store && !m_looked.insert(std::hash<std::string>()(file.swing.record)).second)) {
            ++m_outcome.alreadyThere;
            return {};
        }
        m_signs.add(swing);
        ++m_outcome.swings;
        m_outcome.readings += static_cast<std::int64_t>(file.swing.readings.size());
        file.swing.compass = *compass;
        file.swing.site = *site;
        const Message missing = missingIn(file.swing, m_today);
        file.swing.state = missing.empty() ? SwingState::Complete : SwingState::Draft;
        if (!missing.empty() && m_outcome.drafts++ == 0) {
            m_firstDraft = missing;
            m_firstDraftLine = swing.line;
        }
        return m_store ? store(swing) : Result<void>();
    }

    Result<void> store(YearsSwing& swing)
    {
        Swing& one = swing.file.swing;
        stampUnlessSigned(one, m_sites[one.site]);
        const CachedResult result = resultOf(one, m_limits[one.compass]);
        m_swing << one.record;
        bindParticulars(m_swing, one);
        m_swing << result.readings << result.maxAbsDeviation_deg;
        for (const auto& coefficient_deg : result.coefficient_deg)
            m_swing << coefficient_deg;
        m_swing << static_cast<int>(result.status);
        if (const auto done = m_swing.run(); !done)
            return done;
        one.id = SwingId{m_swing.insertedId()};
        noteRow(m_outcome.made.swings, one.id);
        int position = 0;
        for (const auto& reading : one.readings) {
            m_reading << one.id << position++;
            bindReading(m_reading, reading);
            if (const auto done = m_reading.run(); !done)
                return done;
        }
        return audit(m_database, "added swing", one.record,
            m_outcome.made.name + ", line " + std::to_string(swing.line) + ": a record of years on paper");
    }

    /// Finds by name, else makes. A look makes nothing: the id is then not valid.
    template <class IdType, class Find, class Make>
    Result<IdType> known(KnownNames<IdType>& names, const std::string& name, Find find, Make make, int& added, MadeRows& made)
    {
        if (const auto found = names.find(name); found != names.end())
            return found->second;
        Result<IdType> id = find();
        if (!id)
            return id;
        if (!id->valid()) {
            ++added;
            if (m_store) {
                id = make();
                if (!id)
                    return id;
                noteRow(made, *id);
            }
        }
        names.emplace(name, *id);
        return id;
    }

    Result<AircraftTypeId> typeOf(const std::string& name)
    {
        return known(
            m_types, name, [&] { return rowWhere<AircraftTypeId>(m_database, "aircraft_type", "name = ?", name); },
            [&] {
                AircraftType type;
                type.record = recordIdOfType(name);
                type.name = name;
                return FleetStore(m_database).add(type);
            },
            m_outcome.types, m_outcome.made.types);
    }

    void tell(Message message)
    {
        if (m_outcome.warnings.size() < kMostTold)
            m_outcome.warnings.push_back(std::move(message));
    }

    /// One aircraft of two types, or two names that differ by a space, a hyphen or a capital letter: mostly one of them is a slip, which
    /// would tear the history of its compasses apart.
    Result<void> doubtAircraft(const YearsSwing& swing)
    {
        const auto& file = swing.file;
        if (m_bareNames.empty()) {
            Statement statement(m_database, "SELECT registration FROM aircraft");
            const auto names = rowsOf<std::string>(statement, [](Statement& row) { return row.text(0); });
            if (!names)
                return names.error();
            for (const auto& name : *names)
                m_bareNames.emplace(bareName(name), name);
        }
        if (!m_aircraft.contains(file.aircraft)) {
            const auto [near, fresh] = m_bareNames.emplace(bareName(file.aircraft), file.aircraft);
            if (!fresh && near->second != file.aircraft)
                tell({MARKED("db", "line %1: %2 and %3 are perhaps one aircraft, written in two ways; they are taken as two"), swing.line,
                    near->second, file.aircraft});
        }
        if (file.type.empty())
            return {};
        const auto [first, only] = m_typeSaid.emplace(file.aircraft, file.type);
        if (!only && first->second != file.type)
            tell({MARKED("db", "line %1: %2 is a %3 here, and a %4 above; it is taken as the first"), swing.line, file.aircraft, file.type,
                first->second});
        return {};
    }

    Result<AircraftId> aircraftOf(const YearsSwing& swing, AircraftTypeId type)
    {
        const auto& file = swing.file;
        if (const auto doubted = doubtAircraft(swing); !doubted)
            return doubted.error();
        const auto find = [&]() -> Result<AircraftId> {
            const auto id = rowWhere<AircraftId>(m_database, "aircraft", "registration = ?", file.aircraft);
            if (!id || !id->valid() || file.type.empty())
                return id;
            const auto same = rowWhere<AircraftId>(m_database, "aircraft", "id = ? AND type_id = ?", *id, type.value);
            if (!same)
                return same;
            if (!same->valid())
                tell({MARKED("db", "line %1: %2 is no %3 in the database; what is known of it is left as it is"), swing.line, file.aircraft,
                    file.type});
            return id;
        };
        return known(
            m_aircraft, file.aircraft, find,
            [&] {
                Aircraft aircraft;
                aircraft.record = recordIdOfAircraft(file.aircraft);
                aircraft.type = type;
                aircraft.registration = file.aircraft;
                aircraft.operatorName = file.operatorName;
                return FleetStore(m_database).add(aircraft);
            },
            m_outcome.aircraft, m_outcome.made.aircraft);
    }

    Result<SiteId> siteOf(const SwingFile& file)
    {
        if (file.site.empty())
            return SiteId{};
        const auto id = known(
            m_siteNames, file.site, [&] { return rowWhere<SiteId>(m_database, "site", "name = ?", file.site); },
            [&] {
                Site site = *recordOf(file).site;
                site.record = recordIdOfSite(site.name);
                return SiteStore(m_database).add(site);
            },
            m_outcome.sites, m_outcome.made.sites);
        if (id && !m_sites.contains(*id)) {
            auto site = SiteStore(m_database).site(*id);
            if (!site)
                return site.error();
            m_sites.emplace(*id, std::move(site.value()));
        }
        return id;
    }

    Result<CompassId> compassOf(const SwingFile& file, AircraftId aircraft)
    {
        const std::string name = file.compass.empty() ? "compass not stated" : file.compass;
        const auto id = known(
            m_compasses, file.aircraft + '\x1f' + name,
            [&]() -> Result<CompassId> {
                if (!aircraft.valid())
                    return CompassId{};
                return rowWhere<CompassId>(m_database, "compass", "aircraft_id = ? AND name = ?", aircraft, name);
            },
            [&] {
                CompassSystem compass = recordOf(file).compass;
                compass.name = name;
                compass.record = recordIdOfCompass(file.aircraft, name);
                compass.aircraft = aircraft;
                return FleetStore(m_database).add(compass);
            },
            m_outcome.compasses, m_outcome.made.compasses);
        if (id && id->valid() && !m_limits.contains(*id)) {
            auto limits = SiteStore(m_database).limitsOf(*id);
            if (!limits)
                return limits.error();
            m_limits.emplace(*id, std::move(limits.value()));
        }
        return id;
    }

    Result<YearsOutcome> finish()
    {
        for (const auto& [compass, limits] : m_limits)
            if (const auto done = refreshCompass(m_database, compass); !done)
                return done.error();
        Statement last(m_database, "SELECT COALESCE(MAX(id), 0) FROM audit_entry");
        const auto found = firstOf<std::int64_t>(last, [](Statement& row) { return row.integer(0); });
        if (!found)
            return found.error();
        m_outcome.made.lastAudit = found->value_or(0);
        m_database.changes().note(change::Fleet{});
        m_database.changes().note(change::Sites{});
        return std::move(m_outcome);
    }

    Database& m_database;
    bool m_store;
    Date m_today;
    Statement m_findSwing, m_swing, m_reading;
    KnownNames<AircraftTypeId> m_types;
    KnownNames<AircraftId> m_aircraft;
    std::unordered_map<std::string, std::string> m_bareNames; ///< of all aircraft: the name that each first had
    std::unordered_map<std::string, std::string> m_typeSaid;  ///< by the table, of each aircraft
    KnownNames<CompassId> m_compasses;
    KnownNames<SiteId> m_siteNames;
    std::unordered_map<SiteId, std::optional<Site>> m_sites;
    std::unordered_map<CompassId, std::optional<LimitsProfile>> m_limits; ///< of each compass that has got swings
    std::unordered_set<std::size_t> m_looked;                             ///< swings that a look has seen
    YearsSigns m_signs;
    Message m_firstDraft;
    std::int64_t m_firstDraftLine = 0;
    YearsOutcome m_outcome;
};

} // namespace

Result<YearsOutcome> importYears(Database& database, YearsReader& reader, YearsStep step, Date today)
{
    auto transaction = step == YearsStep::Store ? Transaction::begin(database) : Transaction::beginReading(database);
    if (!transaction)
        return transaction.error();
    auto outcome = YearsImporter(database, step, today).import(reader);
    if (!outcome || step == YearsStep::Look)
        return outcome;
    if (const auto committed = transaction->commit(); !committed)
        return committed.error();
    return outcome;
}

Result<std::vector<YearsOutcome>> importYears(Database& database, std::span<const std::unique_ptr<YearsReader>> readers, Date today)
{
    auto transaction = Transaction::begin(database);
    if (!transaction)
        return transaction.error();
    std::vector<YearsOutcome> outcomes;
    for (const auto& reader : readers) {
        auto outcome = importYears(database, *reader, YearsStep::Store, today);
        if (!outcome)
            return outcome.error();
        outcomes.push_back(std::move(outcome.value()));
    }
    if (const auto committed = transaction->commit(); !committed)
        return committed.error();
    return outcomes;
}

} // namespace lubberline::db
