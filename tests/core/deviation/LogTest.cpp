// A log of a turn has so many readings that its results are found by shorter ways: they are the same.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/algebra/LeastSquares.h"
#include "core/deviation/Harmonics.h"
#include "core/deviation/SmithFit.h"

namespace lubberline {
namespace {

std::vector<Observation> logOf(int readings, double rho)
{
    std::mt19937_64 engine(7);
    std::normal_distribution<double> normal;
    const ExactSmith smith{0.01, 0.08, -0.05, 0.02, -0.01};
    double slow_deg = 0;
    std::vector<Observation> log;
    for (int i = 0; i < readings; ++i) {
        slow_deg = rho * slow_deg + std::sqrt(1 - rho * rho) * 0.6 * normal(engine);
        const auto magnetic = MagneticHeading::fromDegrees(0.73 * i + 0.3 * normal(engine));
        const double compass_deg = toCompass(magnetic, deviationAt(smith, magnetic)).degrees();
        log.push_back({magnetic, CompassHeading::fromDegrees(compass_deg + slow_deg + 0.2 * normal(engine))});
    }
    return log;
}

TEST(Log, harmonicsBySumsAreThoseOfLeastSquares)
{
    std::vector<HarmonicSample> samples;
    for (const auto& reading : logOf(1500, 0.5))
        samples.push_back({reading.magnetic.radians(), deviationOf(reading.magnetic, reading.compass).radians()});
    const auto found = harmonics(samples);
    ASSERT_TRUE(found);
    const int highest = found->highestResolvable;
    ASSERT_GT(highest, 40);
    Eigen::MatrixXd design(static_cast<Eigen::Index>(samples.size()), 2 * highest + 1);
    Eigen::VectorXd observed(design.rows());
    for (Eigen::Index i = 0; i < design.rows(); ++i) {
        const auto& sample = samples[static_cast<std::size_t>(i)];
        observed(i) = sample.deviation_rad;
        design(i, 0) = 1;
        for (int k = 1; k <= highest; ++k) {
            design(i, 2 * k - 1) = std::sin(k * sample.heading_rad);
            design(i, 2 * k) = std::cos(k * sample.heading_rad);
        }
    }
    EXPECT_NEAR(found->conditionNumber, conditionNumber(singularValues(design)), 1e-9);
    const auto solution = solveLeastSquares(design, observed).solution;
    EXPECT_NEAR(found->orders[0].cos_rad, solution(0), 1e-12);
    for (int k = 1; k <= highest; ++k) {
        EXPECT_NEAR(found->orders[static_cast<std::size_t>(k)].sin_rad, solution(2 * k - 1), 1e-12) << k;
        EXPECT_NEAR(found->orders[static_cast<std::size_t>(k)].cos_rad, solution(2 * k), 1e-12) << k;
    }
}

TEST(Log, aGapLeavesFewerOrdersHoweverTheyAreFound)
{
    std::vector<HarmonicSample> few, many;
    for (const int samples : {900, 1800}) // below and above the size from which sums are used
        for (int i = 0; i < samples; ++i) {
            const double heading_rad = toRadians(20.0 + 320.0 * (i + 0.3 * std::sin(i)) / samples);
            (samples == 900 ? few : many).push_back({heading_rad, 0.1 * std::sin(heading_rad)});
        }
    const auto byRows = harmonics(few), bySums = harmonics(many);
    ASSERT_TRUE(byRows && bySums);
    EXPECT_EQ(byRows->highestResolvable, bySums->highestResolvable);
    EXPECT_NEAR(bySums->orders[1].sin_rad, 0.1, 1e-12);
}

TEST(Log, withoutErrorsTheFitIsTheSame)
{
    const auto readings = logOf(1200, 0.9);
    const auto whole = fitApproximate(readings), bare = fitApproximate(readings, {.uncertainty = false});
    ASSERT_TRUE(whole && bare);
    EXPECT_EQ(whole->value, bare->value);
    EXPECT_EQ(whole->residual_rad, bare->residual_rad);
    EXPECT_FALSE(bare->intervalFactor);
}

} // namespace
} // namespace lubberline
