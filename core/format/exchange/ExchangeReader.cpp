#include <map>
#include <set>

#include "core/due/DueRules.h"
#include "core/format/exchange/CoilJson.h"
#include "core/format/exchange/DueRuleJson.h"
#include "core/format/exchange/ElectricalJson.h"
#include "core/format/exchange/Exchange.h"
#include "core/format/exchange/ExchangeParts.h"
#include "core/format/exchange/InstrumentJson.h"
#include "core/format/exchange/JobJson.h"
#include "core/format/exchange/ReadingJson.h"
#include "core/format/exchange/RecordChoice.h"
#include "core/format/exchange/SiteJson.h"
#include "core/format/exchange/SwingJson.h"
#include "core/format/json/JsonDocument.h"
#include "core/record/Ranges.h"

namespace lubberline {

namespace {

using Json = nlohmann::json;

class FleetReader {
public:
    FleetReader(const Json& document, const std::string& name) : m_document(document), m_fault(name) {}

    Result<Fleet> read()
    {
        const JsonPath root;
        JsonObject file(m_document, root, m_fault);
        if (file.requiredText("format") != "lubberline")
            m_fault.report(ErrorCode::Format, JsonPath{&root, "format"},
                MARKED("core", "is not \"lubberline\"; expected an exchange file (.lubberline.json)"));
        checkVersion(file, root);
        if (!m_fault.error())
            readRecords(file);
        if (m_fault.error())
            return *m_fault.error();
        return std::move(m_fleet);
    }

private:
    void checkVersion(JsonObject& file, const JsonPath& root);
    void readRecords(JsonObject& file);
    void readLimits(const Json& value, const JsonPath& path);
    void readSite(const Json& value, const JsonPath& path);
    void readType(const Json& value, const JsonPath& path);
    void readAircraft(const Json& value, const JsonPath& path);
    void readEvent(const Json& value, const JsonPath& path, AircraftId aircraft);
    void readCompass(const Json& value, const JsonPath& path, AircraftId aircraft);
    void readSensor(const Json& value, const JsonPath& path, CompassId compass);
    void readSwing(const Json& value, const JsonPath& path, CompassId compass);
    void readConfiguration(JsonObject& object, Swing& swing);
    void readInstrumentOf(JsonObject& object);
    void readRule(JsonObject& object);
    /// The keys of a swing that came with version 3, and its guided swing.
    void readVersion3(JsonObject& object, Swing& swing);
    void readCause(JsonObject& object, Event& event);

    /// The identity of a new record, which no other of the file may have.
    RecordId identity(JsonObject& object)
    {
        RecordId record = object.recordId("record");
        own(object, record);
        return record;
    }
    void own(JsonObject& object, const RecordId& record)
    {
        if (!m_records.insert(record).second)
            object.fault(
                "record", {MARKED("core", "%1 is the identity of another record, too; expected one of its own"), inQuotes(record)});
    }
    template <class IdType>
    IdType reference(JsonObject& object, std::string_view key, const std::map<RecordId, IdType>& known, Pattern what)
    {
        if (!object.has(key))
            return {};
        const auto found = known.find(object.recordId(key));
        if (found == known.end())
            object.fault(key, {MARKED("core", "refers to a record that is not there; expected %1 of this file"), what});
        return found == known.end() ? IdType{} : found->second;
    }

    const Json& m_document;
    double m_version = kExchangeVersion; ///< of the file: an older one has no keys of a newer
    FirstFault m_fault;
    Fleet m_fleet;
    std::set<RecordId> m_records;
    std::map<RecordId, LimitsProfileId> m_limits;
    std::map<RecordId, SiteId> m_sites;
    std::map<RecordId, AircraftTypeId> m_types;
};

void FleetReader::checkVersion(JsonObject& file, const JsonPath& root)
{
    m_version = file.requiredNumber("version", {1, 1e9});
    if (!m_fault.error() && m_version > kExchangeVersion)
        m_fault.report(ErrorCode::NewerSchema, JsonPath{&root, "version"},
            {MARKED("core",
                 "the file is of exchange version %1, written by a newer Lubberline; expected versions up to %2, which this one reads"),
                static_cast<long long>(m_version), kExchangeVersion});
}

void FleetReader::readRecords(JsonObject& file)
{
    file.array("limits", [this](const Json& value, const JsonPath& path) { readLimits(value, path); });
    file.array("sites", [this](const Json& value, const JsonPath& path) { readSite(value, path); });
    if (m_version >= 3)
        file.objects("instruments", [this](JsonObject& one) { readInstrumentOf(one); });
    file.array("types", [this](const Json& value, const JsonPath& path) { readType(value, path); });
    if (m_version >= 3)
        file.objects("due_rules", [this](JsonObject& one) { readRule(one); });
    file.array("aircraft", [this](const Json& value, const JsonPath& path) { readAircraft(value, path); });
    file.finish();
}

/// A number of this file's own for the next record of a list: 1, 2, 3 …
template <class Record>
auto nextId(const std::vector<Record>& records)
{
    return decltype(Record::id){static_cast<std::int64_t>(records.size()) + 1};
}

void FleetReader::readLimits(const Json& value, const JsonPath& path)
{
    JsonObject object(value, path, m_fault);
    LimitsProfile limits;
    limits.id = nextId(m_fleet.limits);
    limits.record = identity(object);
    limits.name = object.requiredText("name");
    limits.document = object.text("document");
    limits.issue = object.text("issue");
    limits.scope = object.text("scope");
    limits.maxDeviation_deg = object.number("max_deviation_deg", kPositiveRange);
    limits.maxSpread_deg = object.number("max_spread_deg", kPositiveRange);
    object.finish();
    m_limits[limits.record] = limits.id;
    m_fleet.limits.push_back(std::move(limits));
}

void FleetReader::readSite(const Json& value, const JsonPath& path)
{
    JsonObject object(value, path, m_fault);
    Site site;
    site.id = nextId(m_fleet.sites);
    site.record = identity(object);
    site.name = object.requiredText("name");
    site.latitude_deg = object.number("latitude_deg", kLatitudeRange);
    site.longitude_deg = object.number("longitude_deg", kSignedAngleRange);
    site.elevation_m = object.number("elevation_m", kElevationRange);
    site.variation_deg = object.number("variation_deg", kSignedAngleRange);
    site.variationSource = object.text("variation_source");
    site.note = object.text("note");
    if (m_version >= 3)
        readBase(object, site);
    object.finish();
    m_sites[site.record] = site.id;
    m_fleet.sites.push_back(std::move(site));
}

void FleetReader::readType(const Json& value, const JsonPath& path)
{
    JsonObject object(value, path, m_fault);
    AircraftType type;
    type.id = nextId(m_fleet.types);
    type.record = identity(object);
    type.name = object.requiredText("name");
    type.maker = object.text("maker");
    type.note = object.text("note");
    object.finish();
    m_types[type.record] = type.id;
    m_fleet.types.push_back(std::move(type));
}

void FleetReader::readAircraft(const Json& value, const JsonPath& path)
{
    JsonObject object(value, path, m_fault);
    Aircraft aircraft;
    aircraft.id = nextId(m_fleet.aircraft);
    aircraft.record = identity(object);
    if (!object.has("type"))
        object.missing("type", MARKED("core", "the record id of a type of this file"));
    aircraft.type = reference(object, "type", m_types, MARKED("core", "a type"));
    aircraft.registration = object.requiredText("registration");
    aircraft.serialNumber = object.text("serial_number");
    aircraft.operatorName = object.text("operator");
    aircraft.builtYear = object.integer("built_year", kYearRange);
    aircraft.note = object.text("note");
    aircraft.demonstration = object.boolean("demonstration");
    if (m_version >= 3)
        aircraft.base = reference(object, "base", m_sites, MARKED("core", "a site"));
    const AircraftId id = aircraft.id;
    m_fleet.aircraft.push_back(std::move(aircraft));
    object.array("compasses", [&](const Json& one, const JsonPath& place) { readCompass(one, place, id); });
    object.array("events", [&](const Json& one, const JsonPath& place) { readEvent(one, place, id); });
    object.finish();
}

void FleetReader::readEvent(const Json& value, const JsonPath& path, AircraftId aircraft)
{
    JsonObject object(value, path, m_fault);
    Event event;
    event.id = nextId(m_fleet.events);
    event.record = identity(object);
    event.aircraft = aircraft;
    event.date = object.date("date");
    event.kind = object.text("kind");
    event.note = object.text("note");
    if (m_version >= 3)
        readCause(object, event);
    object.finish();
    m_fleet.events.push_back(std::move(event));
}

void FleetReader::readCompass(const Json& value, const JsonPath& path, AircraftId aircraft)
{
    JsonObject object(value, path, m_fault);
    CompassSystem compass;
    compass.id = nextId(m_fleet.compasses);
    compass.record = identity(object);
    compass.aircraft = aircraft;
    compass.name = object.requiredText("name");
    compass.kind = choice<CompassKind>(object, "kind");
    compass.compensator = choice<Compensator>(object, "compensator");
    compass.maker = object.text("maker");
    compass.partNumber = object.text("part_number");
    compass.serialNumber = object.text("serial_number");
    compass.location = object.text("location");
    compass.resolution_deg = object.requiredNumber("resolution_deg", kPositiveRange);
    compass.resolutionStated = !object.boolean("resolution_not_stated");
    compass.limits = reference(object, "limits", m_limits, MARKED("core", "a limits profile"));
    if (m_version >= 3)
        compass.installed = object.date("installed");
    const CompassId id = compass.id;
    m_fleet.compasses.push_back(std::move(compass));
    if (m_version >= 2)
        object.array("sensors", [&](const Json& one, const JsonPath& place) { readSensor(one, place, id); });
    object.array("swings", [&](const Json& one, const JsonPath& place) { readSwing(one, place, id); });
    if (m_version >= 3)
        object.objects("electrical_swings", [&](JsonObject& one) {
            ElectricalSwing swing = readElectrical(one);
            if (swing.record.empty())
                one.missing("record", MARKED("core", "a record id"));
            own(one, swing.record);
            m_fleet.electrical.push_back({id, std::move(swing)});
        });
    if (m_version >= 8)
        object.objects("coil_benches", [&](JsonObject& one) {
            CoilBench bench = readCoilBench(one);
            if (bench.record.empty())
                one.missing("record", MARKED("core", "a record id"));
            own(one, bench.record);
            m_fleet.coilBenches.push_back({id, std::move(bench)});
        });
    object.finish();
}

void FleetReader::readSensor(const Json& value, const JsonPath& path, CompassId compass)
{
    JsonObject object(value, path, m_fault);
    SensorRecord sensor;
    sensor.id = nextId(m_fleet.sensors);
    sensor.record = identity(object);
    sensor.compass = compass;
    sensor.name = object.requiredText("name");
    for (const auto& other : m_fleet.sensors)
        if (other.compass == compass && other.name == sensor.name)
            object.fault("name",
                {MARKED("core", "%1 is the name of another sensor model of this compass; expected one of its own"), inQuotes(sensor.name)});
    sensor.origin = choice<ModelOrigin>(object, "origin");
    sensor.note = object.text("note");
    exchange::readSensorParts(object, sensor, m_fault);
    object.finish();
    m_fleet.sensors.push_back(std::move(sensor));
}

void FleetReader::readSwing(const Json& value, const JsonPath& path, CompassId compass)
{
    JsonObject object(value, path, m_fault);
    Swing swing;
    swing.id = nextId(m_fleet.swings);
    swing.record = identity(object);
    swing.compass = compass;
    swing.site = reference(object, "site", m_sites, MARKED("core", "a site"));
    swing.date = object.date("date");
    swing.kind = choice<SwingKind>(object, "kind");
    swing.stage = choice<SwingStage>(object, "stage");
    swing.state = choice<SwingState>(object, "state");
    readConfiguration(object, swing);
    swing.variation_deg = object.number("variation_deg", kSignedAngleRange);
    if (m_version >= 2) {
        swing.indexRemoved_deg = object.number("index_removed_deg", kSignedAngleRange);
        object.object("field", [&](JsonObject& field) { swing.field = exchange::readStamp(field); });
    }
    if (m_version >= 6)
        object.numbers("shared_error_deg", swing.sharedErrors.of_deg, kSharedErrorRange);
    swing.procedure = object.text("procedure");
    swing.workOrder = object.text("work_order");
    swing.reason = object.text("reason");
    swing.note = object.text("note");
    if (m_version >= 3)
        readVersion3(object, swing);
    object.objects("readings", [&](JsonObject& one) { swing.readings.push_back(readReading(one, m_version >= 3)); });
    if (swing.readings.size() > kMaxReadings)
        object.fault("readings", {MARKED("core", "are more than %1; expected a compass swing"), kMaxReadings});
    object.finish();
    m_fleet.swings.push_back(std::move(swing));
}

void FleetReader::readConfiguration(JsonObject& object, Swing& swing)
{
    swing.configuration.radio = choice<RadioState>(object, "radio");
    swing.configuration.engines = object.text("engines");
    swing.configuration.electrics = object.text("electrics");
    swing.configuration.other = object.text("configuration");
    swing.datum.instrument = object.text("datum");
    swing.datum.serialNumber = object.text("datum_serial_number");
    swing.datum.calibrationDue = object.date("datum_calibration_due");
    swing.people.datumReader = object.text("datum_reader");
    swing.people.cockpitReader = object.text("cockpit_reader");
    swing.people.adjuster = object.text("adjuster");
    swing.people.inspector = object.text("inspector");
}

void FleetReader::readInstrumentOf(JsonObject& object)
{
    DatumInstrument instrument = readInstrument(object);
    if (instrument.record.empty())
        object.missing("record", MARKED("core", "a record id"));
    if (instrument.name.empty())
        object.missing("name", MARKED("core", "the instrument's name"));
    own(object, instrument.record);
    m_fleet.instruments.push_back(std::move(instrument));
}

void FleetReader::readRule(JsonObject& object)
{
    DueRule rule = readDueRule(object);
    own(object, rule.record);
    if (!rule.type.empty() && !m_types.contains(rule.type))
        object.fault("type", MARKED("core", "refers to a record that is not there; expected a type of this file"));
    m_fleet.dueRules.push_back(std::move(rule));
}

void FleetReader::readCause(JsonObject& object, Event& event)
{
    if (const std::string word = object.text("cause"); !word.empty()) {
        const auto cause = choiceOf<DueCause>(word);
        if (!cause)
            object.fault("cause",
                {MARKED("core", "%1 is not known; expected a cause such as lightning, engine_change or parts_replaced"), inQuotes(word)});
        event.cause = cause.value_or(DueCause::Other);
    }
    object.objects("waivers", [&](JsonObject& one) {
        Waiver waiver = readWaiver(one, event.record);
        own(one, waiver.record);
        m_fleet.waivers.push_back(std::move(waiver));
    });
}

void FleetReader::readVersion3(JsonObject& object, Swing& swing)
{
    readSwingRecord(object, swing);
    object.object("job", [&](JsonObject& one) {
        SwingJob job = readJob(one);
        own(one, job.record);
        m_fleet.jobs.push_back({swing.id, std::move(job)});
    });
}

} // namespace

Result<Fleet> readExchange(std::string_view text, const std::string& name)
{
    const auto document = parseJson(text, name, MARKED("core", "an exchange file (.lubberline.json)"));
    if (!document)
        return document.error();
    return FleetReader(*document, name).read();
}

} // namespace lubberline
