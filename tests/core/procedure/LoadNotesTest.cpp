#include <gtest/gtest.h>

#include "core/procedure/LoadNotes.h"
#include "core/swing/Observations.h"

namespace lubberline::test {

namespace {

/// d = 2° sin(heading) as read on eight headings.
Analysis twoDegreesEast()
{
    Swing swing;
    for (int heading = 0; heading < 360; heading += 45) {
        Reading reading;
        reading.magnetic = MagneticHeading::fromDegrees(heading);
        reading.compass = CompassHeading::fromDegrees(heading - 2 * std::sin(toRadians(heading)));
        swing.readings.push_back(reading);
    }
    return analyse(observationsOf(swing)).value();
}

SwingJob jobWith(std::initializer_list<job::InterferenceRead> reads)
{
    SwingJob job;
    for (const auto& read : reads)
        job.events.push_back({{}, read});
    return job;
}

} // namespace

TEST(LoadNotes, nameWhatPushesTheCompassPastTenDegrees)
{
    const Analysis analysis = twoDegreesEast();
    // With the pitot heat on the compass reads 13° less on E: deviation 2 + 13; on W −2 + 13.
    const auto notes = loadsPast(jobWith({{90, "pitot heat", 88, 75}, {270, "pitot heat", 272, 259}, {0, "radio", 0, 4}}), analysis);
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_EQ(notes[0].load, "pitot heat");
    EXPECT_EQ(notes[0].heading_deg, 90);
    EXPECT_NEAR(notes[0].deviation_deg, 15, 0.05);
}

TEST(LoadNotes, acrossNorthAndWithTheirSign)
{
    const Analysis analysis = twoDegreesEast();
    const auto notes = loadsPast(jobWith({{0, "wipers", 355, 6}}), analysis); // reads 11° more
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_NEAR(notes[0].deviation_deg, -11, 0.05);
    EXPECT_TRUE(loadsPast(jobWith({{0, "wipers", 355, 4}}), analysis).empty());
    EXPECT_TRUE(loadsPast(jobWith({}), analysis).empty());
    EXPECT_EQ(loadsPast(jobWith({{0, "wipers", 355, 4}}), analysis, 8.9).size(), 1u);
}

} // namespace lubberline::test
