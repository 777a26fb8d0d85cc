// What each reading adds to a coefficient adds up to the coefficient.

#include <gtest/gtest.h>

#include "core/deviation/Derivation.h"

namespace lubberline {
namespace {

/// The check swing of the worksheet examples, question 1.
std::vector<Observation> worksheet()
{
    std::vector<Observation> readings;
    for (const auto& [magnetic_deg, compass_deg] :
        {std::pair{317.0, 316.0}, {0.0, 358.0}, {47.0, 42.0}, {93.0, 89.0}, {135.0, 134.0}, {179.0, 177.0}, {225.0, 220.0}, {273.0, 269.0}})
        readings.push_back({MagneticHeading::fromDegrees(magnetic_deg), CompassHeading::fromDegrees(compass_deg)});
    return readings;
}

/// A compass mounted the wrong way round.
std::vector<Observation> turned()
{
    auto readings = worksheet();
    for (auto& reading : readings)
        reading.compass = CompassHeading::fromDegrees(reading.compass.degrees() + 180.0);
    return readings;
}

TEST(Derivation, sumsAreTheCoefficients)
{
    for (const auto& readings : {worksheet(), turned()}) {
        const auto approximate = fitApproximate(readings);
        const auto exact = fitExact(readings);
        ASSERT_TRUE(approximate && exact);
        for (const Coefficient which : kCoefficients) {
            EXPECT_NEAR(derivationOf(readings, *approximate, which)->sum, *approximate->of(which), 1e-12);
            EXPECT_NEAR(derivationOf(readings, *exact, which)->sum, *exact->of(which), 1e-12);
            EXPECT_EQ(derivationOf(readings, *approximate, which)->terms.size(), readings.size());
        }
    }
}

TEST(Derivation, rulesOfTheWorksheet)
{
    const auto readings = worksheet();
    const auto rules = pointRules(readings);
    ASSERT_TRUE(rules);
    // B = (δE − δW)/2 = (4 − 4)/2 = 0; C = (δN − δS)/2 = (2 − 2)/2 = 0; A of eight points: the mean of 1 2 5 4 1 2 5 4
    EXPECT_NEAR(toDegrees(derivationOf(readings, *rules, Coefficient::A)->sum), 3.0, 1e-9);
    EXPECT_NEAR(toDegrees(derivationOf(readings, *rules, Coefficient::B)->sum), 0.0, 1e-9);
    EXPECT_NEAR(toDegrees(derivationOf(readings, *rules, Coefficient::D)->sum), *rules->D_rad * kDegreesPerRadian, 1e-9);
    EXPECT_EQ(derivationOf(readings, *rules, Coefficient::B)->terms.size(), 2u);
}

TEST(Derivation, whatCannotBeToldHasNone)
{
    auto readings = worksheet();
    readings = {readings[1], readings[3], readings[5], readings[7]};
    const auto rules = pointRules(readings);
    ASSERT_TRUE(rules);
    EXPECT_FALSE(derivationOf(readings, *rules, Coefficient::D));
    EXPECT_NEAR(toDegrees(derivationOf(readings, *rules, Coefficient::A)->sum), 3.0, 1e-9);
    const auto fit = fitApproximate(readings);
    ASSERT_TRUE(fit);
    EXPECT_EQ(derivationOf(readings, *fit, Coefficient::D).has_value(), fit->of(Coefficient::D).has_value());
}

TEST(Derivation, readingsOnOneHeadingShareItsWeight)
{
    auto readings = worksheet();
    readings.push_back({readings[3].magnetic, CompassHeading::fromDegrees(91.0)});
    const auto rules = pointRules(readings);
    ASSERT_TRUE(rules);
    EXPECT_NEAR(derivationOf(readings, *rules, Coefficient::B)->sum, rules->B_rad, 1e-12);
}

} // namespace
} // namespace lubberline
