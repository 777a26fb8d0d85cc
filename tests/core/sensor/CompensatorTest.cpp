// A compensator is set for a range of attitudes: what magnets and soft iron can take away goes, the heeling magnet is found by pitch and roll,
// reaches are kept, and level adjustment is not the best there.

#include <gtest/gtest.h>

#include <cmath>

#include "core/angle/Angle.h"
#include "core/sensor/Compensator.h"

namespace lubberline {
namespace {

const MeridianField kField{18500, 18500 * std::tan(toRadians(67.0))};

TEST(Compensator, takesAwayWhatItCanMake)
{
    SensorModel model;
    model.hardIron_nT = {1500, -900, 2500};
    model.softIron(0, 0) = 0.03;
    model.softIron(1, 1) = -0.02;
    const auto result = bestCompensator(model, kField, {20, 20}, {});
    EXPECT_GT(result.before.largest_deg, 8);
    EXPECT_LT(result.after.largest_deg, 0.05);
    // What is left of a and e is alike: a common factor turns nothing.
    EXPECT_NEAR(0.03 + result.best.foreAft, -0.02 + result.best.athwart, 1e-3);
    EXPECT_NEAR(result.best.magnets_nT.x(), -1500, 60);
    // Level the vertical magnet is not seen, and stays where it is: the range shows it.
    EXPECT_EQ(result.level.magnets_nT.z(), 0);
    EXPECT_GT(result.afterLevel.largest_deg, 2);
    EXPECT_LE(result.after.largest_deg, 3); // the source's demand at 20° of pitch and roll
    EXPECT_FALSE(result.warnings.size());
}

TEST(Compensator, onlyLevelIsAsBefore)
{
    SensorModel model;
    model.hardIron_nT = {800, 600, 0};
    const auto result = bestCompensator(model, kField, {0, 0}, {});
    EXPECT_LT(result.after.largest_deg, 1e-3);
    EXPECT_NEAR(result.afterLevel.largest_deg, result.after.largest_deg, 1e-3);
    EXPECT_NEAR(residualOver(SensorModel(), kField, {10, 10}).largest_deg, 0, 1e-9);
}

TEST(Compensator, staysWithinItsReachAndSaysSo)
{
    SensorModel model;
    model.hardIron_nT = {3000, 0, 0};
    CompensatorReach reach;
    reach.magnets_nT = {1000, 1000, 0};
    reach.foreAft = reach.athwart = 0;
    const auto result = bestCompensator(model, kField, {10, 10}, reach);
    EXPECT_NEAR(result.best.magnets_nT.x(), -1000, 1);
    EXPECT_EQ(result.best.magnets_nT.z(), 0);
    EXPECT_EQ(result.best.foreAft, 0);
    EXPECT_TRUE(result.atEnd[0]);
    ASSERT_EQ(result.warnings.size(), 1u);
    EXPECT_LT(result.after.largest_deg, result.before.largest_deg);
}

TEST(Compensator, whatItCannotMakeIsSharedOut)
{
    SensorModel model; // b and d alike: a D that no corrector of a and e takes away
    model.softIron(0, 1) = model.softIron(1, 0) = 0.02;
    model.hardIron_nT = {500, 500, 500};
    const auto result = bestCompensator(model, kField, {20, 20}, {});
    EXPECT_GT(result.after.largest_deg, 0.5);
    EXPECT_LE(result.after.largest_deg, result.afterLevel.largest_deg + 1e-9);
    EXPECT_LT(result.after.largest_deg, result.before.largest_deg);
}

} // namespace
} // namespace lubberline
