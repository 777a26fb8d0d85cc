// A compass that is based elsewhere than where it was swung.

#include <gtest/gtest.h>

#include "core/sensor/SensorReading.h"
#include "core/swing/MoveRule.h"
#include "core/swing/SwingField.h"

namespace lubberline {
namespace {

Site site(const char* name, double latitude_deg, double longitude_deg)
{
    Site made;
    made.name = name;
    made.latitude_deg = latitude_deg;
    made.longitude_deg = longitude_deg;
    return made;
}

/// Swung at Warsaw every 30° with vertical soft iron and hard iron, under a limit of 10°.
SwingRecord swungAtWarsaw(double p_nT)
{
    SwingRecord record;
    record.site = site("Warsaw", 52.2, 21.0);
    record.swing.date = "2026-06-10";
    record.limits = LimitsProfile{};
    record.limits->maxDeviation_deg = 10.0;
    record.swing.field = stampFor(record.swing, record.site);
    SensorModel model;
    model.hardIron_nT = {p_nT, 0, 0};
    model.softIron(0, 2) = 0.01;
    for (int heading_deg = 0; heading_deg < 360; heading_deg += 30) {
        Reading reading;
        reading.magnetic = MagneticHeading::fromDegrees(heading_deg);
        reading.compass = readSensor(model, record.swing.field->field.meridian(), {*reading.magnetic}).compass;
        record.swing.readings.push_back(reading);
    }
    return record;
}

TEST(MoveRule, aBaseNextDoorChangesNothing)
{
    const auto why = whySwingAfterMove(swungAtWarsaw(1500), site("Modlin", 52.45, 20.65), "2026-11-23");
    ASSERT_TRUE(why) << why.error().message.english();
    EXPECT_TRUE(why->empty());
}

TEST(MoveRule, aWeakHorizontalFieldTurnsTheNeedleFurther)
{
    const auto why = whySwingAfterMove(swungAtWarsaw(1500), site("Alert", 78.0, -70.0), "2026-11-23");
    ASSERT_TRUE(why) << why.error().message.english();
    EXPECT_EQ(why->english().rfind("based at Alert: ", 0), 0u) << why->english();
    EXPECT_NE(why->english().find("beyond the limit"), std::string::npos) << why->english();
}

/// A compass without deviation at Warsaw may owe it to hard iron that takes vertical soft iron's deviation away there, and there
/// only: what is said of Singapore is said with the assumption that it rests on.
TEST(MoveRule, withoutDeviationHereIsNotWithoutDeviationThere)
{
    auto clean = swungAtWarsaw(0);
    for (auto& reading : clean.swing.readings)
        reading.compass = CompassHeading::fromDegrees(reading.magnetic->degrees());
    const auto far = whySwingAfterMove(clean, site("Singapore", 1.3, 103.9), "2026-11-23");
    ASSERT_TRUE(far) << far.error().message.english();
    EXPECT_NE(far->english().find("with a probability of 95 %, assuming vertical soft iron"), std::string::npos) << far->english();
    const auto near = whySwingAfterMove(clean, site("Vienna", 48.1, 16.6), "2026-11-23");
    ASSERT_TRUE(near);
    EXPECT_TRUE(near->empty()) << near->english();
}

TEST(MoveRule, saysWhatIsMissing)
{
    Site nowhere;
    nowhere.name = "the strip";
    const auto why = whySwingAfterMove(swungAtWarsaw(1500), nowhere, "2026-11-23");
    ASSERT_FALSE(why);
    EXPECT_NE(why.error().message.english().find("the strip"), std::string::npos);
    auto few = swungAtWarsaw(1500);
    few.swing.readings.resize(4);
    EXPECT_FALSE(whySwingAfterMove(few, site("Modlin", 52.45, 20.65), "2026-11-23"));
    EXPECT_FALSE(whySwingAfterMove(swungAtWarsaw(1500), site("Modlin", 52.45, 20.65), "1500-01-01"));
}

} // namespace
} // namespace lubberline
