// Statistics with known answers: the sources are named at each.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/fleet/ControlChart.h"
#include "core/fleet/Proportion.h"
#include "core/fleet/VarianceComponents.h"

using namespace lubberline;

namespace {

/// Dyestuff, six batches of five (Davies, Statistical Methods in Research and Production, 1947; lme4's first example).
std::vector<VarianceRow> dyestuff(std::vector<std::size_t> sizes = {5, 5, 5, 5, 5, 5})
{
    const double yield[6][5] = {{1545, 1440, 1440, 1520, 1580}, {1540, 1555, 1490, 1560, 1495}, {1595, 1550, 1605, 1510, 1560},
        {1445, 1440, 1595, 1465, 1545}, {1595, 1630, 1515, 1635, 1625}, {1520, 1455, 1450, 1480, 1445}};
    std::vector<VarianceRow> rows;
    for (std::size_t batch = 0; batch < 6; ++batch)
        for (std::size_t i = 0; i < sizes[batch]; ++i)
            rows.push_back({yield[batch][i], static_cast<std::int32_t>(batch)});
    return rows;
}

} // namespace

TEST(PublishedStatistics, dyestuffByRestrictedMaximumLikelihood)
{
    const auto report = varianceComponents(dyestuff());
    ASSERT_TRUE(report);
    EXPECT_NEAR(report->aircraft->variance, 1764.05, 0.005);
    EXPECT_NEAR(report->residual.variance, 2451.25, 0.005);
    EXPECT_NEAR(report->mean, 1527.5, 1e-9);
    EXPECT_NEAR(report->meanStandardError, 19.38341, 5e-6);
    EXPECT_NEAR(report->criterion, 319.654277, 5e-7);
    EXPECT_FALSE(report->crew);
    EXPECT_FALSE(report->site);
    EXPECT_EQ(report->notTold.size(), 2u);
}

TEST(PublishedStatistics, dyestuffUnbalanced)
{
    const auto report = varianceComponents(dyestuff({3, 5, 5, 2, 5, 4}));
    ASSERT_TRUE(report);
    EXPECT_NEAR(report->mean, 1516.4793, 5e-5);
    EXPECT_NEAR(report->aircraft->variance, 3097.913, 0.005);
    EXPECT_NEAR(report->residual.variance, 1705.292, 0.002);
    EXPECT_NEAR(report->meanStandardError, 24.38311, 2e-5);
    EXPECT_NEAR(report->criterion, 249.921371, 5e-7);
}

TEST(PublishedStatistics, profileIntervalsHoldWhatTheyBoundAndAreNotSymmetric)
{
    const auto report = varianceComponents(dyestuff());
    ASSERT_TRUE(report);
    const auto& batch = *report->aircraft;
    EXPECT_LT(batch.interval.low, batch.variance);
    EXPECT_GT(batch.interval.high - batch.variance, 2 * (batch.variance - batch.interval.low));
    // The residual's interval is close to the exact one of χ² with 24 degrees: 2451.25·24/39.364, 2451.25·24/12.401.
    EXPECT_NEAR(report->residual.interval.low, 1494.5, 60);
    EXPECT_NEAR(report->residual.interval.high, 4744.0, 250);
    const auto share = intraclassInterval(11271.5 / 2451.25, 6, 5);
    EXPECT_NEAR(share.low, 0.0838361, 5e-8);
    EXPECT_NEAR(share.high, 0.8478768, 5e-8);
}

TEST(PublishedStatistics, clopperAndPearson)
{
    const auto near = [](Interval interval, double low, double high) {
        EXPECT_NEAR(interval.low, low, 5e-8);
        EXPECT_NEAR(interval.high, high, 5e-8);
    };
    near(clopperPearson(4, 20, 0.90), 0.0713539, 0.4010281); // NIST e-Handbook 7.2.4.1
    near(clopperPearson(0, 40), 0, 0.0880973);
    near(clopperPearson(1, 40), 0.00063274, 0.1315859);
    near(clopperPearson(5, 200), 0.0081662, 0.0573744);
    near(clopperPearson(25, 1000), 0.0162425, 0.0366848);
    near(clopperPearson(0, 1), 0, 0.975);
}

TEST(PublishedStatistics, toleranceFactors)
{
    EXPECT_NEAR(toleranceFactorOneSided(43, 0.90, 0.99), 1.873954, 5e-7); // NIST e-Handbook 7.2.6.3
    EXPECT_NEAR(toleranceFactor(43, 0.90, 0.99), 2.222825, 5e-6);
    const std::pair<int, double> known[] = {{5, 7.6368}, {10, 5.1518}, {20, 4.2121}, {40, 3.7440}, {100, 3.4187}, {300, 3.2231}};
    for (const auto& [n, factor] : known)
        EXPECT_NEAR(toleranceFactor(n, 0.9973, 0.95), factor, 1e-4) << n;
}

TEST(PublishedStatistics, theNextOutsideThreeStandardDeviations)
{
    const std::pair<int, double> known[] = {{5, 5.20}, {10, 1.88}, {20, 0.86}, {40, 0.52}, {100, 0.36}, {300, 0.30}};
    for (const auto& [n, percent] : known) {
        EXPECT_NEAR(100 * nextOutside(n, 3), percent, 0.005) << n;
        EXPECT_NEAR(nextBeyond(n, 0, 1, 3), nextOutside(n, 3), 1e-12);
    }
}

TEST(PublishedStatistics, movingAverageChart)
{
    // NIST e-Handbook 6.3.2.4
    const std::vector<double> values{
        52.0, 47.0, 53.0, 49.3, 50.1, 47.0, 51.0, 50.1, 51.2, 50.5, 49.6, 47.6, 49.9, 51.3, 47.8, 51.2, 52.6, 52.4, 53.6, 52.1};
    const std::vector<double> average{50.60, 49.52, 50.56, 50.18, 50.16, 49.21, 49.75, 49.85, 50.26, 50.33, 50.11, 49.36, 49.52, 50.05,
        49.38, 49.92, 50.73, 51.23, 51.94, 51.99};
    const auto chart = ewma(values, 50, 2.0539, 0.3, 3);
    EXPECT_NEAR(chart.low, 47.4116, 5e-5);
    EXPECT_NEAR(chart.high, 52.5884, 5e-5);
    for (std::size_t i = 0; i < values.size(); ++i)
        EXPECT_NEAR(chart.average[i], average[i], 0.0051) << i;
    EXPECT_EQ(std::ranges::count(chart.alarm, true), 0);
}

TEST(PublishedStatistics, runLengths)
{
    // Montgomery, Introduction to Statistical Quality Control
    const double shifts[] = {0, 0.5, 1, 2, 3}, four[] = {167.68, 26.63, 8.38, 3.34, 2.19}, five[] = {465.44, 38.00, 10.38, 4.01, 2.57};
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_NEAR(cusumRunLength(0.5, 4, shifts[i]), four[i], 0.005 + 2e-4 * four[i]) << shifts[i];
        EXPECT_NEAR(cusumRunLength(0.5, 5, shifts[i]), five[i], 0.005 + 2e-4 * five[i]) << shifts[i];
    }
    const struct {
        double weight, width, lengths[4];
    } known[] = {{0.1, 2.814, {499.5, 31.3, 10.3, 4.4}}, {0.2, 2.962, {499.7, 41.8, 10.5, 3.7}}, {0.3, 3.023, {499.9, 55.4, 12.0, 3.5}}};
    for (const auto& [weight, width, lengths] : known)
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_NEAR(ewmaRunLength(weight, width, shifts[i]), lengths[i], i == 0 ? 0.6 : 0.055) << weight << " " << shifts[i];
}

TEST(PublishedStatistics, cusumBeginsAgainAfterAnAlarm)
{
    const std::vector<double> values(12, 2.0);
    const auto chart = cusum(values, 0, 1, 0.5, 4);
    EXPECT_FALSE(chart.alarm[1]);
    EXPECT_TRUE(chart.alarm[2]); // 1.5, 3.0, 4.5
    EXPECT_DOUBLE_EQ(chart.high[3], 1.5);
    EXPECT_TRUE(chart.alarm[5]);
    EXPECT_DOUBLE_EQ(chart.low[5], 0.0);
}

TEST(PublishedStatistics, discoveriesAtAFalseRate)
{
    // Benjamini and Hochberg 1995, section 3.2 (15 tests at 5 %): four are rejected.
    const std::vector<double> p{
        0.0001, 0.0004, 0.0019, 0.0095, 0.0201, 0.0278, 0.0298, 0.0344, 0.0459, 0.3240, 0.4262, 0.5719, 0.6528, 0.7590, 1.0};
    const auto found = discoveries(p, 0.05, p.size());
    EXPECT_EQ(std::ranges::count(found, true), 4);
    EXPECT_TRUE(found[3]);
    EXPECT_FALSE(found[4]);
}
