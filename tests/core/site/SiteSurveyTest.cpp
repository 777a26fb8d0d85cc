#include <gtest/gtest.h>

#include <limits>

#include "core/site/SiteSurvey.h"

namespace lubberline {
namespace {

SurveyPoint declination(double value_deg) { return {0, 0, 1, value_deg, {}}; }
SurveyPoint total(double value_nT) { return {0, 0, 1, {}, value_nT}; }

TEST(SiteSurvey, extentsOfAGrid)
{
    const std::vector<SurveyPoint> points{
        declination(5.10), declination(5.20), declination(5.15), {10, 0, 1, 5.15, 50000.0}, total(50010.0)};
    const auto summary = summarise(points, 18000);
    ASSERT_TRUE(summary);
    EXPECT_EQ(summary->declination_deg->count, 4);
    EXPECT_NEAR(summary->declination_deg->mean, 5.15, 1e-12);
    EXPECT_NEAR(summary->declination_deg->range(), 0.10, 1e-12);
    EXPECT_NEAR(summary->largestOff_deg, 0.05, 1e-12);
    EXPECT_DOUBLE_EQ(summary->total_nT->range(), 10.0);
    EXPECT_EQ(summary->meets, SiteClass::Class1);
    EXPECT_TRUE(summary->withinMilitaryRange);
}

TEST(SiteSurvey, classesAtTheirEdges)
{
    const auto meets = [](double off_deg) {
        return summarise(std::vector{declination(-12.0 - off_deg), declination(-12.0 + off_deg)}, 0)->meets;
    };
    EXPECT_EQ(meets(0.1), SiteClass::Class1);
    EXPECT_EQ(meets(0.101), SiteClass::Class2);
    EXPECT_EQ(meets(0.25), SiteClass::Class2);
    EXPECT_EQ(meets(0.26), SiteClass::None);
    EXPECT_FALSE(summarise(std::vector{declination(5.0), declination(5.201)}, 0)->withinMilitaryRange); // 12.06′
    EXPECT_TRUE(summarise(std::vector{declination(5.0), declination(5.2)}, 0)->withinMilitaryRange);
}

/// Nelson Airport, 2019: a range of 8.06 nT is 0.026° and 31 nT are permissible for 0.1°, with H of about 17,760 nT.
TEST(SiteSurvey, totalFieldSurveyOfNelsonAirport)
{
    const auto nelson = summarise(std::vector{total(56000.0), total(56008.06)}, 17760);
    ASSERT_TRUE(nelson);
    EXPECT_NEAR(*nelson->equivalent_deg * 2, 0.026, 0.0005); // the survey takes the whole range
    EXPECT_EQ(nelson->meets, SiteClass::Class1);
    EXPECT_EQ(summarise(std::vector{total(56000.0), total(56063.0)}, 17760)->meets, SiteClass::Class2);
}

TEST(SiteSurvey, nothingMeasuredIsAnError)
{
    EXPECT_FALSE(summarise({}, 18000));
    EXPECT_FALSE(summarise(std::vector{SurveyPoint{}}, 18000));
    EXPECT_FALSE(summarise(std::vector{declination(std::numeric_limits<double>::quiet_NaN())}, 18000));
}

TEST(PaintedLines, offsetOfToday)
{
    // Painted with 4° E; today 6.5° E: the line marked 000 points to true 004, which is magnetic 357.5 today.
    EXPECT_DOUBLE_EQ(paintedLineOffset_deg(Variation::fromDegrees(4.0), Variation::fromDegrees(6.5)), -2.5);
    EXPECT_DOUBLE_EQ(paintedLineOffset_deg(Variation::fromDegrees(-1.0), Variation::fromDegrees(-3.0)), 2.0);
}

TEST(SiteFitness, expiryAndClass)
{
    EXPECT_TRUE(whyUnfit({"2026-11-23", SiteClass::Class1, SiteClass::Class1}, "2026-11-23").empty());
    EXPECT_FALSE(whyUnfit({"2026-11-23", SiteClass::Class1, SiteClass::Class1}, "2026-11-24").empty());
    EXPECT_FALSE(whyUnfit({"", SiteClass::Class2, SiteClass::Class1}, "2026-11-24").empty());
    EXPECT_TRUE(whyUnfit({"", SiteClass::Class1, SiteClass::Class2}, "2026-11-24").empty());
    EXPECT_TRUE(whyUnfit({"", SiteClass::None, SiteClass::None}, "2026-11-24").empty());
}

} // namespace
} // namespace lubberline
