#include "db/transfer/ImportParticulars.h"

#include <algorithm>

#include "db/stores/CoilStore.h"
#include "db/stores/DueStore.h"
#include "db/stores/ElectricalStore.h"
#include "db/stores/FleetStore.h"
#include "db/stores/SensorStore.h"
#include "db/stores/SiteStore.h"
#include "db/transfer/RowWhere.h"

namespace lubberline::db {

namespace {

class ParticularsImporter {
public:
    ParticularsImporter(Database& database, const Fleet& fleet) : m_database(database), m_fleet(fleet) {}

    Result<ImportedIds> import()
    {
        using One = ParticularsImporter;
        for (const auto& step : {&One::limits, &One::sites, &One::types, &One::aircraft, &One::compasses, &One::sensors, &One::events,
                 &One::instruments, &One::dueRules, &One::waivers, &One::electrical, &One::coilBenches})
            if (const auto done = (this->*step)(); !done)
                return done.error();
        return std::move(m_known);
    }

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
    Result<void> coilBenches();

    /// The id of the record with this RecordId, else of the one that `where` finds by name; not valid: none.
    template <class IdType, class... Values>
    Result<IdType> find(const QString& table, const RecordId& record, const char* where, const Values&... values)
    {
        const auto byRecord = rowWhere<IdType>(m_database, table, "record = ?", record);
        return !byRecord || byRecord->valid() ? byRecord : rowWhere<IdType>(m_database, table, where, values...);
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
    ImportedIds m_known;
};

Result<void> ParticularsImporter::limits()
{
    return each(
        m_fleet.limits, m_known.limits,
        [this](const LimitsProfile& one) { return find<LimitsProfileId>("limits_profile", one.record, "name = ?", one.name); },
        [this](LimitsProfile one) {
            one.id = {};
            return SiteStore(m_database).add(one);
        });
}

Result<void> ParticularsImporter::sites()
{
    return each(
        m_fleet.sites, m_known.sites, [this](const Site& one) { return find<SiteId>("site", one.record, "name = ?", one.name); },
        [this](Site one) {
            one.id = {};
            return SiteStore(m_database).add(one);
        });
}

Result<void> ParticularsImporter::types()
{
    return each(
        m_fleet.types, m_known.types,
        [this](const AircraftType& one) { return find<AircraftTypeId>("aircraft_type", one.record, "name = ?", one.name); },
        [this](AircraftType one) {
            one.id = {};
            return FleetStore(m_database).add(one);
        });
}

Result<void> ParticularsImporter::aircraft()
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
        &m_known.newAircraft);
}

Result<void> ParticularsImporter::compasses()
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

Result<void> ParticularsImporter::sensors()
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

Result<void> ParticularsImporter::events()
{
    return each(
        m_fleet.events, m_known.events,
        [this](const Event& one) { return rowWhere<EventId>(m_database, "event", "record = ?", one.record); },
        [this](Event one) {
            one.id = {};
            one.aircraft = translated(m_known.aircraft, one.aircraft);
            return FleetStore(m_database).add(one);
        });
}

/// What is not known by its record or its name is added.
Result<void> ParticularsImporter::instruments()
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

Result<void> ParticularsImporter::dueRules()
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

Result<void> ParticularsImporter::waivers()
{
    for (const auto& one : m_fleet.waivers) {
        const auto found = rowWhere<Id<struct WaiverRow>>(m_database, "waiver", "record = ?", one.record);
        if (!found)
            return found.error();
        if (!found->valid())
            if (const auto saved = DueStore(m_database).add(one); !saved)
                return saved.error();
    }
    return {};
}

Result<void> ParticularsImporter::electrical()
{
    for (const auto& one : m_fleet.electrical) {
        const auto found = rowWhere<Id<struct ElectricalRow>>(m_database, "electrical_swing", "record = ?", one.swing.record);
        if (!found)
            return found.error();
        if (!found->valid())
            if (const auto saved = ElectricalStore(m_database).add(translated(m_known.compasses, one.compass), one.swing); !saved)
                return saved.error();
    }
    return {};
}

Result<void> ParticularsImporter::coilBenches()
{
    for (const auto& one : m_fleet.coilBenches) {
        const auto found = rowWhere<Id<struct CoilRow>>(m_database, "coil_bench", "record = ?", one.bench.record);
        if (!found)
            return found.error();
        if (!found->valid())
            if (const auto saved = CoilStore(m_database).add(translated(m_known.compasses, one.compass), one.bench); !saved)
                return saved.error();
    }
    return {};
}

} // namespace

Result<ImportedIds> importParticulars(Database& database, const Fleet& fleet) { return ParticularsImporter(database, fleet).import(); }

} // namespace lubberline::db
