// A dipole is found where it is, with what it is, in the Earth's field and in noise; and what cannot be told is said.

#include "core/calibration/DipoleSource.h"

#include <gmock/gmock.h>

#include <random>

namespace lubberline {
namespace {

std::vector<StrayReading> readingsAround(const DipoleSource& source, double noise_nT, int count = 12)
{
    std::mt19937_64 random(4);
    std::normal_distribution<double> normal;
    std::vector<StrayReading> readings;
    for (int i = 0; i < count; ++i) {
        const double turn = 0.7 * i;
        const Eigen::Vector3d at(1.5 * std::cos(turn), 1.5 * std::sin(turn), 0.25 * (i % 4));
        readings.push_back(
            {at, source.uniform_nT + source.fieldAt_nT(at) + noise_nT * Eigen::Vector3d{normal(random), normal(random), normal(random)}});
    }
    return readings;
}

DipoleSource truth()
{
    DipoleSource source;
    source.at_m = {0.3, -0.4, 0.2};
    source.moment_A_m2 = {4, -2, 6};
    source.uniform_nT = {18000, 500, 43000};
    return source;
}

TEST(DipoleSource, onItsAxisTheFieldIsTwiceThatBeside)
{
    DipoleSource source;
    source.moment_A_m2 = {0, 0, 1};
    EXPECT_NEAR(source.fieldAt_nT({0, 0, 2}).z(), 200.0 / 8, 1e-9); // μ0/4π 2m/d³
    EXPECT_NEAR(source.fieldAt_nT({2, 0, 0}).z(), -100.0 / 8, 1e-9);
}

TEST(DipoleSource, isFoundWhereItIs)
{
    const auto exact = locateDipole(readingsAround(truth(), 0));
    ASSERT_TRUE(exact);
    EXPECT_LT((exact->at_m - truth().at_m).norm(), 1e-4);
    EXPECT_LT((exact->moment_A_m2 - truth().moment_A_m2).norm(), 1e-2);
    EXPECT_LT((exact->uniform_nT - truth().uniform_nT).norm(), 1);
    const auto noisy = locateDipole(readingsAround(truth(), 10));
    ASSERT_TRUE(noisy);
    EXPECT_NEAR(noisy->rms_nT, 10, 4);
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_LT(std::abs(noisy->at_m[axis] - truth().at_m[axis]), 4 * noisy->atError_m[axis]) << axis;
    EXPECT_NEAR(noisy->moment_A_m2.norm(), truth().moment_A_m2.norm(), 4 * noisy->momentError_A_m2);
}

/// Two sources were one dipole, sure to 3 cm where it left 283 nT of readings that are true to 5 nT, in a uniform field that was not there.
TEST(DipoleSource, twoSourcesAreNoOne)
{
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> even(-3, 3);
    std::normal_distribution<double> noise(0, 5);
    DipoleSource one, other;
    one.at_m = {1.2, -0.7, 0.4};
    one.moment_A_m2 = {20, -5, 30};
    other.at_m = -one.at_m;
    other.moment_A_m2 = 1.5 * one.moment_A_m2;
    std::vector<StrayReading> readings;
    while (readings.size() < 40) {
        const Eigen::Vector3d at(even(random), even(random), even(random));
        if ((at - one.at_m).norm() > 1 && (at - other.at_m).norm() > 1)
            readings.push_back(
                {at, one.fieldAt_nT(at) + other.fieldAt_nT(at) + Eigen::Vector3d(noise(random), noise(random), noise(random))});
    }
    const auto found = locateDipole(readings);
    ASSERT_TRUE(found) << describe(found.error());
    ASSERT_TRUE(found->two);
    EXPECT_NEAR(found->two->rms_nT, 5, 1);
    const bool turned = (found->two->at_m[0] - one.at_m).norm() > 1;
    EXPECT_LT((found->two->at_m[turned ? 1 : 0] - one.at_m).norm(), 0.02);
    EXPECT_LT((found->two->at_m[turned ? 0 : 1] - other.at_m).norm(), 0.02);
    EXPECT_LT(found->two->uniform_nT.norm(), 15);
    ASSERT_FALSE(found->warnings.empty());
    EXPECT_THAT(found->warnings[0].english(), testing::HasSubstr("more than one source"));
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_LT(std::abs(found->uniform_nT[axis]), 2 * found->uniformError_nT[axis]) << axis;
    // One source in noise is one, whatever the noise.
    for (unsigned seed = 1; seed <= 30; ++seed) {
        std::mt19937_64 draw(seed);
        std::vector<StrayReading> single;
        for (const StrayReading& reading : readings)
            single.push_back({reading.at_m, one.fieldAt_nT(reading.at_m) + 5 * Eigen::Vector3d(noise(draw), noise(draw), noise(draw))});
        const auto alone = locateDipole(single);
        ASSERT_TRUE(alone);
        EXPECT_FALSE(alone->two) << seed;
        EXPECT_TRUE(alone->warnings.empty()) << together(alone->warnings).english();
    }
}

/// Readings on a fine grid near a bar that is no dipole: what is left goes from reading to reading.
TEST(DipoleSource, whatIsLeftIsNoNoise)
{
    std::mt19937_64 random(6);
    std::normal_distribution<double> noise(0, 2);
    std::vector<StrayReading> readings;
    for (int i = 0; i < 6; ++i)
        for (int k = 0; k < 6; ++k) {
            const Eigen::Vector3d at(-1 + 0.4 * i, -1 + 0.4 * k, 0.6);
            Eigen::Vector3d field{noise(random), noise(random), noise(random)};
            for (int part = -10; part <= 10; ++part) {
                DipoleSource piece;
                piece.at_m = {0.08 * part, 0, 0};
                piece.moment_A_m2 = {0.5, 0, 0.2};
                field += piece.fieldAt_nT(at);
            }
            readings.push_back({at, field});
        }
    const auto found = locateDipole(readings);
    ASSERT_TRUE(found);
    ASSERT_FALSE(found->warnings.empty());
    EXPECT_TRUE(found->two || found->warnings[0].english().find("neighbouring readings") != std::string::npos);
}

TEST(DipoleSource, saysWhatItCannotTell)
{
    EXPECT_FALSE(locateDipole(readingsAround(truth(), 0, 4)));
    auto twice = readingsAround(truth(), 0);
    twice[3].at_m = twice[7].at_m;
    const auto same = locateDipole(twice);
    ASSERT_FALSE(same);
    EXPECT_THAT(describe(same.error()), testing::HasSubstr("readings 4 and 8"));
    DipoleSource none;
    none.uniform_nT = {18000, 0, 40000};
    EXPECT_FALSE(locateDipole(readingsAround(none, 20)));
    const auto near = locateDipole(readingsAround(truth(), 0), 1);
    ASSERT_TRUE(near);
    ASSERT_FALSE(near->warnings.empty());
    EXPECT_THAT(near->warnings[0].english(), testing::HasSubstr("three of its lengths"));
    EXPECT_EQ(installationDistances().front().least_m, 3.0);
}

} // namespace
} // namespace lubberline
