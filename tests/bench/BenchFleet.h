#pragma once
/// A large fleet for benchmarks: swings of 24 readings with hard and soft iron and reading noise.

#include <cmath>
#include <random>
#include <string>

#include "core/deviation/Smith.h"
#include "db/engine/Transaction.h"
#include "db/stores/FleetStore.h"
#include "db/stores/SwingStore.h"

namespace lubberline::bench {

inline Swing noisySwing(CompassId compass, std::mt19937& random, int points)
{
    std::normal_distribution<double> noise(0.0, 0.3), coefficient(0.0, 0.03);
    const ExactSmith smith{coefficient(random), coefficient(random), coefficient(random), coefficient(random) / 4, coefficient(random) / 4};
    Swing swing;
    swing.compass = compass;
    const auto year = 10 + random() % 16, day = 1 + random() % 9;
    swing.date = *Date::read("20" + std::to_string(year) + "-05-0" + std::to_string(day));
    for (int i = 0; i < points; ++i) {
        Reading reading;
        reading.magnetic = MagneticHeading::fromDegrees(360.0 * i / points);
        const double compass_deg = toCompass(*reading.magnetic, deviationAt(smith, *reading.magnetic)).degrees();
        reading.compass = CompassHeading::fromDegrees(compass_deg + noise(random));
        swing.readings.push_back(reading);
    }
    return swing;
}

/// 20 types of aircraft with two compasses each, ten swings a compass.
inline void fillFleet(db::Database& database, int swings, int points = 24)
{
    auto transaction = db::Transaction::begin(database);
    db::FleetStore fleet(database);
    db::SwingStore repository(database);
    std::mt19937 random(1);
    std::vector<AircraftTypeId> types;
    for (int i = 0; i < 20; ++i)
        types.push_back(*fleet.add(AircraftType{{}, {}, "Type " + std::to_string(i), "", ""}));
    for (int stored = 0, number = 0; stored < swings; ++number) {
        Aircraft aircraft;
        aircraft.type = types[static_cast<std::size_t>(number) % types.size()];
        aircraft.registration = "B-" + std::to_string(number);
        const auto id = *fleet.add(aircraft);
        for (const char* name : {"standby", "remote"}) {
            CompassSystem compass;
            compass.aircraft = id;
            compass.name = name;
            const auto compassId = *fleet.add(compass);
            for (int i = 0; i < 10 && stored < swings; ++i, ++stored)
                if (!repository.add(noisySwing(compassId, random, points)))
                    std::abort();
        }
    }
    if (!transaction->commit())
        std::abort();
}

} // namespace lubberline::bench
