#include <gtest/gtest.h>

#include "core/swing/Observations.h"
#include "tests/ui/report/swing/SampleSwings.h"
#include "ui/plots/swing/PictureOf.h"

namespace lubberline::test {

namespace {

std::shared_ptr<const Analysis> analysisOf(const SwingRecord& record)
{
    return std::make_shared<const Analysis>(analyse(observationsOf(record.swing)).value());
}

} // namespace

TEST(PictureOf, keepsTheRowsOfTheTable)
{
    SwingRecord record = simulatedRecord(12);
    record.swing.readings[2].exclusion = Exclusion{"reason"};
    record.swing.readings.insert(record.swing.readings.begin() + 5, Reading{}); // a row that is being entered
    const double read_deg = record.swing.readings[8].compass->degrees();
    record.swing.readings[8].compass = CompassHeading::fromDegrees(read_deg + 10);
    const auto picture = ui::pictureOf(record, analysisOf(record), {}, nullptr, {}, AngleStyle::DecimalDegrees);
    ASSERT_EQ(picture.readings.size(), 12u);
    for (const auto& point : picture.readings) {
        const Reading& reading = record.swing.readings[static_cast<std::size_t>(point.row)];
        EXPECT_EQ(point.magnetic, *reading.magnetic);
        EXPECT_EQ(point.deviation, deviationOf(*reading.magnetic, *reading.compass));
        EXPECT_EQ(point.excluded, point.row == 2);
        EXPECT_EQ(point.suspect, point.row == 8);
        EXPECT_EQ(point.studentised.has_value(), point.row != 2);
    }
}

TEST(PictureOf, takesLimitsResolutionAndTitleFromTheRecord)
{
    SwingRecord record = simulatedRecord(8);
    record.compass.resolution_deg = 0.5;
    auto picture = ui::pictureOf(record, analysisOf(record), "not shown", nullptr, {}, AngleStyle::DegreesMinutes);
    EXPECT_EQ(picture.limit_deg, 10.0);
    EXPECT_EQ(picture.limitDocument, "14 CFR 25.1327");
    EXPECT_EQ(picture.resolution_deg, 0.5);
    EXPECT_EQ(picture.angleStyle, AngleStyle::DegreesMinutes);
    EXPECT_EQ(picture.title, QString::fromUtf8("SP-XYZ · standby compass · 2026-11-20"));
    EXPECT_TRUE(picture.whyNoAnalysis.isEmpty());
    record.limits.reset();
    EXPECT_FALSE(ui::pictureOf(record, analysisOf(record), {}, nullptr, {}, AngleStyle::DecimalDegrees).limit_deg.has_value());
}

TEST(PictureOf, withoutAnAnalysisItSaysWhy)
{
    SwingRecord record = simulatedRecord(8);
    record.swing.readings.resize(2);
    const auto picture
        = ui::pictureOf(record, nullptr, "three readings are needed", analysisOf(simulatedRecord(8)), "2025", AngleStyle::DecimalDegrees);
    EXPECT_EQ(picture.whyNoAnalysis, "three readings are needed");
    EXPECT_EQ(picture.readings.size(), 2u);
    EXPECT_EQ(picture.previousLabel, "2025");
    EXPECT_NE(picture.previous, nullptr);
}

TEST(PictureOfDeathTest, theAnalysisMustBeOfThisSwing)
{
    const SwingRecord record = simulatedRecord(8);
    const auto other = analysisOf(simulatedRecord(12));
    EXPECT_DEATH((void)ui::pictureOf(record, other, {}, nullptr, {}, AngleStyle::DecimalDegrees), "used readings");
}

} // namespace lubberline::test
