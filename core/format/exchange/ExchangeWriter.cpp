#include <algorithm>
#include <map>

#include "core/base/Contract.h"
#include "core/due/DueRules.h"
#include "core/format/exchange/CoilJson.h"
#include "core/format/exchange/DueRuleJson.h"
#include "core/format/exchange/ElectricalJson.h"
#include "core/format/exchange/Exchange.h"
#include "core/format/exchange/ExchangeParts.h"
#include "core/format/exchange/InstrumentJson.h"
#include "core/format/exchange/JobJson.h"
#include "core/format/exchange/OptionalKeys.h"
#include "core/format/exchange/ReadingJson.h"
#include "core/format/exchange/SiteJson.h"
#include "core/format/exchange/SwingJson.h"
#include "core/format/json/JsonWriter.h"
#include "core/record/RecordWords.h"

namespace lubberline {

namespace {

void record(JsonWriter& json, const RecordId& id)
{
    LUBBERLINE_EXPECT(isRecordId(id), "a record that is written has an identity");
    json.text("record", id);
}

/// The records by RecordId, so that the order in memory leaves no trace.
template <class Record, class Belongs>
std::vector<const Record*> sorted(const std::vector<Record>& records, Belongs belongs)
{
    std::vector<const Record*> chosen;
    for (const auto& one : records)
        if (belongs(one))
            chosen.push_back(&one);
    std::sort(chosen.begin(), chosen.end(), [](const Record* a, const Record* b) { return a->record < b->record; });
    return chosen;
}

/// Children grouped under their parent's id once, instead of a search for each parent.
template <class Record, class ParentId>
std::map<ParentId, std::vector<const Record*>> grouped(const std::vector<Record>& records, ParentId Record::*parent)
{
    std::map<ParentId, std::vector<const Record*>> groups;
    for (const Record* one : sorted(records, [](const Record&) { return true; }))
        groups[one->*parent].push_back(one);
    return groups;
}

class FleetWriter {
public:
    explicit FleetWriter(const Fleet& fleet)
        : m_fleet(fleet)
        , m_compasses(grouped(fleet.compasses, &CompassSystem::aircraft))
        , m_events(grouped(fleet.events, &Event::aircraft))
        , m_sensors(grouped(fleet.sensors, &SensorRecord::compass))
        , m_swings(grouped(fleet.swings, &Swing::compass))
    {
    }

    std::string write()
    {
        m_json.beginObject();
        m_json.text("format", "lubberline");
        m_json.integer("version", exchangeVersionOf(m_fleet));
        all("limits", m_fleet.limits);
        all("sites", m_fleet.sites);
        if (!m_fleet.instruments.empty())
            all("instruments", m_fleet.instruments);
        all("types", m_fleet.types);
        if (!m_fleet.dueRules.empty())
            all("due_rules", m_fleet.dueRules);
        all("aircraft", m_fleet.aircraft);
        m_json.end();
        return m_json.take();
    }

private:
    template <class Record>
    void all(std::string_view key, const std::vector<Record>& records)
    {
        each(key, sorted(records, [](const Record&) { return true; }));
    }
    template <class Record>
    void each(std::string_view key, const std::vector<const Record*>& records)
    {
        m_json.beginArray(key);
        for (const Record* one : records) {
            m_json.beginObject();
            write(*one);
            m_json.end();
        }
        m_json.end();
    }
    template <class Record, class ParentId>
    void children(std::string_view key, const std::map<ParentId, std::vector<const Record*>>& groups, ParentId parent)
    {
        const auto found = groups.find(parent);
        each(key, found == groups.end() ? std::vector<const Record*>{} : found->second);
    }
    /// The RecordId of a record of this fleet that another one refers to; nothing when the reference is not set.
    template <class Record, class IdType>
    void reference(std::string_view key, const std::vector<Record>& records, IdType id)
    {
        if (!id.valid())
            return;
        const auto found = std::find_if(records.begin(), records.end(), [&](const Record& one) { return one.id == id; });
        LUBBERLINE_EXPECT(found != records.end(), "a fleet holds what its records refer to");
        m_json.text(key, found->record);
    }

    void write(const DatumInstrument& instrument) { writeInstrument(m_json, instrument); }
    void write(const DueRule& rule) { writeDueRule(m_json, rule); }
    void write(const Waiver& waiver) { writeWaiver(m_json, waiver); }
    void write(const ElectricalSwing& swing) { writeElectrical(m_json, swing); }
    void write(const CoilBench& bench) { writeCoilBench(m_json, bench); }
    void write(const LimitsProfile& limits);
    void write(const Site& site);
    void write(const AircraftType& type);
    void write(const Aircraft& aircraft);
    void write(const Event& event);
    void write(const CompassSystem& compass);
    void write(const SensorRecord& sensor);
    void write(const Swing& swing);

    const Fleet& m_fleet;
    std::map<AircraftId, std::vector<const CompassSystem*>> m_compasses;
    std::map<AircraftId, std::vector<const Event*>> m_events;
    std::map<CompassId, std::vector<const SensorRecord*>> m_sensors;
    std::map<CompassId, std::vector<const Swing*>> m_swings;
    JsonWriter m_json;
};

void FleetWriter::write(const LimitsProfile& limits)
{
    record(m_json, limits.record);
    m_json.text("name", limits.name);
    textIfAny(m_json, "document", limits.document);
    textIfAny(m_json, "issue", limits.issue);
    textIfAny(m_json, "scope", limits.scope);
    numberIfAny(m_json, "max_deviation_deg", limits.maxDeviation_deg);
    numberIfAny(m_json, "max_spread_deg", limits.maxSpread_deg);
}

void FleetWriter::write(const Site& site)
{
    record(m_json, site.record);
    m_json.text("name", site.name);
    numberIfAny(m_json, "latitude_deg", site.latitude_deg);
    numberIfAny(m_json, "longitude_deg", site.longitude_deg);
    numberIfAny(m_json, "elevation_m", site.elevation_m);
    numberIfAny(m_json, "variation_deg", site.variation_deg);
    textIfAny(m_json, "variation_source", site.variationSource);
    textIfAny(m_json, "note", site.note);
    writeBase(m_json, site);
}

void FleetWriter::write(const AircraftType& type)
{
    record(m_json, type.record);
    m_json.text("name", type.name);
    textIfAny(m_json, "maker", type.maker);
    textIfAny(m_json, "note", type.note);
}

void FleetWriter::write(const Aircraft& aircraft)
{
    record(m_json, aircraft.record);
    LUBBERLINE_EXPECT(aircraft.type.valid(), "an aircraft has a type");
    reference("type", m_fleet.types, aircraft.type);
    m_json.text("registration", aircraft.registration);
    textIfAny(m_json, "serial_number", aircraft.serialNumber);
    textIfAny(m_json, "operator", aircraft.operatorName);
    if (aircraft.builtYear)
        m_json.integer("built_year", *aircraft.builtYear);
    textIfAny(m_json, "note", aircraft.note);
    reference("base", m_fleet.sites, aircraft.base);
    m_json.boolean("demonstration", aircraft.demonstration);
    children("compasses", m_compasses, aircraft.id);
    children("events", m_events, aircraft.id);
}

void FleetWriter::write(const Event& event)
{
    record(m_json, event.record);
    textIfAny(m_json, "date", event.date);
    textIfAny(m_json, "kind", event.kind);
    textIfAny(m_json, "note", event.note);
    if (event.cause != DueCause::Other)
        m_json.text("cause", fileWord(event.cause));
    const auto waivers = sorted(m_fleet.waivers, [&](const Waiver& one) { return one.event == event.record; });
    if (!waivers.empty())
        each("waivers", waivers);
}

void FleetWriter::write(const CompassSystem& compass)
{
    record(m_json, compass.record);
    m_json.text("name", compass.name);
    m_json.text("kind", fileWord(compass.kind));
    m_json.text("compensator", fileWord(compass.compensator));
    textIfAny(m_json, "maker", compass.maker);
    textIfAny(m_json, "part_number", compass.partNumber);
    textIfAny(m_json, "serial_number", compass.serialNumber);
    textIfAny(m_json, "location", compass.location);
    m_json.number("resolution_deg", compass.resolution_deg);
    if (!compass.resolutionStated)
        m_json.boolean("resolution_not_stated", true);
    reference("limits", m_fleet.limits, compass.limits);
    textIfAny(m_json, "installed", compass.installed);
    if (m_sensors.contains(compass.id))
        children("sensors", m_sensors, compass.id);
    children("swings", m_swings, compass.id);
    std::vector<const ElectricalSwing*> electrical;
    for (const auto& one : m_fleet.electrical)
        if (one.compass == compass.id)
            electrical.push_back(&one.swing);
    std::sort(electrical.begin(), electrical.end(), [](const auto* a, const auto* b) { return a->record < b->record; });
    if (!electrical.empty())
        each("electrical_swings", electrical);
    std::vector<const CoilBench*> benches;
    for (const auto& one : m_fleet.coilBenches)
        if (one.compass == compass.id)
            benches.push_back(&one.bench);
    std::sort(benches.begin(), benches.end(), [](const auto* a, const auto* b) { return a->record < b->record; });
    if (!benches.empty())
        each("coil_benches", benches);
}

void FleetWriter::write(const SensorRecord& sensor)
{
    record(m_json, sensor.record);
    m_json.text("name", sensor.name);
    m_json.text("origin", fileWord(sensor.origin));
    textIfAny(m_json, "note", sensor.note);
    exchange::writeSensorParts(m_json, sensor);
}

void FleetWriter::write(const Swing& swing)
{
    record(m_json, swing.record);
    reference("site", m_fleet.sites, swing.site);
    textIfAny(m_json, "date", swing.date);
    m_json.text("kind", fileWord(swing.kind));
    m_json.text("stage", fileWord(swing.stage));
    m_json.text("state", fileWord(swing.state));
    m_json.text("radio", fileWord(swing.configuration.radio));
    textIfAny(m_json, "engines", swing.configuration.engines);
    textIfAny(m_json, "electrics", swing.configuration.electrics);
    textIfAny(m_json, "configuration", swing.configuration.other);
    textIfAny(m_json, "datum", swing.datum.instrument);
    textIfAny(m_json, "datum_serial_number", swing.datum.serialNumber);
    textIfAny(m_json, "datum_calibration_due", swing.datum.calibrationDue);
    textIfAny(m_json, "datum_reader", swing.people.datumReader);
    textIfAny(m_json, "cockpit_reader", swing.people.cockpitReader);
    textIfAny(m_json, "adjuster", swing.people.adjuster);
    textIfAny(m_json, "inspector", swing.people.inspector);
    numberIfAny(m_json, "variation_deg", swing.variation_deg);
    numberIfAny(m_json, "index_removed_deg", swing.indexRemoved_deg);
    if (swing.sharedErrors.any())
        m_json.numbers("shared_error_deg", swing.sharedErrors.of_deg); // A … E
    if (swing.field)
        exchange::writeStamp(m_json, "field", *swing.field);
    textIfAny(m_json, "procedure", swing.procedure);
    textIfAny(m_json, "work_order", swing.workOrder);
    textIfAny(m_json, "reason", swing.reason);
    textIfAny(m_json, "note", swing.note);
    writeSwingRecord(m_json, swing);
    const auto job = std::find_if(m_fleet.jobs.begin(), m_fleet.jobs.end(), [&](const JobRecord& one) { return one.swing == swing.id; });
    if (job != m_fleet.jobs.end()) {
        m_json.beginObject("job");
        writeJob(m_json, job->job);
        m_json.end();
    }
    m_json.beginArray("readings");
    for (const auto& reading : swing.readings) {
        m_json.beginObject({}, true);
        writeReadingKeys(m_json, reading);
        m_json.end();
    }
    m_json.end();
}

} // namespace

int exchangeVersionOf(const Fleet& fleet)
{
    const auto any = [](const auto& records, auto holds) { return std::any_of(records.begin(), records.end(), holds); };
    const bool third = !fleet.jobs.empty() || !fleet.electrical.empty() || !fleet.waivers.empty() || !fleet.instruments.empty()
        || !fleet.dueRules.empty() || any(fleet.sites, hasBase) || any(fleet.aircraft, [](const Aircraft& one) { return one.base.valid(); })
        || any(fleet.compasses, [](const CompassSystem& one) { return !one.installed.empty(); })
        || any(fleet.events, [](const Event& one) { return one.cause != DueCause::Other; }) || any(fleet.swings, [&](const Swing& swing) {
               return hasSwingRecord(swing)
                   || any(swing.readings, [](const Reading& one) { return !one.raw.empty() || !one.timeUtc.empty(); });
           });
    const bool second
        = !fleet.sensors.empty() || any(fleet.swings, [](const Swing& swing) { return swing.field || swing.indexRemoved_deg; });
    const auto signedBy = [&](int contents) {
        return any(fleet.swings,
            [&](const Swing& swing) { return any(swing.signatures, [&](const Signature& one) { return one.contents >= contents; }); });
    };
    const bool sixth = any(fleet.swings, [](const Swing& swing) { return swing.sharedErrors.any(); });
    const bool seventh = any(fleet.sensors, [](const SensorRecord& one) { return one.uncertainty.has_value(); });
    return !fleet.coilBenches.empty() ? 8 : seventh ? 7 : sixth ? 6 : signedBy(3) ? 5 : signedBy(2) ? 4 : third ? 3 : second ? 2 : 1;
}

std::string writeExchange(const Fleet& fleet) { return FleetWriter(fleet).write(); }

} // namespace lubberline
