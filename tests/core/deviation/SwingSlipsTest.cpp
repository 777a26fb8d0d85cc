// Slips seeded into whole swings of eight readings to 1°: found at the promised rates, and readings that are right left alone.
// The rates are of simulated swings with a fixed seed: no luck of the day in them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <random>
#include <utility>

#include "core/deviation/SwingSlips.h"

namespace lubberline {
namespace {

struct Rates {
    double named = 0, alarms = 0, innocent = 0;
    int swings = 0;
};

/// The coefficients that the swing before gave.
using Last = std::function<ApproximateSmith(ApproximateSmith now, std::mt19937_64& engine)>;

/// @param slip what the reading becomes; the same figure: this swing is left out. @param last empty: there is no history.
Rates ratesOf(double scatter_deg, int readings, const std::function<double(double compass_deg, double magnetic_deg, int sign)>& slip,
    const Last& last = {})
{
    std::mt19937_64 engine(20261126), lastEngine(7);
    std::normal_distribution<double> noise;
    std::uniform_real_distribution<double> within(-1.0, 1.0);
    Rates rates;
    for (int swing = 0; swing < 150; ++swing) {
        const ApproximateSmith smith{toRadians(0.5 * within(engine)), toRadians(6 * within(engine)), toRadians(6 * within(engine)),
            toRadians(2.5 * within(engine)), toRadians(1.0 * within(engine))};
        std::vector<Observation> observations;
        for (int i = 0; i < readings; ++i) {
            const auto magnetic = MagneticHeading::fromDegrees(360.0 * i / readings);
            const double compass = compassHeadingFor(smith, magnetic)->degrees() + scatter_deg * noise(engine);
            observations.push_back({magnetic, CompassHeading::fromDegrees(std::round(compass))});
        }
        const auto wrong = static_cast<std::size_t>(engine() % static_cast<unsigned>(readings));
        auto& reading = observations[wrong];
        const double written = wrap360(slip(reading.compass.degrees(), reading.magnetic.degrees(), engine() % 2 ? 1 : -1));
        const bool slipped = written != reading.compass.degrees();
        reading.compass = CompassHeading::fromDegrees(written);
        const auto history = last ? std::optional(curveAfter(last(smith, lastEngine))) : std::nullopt;
        const auto found = findSlips(observations, 1.0, history).slips;
        bool named = false, innocent = false;
        for (const auto& one : found) {
            const bool maybe = one.reading == wrong || std::count(one.orReadings.begin(), one.orReadings.end(), wrong) > 0;
            named |= slipped && one.reading == wrong;
            innocent |= slipped ? !maybe : one.orReadings.empty(); // of two that cannot be told apart neither is blamed
        }
        rates.named += named;
        rates.innocent += innocent;
        rates.alarms += !found.empty();
        ++rates.swings;
    }
    for (double* rate : {&rates.named, &rates.alarms, &rates.innocent})
        *rate /= rates.swings;
    return rates;
}

double offBy(double compass_deg, double off_deg) { return compass_deg + off_deg; }

TEST(SwingSlips, eightReadingsNameASlipOfTenOrOfHalfACircle)
{
    for (const double scatter : {0.3, 0.5}) {
        for (const double off : {8.0, 10.0, 100.0, 180.0}) {
            const auto rates = ratesOf(scatter, 8, [off](double compass, double, int sign) { return offBy(compass, sign * off); });
            EXPECT_GE(rates.named, 0.97) << scatter << " " << off;
            EXPECT_LE(rates.innocent, 0.02) << scatter << " " << off;
        }
    }
    const auto coarse = ratesOf(1.0, 8, [](double compass, double, int sign) { return offBy(compass, 8.0 * sign); });
    EXPECT_GE(coarse.named, 0.94);
    EXPECT_LE(coarse.innocent, 0.02);
}

TEST(SwingSlips, eightReadingsNameMostSlipsOfFiveDegrees)
{
    const auto slip = [](double compass, double, int sign) { return offBy(compass, 5.0 * sign); };
    EXPECT_GE(ratesOf(0.3, 8, slip).named, 0.96);
    EXPECT_GE(ratesOf(0.5, 8, slip).named, 0.80);
}

TEST(SwingSlips, aDeviationAppliedTheWrongWayIsNamed)
{
    const auto rates = ratesOf(0.5, 12, [](double compass, double magnetic, int) {
        const double turned = 2.0 * magnetic - compass;
        return std::abs(wrap180(turned - compass)) < 8.0 ? compass : turned;
    });
    EXPECT_LE(rates.alarms - rates.named, 0.01); // what is named is what slipped
}

TEST(SwingSlips, rightReadingsAreLeftAlone)
{
    const auto nothing = [](double compass, double, int) { return compass; };
    EXPECT_EQ(ratesOf(0.3, 8, nothing).alarms, 0.0);
    EXPECT_LE(ratesOf(0.5, 8, nothing).alarms, 0.02);
    const auto coarse = ratesOf(1.0, 8, nothing);
    EXPECT_LE(coarse.alarms, 0.12); // the price of finding 5° at 0.3°: a look costs seconds
    EXPECT_LE(coarse.innocent, 0.02);
    for (const int many : {12, 16, 24, 36})
        EXPECT_LE(ratesOf(1.0, many, nothing).alarms, 0.05) << many;
    EXPECT_LE(ratesOf(0.5, 24, nothing).alarms, 0.02);
}

ApproximateSmith asBefore(ApproximateSmith smith, std::mt19937_64& engine)
{
    std::normal_distribution<double> normal;
    const auto moved = [&](double& coefficient_rad, double by_deg) { coefficient_rad += toRadians(by_deg * normal(engine)); };
    moved(smith.A_rad, 0.3);
    moved(smith.B_rad, 1.0);
    moved(smith.C_rad, 1.0);
    moved(smith.D_rad, 0.2);
    moved(smith.E_rad, 0.2);
    return smith;
}

/// Lightning, or another engine.
ApproximateSmith quiteOther(ApproximateSmith smith, std::mt19937_64&)
{
    smith.B_rad += toRadians(9.0);
    smith.C_rad -= toRadians(6.0);
    return smith;
}

TEST(SwingSlips, aHistoryFindsMoreAndBlamesNoMore)
{
    for (const auto& [scatter, off] : {std::pair(0.5, 5.0), {1.0, 8.0}, {0.3, 10.0}}) {
        const auto slip = [off = off](double compass, double, int sign) { return offBy(compass, sign * off); };
        const auto without = ratesOf(scatter, 8, slip), with = ratesOf(scatter, 8, slip, asBefore);
        EXPECT_GE(with.named, without.named) << scatter;
        EXPECT_LE(with.innocent, 0.02) << scatter;
        EXPECT_GE(ratesOf(scatter, 8, slip, quiteOther).named, without.named - 0.02) << scatter;
    }
    const auto nothing = [](double compass, double, int) { return compass; };
    for (const double scatter : {0.3, 0.5, 1.0}) {
        const auto without = ratesOf(scatter, 8, nothing);
        EXPECT_LE(ratesOf(scatter, 8, nothing, asBefore).alarms, without.alarms) << scatter;
        EXPECT_LE(ratesOf(scatter, 8, nothing, quiteOther).alarms, without.alarms + 0.01) << scatter;
    }
}

TEST(SwingSlips, whatWasMeantIsNamedWithItsProbability)
{
    std::vector<Observation> readings;
    for (int i = 0; i < 12; ++i)
        readings.push_back({MagneticHeading::fromDegrees(30 * i), CompassHeading::fromDegrees(30 * i)});
    readings[9].compass = CompassHeading::fromDegrees(207); // 270 with its digits swapped
    const auto found = findSlips(readings, 1.0).slips;
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].reading, 9u);
    ASSERT_FALSE(found[0].candidates.empty());
    EXPECT_EQ(found[0].candidates[0].slip, Slip::SwappedDigits);
    EXPECT_EQ(found[0].candidates[0].meant_deg, 270.0);
    EXPECT_GT(found[0].candidates[0].probability, 0.9);
    EXPECT_TRUE(found[0].orReadings.empty());
}

TEST(SwingSlips, twoSlipsOfTwelveAreBothFound)
{
    std::vector<Observation> readings;
    for (int i = 0; i < 12; ++i)
        readings.push_back({MagneticHeading::fromDegrees(30 * i), CompassHeading::fromDegrees(30 * i - 2 * std::round(std::sin(i)))});
    readings[2].compass = CompassHeading::fromDegrees(readings[2].compass.degrees() + 10);
    readings[7].compass = CompassHeading::fromDegrees(readings[7].compass.degrees() + 180);
    std::vector<std::size_t> named;
    for (const auto& one : findSlips(readings, 1.0).slips)
        named.push_back(one.reading);
    std::sort(named.begin(), named.end());
    EXPECT_EQ(named, (std::vector<std::size_t>{2, 7}));
}

/// Published: Evans, Elementary Manual for the Deviation of the Compass: four intercardinals, all right, B 21° and D 6.8°.
TEST(SwingSlips, fourReadingsOfALargeCurveBlameNobody)
{
    const std::vector<Observation> readings{{MagneticHeading::fromDegrees(69.0 + 10.0 / 60), CompassHeading::fromDegrees(45)},
        {MagneticHeading::fromDegrees(141), CompassHeading::fromDegrees(135)},
        {MagneticHeading::fromDegrees(214.5), CompassHeading::fromDegrees(225)},
        {MagneticHeading::fromDegrees(295.5), CompassHeading::fromDegrees(315)}};
    const auto found = findSlips(readings, 1.0);
    EXPECT_TRUE(found.slips.empty());
    EXPECT_GT(*found.seenFrom_deg, 20.0);
}

/// Whatever the coefficients, four or five readings are explained by them: D and E to 8°, B and C to 20°.
TEST(SwingSlips, fourOrFiveReadingsOfAnyCurveBlameNobody)
{
    std::mt19937_64 engine(20261128);
    std::uniform_real_distribution<double> within(-1.0, 1.0);
    int alarms = 0;
    for (int swing = 0; swing < 200; ++swing) {
        const ApproximateSmith smith{toRadians(2 * within(engine)), toRadians(20 * within(engine)), toRadians(20 * within(engine)),
            toRadians(8 * within(engine)), toRadians(8 * within(engine))};
        const int count = 4 + swing % 2;
        const double first_deg = swing % 4 < 2 ? 0.0 : 45.0;
        std::vector<Observation> readings;
        for (int i = 0; i < count; ++i) {
            const auto magnetic = MagneticHeading::fromDegrees(first_deg + (count == 4 ? 90.0 * i : 72.0 * i));
            readings.push_back({magnetic, CompassHeading::fromDegrees(std::round(compassHeadingFor(smith, magnetic)->degrees()))});
        }
        alarms += !findSlips(readings, 1.0).slips.empty();
    }
    EXPECT_LE(alarms, 4);
}

/// But no compass deviates by half a circle on one heading alone.
TEST(SwingSlips, aReciprocalAmongFourIsNamed)
{
    for (const std::size_t wrong : {0u, 1u, 2u, 3u}) {
        std::vector<Observation> readings;
        for (int i = 0; i < 4; ++i)
            readings.push_back({MagneticHeading::fromDegrees(90.0 * i), CompassHeading::fromDegrees(90.0 * i + (i % 2 ? 2 : -1))});
        readings[wrong].compass = CompassHeading::fromDegrees(readings[wrong].compass.degrees() + 180.0);
        const auto found = findSlips(readings, 1.0).slips;
        ASSERT_FALSE(found.empty()) << wrong;
        EXPECT_EQ(found[0].reading, wrong);
    }
}

/// The index is no slip: every reading has it.
TEST(SwingSlips, aMountThatIsOutSlipsNobody)
{
    std::vector<Observation> readings;
    for (int i = 0; i < 8; ++i)
        readings.push_back({MagneticHeading::fromDegrees(45 * i), CompassHeading::fromDegrees(45 * i + 180)});
    EXPECT_TRUE(findSlips(readings, 1.0).slips.empty());
}

TEST(SwingSlips, howSmallASlipCouldPassIsSaid)
{
    const auto seenFrom = [](int count) {
        std::vector<Observation> readings;
        for (int i = 0; i < count; ++i)
            readings.push_back(
                {MagneticHeading::fromDegrees(360.0 * i / count), CompassHeading::fromDegrees(std::round(360.0 * i / count))});
        return findSlips(readings, 1.0).seenFrom_deg;
    };
    EXPECT_FALSE(seenFrom(2));
    EXPECT_GT(*seenFrom(4), 8.0);
    EXPECT_LT(*seenFrom(8), 6.0);
    EXPECT_LT(*seenFrom(24), *seenFrom(8));
}

/// The compass figures of 120 and 150 stand in each other's row: one exchange, and not the digits that happen to come near.
TEST(SwingSlips, figuresInEachOthersRowAreNamedSo)
{
    std::mt19937_64 engine(7);
    std::normal_distribution<double> normal;
    int named = 0, swings = 0;
    for (; swings < 40; ++swings) {
        const ApproximateSmith smith{0.0, toRadians(4 * normal(engine)), toRadians(4 * normal(engine)), toRadians(normal(engine)), 0.0};
        std::vector<Observation> readings;
        for (int i = 0; i < 12; ++i) {
            const double magnetic = 30.0 * i;
            double compass = magnetic;
            for (int k = 0; k < 20; ++k)
                compass = magnetic - deviationAt(smith, CompassHeading::fromDegrees(wrap360(compass))).degrees();
            readings.push_back(
                {MagneticHeading::fromDegrees(magnetic), CompassHeading::fromDegrees(wrap360(std::round(compass + 0.3 * normal(engine))))});
        }
        std::swap(readings[4].compass, readings[5].compass);
        const auto found = findSlips(readings, 1.0);
        if (found.slips.size() != 2)
            continue;
        const auto& one = found.slips[0].reading == 4 ? found.slips[0] : found.slips[1];
        named += one.reading == 4 && !one.candidates.empty() && one.candidates[0].slip == Slip::WrongRow
            && one.candidates[0].meant_deg == 150.0 && one.candidates[0].probability > 0.9;
    }
    EXPECT_GE(named, 0.95 * swings);
}

} // namespace
} // namespace lubberline
