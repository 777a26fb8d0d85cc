// Legs by GPS alone: the exact check, their errors, and what they cannot tell.

#include <gtest/gtest.h>

#include <algorithm>

#include <cmath>
#include <random>

#include "core/inflight/InflightSwing.h"
#include "core/inflight/Legs.h"
#include "core/inflight/WindVector.h"

using namespace lubberline;

namespace {

Leg legOf(double heading_deg, double airspeed, const Eigen::Vector2d& wind)
{
    const Eigen::Vector2d ground = velocityOf(heading_deg, airspeed) + wind;
    Leg leg;
    leg.track_deg = directionOf_deg(ground);
    leg.groundSpeed_kt = ground.norm();
    return leg;
}

TEST(Legs, exactCheck)
{
    // Wind (8, −5) m/s, airspeed 60 m/s, headings 010, 100, 190, 280; three of them do as well.
    for (const std::size_t count : {std::size_t{3}, std::size_t{4}}) {
        std::vector<Leg> legs;
        const std::vector<double> headings{10, 100, 190, 280};
        for (std::size_t i = 0; i < count; ++i) {
            legs.push_back(legOf(headings[i], 60, {8, -5}));
            legs.back().compassHeading_deg = headings[i] - 3.0;
            legs.back().variation_deg = 5.0;
        }
        const auto solution = solveLegs(legs, {});
        ASSERT_TRUE(solution) << solution.error().message.english();
        EXPECT_NEAR(solution->air.toward_kt.x(), 8, 1e-9);
        EXPECT_NEAR(solution->air.toward_kt.y(), -5, 1e-9);
        EXPECT_NEAR(solution->air.airspeed_kt, 60, 1e-9);
        for (std::size_t i = 0; i < count; ++i) {
            EXPECT_NEAR(solution->legs[i].trueHeading_deg, headings[i], 1e-9);
            EXPECT_NEAR(*solution->legs[i].deviation_deg, -2.0, 1e-9); // magnetic = true − 5; compass = true − 3
        }
        EXPECT_EQ(swingOf(*solution).readings.size(), count);
    }
}

TEST(Legs, errorsAreThoseOfTheGroundVelocities)
{
    std::mt19937_64 engine(1);
    std::normal_distribution<double> normal;
    double squares = 0;
    constexpr int kRuns = 400;
    for (int run = 0; run < kRuns; ++run) {
        std::vector<Leg> legs;
        for (const double heading : {0.0, 120.0, 240.0}) {
            Leg leg = legOf(heading, 100, {12, 7});
            const Eigen::Vector2d off
                = velocityOf(leg.track_deg, leg.groundSpeed_kt) + 0.5 * Eigen::Vector2d{normal(engine), normal(engine)};
            leg.track_deg = directionOf_deg(off);
            leg.groundSpeed_kt = off.norm();
            legs.push_back(leg);
        }
        const auto solution = solveLegs(legs, {});
        ASSERT_TRUE(solution);
        squares += std::pow(wrap180(solution->legs[0].trueHeading_deg) / solution->legs[0].standardError_deg, 2);
    }
    EXPECT_NEAR(std::sqrt(squares / kRuns), 1.0, 0.3);
}

TEST(Legs, whatLegsCannotTellIsAnError)
{
    const Eigen::Vector2d wind(8, -5);
    EXPECT_FALSE(solveLegs(std::vector<Leg>{legOf(10, 60, wind), legOf(190, 60, wind)}, {}));
    const auto arc = solveLegs(std::vector<Leg>{legOf(10, 60, wind), legOf(20, 60, wind), legOf(30, 60, wind)}, {});
    ASSERT_FALSE(arc);
    EXPECT_NE(arc.error().message.english().find("too short an arc"), std::string::npos);
    // 010, 011 and 012 with 0.3 kt of error lie on a circle of 1 kt: no airspeed, and no heading either.
    const auto near
        = solveLegs(std::vector<Leg>{{"1", 19.03, 57.68, {}, {}}, {"2", 19.94, 57.09, {}, {}}, {"3", 20.57, 57.35, {}, {}}}, {});
    ASSERT_FALSE(near);
    EXPECT_EQ(near.error().message.english(), arc.error().message.english());
    const auto noVariation = solveLegs(std::vector<Leg>{legOf(0, 60, wind), legOf(120, 60, wind), legOf(240, 60, wind)}, {});
    ASSERT_TRUE(noVariation);
    EXPECT_FALSE(noVariation->legs[0].deviation_deg.has_value());
    EXPECT_EQ(noVariation->warnings.size(), 3u); // no variation; nothing left to check; one airspeed is assumed
    const auto line = solveLegs(std::vector<Leg>{legOf(10, 60, wind), legOf(190, 60, wind), legOf(12, 60, wind), legOf(188, 60, wind)}, {});
    ASSERT_FALSE(line);
    EXPECT_NE(line.error().message.english().find("along one line, there and back"), std::string::npos);
}

/// 8 kt faster to the east and 8 kt slower to the west is a wind of 8 kt to every circle: it is said that this does not show.
TEST(Legs, anAirspeedThatIsNotHeldIsTakenForWindAndSaid)
{
    const std::vector<Leg> legs{{"1", 0, 100, {}, {}}, {"2", 90, 108, {}, {}}, {"3", 180, 100, {}, {}}, {"4", 270, 92, {}, {}}};
    const auto solved = solveLegs(legs, {});
    ASSERT_TRUE(solved);
    EXPECT_NEAR(solved->air.toward_kt.norm(), 8.0, 0.2);
    const auto warnings = inEnglish(solved->warnings);
    EXPECT_TRUE(std::any_of(
        warnings.begin(), warnings.end(), [](const auto& one) { return one.find("turns headings by up to 0.6°") != std::string::npos; }));
}

TEST(Legs, windZeroAndWindAboveTheAirspeed)
{
    for (const Eigen::Vector2d& wind : {Eigen::Vector2d(0, 0), Eigen::Vector2d(70, 10)}) {
        std::vector<Leg> legs;
        for (const double heading : {0.0, 90.0, 180.0, 270.0})
            legs.push_back(legOf(heading, 60, wind));
        const auto solution = solveLegs(legs, {});
        ASSERT_TRUE(solution);
        EXPECT_NEAR((solution->air.toward_kt - wind).norm(), 0.0, 1e-6);
        EXPECT_NEAR(solution->legs[1].trueHeading_deg, 90.0, 1e-6);
    }
}

/// What the wind is uncertain by is in every leg, and of four legs no scatter shows what each has by itself.
TEST(Legs, theSwingKeepsWhatTheWindLeavesOpen)
{
    std::vector<Leg> legs;
    for (const double heading : {0.0, 90.0, 180.0, 270.0}) {
        legs.push_back(legOf(heading, 100, {12, 7}));
        legs.back().compassHeading_deg = heading;
        legs.back().variation_deg = 0.0;
    }
    const auto solution = solveLegs(legs, {1.0, {}, 0.4});
    ASSERT_TRUE(solution);
    // A knot across is 1/100 of a radian at this airspeed: of each leg by itself half of it in A, 1/√2 in B and C.
    const double knot_deg = toDegrees(1.0 / solution->air.airspeed_kt);
    const Swing swing = swingOf(*solution);
    EXPECT_NEAR(swing.sharedErrors.of_deg[0], std::hypot(0.4, knot_deg / 2), 1e-3); // with the variation's
    const auto ofWind = [&](Eigen::Index axis) { return std::sqrt(solution->air.covariance(axis, axis)) * knot_deg; };
    EXPECT_NEAR(swing.sharedErrors.of_deg[1], std::hypot(ofWind(1), knot_deg / std::sqrt(2.0)), 0.02);
    EXPECT_NEAR(swing.sharedErrors.of_deg[2], std::hypot(ofWind(0), knot_deg / std::sqrt(2.0)), 0.02);
    ASSERT_EQ(swing.readings.front().extra.size(), 1u);
    EXPECT_EQ(swing.readings.front().extra.front().first, "datum_error_deg");
}

} // namespace
