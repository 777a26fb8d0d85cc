// The inverse of the deviation curve at the seam of the circle: a root at north, give or take the rounding, is found once.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/deviation/Smith.h"

namespace lubberline {
namespace {

TEST(SmithRoots, northIsFoundOnceByWhateverCurve)
{
    std::mt19937_64 engine(3);
    std::uniform_real_distribution<double> within(-1.0, 1.0);
    for (int curve = 0; curve < 400; ++curve) {
        const ApproximateSmith smith{
            0.05 * within(engine), 0.1 * within(engine), 0.1 * within(engine), 0.03 * within(engine), 0.03 * within(engine)};
        for (const double compass_deg : {0.0, 1e-14, 359.99999999999994, 180.0, 0.5, 359.5}) {
            const auto compass = CompassHeading::fromDegrees(compass_deg);
            const auto magnetic = MagneticHeading::fromDegrees(wrap360(compass_deg + deviationAt(smith, compass).degrees()));
            const auto found = compassHeadingFor(smith, magnetic);
            ASSERT_TRUE(found) << found.error().message.english() << " at " << compass_deg;
            EXPECT_NEAR(wrap180(found->degrees() - compass_deg), 0.0, 1e-9);
            const ExactSmith exact = toExact(smith);
            const auto north = MagneticHeading::fromDegrees(compass_deg);
            const auto steered = toCompass(north, deviationAt(exact, north));
            const auto back = magneticHeadingFor(exact, steered);
            ASSERT_TRUE(back) << back.error().message.english() << " at " << compass_deg;
            EXPECT_NEAR(wrap180(back->degrees() - compass_deg), 0.0, 1e-9);
        }
    }
}

} // namespace
} // namespace lubberline
