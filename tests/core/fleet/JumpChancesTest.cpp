// Critical values by pattern of dates: those of the dates themselves, shared by what is spaced alike, the same whoever asks.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>
#include <vector>

#include "core/fleet/FleetRandom.h"
#include "core/fleet/JumpChances.h"

using namespace lubberline;

namespace {

std::vector<DatedValue> everyDays(int n, int days, int first = 0)
{
    std::vector<DatedValue> series;
    for (int i = 0; i < n; ++i)
        series.push_back({first + days * i, 0, 0.04});
    return series;
}

std::vector<DatedValue> drawn(FleetRandom& random)
{
    std::vector<DatedValue> series;
    const int n = 5 + static_cast<int>(random.unit() * 11);
    int day = 9000;
    for (int i = 0; i < n; ++i) {
        series.push_back({day, 0, 0.05 * std::exp(0.5 * random.normal()), i > 1 && random.unit() < 0.08});
        day += random.unit() < 0.1 ? 3 : 100 + static_cast<int>(random.unit() * 600);
    }
    return series;
}

} // namespace

struct Critical {
    int n;
    double five, one;
};

/// The values of JumpTestTest.cpp, by 200,000 simulations of another program.
TEST(JumpChances, tablesHoldKnownCriticalValues)
{
    for (const auto& [n, five, one] : {Critical{5, 2.44, 2.99}, {6, 2.50, 3.05}, {8, 2.59, 3.12}, {10, 2.65, 3.19}, {20, 2.81, 3.33}}) {
        const JumpTable table(jumpPatternOf(everyDays(n, 365), {.trend = false, .at = {}}));
        EXPECT_NEAR(table.criticalValue(0.05), five, 0.03) << n;
        EXPECT_NEAR(table.criticalValue(0.01), one, 0.03) << n;
    }
    for (const auto& [n, five, one] : {Critical{5, 2.45, 3.00}, {8, 2.64, 3.17}, {15, 2.84, 3.35}, {20, 2.92, 3.41}}) {
        const JumpTable table(jumpPatternOf(everyDays(n, 365), {.trend = true, .at = {}}));
        EXPECT_NEAR(table.criticalValue(0.05), five, 0.03) << n;
        EXPECT_NEAR(table.criticalValue(0.01), one, 0.03) << n;
    }
}

TEST(JumpChances, areThoseOfTheDatesWithinATenth)
{
    FleetRandom random(7);
    for (int round = 0; round < 60; ++round) {
        const auto series = drawn(random);
        JumpOptions options;
        options.trend = round % 2 == 0;
        options.walk_year = round % 3 == 0 ? 0.1 * random.unit() : 0.0;
        if (round % 5 == 0)
            options.at.push_back(2);
        const JumpDesign exact(series, options);
        if (exact.places().empty())
            continue;
        const JumpTable table(jumpPatternOf(series, options));
        for (const double statistic : {2.5, 3.1, 4.4, 6.0}) {
            const double known = exact.chanceBeyond(statistic, 400);
            EXPECT_NEAR(table.chanceBeyond(statistic), known, 0.1 * known) << round << ' ' << statistic;
            EXPECT_GE(table.chanceBeyond(statistic), 2 * normalTail(statistic));
        }
    }
}

TEST(JumpChances, whatIsSpacedAlikeIsOnePattern)
{
    const auto pattern = jumpPatternOf(everyDays(9, 365), {});
    EXPECT_EQ(pattern, jumpPatternOf(everyDays(9, 730, 12000), {}));
    auto other = everyDays(9, 365);
    for (auto& each : other)
        each.variance *= 7.3;
    other[4].day += 12; // some weeks late
    EXPECT_EQ(pattern, jumpPatternOf(other, {}));
    other[4].day += 120;
    EXPECT_NE(pattern, jumpPatternOf(other, {}));
    auto worse = everyDays(9, 365);
    worse[3].variance *= 4;
    EXPECT_NE(pattern, jumpPatternOf(worse, {}));
    auto corrected = everyDays(9, 365);
    corrected[3].corrected = true;
    EXPECT_NE(pattern, jumpPatternOf(corrected, {}));
    JumpOptions jumped;
    jumped.at = {3};
    EXPECT_EQ(jumpPatternOf(corrected, {}), jumpPatternOf(everyDays(9, 365), jumped)); // neither is asked for
    JumpOptions level;
    level.trend = false;
    EXPECT_NE(pattern, jumpPatternOf(everyDays(9, 365), level));
    // Of wandering it is the share that counts: four times in half of the time.
    JumpOptions slow, quick;
    slow.walk_year = 0.01;
    quick.walk_year = 0.02;
    EXPECT_EQ(jumpPatternOf(everyDays(9, 730), slow), jumpPatternOf(everyDays(9, 365), quick));
    // One day is one day, and the next is another.
    auto near = everyDays(9, 365);
    near[4].day = near[3].day;
    EXPECT_NE(pattern, jumpPatternOf(near, {}));
    const auto same = jumpPatternOf(near, {});
    near[4].day += 1;
    EXPECT_NE(same, jumpPatternOf(near, {}));
}

TEST(JumpChances, areTheSameWhoeverAsksFirst)
{
    FleetRandom random(3);
    std::vector<JumpPattern> patterns;
    for (int i = 0; i < 40; ++i)
        patterns.push_back(jumpPatternOf(drawn(random), {}));
    JumpChances forward, together;
    std::vector<double> known;
    for (const auto& pattern : patterns)
        known.push_back(forward.of(pattern)->chanceBeyond(3.3));
    std::vector<std::thread> hands;
    std::vector<std::vector<double>> found(4, std::vector<double>(patterns.size()));
    for (std::size_t hand = 0; hand < found.size(); ++hand)
        hands.emplace_back([&, hand] {
            for (std::size_t i = 0; i < patterns.size(); ++i) {
                const std::size_t place = hand % 2 == 0 ? i : patterns.size() - 1 - i;
                found[hand][place] = together.of(patterns[place])->chanceBeyond(3.3);
            }
        });
    for (auto& hand : hands)
        hand.join();
    for (const auto& each : found)
        EXPECT_EQ(each, known);
    EXPECT_EQ(together.patterns(), forward.patterns());
    EXPECT_EQ(forward.of(patterns.front()), forward.of(patterns.front())); // kept, not made anew
}

/// What cannot be tested is never found.
TEST(JumpChances, seriesWithoutAPlaceHaveNoChance)
{
    EXPECT_EQ(JumpTable(jumpPatternOf(everyDays(3, 0), {})).chanceBeyond(9), 1.0);
    EXPECT_EQ(JumpTable(jumpPatternOf({}, {})).chanceBeyond(9), 1.0);
    EXPECT_LT(JumpTable(jumpPatternOf(everyDays(9, 365), {})).chanceBeyond(40), 1e-300);
}
