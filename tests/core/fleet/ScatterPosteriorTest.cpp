// Small fleets tell badly how much their compasses wander: intervals of drift must hold all the same, and what wandered is no jump.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "core/fleet/FleetRandom.h"
#include "core/fleet/SeriesFit.h"
#include "tests/core/fleet/SimulatedFleet.h"

using namespace lubberline;
using namespace lubberline::test;

namespace {

/// Eight aircraft of six swings, whose coefficients wander by so much in the root of a year and do not drift.
Truth wandering(std::uint32_t seed, double wander_deg, std::function<double(int, int, std::size_t)> more = {})
{
    Truth truth;
    truth.seed = seed;
    truth.aircraft = 8;
    truth.swings = 6;
    auto random = std::make_shared<FleetRandom>(seed);
    auto level = std::make_shared<FiveTerms>();
    truth.extra = [=](int a, int s, std::size_t c) {
        (*level)[c] = s == 0 ? 0.0 : (*level)[c] + wander_deg * random->normal();
        return (*level)[c] + (more ? more(a, s, c) : 0.0);
    };
    return truth;
}

struct Held {
    int inside = 0, all = 0;
};
Held heldOver(int fleets, double wander_deg)
{
    Held held;
    for (int i = 0; i < fleets; ++i) {
        const SimulatedFleet simulated(wandering(static_cast<std::uint32_t>(100 + i), wander_deg));
        const auto report = reported(simulated.fleet, {.variance = false});
        for (const auto& history : report.changes.driftOf)
            for (const auto& drift : history) {
                held.all += 1;
                held.inside += drift->interval95.low <= 0 && drift->interval95.high >= 0 ? 1 : 0;
            }
    }
    return held;
}

} // namespace

TEST(ScatterPosterior, intervalsOfDriftHoldWithWanderAndWithout)
{
    // With a wander taken for none, 60 of 100 held.
    const Held wander = heldOver(10, 0.4), still = heldOver(5, 0.0);
    EXPECT_EQ(wander.all, 400);
    EXPECT_GE(wander.inside, 0.86 * wander.all);
    EXPECT_GE(still.inside, 0.93 * still.all);
}

TEST(ScatterPosterior, jumpsAreFoundAndWhatWanderedIsNone)
{
    int found = 0, wrong = 0;
    constexpr int fleets = 8;
    for (int i = 0; i < fleets; ++i) {
        const auto jump = [](int a, int s, std::size_t c) { return a == 3 && c == 1 && s >= 3 ? 3.0 : 0.0; };
        const SimulatedFleet simulated(wandering(static_cast<std::uint32_t>(200 + i), 0.3, jump));
        for (const auto& each : reported(simulated.fleet, {.variance = false}).changes.jumps) {
            const bool right = each.compass == 3 && each.coefficient == 1 && each.change_deg > 0;
            (right ? found : wrong) += 1;
            if (right) {
                EXPECT_NEAR(each.change_deg, 3.0, 4 * each.standardError_deg);
            }
        }
    }
    EXPECT_GE(found, fleets - 2);
    EXPECT_LE(wrong, 3);
}

/// Of equal variances, levels and trend are those of least squares.
TEST(SeriesFit, isLeastSquaresWhereNothingWanders)
{
    const std::vector<double> values{1.0, 3.0, 2.0, 5.0, 4.0};
    std::vector<DatedValue> series;
    for (std::size_t i = 0; i < values.size(); ++i)
        series.push_back({static_cast<int>(1461 * i), values[i], 0.04});
    const auto fit = fitSeries(series, {0.05, 0}, true, {});
    ASSERT_TRUE(fit.perYear);
    EXPECT_NEAR(*fit.perYear, 0.8 / 4, 1e-12); // Σ(i − 2)(y − 3) / Σ(i − 2)² = 8/10 in four years
    EXPECT_NEAR(fit.perYearError, 0.3 / std::sqrt(10.0) / 4, 1e-12);
    EXPECT_EQ(fit.freedom, 3);
    // Residuals −0.4 0.8 −1 1.2 −0.6: 3.6, of a variance of 0.09; determinants 0.09⁵ and 5·10·16/0.09² (years)
    EXPECT_NEAR(fit.logLikelihood, -0.5 * (3.6 / 0.09 + 5 * std::log(0.09) + std::log(5.0 * 10 * 16) - 2 * std::log(0.09)), 1e-9);
    EXPECT_EQ(fit.places.size(), 4u);
}

/// A level that wanders from one exact figure to the next: its trend is that from the first to the last.
TEST(SeriesFit, trendOfARandomWalkIsFromFirstToLast)
{
    const std::vector<double> values{0.0, 3.0, 2.0, 5.0};
    std::vector<DatedValue> series;
    for (std::size_t i = 0; i < values.size(); ++i)
        series.push_back({static_cast<int>(1461 * i), values[i], 1e-9});
    const auto fit = fitSeries(series, {0, 0.25}, true, {});
    ASSERT_TRUE(fit.perYear);
    EXPECT_NEAR(*fit.perYear, 5.0 / 12, 1e-5);
    EXPECT_NEAR(fit.perYearError, std::sqrt(0.25 / 12), 1e-5);
}
