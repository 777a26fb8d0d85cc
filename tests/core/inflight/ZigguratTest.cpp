// Normal numbers by the million, held against the normal distribution: its moments, its shares in every layer and in the tail.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/inflight/Ziggurat.h"

namespace {

using namespace lubberline;

double below(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

std::vector<double> drawn(std::size_t count, std::uint64_t seed)
{
    const Ziggurat normal;
    FleetRandom random(seed);
    std::vector<double> numbers(count);
    for (double& one : numbers)
        one = normal(random);
    return numbers;
}

} // namespace

TEST(Ziggurat, hasTheSharesOfTheNormalDistribution)
{
    constexpr std::size_t kCount = 2'000'000;
    auto numbers = drawn(kCount, 7);
    std::sort(numbers.begin(), numbers.end());
    double apart = 0;
    for (std::size_t i = 0; i < kCount; ++i)
        apart = std::max(apart, std::abs(below(numbers[i]) - (static_cast<double>(i) + 0.5) / kCount));
    EXPECT_LT(apart, 1.63 / std::sqrt(static_cast<double>(kCount))) << "Kolmogorov and Smirnov, 1 %";
    for (const double limit : {2.0, 3.0, 3.442619855899, 4.0}) {
        const double expected = kCount * below(-limit);
        for (const double side : {-1.0, 1.0}) {
            const auto beyond = std::count_if(numbers.begin(), numbers.end(), [&](double x) { return side * x > limit; });
            EXPECT_NEAR(static_cast<double>(beyond), expected, 4.0 * std::sqrt(expected)) << limit << ' ' << side;
        }
    }
}

TEST(Ziggurat, hasTheMomentsOfTheNormalDistribution)
{
    std::array<double, 5> moments{};
    const auto numbers = drawn(1'000'000, 8);
    for (const double x : numbers)
        for (int order = 1; order <= 4; ++order)
            moments[static_cast<std::size_t>(order)] += std::pow(x, order) / static_cast<double>(numbers.size());
    EXPECT_NEAR(moments[1], 0.0, 4e-3);
    EXPECT_NEAR(moments[2], 1.0, 6e-3);
    EXPECT_NEAR(moments[3], 0.0, 16e-3);
    EXPECT_NEAR(moments[4], 3.0, 40e-3);
}

TEST(Ziggurat, drawsTheSameOfTheSameSeed)
{
    EXPECT_EQ(drawn(1000, 9), drawn(1000, 9));
    EXPECT_NE(drawn(1000, 9), drawn(1000, 10));
}
