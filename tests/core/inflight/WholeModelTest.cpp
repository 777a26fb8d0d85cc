// The whole sensor model followed through flights: its row is the chain of core/sensor, exactly; model, level A to E and a change of iron are
// found again; what level flight cannot tell is said.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/angle/Angle.h"
#include "core/inflight/ContinuousSwing.h"
#include "core/sensor/SensorReading.h"

using namespace lubberline;

namespace {

const MeridianField kField = MeridianField::fromDip(18700, toRadians(67));

SensorModel iron()
{
    SensorModel model;
    model.softIron << 0.012, -0.004, 0.010, 0.006, -0.009, 0.003, 0.005, -0.008, 0;
    model.hardIron_nT = {700, -400, 300};
    return model;
}

/// Turns with banks and climbs, as an aircraft flies them.
struct Flight {
    explicit Flight(double steepest, std::uint64_t seed = 15) : most_deg(steepest), engine(seed) {}
    ContinuousSample next(const SensorModel& model)
    {
        const double heading = 137.5 * at, pitch = most_deg * std::sin(0.71 * at), roll = 1.5 * most_deg * std::sin(0.43 * at + 1);
        const auto reading = readSensor(model, kField, {MagneticHeading::fromDegrees(wrap360(heading)), toRadians(pitch), toRadians(roll)});
        ContinuousSample sample;
        sample.time_s = 10.0 * at++;
        sample.compassHeading_deg = reading.compass->degrees();
        sample.deviation_deg = reading.deviation->degrees() + 0.3 * normal(engine);
        sample.at = {pitch, roll, kField};
        return sample;
    }
    double most_deg;
    int at = 0;
    std::mt19937_64 engine;
    std::normal_distribution<double> normal;
};

ContinuousOptions wholeModel()
{
    ContinuousOptions options;
    options.noise_deg = 0.3;
    options.wholeModelOver_nT = kField.horizontal_nT;
    return options;
}

} // namespace

TEST(WholeModel, itsRowIsTheChainOfTheSensorExactly)
{
    StateFilter::State state(kModelStates);
    const SensorModel model = iron();
    for (int place = 0; place < 8; ++place)
        state(place) = toDegrees(model.softIron(place / 3, place % 3));
    for (int axis = 0; axis < 3; ++axis)
        state(8 + axis) = toDegrees(model.hardIron_nT(axis) / kField.horizontal_nT);
    EXPECT_TRUE(modelOf(state, kField.horizontal_nT).softIron.isApprox(model.softIron, 1e-12));
    EXPECT_TRUE(modelOf(state, kField.horizontal_nT).hardIron_nT.isApprox(model.hardIron_nT, 1e-12));
    const MeridianField elsewhere = MeridianField::fromDip(30000, toRadians(-40));
    for (const MeridianField& field : {kField, elsewhere})
        for (double heading = 0; heading < 360; heading += 17)
            for (const auto& [pitch, roll] : {std::pair{0.0, 0.0}, {12.0, -25.0}, {-8.0, 40.0}}) {
                const auto reading = readSensor(model, field, {MagneticHeading::fromDegrees(heading), toRadians(pitch), toRadians(roll)});
                const auto row
                    = modelRow(reading.compass->degrees(), reading.deviation->degrees(), {pitch, roll, field}, kField.horizontal_nT);
                EXPECT_NEAR(row.dot(state), toDegrees(std::sin(reading.deviation->radians())), 1e-9) << heading;
            }
}

TEST(WholeModel, isFoundAgainWithItsErrors)
{
    ContinuousSwing swing(wholeModel());
    Flight flight(15);
    for (int i = 0; i < 3000; ++i)
        swing.add(flight.next(iron()));
    const ContinuousResult result = swing.finish();
    ASSERT_TRUE(result.told);
    ASSERT_TRUE(result.whole && result.whole->model);
    EXPECT_TRUE(result.alarms.empty());
    for (int place = 0; place < kModelStates; ++place) {
        const double truth = place < 8 ? toDegrees(iron().softIron(place / 3, place % 3))
                                       : toDegrees(iron().hardIron_nT(place - 8) / kField.horizontal_nT);
        const auto at = static_cast<std::size_t>(place);
        EXPECT_NEAR(*result.state_deg[at], truth, 3.5 * *result.standardError_deg[at]) << kModelNames[at];
        EXPECT_LT(*result.standardError_deg[at], 0.35) << kModelNames[at];
    }
    // B = (P + c Z)/H, C = (Q + f Z)/H, A = (d − b)/2, to the first order.
    const double ratio = kField.down_nT / kField.horizontal_nT;
    EXPECT_NEAR(*result.whole->level_deg[0], toDegrees((0.006 + 0.004) / 2), 0.1);
    EXPECT_NEAR(*result.whole->level_deg[1], toDegrees(700 / kField.horizontal_nT + 0.010 * ratio), 0.1);
    EXPECT_NEAR(*result.whole->level_deg[2], toDegrees(-400 / kField.horizontal_nT + 0.003 * ratio), 0.1);
    EXPECT_NEAR(*result.whole->level_deg[3], toDegrees((0.012 + 0.009) / 2), 0.1);
    EXPECT_NEAR(*result.whole->level_deg[4], toDegrees((0.006 - 0.004) / 2), 0.1);
}

TEST(WholeModel, itsErrorsAreThoseStated)
{
    double squares = 0;
    constexpr int kFlights = 20;
    for (std::uint64_t seed = 1; seed <= kFlights; ++seed) {
        ContinuousSwing swing(wholeModel());
        Flight flight(15, seed);
        for (int i = 0; i < 1000; ++i)
            swing.add(flight.next(iron()));
        const ContinuousResult result = swing.finish();
        ASSERT_TRUE(result.told);
        for (int place = 0; place < kModelStates; ++place) {
            const double truth = place < 8 ? toDegrees(iron().softIron(place / 3, place % 3))
                                           : toDegrees(iron().hardIron_nT(place - 8) / kField.horizontal_nT);
            const auto at = static_cast<std::size_t>(place);
            squares += std::pow((*result.state_deg[at] - truth) / *result.standardError_deg[at], 2);
        }
    }
    EXPECT_NEAR(squares / (kFlights * kModelStates), 1.0, 0.3);
}

TEST(WholeModel, aChangeOfHardIronRaisesAnAlarm)
{
    ContinuousSwing swing(wholeModel());
    Flight flight(15);
    SensorModel changed = iron();
    changed.hardIron_nT.x() += 500; // 1.5° of B
    for (int i = 0; i < 2000; ++i)
        swing.add(flight.next(i < 1500 ? iron() : changed));
    const ContinuousResult result = swing.finish();
    ASSERT_FALSE(result.alarms.empty());
    EXPECT_EQ(result.alarms[0].coefficient, "P");
    EXPECT_GE(result.alarms[0].time_s, 15000);
    EXPECT_LT(result.alarms[0].time_s, 15400);
    EXPECT_NEAR(result.alarms[0].change_deg, toDegrees(500 / kField.horizontal_nT), 3.5 * result.alarms[0].standardError_deg);
}

TEST(WholeModel, levelFlightTellsTheLevelCoefficientsAndSaysWhatItDoesNot)
{
    ContinuousSwing swing(wholeModel());
    Flight flight(0);
    for (int i = 0; i < 500; ++i)
        swing.add(flight.next(iron()));
    const ContinuousResult result = swing.finish();
    EXPECT_FALSE(result.told);
    ASSERT_TRUE(result.whole);
    EXPECT_FALSE(result.whole->model);
    EXPECT_FALSE(result.state_deg[8]);           // P is not told from c
    EXPECT_GE(result.nullDirections.size(), 6u); // of 11 level flight tells five
    const double ratio = kField.down_nT / kField.horizontal_nT;
    ASSERT_TRUE(result.whole->level_deg[1]);
    EXPECT_NEAR(*result.whole->level_deg[1], toDegrees(700 / kField.horizontal_nT + 0.010 * ratio), 0.15);
}
