// Standard errors of readings that follow each other closely: held against the scatter of the coefficients over simulated logs.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/deviation/SmithFit.h"

namespace lubberline {
namespace {

/// A slow turn of 400 readings, noise correlated from one reading to the next, with a white part.
std::vector<Observation> turn(std::mt19937_64& engine, double rho, double slow_deg, double white_deg)
{
    std::normal_distribution<double> normal;
    double slow = slow_deg * normal(engine);
    std::vector<Observation> readings;
    for (int i = 0; i < 400; ++i) {
        slow = rho * slow + std::sqrt(1 - rho * rho) * slow_deg * normal(engine);
        const double psi = 0.9 * i, delta = -3 * std::sin(toRadians(psi)) + 2 * std::cos(toRadians(psi));
        readings.push_back(
            {MagneticHeading::fromDegrees(psi), CompassHeading::fromDegrees(psi - delta + slow + white_deg * normal(engine))});
    }
    return readings;
}

/// Standard deviation of a coefficient over simulated logs against the mean standard error that is stated.
void expectHonest(double rho, double slow_deg, double white_deg, double within)
{
    std::mt19937_64 engine(5);
    constexpr int kLogs = 120;
    std::array<double, 5> sum{}, squares{}, stated{};
    for (int log = 0; log < kLogs; ++log) {
        const auto fit = fitApproximate(turn(engine, rho, slow_deg, white_deg));
        ASSERT_TRUE(fit);
        for (std::size_t i = 0; i < 5; ++i) {
            sum[i] += *fit->value[i];
            squares[i] += *fit->value[i] * *fit->value[i];
            stated[i] += *fit->standardError[i] / kLogs;
        }
    }
    for (std::size_t i = 0; i < 5; ++i) {
        const double spread = std::sqrt(squares[i] / kLogs - sum[i] * sum[i] / kLogs / kLogs);
        EXPECT_LT(stated[i] / spread, within) << "coefficient " << i;
        EXPECT_GT(stated[i] / spread, 1 / within) << "coefficient " << i;
    }
}

TEST(SerialCorrelation, logsOfATurnStateTheErrorsThatTheyHave)
{
    expectHonest(0.93, 0.8, 0.0, 1.5);
    expectHonest(0.98, 0.8, 0.0, 1.4);
    expectHonest(0.98, 0.8, 0.1, 1.4); // a little of it white, as of a reference that is sent to a tenth of a degree
    expectHonest(0.97, 0.6, 0.4, 1.4); // a white part hides the slow one from the lag-one figure
}

TEST(SerialCorrelation, independentReadingsAreLeftAsTheyAre)
{
    std::mt19937_64 engine(11);
    int correlated = 0;
    for (int log = 0; log < 100; ++log)
        correlated += fitApproximate(turn(engine, 0.0, 0.0, 0.5))->lagOneCorrelation.has_value();
    EXPECT_LE(correlated, 2);
}

/// Eight thousand readings half a tenth of a degree apart, white noise of 0.3°: neighbours differ by their noise alone, which stands on both sides of
/// the exact equation. It passed for a drift that made A uncertain by 18°.
TEST(SerialCorrelation, whiteNoiseOfADenseLogIsNoDriftOfTheExactCoefficients)
{
    std::mt19937_64 engine(3);
    std::normal_distribution<double> normal;
    std::vector<Observation> readings;
    for (int i = 0; i < 8000; ++i) {
        const double psi = 0.045 * i, delta = -3 * std::sin(toRadians(psi)) + 2 * std::cos(toRadians(psi));
        readings.push_back({MagneticHeading::fromDegrees(psi), CompassHeading::fromDegrees(psi - delta + 0.3 * normal(engine))});
    }
    const auto exact = fitExact(readings);
    const auto approximate = fitApproximate(readings);
    ASSERT_TRUE(exact && approximate);
    EXPECT_FALSE(exact->lagOneCorrelation);
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_NEAR(*exact->standardError[i] / *approximate->standardError[i], 1.0, 0.2) << i;
}

} // namespace
} // namespace lubberline
