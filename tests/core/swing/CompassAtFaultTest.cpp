// A compass that is stuck, mirrored, or out as a whole is named before any coefficient; what fits no five coefficients is said.

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "core/swing/Analysis.h"
#include "core/swing/Card.h"
#include "core/swing/CompassAtFault.h"

namespace lubberline {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

std::vector<Observation> around(int count, const std::function<double(double psi_deg)>& compass_deg)
{
    std::vector<Observation> readings;
    for (int i = 0; i < count; ++i) {
        const double psi = 360.0 * i / count;
        readings.push_back({MagneticHeading::fromDegrees(psi), CompassHeading::fromDegrees(compass_deg(psi))});
    }
    return readings;
}

/// δ = 65° sin ψ: between 315 and 030 it reads less while the aircraft turns right. A smooth curve through the readings rises all the same.
TEST(CompassAtFault, readingsThatFoldAreSaidAndHaveNoCard)
{
    const auto readings = around(24, [](double psi) { return psi - 65.0 * std::sin(toRadians(psi)); });
    const auto fold = foldOf(readings);
    ASSERT_TRUE(fold);
    EXPECT_EQ(fold->from.degrees(), 330.0);
    EXPECT_EQ(fold->to.degrees(), 30.0);
    const auto analysis = analyse(readings);
    ASSERT_TRUE(analysis);
    EXPECT_TRUE(analysis->slips.slips.empty());
    EXPECT_THAT(inEnglish(analysis->warnings), Contains(HasSubstr("falls while the aircraft turns right")));
    const auto card = makeCard(*analysis, {});
    ASSERT_FALSE(card);
    EXPECT_THAT(card.error().message.english(), HasSubstr("one reading stands for more than one heading"));
    // One misread figure is a slip, and a steep curve that rises is none.
    auto slipped = around(24, [](double psi) { return psi - 5.0 * std::sin(toRadians(psi)); });
    slipped[7].compass = CompassHeading::fromDegrees(slipped[7].compass.degrees() + 40);
    EXPECT_FALSE(foldOf(slipped));
    EXPECT_FALSE(foldOf(around(36, [](double psi) { return psi - 50.0 * std::sin(toRadians(psi)); })));
}

TEST(CompassAtFault, aStuckCompassIsNamedWithItsFigure)
{
    for (const int count : {4, 8, 36}) {
        const auto stuck = analyse(around(count, [](double) { return 123.0; }));
        ASSERT_FALSE(stuck);
        EXPECT_THAT(stuck.error().message.english(), HasSubstr("reads 123 on all headings"));
    }
    EXPECT_FALSE(analyse(around(12, [](double psi) { return 359.5 + (psi > 180 ? 1.0 : 0.0); }))); // about north, to and fro by a degree
}

TEST(CompassAtFault, aCompassThatIsHeldIsNamedWithItsBounds)
{
    for (const double swing : {4.0, 15.0, 20.0})
        for (const int count : {6, 12, 36}) {
            const auto held = analyse(around(count, [swing](double psi) { return 200 + swing * std::sin(toRadians(psi)); }));
            ASSERT_FALSE(held) << swing;
            EXPECT_THAT(held.error().message.english(), HasSubstr("keeps between")) << swing;
        }
    // Half as much iron again as the Earth has field: it folds, which is told by its own name.
    EXPECT_TRUE(analyse(around(24, [](double psi) {
        return psi - deviationAt(ExactSmith{0, 1.5, 0, 0, 0}, MagneticHeading::fromDegrees(psi)).degrees();
    })));
}

TEST(CompassAtFault, readingsThatHaveNothingToDoWithTheHeadingsAreToldSo)
{
    for (const int count : {12, 24}) {
        const auto twice = analyse(around(count, [](double psi) { return 2 * psi + 10; }));
        ASSERT_FALSE(twice);
        EXPECT_THAT(twice.error().message.english(), HasSubstr("does not follow the headings"));
        const auto any = analyse(around(count, [](double psi) { return 43758.5453 * std::sin(12.9898 * psi); }));
        ASSERT_FALSE(any);
        EXPECT_THAT(any.error().message.english(), HasSubstr("does not follow the headings"));
    }
    // As many coefficients as readings fit anything: their size tells.
    const auto three = analyse(std::vector<Observation>{{MagneticHeading::fromDegrees(0), CompassHeading::fromDegrees(200)},
        {MagneticHeading::fromDegrees(120), CompassHeading::fromDegrees(80)},
        {MagneticHeading::fromDegrees(240), CompassHeading::fromDegrees(60)}});
    EXPECT_FALSE(three);
}

/// Seven readings of a compass and one from the other side of the card, or of another row: that one is named, and no card is made of it.
TEST(CompassAtFault, oneReadingFarAstrayIsNamedAmongOthersThatFollow)
{
    const auto reads = [](double psi) { return std::round(psi - 1.0 - 3.0 * std::sin(toRadians(psi)) + 2.0 * std::cos(toRadians(psi))); };
    for (const double off : {180.0, -120.0})
        for (std::size_t row = 0; row < 8; ++row) {
            auto readings = around(8, reads);
            readings[row].compass = CompassHeading::fromDegrees(readings[row].compass.degrees() + off);
            const auto analysis = analyse(readings);
            ASSERT_TRUE(analysis) << analysis.error().message.english();
            ASSERT_EQ(analysis->slips.slips.size(), 1u) << off << ' ' << row;
            EXPECT_EQ(analysis->slips.slips[0].reading, row) << off;
            EXPECT_TRUE(analysis->readings[row].suspect);
            const auto& meant = analysis->slips.slips[0].candidates; // 317 and 137 are also swapped digits
            EXPECT_EQ(off == 180.0, std::ranges::any_of(meant, [](const auto& one) { return one.slip == Slip::Reciprocal; })) << row;
            EXPECT_THAT(inEnglish(analysis->warnings), Contains(HasSubstr("goes with none of the others"))) << off << ' ' << row;
            EXPECT_THAT(inEnglish(analysis->warnings), Not(Contains(HasSubstr("in its mount")))) << off << ' ' << row;
            EXPECT_FALSE(makeCard(*analysis, {30, CardSource::Fit, {}}));
        }
    auto two = around(8, reads);
    for (const std::size_t row : {1u, 4u})
        two[row].compass = CompassHeading::fromDegrees(two[row].compass.degrees() + 180.0);
    EXPECT_FALSE(analyse(two)); // the list as a whole
    auto ofTwelve = around(12, reads);
    ofTwelve[3].compass = CompassHeading::fromDegrees(ofTwelve[3].compass.degrees() + 10.0);
    ofTwelve[8].compass = CompassHeading::fromDegrees(ofTwelve[8].compass.degrees() + 180.0);
    const auto both = analyse(ofTwelve);
    ASSERT_TRUE(both) << both.error().message.english();
    EXPECT_THAT(inEnglish(both->warnings), Contains(HasSubstr("the reading on 240° magnetic goes with none of the others")));
    EXPECT_FALSE(makeCard(*both, {30, CardSource::Fit, {}}));
}

std::vector<Observation> readWith(int count, const std::function<double(double psi_deg)>& beyond_deg)
{
    std::mt19937_64 engine(3);
    return around(count, [&](double psi) {
        const double scatter = (static_cast<double>(engine() >> 11) * 0x1p-53 - 0.5) * 1.2; // of 0.35°
        return std::round(psi + 1.0 - 4.0 * std::sin(toRadians(psi)) + 2.0 * std::cos(toRadians(psi)) - beyond_deg(psi) + scatter);
    });
}

/// @param width_deg  of the whole bump, about 200
std::function<double(double)> bump(double height_deg, double width_deg)
{
    return [=](double psi) {
        const double off = wrap180(psi - 200.0);
        return std::abs(off) < width_deg / 2 ? height_deg * std::pow(std::cos(kPi * off / width_deg), 2) : 0.0;
    };
}

AnalysisOptions toWholeDegrees()
{
    AnalysisOptions options;
    options.readingError_rad = toRadians(1.0 / std::sqrt(12.0));
    return options;
}

TEST(CompassAtFault, readingsThatGoAstrayTogetherAreNoSlipOfOne)
{
    for (const int count : {24, 36, 72})
        for (const double height : {-12.0, 6.0, 10.0})
            for (const double width : {90.0, 120.0, 150.0}) {
                const auto analysis = analyse(readWith(count, bump(height, width)), toWholeDegrees());
                ASSERT_TRUE(analysis);
                EXPECT_TRUE(analysis->slips.slips.empty()) << count << ' ' << height << ' ' << width;
                EXPECT_THAT(inEnglish(analysis->warnings), Contains(HasSubstr("five coefficients do not describe this curve")))
                    << count << ' ' << height << ' ' << width;
            }
}

/// Beside the bump one reading slipped all the same: both are told, and none of it as certain.
TEST(CompassAtFault, aSlipBesideABumpIsNamedWithTheBump)
{
    for (const int count : {24, 36})
        for (const std::size_t row : {2u, 7u, 19u}) {
            auto readings = readWith(count, bump(8.0, 120.0));
            readings[row].compass = CompassHeading::fromDegrees(readings[row].compass.degrees() + 20.0);
            const auto analysis = analyse(readings, toWholeDegrees());
            ASSERT_TRUE(analysis);
            ASSERT_EQ(analysis->slips.slips.size(), 1u) << count << ' ' << row;
            EXPECT_EQ(analysis->slips.slips[0].reading, row);
            EXPECT_LE(analysis->slips.slips[0].probability, 0.9);
            EXPECT_THAT(inEnglish(analysis->warnings), Contains(HasSubstr("five coefficients do not describe this curve")));
        }
}

TEST(CompassAtFault, aSquareWaveOfADegreeAndAHalfIsLackOfFit)
{
    for (const int count : {36, 72})
        for (const int times : {1, 2, 3}) {
            const auto square = [times](double psi) { return std::sin(toRadians(times * psi + 5.0)) >= 0 ? 1.5 : -1.5; };
            const auto analysis = analyse(readWith(count, square), toWholeDegrees());
            ASSERT_TRUE(analysis);
            EXPECT_TRUE(analysis->slips.slips.empty()) << count << ' ' << times;
            EXPECT_THAT(inEnglish(analysis->warnings), Contains(HasSubstr("five coefficients"))) << count << ' ' << times;
        }
    for (const int count : {8, 12, 16, 24, 36, 72})
        EXPECT_THAT(inEnglish(analyse(readWith(count, [](double) { return 0.0; }), toWholeDegrees())->warnings),
            Not(Contains(HasSubstr("five coefficients"))))
            << count;
}

/// One of eight that is 100° off brings A beyond 15°: its reading is to be looked at, not the mount.
TEST(CompassAtFault, noMountIsBlamedForAReadingThatSlipped)
{
    const auto reads = [](double psi) { return std::round(psi - 14.0 - 3.0 * std::sin(toRadians(psi)) + 2.0 * std::cos(toRadians(psi))); };
    int outOfPlace = 0;
    for (std::size_t row = 0; row < 8; ++row) {
        auto readings = around(8, reads);
        readings[row].compass = CompassHeading::fromDegrees(readings[row].compass.degrees() - 100.0);
        const auto analysis = analyse(readings);
        ASSERT_TRUE(analysis) << analysis.error().message.english();
        EXPECT_FALSE(analysis->slips.slips.empty()) << row;
        outOfPlace += toDegrees(*analysis->approximate.of(Coefficient::A)) > 15.0 ? 1 : 0;
        EXPECT_THAT(inEnglish(analysis->warnings), Not(Contains(HasSubstr("in its mount")))) << row;
    }
    EXPECT_GT(outOfPlace, 0);
}

TEST(CompassAtFault, figuresInRadiansAreDoubted)
{
    std::vector<Observation> radians;
    for (int i = 0; i < 8; ++i)
        radians.push_back({MagneticHeading::fromDegrees(toRadians(45.0 * i)), CompassHeading::fromDegrees(toRadians(45.0 * i + 2.0))});
    const auto analysis = analyse(radians);
    ASSERT_TRUE(analysis);
    EXPECT_THAT(inEnglish(analysis->warnings), Contains(HasSubstr("as if they were in radians")));
    EXPECT_THAT(inEnglish(analyse(around(8, [](double psi) { return psi; }))->warnings), Not(Contains(HasSubstr("radians"))));
}

TEST(CompassAtFault, aMirroredCompassIsNamed)
{
    for (const double zero : {0.0, 90.0, 200.0}) {
        const auto mirrored = analyse(around(8, [zero](double psi) { return zero - psi + 3 * std::sin(toRadians(psi)); }));
        ASSERT_FALSE(mirrored);
        EXPECT_THAT(mirrored.error().message.english(), HasSubstr("backwards"));
    }
    // A deviation of half a right angle is none.
    EXPECT_TRUE(analyse(around(24, [](double psi) { return psi - 40 * std::sin(toRadians(psi)); })));
}

/// Index 170° E with B 15°: A is 170°, B what it is on a compass that is mounted right.
TEST(CompassAtFault, aLargeIndexIsOneLargeA)
{
    for (const double index : {170.0, 180.0, 90.0, -95.0}) {
        ApproximateSmith smith;
        smith.A_rad = toRadians(index);
        std::vector<Observation> readings;
        for (int i = 0; i < 24; ++i) { // on even compass headings, so that the approximate formula is exact
            const double z = 15.0 * i;
            readings.push_back(
                {MagneticHeading::fromDegrees(z + index + 15 * std::sin(toRadians(z + index)) + 2 * std::cos(toRadians(2 * (z + index)))),
                    CompassHeading::fromDegrees(z)});
        }
        const auto analysis = analyse(readings);
        ASSERT_TRUE(analysis);
        EXPECT_NEAR(wrap180(toDegrees(*analysis->approximate.value[0]) - index), 0, 1e-9);
        EXPECT_NEAR(toDegrees(*analysis->approximate.value[1]), 15, 1e-9);
        EXPECT_NEAR(toDegrees(*analysis->approximate.value[4]), 2, 1e-9);
        EXPECT_LT(toDegrees(analysis->exact.rms_rad), 1.0);
        EXPECT_NEAR(wrap180(toDegrees(analysis->exact.index_rad) - index), 0, 1.0);
        EXPECT_THAT(inEnglish(analysis->warnings).front(), HasSubstr("taken out as its index"));
        EXPECT_TRUE(analysis->slips.slips.empty());
        const auto there = readings[3];
        EXPECT_NEAR(
            wrap180(deviationAt(analysis->exact, there.magnetic).degrees() - deviationOf(there.magnetic, there.compass).degrees()), 0, 2.0);
    }
}

TEST(LackOfFit, aThirdHarmonicIsSaid)
{
    std::vector<Observation> readings;
    for (int i = 0; i < 24; ++i) {
        const double z = 15.0 * i, off = i % 3 == 0 ? 0.1 : -0.05;
        readings.push_back({MagneticHeading::fromDegrees(z + 3 * std::sin(toRadians(z)) + 1.5 * std::sin(toRadians(3 * z)) + off),
            CompassHeading::fromDegrees(z)});
    }
    EXPECT_THAT(inEnglish(analyse(readings)->warnings), Contains(HasSubstr("third harmonic of 1.5")));
}

TEST(LackOfFit, aBumpIsSaid)
{
    const auto bump = around(36, [](double psi) { return psi + 19 * std::exp(-std::pow((psi - 270) / 30, 2)); });
    EXPECT_THAT(inEnglish(analyse(bump)->warnings), Contains(HasSubstr("five coefficients do not describe")));
}

TEST(LackOfFit, readingsThatScatterAsTheyShouldAreLeftAlone)
{
    const auto rounded = around(12, [](double psi) { return std::round(psi - 4 * std::sin(toRadians(psi)) + 0.4 * std::sin(17 * psi)); });
    EXPECT_THAT(inEnglish(analyse(rounded)->warnings), Not(Contains(HasSubstr("five coefficients"))));
}

/// 𝔅 = 0.45 deviates by 27°: the approximate formula is out by degrees, the exact one is right, and so is the card.
TEST(LackOfFit, aLargeDeviationThatTheExactFormulaDescribesFits)
{
    const auto large = around(24, [](double psi) {
        return std::round(10 * (psi - deviationAt(ExactSmith{0, 0.45, 0.1, 0.15, 0}, MagneticHeading::fromDegrees(psi)).degrees())) / 10;
    });
    const auto analysis = analyse(large, {.readingError_rad = toRadians(0.03)});
    ASSERT_TRUE(analysis);
    EXPECT_GT(toDegrees(*analysis->approximate.sigma_rad), 0.5);
    EXPECT_LT(toDegrees(*analysis->exact.sigma_rad), 0.1);
    EXPECT_THAT(inEnglish(analysis->warnings), Not(Contains(HasSubstr("five coefficients"))));
}

/// Field case e06 (36 deviations of a boat, a bump of −19° about 270): no eleven readings slipped, the curve has another shape.
TEST(LackOfFit, aBumpIsNoRowOfSlips)
{
    std::vector<Observation> readings;
    for (const double deviation : {-2.5, -0.5, 1.6, 4.4, -1.7, 0.0, 1.0, 0.3, -0.9, 0.5, -1.2, 0.8, -0.3, 1.7, -2.1, 0.4, -0.6, 1.2, -1.3,
             0.0, 0.9, -1.1, 1.5, -0.7, -13.2, -15.7, -17.9, -19.2, -18.1, 1.8, -0.4, 0.7, -0.2, 1.4, -4.4, -2.9}) {
        const auto compass = CompassHeading::fromDegrees(10.0 * static_cast<double>(readings.size()));
        readings.push_back({toMagnetic(compass, Deviation::fromDegrees(deviation)), compass});
    }
    const auto bump = analyse(readings, {.readingError_rad = toRadians(0.29)});
    ASSERT_TRUE(bump);
    EXPECT_TRUE(bump->slips.slips.empty());
    EXPECT_THAT(inEnglish(bump->warnings), Contains(HasSubstr("five coefficients do not describe")));
}

/// A published swing of eight that scatters by 3.6°: all of it is poor, and seven of eight suspects are none.
TEST(LackOfFit, readingsThatArePoorThroughoutAreNoRowOfSlips)
{
    std::vector<Observation> readings;
    for (const double deviation : {-2, -2, -6, 2, 4, -2, 5, 2}) {
        const auto compass = CompassHeading::fromDegrees(45.0 * static_cast<double>(readings.size()));
        readings.push_back({toMagnetic(compass, Deviation::fromDegrees(deviation)), compass});
    }
    const auto poor = analyse(readings, {.readingError_rad = toRadians(0.29)});
    ASSERT_TRUE(poor);
    EXPECT_LE(poor->slips.slips.size(), 2u);
    EXPECT_THAT(inEnglish(poor->warnings), Contains(HasSubstr("leave a scatter of 3.")));
}

/// A compass far out of any limits, whose own exact curve goes through every reading: nobody misread it.
TEST(LackOfFit, aLargeButPlainDeviationBlamesNobody)
{
    const auto plain = analyse(
        around(12,
            [](double psi) {
                return std::round(10 * (psi - deviationAt(ExactSmith{0, 0, 0, 0.8, 0}, MagneticHeading::fromDegrees(psi)).degrees())) / 10;
            }),
        {.readingError_rad = toRadians(0.03)});
    ASSERT_TRUE(plain);
    EXPECT_TRUE(plain->slips.slips.empty());
}

/// Each reading beside the next heading, or the one before: the commonest accident of a spreadsheet.
TEST(CompassAtFault, readingsOneRowOffAreNoMount)
{
    constexpr ApproximateSmith truth{toRadians(1.0), toRadians(4.0), toRadians(-3.0), toRadians(1.0), 0.0};
    for (const std::size_t count : {8u, 12u, 24u})
        for (const bool clockwise : {true, false})
            for (const std::size_t off : {std::size_t{1}, count - 1, std::size_t{0}}) {
                std::vector<double> magnetic_deg, compass_deg;
                for (std::size_t i = 0; i < count; ++i) {
                    const double at = wrap360((clockwise ? 1.0 : -1.0) * 360.0 * static_cast<double>(i) / static_cast<double>(count));
                    double reads = at;
                    for (int step = 0; step < 20; ++step)
                        reads = at - deviationAt(truth, CompassHeading::fromDegrees(reads)).degrees();
                    magnetic_deg.push_back(at);
                    compass_deg.push_back(std::round(wrap360(reads)));
                }
                std::vector<Observation> readings;
                for (std::size_t i = 0; i < count; ++i)
                    readings.push_back(
                        {MagneticHeading::fromDegrees(magnetic_deg[i]), CompassHeading::fromDegrees(compass_deg[(i + off) % count])});
                const auto told = inEnglish(analyse(readings, {})->warnings);
                const auto row
                    = std::find_if(told.begin(), told.end(), [](const auto& one) { return one.find("one row off") != std::string::npos; });
                ASSERT_EQ(row != told.end(), off != 0) << count << ' ' << off;
                if (off == 0)
                    continue;
                EXPECT_NE(row->find(off == 1 ? "Moved down" : "Moved up"), std::string::npos) << *row;
                EXPECT_NE(row->find("B +"), std::string::npos) << *row;
                EXPECT_TRUE(std::none_of(
                    told.begin(), told.end(), [](const auto& one) { return one.find("Turn it right in its mount") != std::string::npos; }));
            }
}

} // namespace
} // namespace lubberline
