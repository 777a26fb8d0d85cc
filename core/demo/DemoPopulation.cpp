#include "core/demo/DemoPopulation.h"

#include <chrono>
#include <cmath>

#include "core/base/Date.h"
#include "core/deviation/Smith.h"
#include "core/due/DueList.h"
#include "core/record/DerivedId.h"

namespace lubberline {

namespace {

constexpr std::array<double, 5> kMean_deg{0.0, 0.9, 0.15, -2.2, 0.1}; ///< of the compasses; A is the crews'
constexpr std::array<double, 5> kBetween_deg{0.1, 0.6, 0.7, 0.08, 0.08};
constexpr double kWander_deg = 0.12; ///< of B and C in a year
/// Of A: what each crew reads amiss, and how that scatters from swing to swing.
struct DemoCrew {
    const char* name;
    double mean_deg;
};
constexpr std::array<DemoCrew, 5> kCrews{
    {{"K. Lis", 1.2}, {"M. Wrona", 1.5}, {"T. B\u00F3br", 1.8}, {"A. Sikora", 2.1}, {"J. Szpak", 2.4}}};
constexpr double kCrewScatter_deg = 0.8, kTrained = 0.2;
constexpr double kNoise_deg = 0.25, kLimit_deg = 6.0;
constexpr const char* kLimitName = "Su-22M4 (demonstration, 6\u00B0)";

class PopulationMaker {
public:
    PopulationMaker(Fleet& fleet, DemoRandom random, int lastYear) : m_fleet(fleet), m_random(random), m_lastYear(lastYear) {}

    void addType()
    {
        LimitsProfile limits;
        limits.id.value = static_cast<std::int64_t>(m_fleet.limits.size()) + 1;
        limits.record = recordIdFor("demonstration limits of a population");
        limits.name = kLimitName;
        limits.document = "invented for the demonstration";
        limits.scope = "the demonstration's population alone";
        limits.maxDeviation_deg = kLimit_deg;
        m_fleet.limits.push_back(limits);
        AircraftType type;
        type.id.value = static_cast<std::int64_t>(m_fleet.types.size()) + 1;
        type.record = recordIdOfType(kDemoPopulationType);
        type.name = kDemoPopulationType;
        type.maker = "Sukhoi";
        type.note = "Demonstration: years of swings of one type, invented.";
        m_fleet.types.push_back(type);
    }

    void addAircraft(int number)
    {
        Aircraft aircraft;
        aircraft.id.value = static_cast<std::int64_t>(m_fleet.aircraft.size()) + 1;
        aircraft.type = m_fleet.types.back().id;
        aircraft.registration = std::to_string(3201 + number);
        aircraft.record = recordIdOfAircraft("demonstration " + aircraft.registration);
        aircraft.serialNumber = "DEMO-P" + std::to_string(number + 1);
        aircraft.operatorName = "Demonstration operator";
        aircraft.builtYear = 1984 + number % 5;
        aircraft.note = "Demonstration data: the aircraft, its swings and the people are invented.";
        aircraft.demonstration = true;
        m_fleet.aircraft.push_back(aircraft);
        CompassSystem compass;
        compass.id.value = static_cast<std::int64_t>(m_fleet.compasses.size()) + 1;
        compass.aircraft = aircraft.id;
        compass.name = "remote compass";
        compass.record = recordIdOfCompass(aircraft.record, compass.name);
        compass.kind = CompassKind::RemoteStabilised;
        compass.compensator = Compensator::Screws;
        compass.serialNumber = std::to_string(5000 + number * 41);
        compass.location = "fin";
        compass.resolution_deg = 0.5;
        compass.limits = m_fleet.limits.back().id;
        m_fleet.compasses.push_back(compass);
        addEvents(number, aircraft);
        addYears(number);
    }

private:
    [[nodiscard]] static Date dateOf(int year, int month, int day)
    {
        return Date(
            {std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)), std::chrono::day(static_cast<unsigned>(day))});
    }

    void addEvents(int number, const Aircraft& aircraft)
    {
        for (const auto& jump : demoJumps()) {
            if (jump.aircraft != number || *jump.event == '\0')
                continue;
            Event event;
            event.id.value = static_cast<std::int64_t>(m_fleet.events.size()) + 1;
            event.aircraft = aircraft.id;
            event.date = dateOf(m_lastYear - jump.year, 1, 20);
            event.kind = jump.event;
            event.cause = causeInWords(jump.event);
            event.record = recordIdFor("demonstration event " + aircraft.registration + event.date.text());
            m_fleet.events.push_back(event);
        }
    }

    /// A visit a year; in every second one the compass is corrected, but for the one that drifts, which stays in limits.
    void addYears(int number)
    {
        std::array<double, 5> own{};
        for (std::size_t c = 0; c < 5; ++c)
            own[c] = kMean_deg[c] + m_random.normal(kBetween_deg[c]);
        if (number == kDemoDrifting)
            own[1] = kMean_deg[1];
        for (int ago = kDemoPopulationYears - 1; ago >= 0; --ago) {
            for (const std::size_t c : {1u, 2u})
                if (const double step = m_random.normal(kWander_deg); number != kDemoDrifting)
                    own[c] += step;
            if (number == kDemoDrifting) // evenly: what it is found to drift by is then what was put in
                own[1] += kDemoDrift_deg_year;
            for (const auto& jump : demoJumps())
                if (jump.aircraft == number && jump.year == ago)
                    own[jump.coefficient] += jump.size_deg;
            addSwing(number, ago, SwingStage::AsFound, 10, own);
            if (ago % 2 == 1 || number == kDemoDrifting)
                continue;
            for (const std::size_t c : {1u, 2u})
                own[c] = kMean_deg[c] + (own[c] - kMean_deg[c]) * 0.4; // to the type's own, which the crews were taught to leave
            addSwing(number, ago, SwingStage::AsLeft, 12, own);
        }
    }

    void addSwing(int number, int ago, SwingStage stage, int day, std::array<double, 5> smith_deg)
    {
        // Each crew has its aircraft, and now and then those of its neighbours: crews and aircraft can be told apart.
        const DemoCrew& crew = kCrews[static_cast<std::size_t>(number + (ago % 3 == 0 ? 1 : 0)) % kCrews.size()];
        const bool trained = ago < kDemoTrainedYears;
        smith_deg[0] += (crew.mean_deg + m_random.normal(kCrewScatter_deg)) * (trained ? kTrained : 1.0);
        const int year = m_lastYear - ago, month = 3 + number % 8;
        Swing swing;
        swing.id.value = static_cast<std::int64_t>(m_fleet.swings.size()) + 1;
        swing.compass = m_fleet.compasses.back().id;
        swing.site.value = 1 + (number + ago) % 2;
        swing.date = dateOf(year, month, day);
        swing.kind = SwingKind::Check;
        swing.stage = stage;
        swing.state = ago > 0 ? SwingState::Signed : SwingState::Complete;
        swing.configuration.engines = "running, flight idle";
        swing.datum.instrument = "landing compass";
        swing.people.datumReader = crew.name;
        swing.people.inspector = "E. Sowa";
        swing.procedure = "8-point ground swing";
        swing.workOrder = "DEMO-P-" + std::to_string(year) + "-" + std::to_string(number + 1);
        swing.reason = "yearly inspection";
        swing.note = "Demonstration data.";
        swing.readings = read(smith_deg);
        swing.record = recordIdFor("demonstration swing of a population " + m_fleet.compasses.back().record + swing.date.text());
        m_fleet.swings.push_back(std::move(swing));
    }

    std::vector<Reading> read(const std::array<double, 5>& smith_deg)
    {
        const ExactSmith smith = toExact(ApproximateSmith{
            toRadians(smith_deg[0]), toRadians(smith_deg[1]), toRadians(smith_deg[2]), toRadians(smith_deg[3]), toRadians(smith_deg[4])});
        std::vector<Reading> readings;
        for (int i = 0; i < 8; ++i) {
            Reading reading;
            reading.nominal_deg = 45.0 * i;
            reading.magnetic = MagneticHeading::fromDegrees(45.0 * i);
            const double shown
                = toCompass(*reading.magnetic, deviationAt(smith, *reading.magnetic)).degrees() + m_random.normal(kNoise_deg);
            reading.compass = CompassHeading::fromDegrees(std::round(shown * 2) / 2);
            readings.push_back(reading);
        }
        return readings;
    }

    Fleet& m_fleet;
    DemoRandom m_random;
    int m_lastYear;
};

} // namespace

const std::array<DemoJump, 3>& demoJumps()
{
    static constexpr std::array<DemoJump, 3> jumps{{{3, 5, 1, 2.4, "lightning"}, {8, 3, 2, -2.2, "hard landing"}, {13, 5, 3, 1.2, ""}}};
    return jumps;
}

void addPopulation(Fleet& fleet, DemoRandom random, int aircraft, int lastYear)
{
    if (aircraft == 0)
        return;
    PopulationMaker maker(fleet, random, lastYear);
    maker.addType();
    for (int number = 0; number < aircraft; ++number)
        maker.addAircraft(number);
}

} // namespace lubberline
