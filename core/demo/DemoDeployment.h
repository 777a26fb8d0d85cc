#pragma once
/// A magnetometer on some aircraft of the demonstration fleet that is swung at home and far away: one hidden sensor model gives
/// all its readings, so that hard iron and vertical soft iron can be told apart from its swings. Invented.

#include <string>
#include <vector>

#include "core/demo/DemoRandom.h"
#include "core/demo/DemoTypes.h"
#include "core/earth/EarthField.h"
#include "core/record/SensorRecord.h"
#include "core/record/Swing.h"

namespace lubberline {

struct DemoDeployment {
    int type = 0, aircraft = 0;        ///< of demoTypes(), and its number among them
    SensorModel hidden;                ///< with every circuit off
    std::vector<SensorRecord> sensors; ///< kept with the compass; without ids
};
[[nodiscard]] const std::vector<DemoDeployment>& demoDeployments();

/// The magnetometer itself; the limit is that of a shipped profile.
[[nodiscard]] const DemoCompassKind& demoMagnetometer();

/// Where and when in a year it is swung: places of demoSites(), the home base left out.
struct DemoVisit {
    std::size_t site = 0; ///< of demoSites()
    int month = 0, day = 0;
};
[[nodiscard]] const std::vector<DemoVisit>& demoVisits();

/// What it reads on evenly spaced headings, level; where the horizontal field vanishes there is no compass reading.
[[nodiscard]] std::vector<Reading> readDeployed(const SensorModel& hidden, const MeridianField& field, DemoRandom& random);

} // namespace lubberline
