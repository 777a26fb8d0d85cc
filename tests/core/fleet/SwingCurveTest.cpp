#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/deviation/SmithFit.h"
#include "core/fleet/FleetRandom.h"
#include "core/fleet/FleetSwings.h"
#include "core/fleet/SwingCurve.h"

using namespace lubberline;

namespace {

struct Readings {
    std::vector<double> magnetic, compass;
};

Readings readOn(std::vector<double> headings, const FiveTerms& smith_deg, double noise_deg = 0, std::uint64_t seed = 1)
{
    FleetRandom random(seed);
    Readings readings;
    for (const double heading : headings) {
        readings.compass.push_back(heading);
        readings.magnetic.push_back(wrap360(heading + curveAtCompass_deg(smith_deg, heading) + noise_deg * random.normal()));
    }
    return readings;
}

std::vector<double> evenly(int n)
{
    std::vector<double> headings;
    for (int i = 0; i < n; ++i)
        headings.push_back(360.0 * i / n);
    return headings;
}

constexpr FiveTerms kSmith{0.7, -3.0, 2.0, 1.5, -0.4};

} // namespace

class SwingCurveOfHeadings : public testing::TestWithParam<std::vector<double>> {};

TEST_P(SwingCurveOfHeadings, isThatOfTheCarefulFit)
{
    const auto readings = readOn(GetParam(), kSmith, 0.3);
    const auto quick = fitCurve(readings.magnetic, readings.compass);
    std::vector<Observation> observations;
    for (std::size_t i = 0; i < readings.compass.size(); ++i)
        observations.push_back({MagneticHeading::fromDegrees(readings.magnetic[i]), CompassHeading::fromDegrees(readings.compass[i])});
    const auto careful = fitApproximate(observations);
    ASSERT_TRUE(careful);
    ASSERT_EQ(quick.parameters, careful->parameters);
    for (std::size_t c = 0; c < 5; ++c) {
        EXPECT_EQ(quick.known(c), careful->value[c].has_value());
        EXPECT_NEAR(quick.value_deg[c], toDegrees(careful->value[c].value_or(0)), 1e-11);
        for (std::size_t d = 0; d < 5; ++d) {
            EXPECT_NEAR(quick.inverse[c][d] * std::pow(careful->sigma_rad.value_or(0), 2),
                careful->covariance(static_cast<Eigen::Index>(c), static_cast<Eigen::Index>(d)), 1e-15);
        }
    }
    EXPECT_NEAR(quick.residualSquares_deg2, std::pow(toDegrees(careful->sigma_rad.value_or(0)), 2) * quick.degreesOfFreedom(), 1e-11);
}

INSTANTIATE_TEST_SUITE_P(All, SwingCurveOfHeadings,
    testing::Values(evenly(24), evenly(12), evenly(8), evenly(7), evenly(5), evenly(3),
        std::vector<double>{0, 45, 92, 133, 181, 226, 268, 313}, std::vector<double>{0, 1, 2, 3, 4, 120, 240},
        std::vector<double>{10, 55, 100, 145, 190, 235}));

TEST(SwingCurve, fourCardinalsTellAbceAndFourIntercardinalsAbcd)
{
    const auto cardinals = readOn({0, 90, 180, 270}, {0.7, -3.0, 2.0, 0.0, -0.4});
    const auto curve = fitCurve(cardinals.magnetic, cardinals.compass);
    EXPECT_EQ(curve.knownBits, 0b10111);
    EXPECT_NEAR(curve.value_deg[4], -0.4, 1e-12);
    EXPECT_EQ(curve.degreesOfFreedom(), 0);
    const auto between = readOn({45, 135, 225, 315}, {0.7, -3.0, 2.0, 1.5, 0.0});
    const auto other = fitCurve(between.magnetic, between.compass);
    EXPECT_EQ(other.knownBits, 0b01111);
    EXPECT_NEAR(other.value_deg[3], 1.5, 1e-12);
}

TEST(SwingCurve, ofACompassThatIsFarOutAsAWholeThereIsNone)
{
    for (const double index : {180.0, 92.0, -61.0, 0.0}) {
        std::vector<double> magnetic, compass;
        for (int i = 0; i < 24; ++i) {
            compass.push_back(15.0 * i);
            magnetic.push_back(wrap360(15.0 * i + index + 50 * std::sin(toRadians(15.0 * i))));
        }
        const SwingCurve curve = fitCurve(magnetic, compass);
        EXPECT_EQ(curve.farOut, index != 0.0) << index;
        EXPECT_EQ(curve.fitted(), index == 0.0) << index; // 50° of B alone is a deviation like any other
    }
}

TEST(SwingCurve, whatTheHeadingsCannotTellHasNoValue)
{
    for (const auto& headings : {std::vector<double>{}, {10}, {10, 190}, {0, 1, 2, 3, 4, 5}, {30, 30, 30, 30, 30, 30}}) {
        const auto readings = readOn(headings, kSmith);
        EXPECT_FALSE(fitCurve(readings.magnetic, readings.compass).fitted()) << headings.size();
    }
}

TEST(SwingCurve, goesBackToTheHeadingThatItWasReadOn)
{
    for (double compass = 0; compass < 360; compass += 7.5) {
        const double magnetic = compass + curveAtCompass_deg(kSmith, compass);
        const auto point = curveAtMagnetic(kSmith, magnetic);
        EXPECT_NEAR(point.compass_deg, compass, 1e-9);
        EXPECT_NEAR(point.deviation_deg, magnetic - compass, 1e-9);
    }
    double largest = 0;
    for (int z = 0; z < 360; z += 5)
        largest = std::max(largest, std::abs(curveAtCompass_deg(kSmith, z)));
    EXPECT_NEAR(largestOf_deg(kSmith), largest, 1e-12);
}

TEST(FleetSwings, areTheSameInWhateverOrderTheyCame)
{
    FleetSwings one;
    for (const auto& [type, aircraft] : {std::pair("B", "b2"), std::pair("A", "a1"), std::pair("B", "b1")}) {
        one.compasses.emplace_back();
        one.compasses.back().type = type;
        one.compasses.back().aircraft = aircraft;
    }
    one.sites = {"South", "North"};
    one.crews = {"Z", "Y"};
    const auto add = [&](FleetSwings& fleet, int compass, int day, int site, std::vector<double> headings) {
        FleetSwing swing;
        swing.compass = compass;
        swing.day = day;
        swing.site = site;
        swing.crew = site;
        swing.first = static_cast<std::uint32_t>(fleet.compass_deg.size());
        swing.count = static_cast<std::uint32_t>(headings.size());
        fleet.swings.push_back(swing);
        for (const double heading : headings) {
            fleet.compass_deg.push_back(heading);
            fleet.magnetic_deg.push_back(heading + 1);
        }
    };
    FleetSwings two = one;
    std::swap(two.compasses[0], two.compasses[2]);
    std::swap(two.sites[0], two.sites[1]);
    std::swap(two.crews[0], two.crews[1]);
    add(one, 0, 5, 0, {10, 20, 30});
    add(one, 1, 4, 1, {40, 20});
    add(one, 0, 5, 0, {10, 20, 25});
    add(two, 2, 5, 1, {25, 20, 10});
    add(two, 2, 5, 1, {30, 10, 20});
    add(two, 1, 4, 0, {20, 40});
    putInOrder(one);
    putInOrder(two);
    EXPECT_EQ(one.compass_deg, two.compass_deg);
    EXPECT_EQ(one.magnetic_deg, two.magnetic_deg);
    EXPECT_EQ(one.sites, two.sites);
    EXPECT_EQ(one.compass_deg, (std::vector<double>{20, 40, 10, 20, 25, 10, 20, 30}));
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(one.swings[i].compass, two.swings[i].compass);
        EXPECT_EQ(one.swings[i].site, two.swings[i].site);
        EXPECT_EQ(one.swings[i].first, two.swings[i].first);
    }
    EXPECT_EQ(one.compasses[0].aircraft, "a1");
}

TEST(FleetSwings, daysAreThoseOfTheCalendar)
{
    EXPECT_EQ(dayOfDate("1970-01-01"), 0);
    EXPECT_EQ(dayOfDate("2026-11-26"), 20783);
    EXPECT_EQ(dateOfDay(20783), "2026-11-26");
    EXPECT_EQ(dayOfDate("1969-12-31"), -1);
    EXPECT_FALSE(dayOfDate("2026-02-30"));
    EXPECT_FALSE(dayOfDate(""));
}
