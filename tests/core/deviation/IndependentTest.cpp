// Fits, conversion, solve and harmonics against an implementation of their own, on simulated swings.

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "core/swing/Analysis.h"
#include "tests/core/deviation/Independent.h"

namespace lubberline::test {

namespace {

std::vector<Observation> observations(const std::vector<Pair>& readings)
{
    std::vector<Observation> result;
    for (const auto& [psi, z] : readings)
        result.push_back({MagneticHeading::fromRadians(static_cast<double>(psi)), CompassHeading::fromRadians(static_cast<double>(z))});
    return result;
}

std::array<Real, 5> randomCoefficients(std::mt19937& random, double size)
{
    std::uniform_real_distribution<double> uniform(-size, size);
    return {uniform(random) / 2, uniform(random), uniform(random), uniform(random) / 3, uniform(random) / 3};
}

void expectValues(const SmithFitReport& fit, const std::array<Real, 5>& expected, double tolerance)
{
    for (const Coefficient c : kCoefficients) {
        ASSERT_TRUE(fit.of(c)) << letterOf(c);
        EXPECT_NEAR(*fit.of(c), static_cast<double>(expected[indexOf(c)]), tolerance) << letterOf(c);
    }
}

} // namespace

TEST(Independent, exactCoefficientsOfASimulatedSwingComeBackEvenForLargeDeviations)
{
    std::mt19937 random(1);
    for (int trial = 0; trial < 200; ++trial) {
        const auto coefficients = randomCoefficients(random, 0.5); // deviations to some 40°
        const auto readings = observations(simulatedSwing(coefficients, 5 + trial % 30, 0, random, 0.1L * trial));
        const auto fit = fitExact(readings);
        ASSERT_TRUE(fit);
        if (fit->parameters == 5)
            expectValues(*fit, coefficients, 1e-9);
        EXPECT_LT(fit->maxAbsResidual_rad, 1e-9);
    }
}

TEST(Independent, bothFitsOfNoisyReadings)
{
    std::mt19937 random(2);
    for (int trial = 0; trial < 200; ++trial) {
        auto readings = simulatedSwing(randomCoefficients(random, 0.3), 8 + trial % 29, 0.02L, random, 0.37L);
        for (auto& reading : readings) // crews stop near the heading, not on it
            reading.magnetic += 0.02L * std::sin(static_cast<Real>(trial) + 7 * reading.magnetic);
        const auto taken = observations(readings);
        expectValues(*fitApproximate(taken), independentApproximate(readings), 1e-9);
        expectValues(*fitExact(taken), independentExact(readings), 1e-9);
    }
}

TEST(Independent, theOrderOfReadingsDoesNotCount)
{
    std::mt19937 random(3);
    auto readings = observations(simulatedSwing(randomCoefficients(random, 0.2), 16, 0.02L, random));
    const auto first = *analyse(readings);
    for (int trial = 0; trial < 20; ++trial) {
        std::shuffle(readings.begin(), readings.end(), random);
        const auto again = *analyse(readings);
        EXPECT_EQ(again.approximate.value, first.approximate.value); // to the last bit
        EXPECT_EQ(again.exact.value, first.exact.value);
        EXPECT_EQ(again.approximate.conditionNumber, first.approximate.conditionNumber);
        for (std::size_t k = 0; k < first.harmonics.orders.size(); ++k) {
            EXPECT_EQ(again.harmonics.orders[k].sin_rad, first.harmonics.orders[k].sin_rad);
            EXPECT_EQ(again.harmonics.orders[k].cos_rad, first.harmonics.orders[k].cos_rad);
        }
        EXPECT_NEAR(again.approximate.rms_rad, first.approximate.rms_rad, 1e-12);
        EXPECT_EQ(again.summary.maxAbsDeviationAt, first.summary.maxAbsDeviationAt);
    }
}

/// +4 and −4: the figure that is named is that of the heading that is named, in any order.
TEST(Independent, theLargestDeviationIsOfItsHeading)
{
    std::vector<Observation> readings;
    for (const auto& [magnetic, compass] :
        {std::pair(0.0, 0.0), {45.0, 49.0}, {90.0, 92.0}, {135.0, 131.0}, {225.0, 221.0}, {270.0, 270.0}})
        readings.push_back({MagneticHeading::fromDegrees(magnetic), CompassHeading::fromDegrees(compass)});
    for (int turn = 0; turn < 2; ++turn, std::reverse(readings.begin(), readings.end())) {
        const auto summary = analyse(readings)->summary;
        EXPECT_NEAR(toDegrees(summary.maxDeviation_rad), 4.0, 1e-9);
        EXPECT_NEAR(toDegrees(summary.minDeviation_rad), -4.0, 1e-9);
        EXPECT_EQ(summary.maxAbsDeviationAt.degrees(), 135.0);
    }
}

TEST(Independent, aMirroredSwingMirrorsTheSigns)
{
    // Turning the world about the north line: ψ → −ψ, δ → −δ. A, C, E change sign, B and D stay.
    std::mt19937 random(4);
    const auto readings = observations(simulatedSwing(randomCoefficients(random, 0.2), 12, 0.02L, random));
    std::vector<Observation> mirrored;
    for (const auto& reading : readings)
        mirrored.push_back(
            {MagneticHeading::fromDegrees(-reading.magnetic.degrees()), CompassHeading::fromDegrees(-reading.compass.degrees())});
    const auto a = fitApproximate(readings)->smith(), b = fitApproximate(mirrored)->smith();
    EXPECT_NEAR(b.A_rad, -a.A_rad, 1e-12);
    EXPECT_NEAR(b.B_rad, a.B_rad, 1e-12);
    EXPECT_NEAR(b.C_rad, -a.C_rad, 1e-12);
    EXPECT_NEAR(b.D_rad, a.D_rad, 1e-12);
    EXPECT_NEAR(b.E_rad, -a.E_rad, 1e-12);
}

TEST(Independent, harmonicsOfEquallySpacedHeadingsArePlainSums)
{
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    for (const int n : {4, 8, 12, 13, 16, 24, 32, 36}) {
        const double offset = 0.11 * n;
        std::vector<HarmonicSample> samples;
        for (int i = 0; i < n; ++i)
            samples.push_back({offset + 2 * kPi * i / n, 0.1 * normal(random)});
        const auto result = harmonics(samples);
        ASSERT_TRUE(result);
        EXPECT_EQ(result->method, HarmonicsMethod::Fft);
        EXPECT_EQ(result->orders.back().order, n / 2);
        for (const auto& order : result->orders) {
            if (order.nyquist)
                continue;
            Real s = 0, c = 0;
            for (const auto& sample : samples) {
                s += sample.deviation_rad * std::sin(Real(order.order) * sample.heading_rad);
                c += sample.deviation_rad * std::cos(Real(order.order) * sample.heading_rad);
            }
            const Real scale = order.order == 0 ? Real(1) / n : Real(2) / n;
            EXPECT_NEAR(order.sin_rad, static_cast<double>(s * scale), 1e-12);
            EXPECT_NEAR(order.cos_rad, static_cast<double>(c * scale), 1e-12);
        }
    }
}

TEST(Independent, harmonicsOfUnequalHeadingsFindWhatWasPutIn)
{
    std::mt19937 random(6);
    std::uniform_real_distribution<double> jitter(-0.05, 0.05);
    std::vector<HarmonicSample> samples;
    for (int i = 0; i < 24; ++i) {
        const double psi = 2 * kPi * i / 24 + jitter(random);
        samples.push_back(
            {psi, 0.01 + 0.2 * std::sin(psi) - 0.05 * std::cos(2 * psi) + 0.03 * std::sin(3 * psi) + 0.02 * std::cos(4 * psi)});
    }
    const auto result = harmonics(samples);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->method, HarmonicsMethod::LeastSquares);
    ASSERT_GE(result->orders.size(), 5u);
    EXPECT_NEAR(result->orders[0].cos_rad, 0.01, 1e-9);
    EXPECT_NEAR(result->orders[1].sin_rad, 0.2, 1e-9);
    EXPECT_NEAR(result->orders[2].cos_rad, -0.05, 1e-9);
    EXPECT_NEAR(result->orders[3].sin_rad, 0.03, 1e-9);
    EXPECT_NEAR(result->orders[4].cos_rad, 0.02, 1e-9);
}

TEST(Independent, theNyquistOrderIsACosineAndNotDoubled)
{
    std::vector<HarmonicSample> samples;
    for (int i = 0; i < 8; ++i)
        samples.push_back({2 * kPi * i / 8, 0.03 * std::cos(4 * 2 * kPi * i / 8)});
    const auto order = harmonics(samples)->orders.back();
    EXPECT_TRUE(order.nyquist);
    EXPECT_NEAR(order.cos_rad, 0.03, 1e-15);
    EXPECT_EQ(order.sin_rad, 0.0);
}

TEST(Independent, approximateAndExactConvertBothWays)
{
    std::mt19937 random(7);
    for (int trial = 0; trial < 100; ++trial) {
        const auto c = randomCoefficients(random, 0.6);
        const ExactSmith exact{static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2]), static_cast<double>(c[3]),
            static_cast<double>(c[4])};
        const auto approximate = toApproximate(exact);
        ASSERT_TRUE(approximate);
        // [P 5] written out
        EXPECT_NEAR(approximate->B_rad, std::asin(exact.B / (1 + 0.5 * std::sin(approximate->D_rad))), 1e-15);
        EXPECT_NEAR(approximate->C_rad, std::asin(exact.C / (1 - 0.5 * std::sin(approximate->D_rad))), 1e-15);
        const ExactSmith back = toExact(*approximate);
        EXPECT_NEAR(back.A, exact.A, 1e-14);
        EXPECT_NEAR(back.B, exact.B, 1e-14);
        EXPECT_NEAR(back.C, exact.C, 1e-14);
        EXPECT_NEAR(back.D, exact.D, 1e-14);
        EXPECT_NEAR(back.E, exact.E, 1e-14);
    }
    EXPECT_EQ(toApproximate({0, 1.2, 0, 0, 0}).error().code, ErrorCode::Numeric);
}

TEST(Independent, theCompassIsSolvedBackToTheMagneticHeading)
{
    std::mt19937 random(8);
    for (int trial = 0; trial < 50; ++trial) {
        const auto c = randomCoefficients(random, 0.4);
        const ExactSmith smith{static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2]), static_cast<double>(c[3]),
            static_cast<double>(c[4])};
        for (double heading = 0; heading < 360; heading += 22.5) {
            const auto psi = MagneticHeading::fromDegrees(heading);
            const auto solved = magneticHeadingFor(smith, toCompass(psi, deviationAt(smith, psi)));
            ASSERT_TRUE(solved) << describe(solved.error());
            EXPECT_NEAR(wrap180(solved->degrees() - heading), 0.0, 1e-9);
        }
    }
}

TEST(Independent, aFoldedCurveIsAnErrorThatNamesTheHeadings)
{
    const ExactSmith folded{0, 1.5, 0, 0, 0}; // the field at the sensor turns the other way round: |𝔅| > 1
    const auto solved = magneticHeadingFor(folded, CompassHeading::fromDegrees(10));
    ASSERT_FALSE(solved);
    EXPECT_EQ(solved.error().code, ErrorCode::Numeric);
    EXPECT_NE(solved.error().message.english().find("°"), std::string::npos);
}

TEST(Independent, ninetyFivePercentBandsHoldTheTruthThatOften)
{
    std::mt19937 random(9);
    int inside = 0, asked = 0;
    for (int trial = 0; trial < 1000; ++trial) {
        // Approximate truth, so that the model is right and only the noise differs.
        std::vector<Observation> readings;
        std::normal_distribution<double> noise(0, 0.01);
        const ApproximateSmith smith{0.01, 0.1, -0.05, 0.02, 0.01};
        for (int i = 0; i < 12; ++i) {
            const auto z = CompassHeading::fromDegrees(30.0 * i);
            readings.push_back({toMagnetic(z, Deviation::fromRadians(deviationAt(smith, z).radians() + noise(random))), z});
        }
        const auto fit = *fitApproximate(readings);
        for (const double heading : {10.0, 100.0, 250.0}) {
            const auto z = CompassHeading::fromDegrees(heading);
            const double off = deviationAt(fit.smith(), z).radians() - deviationAt(smith, z).radians();
            inside += std::abs(off) <= *bandHalfWidth_rad(fit, z);
            ++asked;
        }
    }
    EXPECT_NEAR(static_cast<double>(inside) / asked, 0.95, 0.02);
}

} // namespace lubberline::test
