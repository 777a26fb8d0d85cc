// Poisson's parameters to Smith's coefficients [P 7], against the swing that the model makes.

#include <gtest/gtest.h>

#include "core/deviation/SmithFit.h"
#include "core/sensor/PoissonSmith.h"
#include "tests/core/sensor/Chain.h"

namespace lubberline::test {
namespace {

std::array<double, 5> valuesOf(const ExactSmith& smith) { return {smith.A, smith.B, smith.C, smith.D, smith.E}; }

std::vector<Observation> levelSwing(const SensorModel& model, const MeridianField& field, int headings = 24)
{
    std::vector<Observation> swing;
    for (int i = 0; i < headings; ++i) {
        const auto reading = readLevel(model, field, 360.0 * i / headings);
        if (reading.compass)
            swing.push_back({reading.attitude.heading, *reading.compass});
    }
    return swing;
}

/// The sum of the terms of each coefficient.
std::array<double, 5> sumsOf(const std::vector<SmithTerm>& terms)
{
    std::array<double, 5> sums{};
    for (const auto& term : terms)
        sums[indexOf(term.coefficient)] += term.value;
    return sums;
}

TEST(PoissonSmith, formulasWrittenOut)
{
    SensorModel model;
    model.softIron << 0.03, 0.004, -0.012, -0.006, -0.02, 0.007, 0.01, 0.02, 0.05;
    model.hardIron_nT = {800, -450, 600};
    const MeridianField field = dipField(18500, 67);
    const auto smith = smithOf(model, field);
    ASSERT_TRUE(smith);
    const double lambda = 1 + (0.03 - 0.02) / 2, tanI = std::tan(toRadians(67));
    EXPECT_NEAR(smith->lambda, lambda, 1e-15);
    EXPECT_NEAR(smith->exact.A, (-0.006 - 0.004) / (2 * lambda), 1e-15);
    EXPECT_NEAR(smith->exact.B, (-0.012 * tanI + 800 / 18500.0) / lambda, 1e-15);
    EXPECT_NEAR(smith->exact.C, (0.007 * tanI - 450 / 18500.0) / lambda, 1e-15);
    EXPECT_NEAR(smith->exact.D, (0.03 + 0.02) / (2 * lambda), 1e-15);
    EXPECT_NEAR(smith->exact.E, (-0.006 + 0.004) / (2 * lambda), 1e-15);
    ASSERT_TRUE(smith->approximate);
    EXPECT_EQ(smith->approximate->D_rad, std::asin(smith->exact.D));
    EXPECT_TRUE(smith->whyNoApproximate.empty());
}

void expectSwingOf(const SensorModel& model, const MeridianField& field)
{
    const auto smith = smithOf(model, field);
    ASSERT_TRUE(smith) << smith.error().message.english();
    const auto swing = levelSwing(model, field);
    for (const auto& point : swing)
        EXPECT_NEAR(
            wrap180(deviationAt(smith->exact, point.magnetic).degrees() - deviationOf(point.magnetic, point.compass).degrees()), 0, 1e-9);
    const auto fit = fitExact(swing);
    ASSERT_TRUE(fit);
    ASSERT_EQ(fit->parameters, 5);
    const auto fitted = valuesOf(fit->smith()), expected = valuesOf(smith->exact);
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_NEAR(fitted[i], expected[i], 1e-9);
    const auto sums = sumsOf(smith->terms);
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_NEAR(sums[i], expected[i], 1e-12);
}

TEST(PoissonSmith, theLevelSwingOfRandomIron)
{
    std::mt19937 random(11);
    for (int i = 0; i < 200; ++i)
        expectSwingOf(randomModel(random, 0.08, 1500, 0), dipField(18500, -70 + 0.7 * i));
}

TEST(PoissonSmith, theLevelSwingOfAMisalignedSensor)
{
    std::mt19937 random(12);
    for (int i = 0; i < 200; ++i)
        expectSwingOf(randomModel(random, 0.08, 1500, 0.1), dipField(18500, -70 + 0.7 * i));
}

TEST(PoissonSmith, anExactFoldedCurveStillFollowsTheFormula)
{
    // Hard iron beyond H: the deviation runs through ±180°, and 𝔅 > 1 has no approximate coefficient.
    SensorModel model;
    model.hardIron_nT = {20000, 3000, 0};
    const MeridianField field = dipField(15000, 60);
    const auto smith = smithOf(model, field);
    ASSERT_TRUE(smith);
    EXPECT_GT(smith->exact.B, 1);
    EXPECT_FALSE(smith->approximate);
    EXPECT_NE(smith->whyNoApproximate.english().find("coefficient B"), std::string::npos) << smith->whyNoApproximate.english();
    for (const auto& point : levelSwing(model, field, 36))
        EXPECT_NEAR(
            wrap180(deviationAt(smith->exact, point.magnetic).degrees() - deviationOf(point.magnetic, point.compass).degrees()), 0, 1e-9);
}

TEST(PoissonSmith, termsNameWhereTheyComeFrom)
{
    SensorModel model;
    model.softIron << 0.03, 0.004, -0.012, -0.006, -0.02, 0, 0, 0, 0.05;
    model.hardIron_nT = {800, 0, 600};
    model.softConstant_nT = {0, 50, 0};
    model.circuits = {{"landing light", {14, -38, 9}, 20, true}, {"pitot heat", {14, -38, 9}, 20, false}};
    const auto smith = smithOf(model, dipField(18500, 67));
    ASSERT_TRUE(smith);
    const auto has = [&](Coefficient coefficient, const std::string& cause) {
        return std::any_of(smith->terms.begin(), smith->terms.end(),
            [&](const SmithTerm& term) { return term.coefficient == coefficient && term.cause.english() == cause; });
    };
    EXPECT_TRUE(has(Coefficient::A, "soft iron b"));
    EXPECT_TRUE(has(Coefficient::A, "soft iron d"));
    EXPECT_TRUE(has(Coefficient::B, "soft iron c (dip)"));
    EXPECT_TRUE(has(Coefficient::B, "hard iron P"));
    EXPECT_TRUE(has(Coefficient::B, "circuit landing light"));
    EXPECT_TRUE(has(Coefficient::C, "soft constant D2"));
    EXPECT_TRUE(has(Coefficient::C, "circuit landing light"));
    EXPECT_TRUE(has(Coefficient::D, "soft iron a"));
    EXPECT_TRUE(has(Coefficient::E, "soft iron d"));
    for (std::size_t i = 1; i < smith->terms.size(); ++i) {
        const auto &before = smith->terms[i - 1], &term = smith->terms[i];
        EXPECT_TRUE(before.coefficient < term.coefficient || std::abs(before.value) >= std::abs(term.value)) << "the largest of each first";
    }
    EXPECT_EQ(smith->terms.size(), 11u) << "what is zero, off or unseen by a level compass (k, R) has no term";
}

TEST(PoissonSmith, theMisalignmentOfAYawAloneIsMinusItsTangent)
{
    SensorModel model;
    model.misalignment.yaw_rad = 0.05;
    const auto smith = smithOf(model, dipField(18500, 67));
    ASSERT_TRUE(smith);
    EXPECT_NEAR(smith->lambda, std::cos(0.05), 1e-15);
    EXPECT_NEAR(smith->exact.A, -std::tan(0.05), 1e-15);
    ASSERT_EQ(smith->terms.size(), 1u);
    EXPECT_EQ(smith->terms[0].cause.english(), "misalignment");
    EXPECT_EQ(smith->exact.B, 0);
}

TEST(PoissonSmith, theMisalignmentOfALeanIsSemicircular)
{
    SensorModel model;
    model.misalignment.roll_rad = 0.01;
    const auto smith = smithOf(model, dipField(18500, 67));
    ASSERT_TRUE(smith);
    EXPECT_NEAR(smith->exact.C, 0.01 * std::tan(toRadians(67)), 1e-5);
    EXPECT_NEAR(smith->exact.D, std::pow(std::tan(0.005), 2), 1e-12);
}

TEST(PoissonSmith, permanentIronFadesWithHAndVerticalSoftIronFollowsTheDip)
{
    SensorModel hard, soft;
    hard.hardIron_nT = {1000, 0, 0};
    soft.softIron(0, 2) = 0.02;
    const auto B = [](const SensorModel& model, double H_nT, double dip_deg) { return smithOf(model, dipField(H_nT, dip_deg))->exact.B; };
    EXPECT_NEAR(B(hard, 10000, 20) / B(hard, 20000, 70), 2, 1e-12);
    EXPECT_NEAR(B(soft, 10000, 70), B(soft, 20000, 70), 1e-15);
    EXPECT_NEAR(B(soft, 20000, -70), -B(soft, 20000, 70), 1e-15);
}

TEST(PoissonSmith, directiveForceIsTheMeanOfTheFieldTowardsNorth)
{
    std::mt19937 random(13);
    const SensorModel model = randomModel(random, 0.1, 1000, 0.05);
    const MeridianField field = dipField(18500, 67);
    double towardsNorth_nT = 0;
    for (int i = 0; i < 36; ++i) {
        const auto reading = readLevel(model, field, 10.0 * i);
        towardsNorth_nT += reading.horizontal_nT * std::cos(reading.deviation->radians()) / 36;
    }
    EXPECT_NEAR(smithOf(model, field)->lambda, towardsNorth_nT / 18500, 1e-12);
}

} // namespace
} // namespace lubberline::test
