#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/record/SwingDifferences.h"

namespace lubberline::test {

namespace {

Swing oneReading()
{
    Swing swing;
    swing.date = "2026-11-23";
    Reading reading;
    reading.nominal_deg = 90;
    reading.magnetic = MagneticHeading::fromDegrees(91);
    reading.compass = CompassHeading::fromDegrees(85.5);
    reading.timeUtc = "2026-11-23T09:00:00Z";
    swing.readings.push_back(reading);
    return swing;
}

} // namespace

/// What, before, after.
using Told = std::array<std::string, 3>;
std::vector<Told> told(const std::vector<SwingDifference>& differences)
{
    std::vector<Told> all;
    for (const auto& one : differences)
        all.push_back({one.what.english(), one.before.english(), one.after.english()});
    return all;
}

TEST(SwingDifferences, ofTheSameSwingAreNone)
{
    Swing after = oneReading();
    after.state = SwingState::Signed;
    after.revision = 2;
    after.signatures.push_back({});
    EXPECT_TRUE(differencesBetween(oneReading(), after).empty());
}

TEST(SwingDifferences, areToldFieldByFieldInTheOrderOfTheRecord)
{
    Swing after = oneReading();
    after.configuration.radio = RadioState::On;
    after.workOrder = "WO 7";
    after.readings[0].compass = CompassHeading::fromDegrees(58.5);
    after.readings[0].timeUtc.clear();
    const std::vector<Told> expected{{"radio", "not stated", "on"}, {"work order", "", "WO 7"}, {"reading 1, compass", "85.5", "58.5"},
        {"reading 1, time", "2026-11-23T09:00:00Z", ""}};
    EXPECT_EQ(told(differencesBetween(oneReading(), after)), expected);
}

TEST(SwingDifferences, tellReadingsThatCameOrWent)
{
    Swing after = oneReading();
    after.readings.clear();
    const auto gone = differencesBetween(oneReading(), after);
    ASSERT_EQ(gone.size(), 4u); // nominal, magnetic, compass, time
    EXPECT_EQ(told(gone)[1], (Told{"reading 1, magnetic", "91", ""}));
    EXPECT_EQ(told(differencesBetween(after, oneReading()))[1], (Told{"reading 1, magnetic", "", "91"}));
}

TEST(SwingDifferences, ofAnExclusionAreItsReason)
{
    Swing after = oneReading();
    after.readings[0].exclusion = Exclusion{"aircraft was moved"};
    const auto found = differencesBetween(oneReading(), after);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(told(found)[0], (Told{"reading 1, excluded", "", "aircraft was moved"}));
}

} // namespace lubberline::test
