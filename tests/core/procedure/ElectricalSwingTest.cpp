// TM 11-4920-292-15, pp. 157 and 190.

#include <gtest/gtest.h>

#include "core/procedure/ElectricalChecks.h"

namespace lubberline {
namespace {

TEST(ElectricalSwing, theManualsExampleOfHalves)
{
    // p. 190: 180 selected reads 180.6; half is removed (180.3); 270 reads 269.3; half is removed (269.65).
    const auto errors = errorsOf({{0.3, 90.0, 180.3, 269.65}});
    ASSERT_TRUE(errors);
    EXPECT_NEAR(errors->northSouth_deg, 0.0, 1e-9);
    EXPECT_NEAR(errors->eastWest_deg, 0.175, 1e-9);
    EXPECT_NEAR(errors->pair90_270_deg, 0.35, 1e-9);
    EXPECT_FALSE(errors->pairsAgree);
}

TEST(ElectricalSwing, pairsAgreeAtTwoTenths)
{
    EXPECT_TRUE(errorsOf({{0.2, 90.1, 180.0, 269.9}})->pairsAgree);
    EXPECT_FALSE(errorsOf({{0.3, 90.1, 180.0, 270.1}})->pairsAgree);
    EXPECT_TRUE(errorsOf({{359.9, 90.0, 180.1, 270.0}})->pairsAgree); // across north
    EXPECT_NEAR(errorsOf({{359.9, 90.0, 180.1, 270.0}})->index_deg, 0.0, 1e-9);
}

TEST(ElectricalSwing, missingAndSlippedPoints)
{
    EXPECT_FALSE(errorsOf({}));
    EXPECT_FALSE(errorsOf({{0.0, 90.0, 180.0, 207.0}}));
}

TEST(ElectricalSwing, selfCheckOfTheSet)
{
    ElectricalSwing swing;
    swing.headings = swing.selfCheck = everyFifteenDegrees();
    EXPECT_FALSE(selfCheckOf(swing));
    for (std::size_t i = 0; i < 24; ++i) {
        swing.headings[i].indicated_deg = swing.headings[i].selected_deg + 2.0; // an index does no harm
        swing.selfCheck[i].indicated_deg = swing.selfCheck[i].selected_deg;
    }
    EXPECT_TRUE(selfCheckOf(swing)->passed);
    EXPECT_NEAR(selfCheckOf(swing)->largest_deg, 0.0, 1e-9);
    *swing.headings[3].indicated_deg += 7.0 / 60.0; // one beyond 6′, mean small
    EXPECT_EQ(selfCheckOf(swing)->beyondSixMinutes, 1);
    EXPECT_TRUE(selfCheckOf(swing)->passed);
    *swing.headings[9].indicated_deg += 7.0 / 60.0; // two
    EXPECT_FALSE(selfCheckOf(swing)->passed);
    *swing.headings[9].indicated_deg -= 7.0 / 60.0;
    *swing.headings[3].indicated_deg += 3.0 / 60.0; // beyond 8′
    EXPECT_FALSE(selfCheckOf(swing)->passed);
}

TEST(ElectricalSwing, openPoints)
{
    ElectricalSwing swing;
    EXPECT_EQ(openPoints(swing).size(), 4u);
    swing.line = "NS-1";
    swing.E1 = swing.E2 = {3.1, 3.2};
    EXPECT_NEAR(*swing.E1.mean_V(), 3.15, 1e-12);
    swing.after = {{0.0, 90.0, 180.0, 270.0}};
    swing.headings = everyFifteenDegrees();
    EXPECT_EQ(openPoints(swing).size(), 1u);
    for (auto& heading : swing.headings)
        heading.indicated_deg = heading.selected_deg;
    EXPECT_TRUE(openPoints(swing).empty());
    swing.headings[6].indicated_deg = 90.3; // F1 says 90.0
    ASSERT_EQ(openPoints(swing).size(), 1u);
    EXPECT_NE(inEnglish(openPoints(swing))[0].find("with 90° selected the headings indicate +0.30° more"), std::string::npos);
    for (auto& heading : swing.headings)
        heading.indicated_deg = wrap360(heading.selected_deg + 180); // the set turned round: F1 agrees, and no heading is right
    ASSERT_EQ(openPoints(swing).size(), 1u);
    EXPECT_EQ(inEnglish(openPoints(swing))[0].find("24 headings indicated more than 30° off"), 0u);
}

TEST(ElectricalSwing, theHeadingsTellTheirLargestError)
{
    ElectricalSwing swing;
    EXPECT_FALSE(electricalErrorsOf(swing));
    swing.headings = {{0, 359.8}, {15, 15.4}, {30, {}}, {90, 89.3}};
    swing.after.indicated_deg[0] = 0.0;
    const auto errors = electricalErrorsOf(swing);
    ASSERT_TRUE(errors);
    EXPECT_EQ(errors->read, 3);
    EXPECT_NEAR(errors->largest_deg, -0.7, 1e-9); // indicated − selected
    EXPECT_EQ(errors->largestAt_deg, 90);
    EXPECT_NEAR(errors->mean_deg, (-0.2 + 0.4 - 0.7) / 3, 1e-3);
    EXPECT_NEAR(errors->againstF1_deg, -0.2, 1e-9);
}

} // namespace
TEST(ElectricalSwing, itsHeadingsAreACalibrationSwing)
{
    ElectricalSwing electrical;
    electrical.date = "2026-11-20";
    electrical.line = "red 2";
    electrical.calibrator = "MC-2M";
    electrical.calibratorSerial = "17";
    electrical.headings = {{0, 359.5}, {15, {}}, {30, 31.0}};
    const Swing swing = swingFrom(electrical);
    EXPECT_EQ(swing.kind, SwingKind::Calibration);
    EXPECT_EQ(swing.stage, SwingStage::AsLeft);
    EXPECT_EQ(swing.procedure, "electrical swing on the line red 2");
    EXPECT_EQ(swing.datum.instrument, "electrical calibrator MC-2M");
    ASSERT_EQ(swing.readings.size(), 2u); // nobody indicated 15
    EXPECT_EQ(swing.readings[1].magnetic->degrees(), 30.0);
    EXPECT_EQ(deviationOf(*swing.readings[1].magnetic, *swing.readings[1].compass).degrees(), -1.0); // magnetic − compass
}

} // namespace lubberline
