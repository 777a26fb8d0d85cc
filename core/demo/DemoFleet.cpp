#include "core/demo/DemoFleet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/base/Contract.h"
#include "core/demo/DemoCompass.h"
#include "core/demo/DemoDeployment.h"
#include "core/demo/DemoPopulation.h"
#include "core/demo/DemoRandom.h"
#include "core/demo/DemoTypes.h"
#include "core/due/DueList.h"
#include "core/record/DerivedId.h"
#include "core/swing/SwingField.h"

namespace lubberline {

namespace {

/// As found beyond this part of the limit, the crew corrects and swings again.
constexpr double kCorrectBeyond = 0.65;
constexpr double kMisread_deg = 10.0;

/// Something that happens to one aircraft in the last year before its last swing, which is then out of limits.
struct Misfortune {
    int type, aircraft;
    std::size_t compass;
    const char* kind;
    const char* note;
    double size_deg;
};
constexpr std::array<Misfortune, 3> kMisfortunes{{
    {0, 1, 0, "lightning strike", "Struck on the nose in flight; exit burn at the fin tip.", 11.0},
    {1, 2, 0, "magnetic cargo", "Steel pipes carried in the cabin for a week; lifted with a magnet crane.", 10.0},
    {3, 0, 1, "wing-tip fairing repaired", "Wing-tip fairing fastened with steel screws.", 2.6},
}};

Date dayOf(int year, int month, int day)
{
    return Date({std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)), std::chrono::day(static_cast<unsigned>(day))});
}

class FleetMaker {
public:
    explicit FleetMaker(const DemoOptions& options) : m_options(options), m_random(options.seed), m_deployed(options.seed + 1'000'003) {}
    Fleet make();

private:
    void addAircraft(int type, int number);
    const CompassSystem& addSystem(const DemoCompassKind& made, const Aircraft& aircraft);
    void addCompass(int type, int number, std::size_t kind, const Aircraft& aircraft);
    void addYear(int type, int number, std::size_t kind, CompassId compass, DemoMagnetism& magnetism, int year);
    void addRadioOff(const DemoCompassKind& kind, DemoMagnetism& magnetism);
    void addSwing(CompassId compass, SwingKind purpose, SwingStage stage, int day, std::vector<Reading> readings);
    void addMisreading(CompassId compass);
    void addDraft(CompassId compass);
    void addDeployments();
    void addMagnetometer(const DemoDeployment& deployment, const Aircraft& aircraft);
    void addDeployedSwing(const SensorModel& hidden, SiteId site, int day);
    void stampSwings();
    void addEvent(AircraftId aircraft, int year, int month, const char* kind, const char* note);
    [[nodiscard]] const Misfortune* misfortuneOf(int type, int number) const;
    [[nodiscard]] const DemoCompassKind& kindOf(CompassId compass) const { return *m_kinds[static_cast<std::size_t>(compass.value) - 1]; }
    void setDatum(Swing& swing, const DemoCompassKind& kind);
    [[nodiscard]] CompassSystem& compassOf(CompassId id) { return m_fleet.compasses[static_cast<std::size_t>(id.value) - 1]; }
    [[nodiscard]] const Aircraft& aircraftOf(const CompassSystem& compass) const
    {
        return m_fleet.aircraft[static_cast<std::size_t>(compass.aircraft.value) - 1];
    }

    DemoOptions m_options;
    DemoRandom m_random;
    Fleet m_fleet;
    DemoRandom m_deployed;                       ///< of its own: the others read the same whether there are deployments or not
    std::vector<const DemoCompassKind*> m_kinds; ///< of each compass of the fleet
    int m_year = 0, m_month = 0;                 ///< of the visit to the compass base that is being made
};

const Misfortune* FleetMaker::misfortuneOf(int type, int number) const
{
    const auto found = std::find_if(kMisfortunes.begin(), kMisfortunes.end(),
        [&](const Misfortune& one) { return one.type == type && std::min(one.aircraft, m_options.aircraftPerType - 1) == number; });
    return found == kMisfortunes.end() ? nullptr : &*found;
}

Fleet FleetMaker::make()
{
    m_fleet.limits = shippedLimitsProfiles();
    for (std::size_t i = 0; i < m_fleet.limits.size(); ++i)
        m_fleet.limits[i].id.value = static_cast<std::int64_t>(i) + 1;
    m_fleet.dueRules = {knownRules().front()};
    m_fleet.dueRules.front().record = recordIdFor("demonstration due rule");
    DatumInstrument sight;
    sight.record = recordIdFor("demonstration sighting compass");
    sight.name = "sighting compass (demonstration)";
    sight.ahead = SightingDirection::Reciprocal;
    m_fleet.instruments = {sight};
    m_fleet.sites = demoSites();
    for (std::size_t i = 0; i < m_fleet.sites.size(); ++i)
        m_fleet.sites[i].id.value = static_cast<std::int64_t>(i) + 1;
    for (int type = 0; type < static_cast<int>(demoTypes().size()); ++type) {
        const DemoType& made = demoTypes()[static_cast<std::size_t>(type)];
        m_fleet.types.push_back({AircraftTypeId{type + 1}, recordIdOfType(made.name), made.name, made.maker, ""});
        for (int number = 0; number < m_options.aircraftPerType; ++number)
            addAircraft(type, number);
    }
    addDeployments();
    addPopulation(m_fleet, DemoRandom(m_options.seed + 2'000'003), m_options.populationAircraft, m_options.lastYear);
    stampSwings();
    return std::move(m_fleet);
}

void FleetMaker::addAircraft(int type, int number)
{
    const DemoType& made = demoTypes()[static_cast<std::size_t>(type)];
    const auto place = static_cast<std::size_t>(number);
    Aircraft aircraft;
    aircraft.id.value = static_cast<std::int64_t>(m_fleet.aircraft.size()) + 1;
    aircraft.type.value = type + 1;
    aircraft.registration = place < made.registrations.size() ? made.registrations[place]
                                                              : std::string(made.registrations[0]) + "-" + std::to_string(number + 1);
    aircraft.record = recordIdOfAircraft("demonstration " + aircraft.registration);
    aircraft.serialNumber = "DEMO-" + std::to_string(100 * (type + 1) + number + 1);
    aircraft.operatorName = "Demonstration operator";
    aircraft.builtYear = made.builtYear + number;
    aircraft.note = "Demonstration data: the aircraft, its swings and the people are invented.";
    aircraft.demonstration = true;
    m_fleet.aircraft.push_back(aircraft);

    if (const auto* misfortune = misfortuneOf(type, number))
        addEvent(aircraft.id, m_options.lastYear, 1, misfortune->kind, misfortune->note);
    if (number == 0)
        addEvent(aircraft.id, m_options.lastYear - 2, 8, "engine change", "Engine exchanged at overhaul.");
    for (std::size_t kind = 0; kind < made.compasses.size(); ++kind)
        addCompass(type, number, kind, aircraft);
}

void FleetMaker::addEvent(AircraftId aircraft, int year, int month, const char* kind, const char* note)
{
    Event event;
    event.id.value = static_cast<std::int64_t>(m_fleet.events.size()) + 1;
    event.aircraft = aircraft;
    event.date = dayOf(year, month, 12 + static_cast<int>(aircraft.value) % 12);
    event.kind = kind;
    event.cause = causeInWords(kind);
    event.note = note;
    event.record = recordIdFor("demonstration event " + std::to_string(aircraft.value) + event.date.text() + event.kind);
    m_fleet.events.push_back(event);
}

const CompassSystem& FleetMaker::addSystem(const DemoCompassKind& made, const Aircraft& aircraft)
{
    CompassSystem compass;
    compass.id.value = static_cast<std::int64_t>(m_fleet.compasses.size()) + 1;
    compass.aircraft = aircraft.id;
    compass.name = made.name;
    compass.record = recordIdOfCompass(aircraft.record, made.name);
    compass.kind = made.kind;
    compass.compensator = made.compensator;
    compass.serialNumber = std::to_string(1000 + compass.id.value * 37);
    compass.location = made.location;
    compass.resolution_deg = made.resolution_deg;
    const auto limits
        = std::find_if(m_fleet.limits.begin(), m_fleet.limits.end(), [&](const LimitsProfile& one) { return one.name == made.limits; });
    LUBBERLINE_EXPECT(limits != m_fleet.limits.end(), "the demonstration uses shipped limits");
    compass.limits = limits->id;
    m_fleet.compasses.push_back(compass);
    m_kinds.push_back(&made);
    return m_fleet.compasses.back();
}

void FleetMaker::addCompass(int type, int number, std::size_t kind, const Aircraft& aircraft)
{
    const DemoCompassKind& made = demoTypes()[static_cast<std::size_t>(type)].compasses[kind];
    const CompassSystem compass = addSystem(made, aircraft);
    DemoMagnetism magnetism(made, m_random);
    for (int year = m_options.lastYear - m_options.swingsPerCompass + 1; year <= m_options.lastYear; ++year)
        addYear(type, number, kind, compass.id, magnetism, year);
    if (type == 3 && number == 1 % m_options.aircraftPerType && kind == 0)
        addMisreading(compass.id);
    if (type == 2 && number == m_options.aircraftPerType - 1 && kind == 1)
        addDraft(compass.id);
}

/// The yearly visit: a check as found; where that is poor, a correction and a check as left.
void FleetMaker::addYear(int type, int number, std::size_t kind, CompassId compass, DemoMagnetism& magnetism, int year)
{
    const DemoCompassKind& made = kindOf(compass);
    const auto* misfortune = misfortuneOf(type, number);
    const bool last = year == m_options.lastYear;
    const bool struck = last && misfortune && misfortune->compass == kind;
    m_year = year;
    m_month = 3 + (number * 2 + type) % 8;
    magnetism.ageOneYear();
    if (number == 0 && year == m_options.lastYear - 1)
        magnetism.strike(made.limit_deg * 0.25); // the engine that was changed the year before
    if (struck)
        magnetism.strike(misfortune->size_deg);

    auto asFound = magnetism.read(made.points, 2.0);
    const bool poor = largestDeviation_deg(asFound) > kCorrectBeyond * made.limit_deg;
    addSwing(compass, SwingKind::Check, SwingStage::AsFound, 10, std::move(asFound));
    if (poor && !struck) {
        addSwing(compass, SwingKind::Correction, SwingStage::AsFound, 11, magnetism.read(4, 1.0));
        magnetism.compensate();
        addSwing(compass, SwingKind::Check, SwingStage::AsLeft, 12, magnetism.read(made.points, 2.0));
    }
    if (last && made.radioPair && !struck)
        addRadioOff(made, magnetism);
}

/// The same swing with the radio off: a card has a column for each.
void FleetMaker::addRadioOff(const DemoCompassKind& kind, DemoMagnetism& magnetism)
{
    m_fleet.swings.back().configuration.radio = RadioState::On;
    magnetism.addSupplyField(-1.2);
    const SwingStage stage = m_fleet.swings.back().stage;
    addSwing(m_fleet.swings.back().compass, SwingKind::Check, stage, 13, magnetism.read(kind.points, 2.0));
    m_fleet.swings.back().configuration.radio = RadioState::Off;
    magnetism.addSupplyField(1.2);
}

void FleetMaker::setDatum(Swing& swing, const DemoCompassKind& kind)
{
    swing.datum.serialNumber = "LC-" + std::to_string(40 + swing.site.value);
    swing.datum.calibrationDue = dayOf(m_year + 1, 1, 31);
    swing.datum.instrument = kind.trueDatum ? "theodolite on surveyed marks (true)" : "landing compass";
    if (!kind.trueDatum)
        return;
    swing.variation_deg = m_fleet.sites[static_cast<std::size_t>(swing.site.value) - 1].variation_deg;
    for (auto& reading : swing.readings)
        reading.trueHeading = toTrue(*reading.magnetic, Variation::fromDegrees(*swing.variation_deg));
}

void FleetMaker::addSwing(CompassId compass, SwingKind purpose, SwingStage stage, int day, std::vector<Reading> readings)
{
    static constexpr std::array<const char*, 4> kTechnicians{"K. Lis", "M. Wrona", "T. B\u00F3br", "A. Sikora"};
    const CompassSystem& system = compassOf(compass);
    const auto index = static_cast<std::size_t>(system.aircraft.value);
    Swing swing;
    swing.id.value = static_cast<std::int64_t>(m_fleet.swings.size()) + 1;
    swing.compass = compass;
    swing.site.value = static_cast<std::int64_t>(index % kDemoHomeSites) + 1;
    swing.date = dayOf(m_year, m_month, day);
    swing.kind = purpose;
    swing.stage = stage;
    swing.state = m_year < m_options.lastYear ? SwingState::Signed : SwingState::Complete;
    swing.configuration.engines = "running, flight idle";
    swing.configuration.electrics = "generators on, pitot heat off";
    swing.configuration.other = "doors closed, flaps up, no stores";
    swing.people.datumReader = kTechnicians[index % kTechnicians.size()];
    swing.people.cockpitReader = kTechnicians[(index + 1) % kTechnicians.size()];
    swing.people.adjuster = purpose == SwingKind::Correction ? "P. Zaj\u0105c" : "";
    swing.people.inspector = "E. Sowa";
    swing.procedure = std::to_string(readings.size()) + "-point ground swing";
    swing.workOrder = "DEMO-" + std::to_string(m_year) + "-" + std::to_string(100 + index);
    swing.reason = "yearly inspection";
    swing.note = "Demonstration data.";
    swing.readings = std::move(readings);
    setDatum(swing, kindOf(compass));
    swing.record = recordIdFor("demonstration swing " + std::to_string(m_options.seed) + system.record + swing.date.text());
    m_fleet.swings.push_back(std::move(swing));
}

/// One figure of last year's check was written down ten degrees off and nobody saw it.
void FleetMaker::addMisreading(CompassId compass)
{
    const int year = m_options.swingsPerCompass > 1 ? m_options.lastYear - 1 : m_options.lastYear;
    const auto swing = std::find_if(m_fleet.swings.rbegin(), m_fleet.swings.rend(), [&](const Swing& one) {
        return one.compass == compass && one.kind == SwingKind::Check && one.date.day().year() == std::chrono::year(year);
    });
    LUBBERLINE_EXPECT(swing != m_fleet.swings.rend(), "every compass is checked every year");
    auto& reading = swing->readings[swing->readings.size() / 3];
    reading.compass = CompassHeading::fromDegrees(reading.compass->degrees() + kMisread_deg);
}

/// A swing that is being entered: laid out on its points, read on the first of them.
void FleetMaker::addDraft(CompassId compass)
{
    const Swing& before = m_fleet.swings.back();
    std::vector<Reading> readings = before.readings;
    m_month = 11;
    addSwing(compass, SwingKind::Check, SwingStage::AsFound, 19, std::move(readings));
    Swing& draft = m_fleet.swings.back();
    draft.state = SwingState::Draft;
    draft.reason = "swing begun, not finished";
    draft.people.inspector.clear();
    for (std::size_t i = draft.readings.size() / 2; i < draft.readings.size(); ++i)
        draft.readings[i].magnetic = {}, draft.readings[i].compass = {};
}

void FleetMaker::addDeployments()
{
    for (const auto& deployment : demoDeployments()) {
        const int place = deployment.type * m_options.aircraftPerType + deployment.aircraft;
        if (deployment.aircraft < m_options.aircraftPerType)
            addMagnetometer(deployment, m_fleet.aircraft[static_cast<std::size_t>(place)]);
    }
}

void FleetMaker::addMagnetometer(const DemoDeployment& deployment, const Aircraft& aircraft)
{
    const CompassSystem& compass = addSystem(demoMagnetometer(), aircraft);
    for (SensorRecord sensor : deployment.sensors) {
        sensor.id.value = static_cast<std::int64_t>(m_fleet.sensors.size()) + 1;
        sensor.compass = compass.id;
        sensor.record = recordIdOfSensor(aircraft.record, compass.name, sensor.name);
        m_fleet.sensors.push_back(std::move(sensor));
    }
    const SiteId home{static_cast<std::int64_t>(static_cast<std::size_t>(aircraft.id.value) % kDemoHomeSites) + 1};
    for (m_year = m_options.lastYear - std::min(m_options.swingsPerCompass, 2) + 1; m_year <= m_options.lastYear; ++m_year) {
        for (const auto& visit : demoVisits()) {
            m_month = visit.month;
            addDeployedSwing(deployment.hidden, SiteId{static_cast<std::int64_t>(visit.site) + 1}, visit.day);
        }
        m_month = 11;
        addDeployedSwing(deployment.hidden, home, 9);
    }
}

/// Without a field (a year that no model has) there is nothing to read.
void FleetMaker::addDeployedSwing(const SensorModel& hidden, SiteId site, int day)
{
    Swing occasion;
    occasion.date = dayOf(m_year, m_month, day);
    const auto stamp = stampFor(occasion, m_fleet.sites[static_cast<std::size_t>(site.value) - 1]);
    if (!stamp)
        return;
    addSwing(
        m_fleet.compasses.back().id, SwingKind::Check, SwingStage::AsFound, day, readDeployed(hidden, stamp->field.meridian(), m_deployed));
    Swing& swing = m_fleet.swings.back();
    swing.site = site;
    swing.datum.serialNumber = "LC-" + std::to_string(40 + site.value);
    swing.reason = static_cast<std::size_t>(site.value) > kDemoHomeSites ? "deployment" : "after deployment";
}

void FleetMaker::stampSwings()
{
    const auto rounded = [](double field_nT) { return std::round(field_nT * 100) / 100; }; // the same figures from every libm
    for (auto& swing : m_fleet.swings) {
        swing.field = stampFor(swing, m_fleet.sites[static_cast<std::size_t>(swing.site.value) - 1]);
        if (swing.field)
            swing.field->field
                = {rounded(swing.field->field.north_nT), rounded(swing.field->field.east_nT), rounded(swing.field->field.down_nT)};
    }
}

} // namespace

Fleet demoFleet(const DemoOptions& options)
{
    LUBBERLINE_EXPECT(
        options.aircraftPerType >= 1 && options.swingsPerCompass >= 1, "at least one aircraft of a type and one swing of a compass");
    return FleetMaker(options).make();
}

} // namespace lubberline
