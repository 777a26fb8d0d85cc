// The iron behind a level deviation: the sensor that has it reads that deviation again, exactly, in any field of the same H.

#include <gtest/gtest.h>

#include <cmath>

#include "core/angle/Angle.h"
#include "core/reference/LevelIron.h"
#include "core/sensor/SensorReading.h"

namespace lubberline {
namespace {

TEST(LevelIron, readsTheDeviationItWasMadeOf)
{
    const ExactSmith smith{0.02, 0.08, -0.05, 0.015, -0.01};
    const SensorModel model = levelIron(smith, 18'000);
    for (const double dip : {-30.0, 0.0, 67.0}) {
        const MeridianField field{18'000, 18'000 * std::tan(toRadians(dip))};
        for (double heading = 0; heading < 360; heading += 7) {
            const auto magnetic = MagneticHeading::fromDegrees(heading);
            EXPECT_NEAR(readSensor(model, field, {magnetic, 0, 0}).deviation->degrees(), deviationAt(smith, magnetic).degrees(), 1e-9)
                << heading;
        }
    }
}

} // namespace
} // namespace lubberline
