#include "core/calibration/Compensation.h"

#include <gmock/gmock.h>

#include "core/calibration/ModelHeader.h"
#include "tests/core/calibration/LogMaker.h"

namespace lubberline::test {
namespace {

using testing::HasSubstr;

/// Level, 240 a second: Smith's B of P = 2000 nT on H = 20 000 nT is 5.74°, all of it in the sine of the heading.
SensorLog levelLog(const SensorModel& model, double noise_nT)
{
    LogPlan plan{.model = model, .tilt_deg = 0, .noise_nT = noise_nT, .samples = 2000};
    SensorLog log = makeLog(plan);
    for (std::size_t row = 0; row < log.size(); ++row)
        log.time_s[row] = static_cast<double>(row) / 240.0;
    return log;
}

SensorModel forwardIron()
{
    SensorModel model;
    model.hardIron_nT = {2000, 0, 0};
    return model;
}

TEST(Compensation, beforeAndAfter)
{
    const auto result = compensate(levelLog(forwardIron(), 0), forwardIron(), {.latency_ms = 2.0});
    ASSERT_TRUE(result) << describe(result.error());
    ASSERT_TRUE(result->before && result->after);
    // tan δ = 0.1 sin ψ / (1 + 0.1 cos ψ): at most asin 0.1 = 5.739°.
    EXPECT_NEAR(result->before->max_deg, 5.739, 0.001);
    EXPECT_NEAR(result->before->harmonics_deg[1], -toDegrees(0.1), 0.02) << "indication error: read − magnetic";
    EXPECT_LT(result->after->max_deg, 1e-9);
    EXPECT_NEAR(*result->rate_hz, 240, 1e-6);
    EXPECT_NEAR(result->spreadBefore, 2000 * 20000 / 40000 / std::sqrt(2), 30);
    EXPECT_LT(result->spreadAfter, 1e-6);
    ASSERT_EQ(result->demands.size(), 3u);
    for (const auto& demand : result->demands)
        EXPECT_EQ(demand.met(), true) << demand.name.english();
}

/// A log without attitude is taken for level, and says so; one that tumbled has no deviation map of "pitch 0".
TEST(Compensation, withoutAttitudeLevelIsTakenAndSaid)
{
    const auto without = [](double tilt_deg) {
        SensorLog log = makeLog({.model = forwardIron(), .tilt_deg = tilt_deg});
        log.heading_deg.clear();
        log.pitch_deg.clear();
        log.roll_deg.clear();
        auto result = compensate(log, forwardIron(), {});
        EXPECT_TRUE(result) << describe(result.error());
        return std::pair(together(result->warnings).english(), result->map.size());
    };
    const auto [level, cells] = without(0);
    EXPECT_THAT(level, HasSubstr("headings are those of a level compass"));
    EXPECT_THAT(level, testing::Not(HasSubstr("tilted")));
    EXPECT_EQ(cells, 24u);
    const auto [tumbled, none] = without(180);
    EXPECT_THAT(tumbled, HasSubstr("this one was tilted"));
    EXPECT_EQ(none, 0u);
}

/// Of P = 2000 nT on H = 20 000 nT the deviation at 090 is atan 0.1 before, and nothing after; a calibration that knows P to 100 nT tells a
/// heading there to atan(1/200), in the field that the compass sees.
TEST(Compensation, theMapOfTheLog)
{
    CompensationOptions options;
    options.field = MeridianField::fromDip(20000, toRadians(60));
    options.uncertainty.emplace().covariance(9, 9) = 100 * 100;
    const auto result = compensate(levelLog(forwardIron(), 0), forwardIron(), options);
    ASSERT_TRUE(result) << describe(result.error());
    ASSERT_EQ(result->map.size(), 24u) << "one pitch, a cell of 15 degrees";
    const ErrorCell& east = result->map[6];
    EXPECT_EQ(east.heading_deg, 90);
    EXPECT_EQ(east.pitch_deg, 0);
    EXPECT_NEAR(east.before_deg, toDegrees(std::atan(0.1)), 0.03);
    EXPECT_NEAR(east.after_deg.value(), 0, 1e-9);
    EXPECT_NEAR(result->map[18].before_deg, -toDegrees(std::atan(0.1)), 0.03);
    // At 090 the field at the sensor is (2000, −20 000): dψ' = Y dX/(X² + Y²).
    EXPECT_NEAR(east.sigma_deg.value(), toDegrees(20000.0 * 100 / (2000.0 * 2000 + 20000.0 * 20000)), 1e-6);
    // Without a reference what compensation makes is one for what was read.
    SensorLog log = levelLog(forwardIron(), 0);
    log.heading_deg.clear();
    const auto alone = compensate(log, forwardIron(), {});
    ASSERT_TRUE(alone);
    EXPECT_NEAR(alone->map[6].before_deg, toDegrees(std::atan(0.1)), 0.03);
    EXPECT_FALSE(alone->map[6].after_deg);
    EXPECT_FALSE(alone->map[6].sigma_deg);
}

/// Iron that is put down in the middle of a log, and a sensor that warms up: a model is for one iron and one gain.
TEST(Compensation, aChangeDuringTheLogIsTold)
{
    for (const double tilt_deg : {0.0, 20.0}) {
        LogPlan plan{.model = exampleModel(), .tilt_deg = tilt_deg, .samples = 3000};
        const auto told = [&](double iron_nT, double gain, const SensorModel& model) {
            SensorLog log = makeLog(plan);
            for (std::size_t row = log.size() / 2; row < log.size(); ++row) {
                log.field[0][row] += iron_nT;
                for (auto& axis : log.field)
                    axis[row] *= 1 + gain;
            }
            const auto result = compensate(log, model, {});
            return result ? together(result->warnings).english() : describe(result.error());
        };
        EXPECT_THAT(told(800, 0, exampleModel()), HasSubstr("changes with time: along x it is +7")) << tilt_deg;
        EXPECT_THAT(told(800, 0, exampleModel()), HasSubstr("after about 150 s than before")) << tilt_deg;
        // Of a sensor that is always level a gain is iron along z.
        EXPECT_THAT(told(0, 0.01, exampleModel()), HasSubstr(tilt_deg > 0 ? "gain changes with time: it is +" : "along z it is +"));
        EXPECT_THAT(told(0, 0, exampleModel()), testing::Not(HasSubstr("changes with time"))) << tilt_deg;
        // A model that is wrong all the time makes the sizes depend on the attitude, and not on the time.
        SensorModel wrong = exampleModel();
        wrong.hardIron_nT.x() += 1500;
        wrong.softIron(1, 1) += 0.03;
        EXPECT_THAT(told(0, 0, wrong), testing::Not(HasSubstr("changes with time"))) << tilt_deg;
        EXPECT_THAT(told(800, 0, wrong), HasSubstr("changes with time: along x")) << tilt_deg;
    }
    // Whichever way attitudes follow each other, nothing is told of a log in which nothing changed.
    for (unsigned seed = 1; seed <= 40; ++seed) {
        LogPlan plan{.model = exampleModel(), .tilt_deg = 15, .samples = 1500, .seed = seed};
        SensorLog log = makeLog(plan);
        const auto result = compensate(log, exampleModel(), {});
        ASSERT_TRUE(result);
        EXPECT_THAT(together(result->warnings).english(), testing::Not(HasSubstr("changes with time"))) << seed;
    }
}

TEST(Compensation, demandsThatAreNotKnownAreNotMet)
{
    SensorLog log = levelLog(forwardIron(), 0);
    log.heading_deg.clear();
    log.time_s.clear();
    const auto result = compensate(log, forwardIron(), {});
    ASSERT_TRUE(result);
    EXPECT_FALSE(result->before);
    for (const auto& demand : result->demands)
        EXPECT_EQ(demand.met(), std::nullopt);
    const auto slow = compensate(levelLog(forwardIron(), 300), forwardIron(), {.latency_ms = 2.0, .filter_ms = 4.2});
    EXPECT_EQ(slow->demands[1].met(), false) << "2 + 4.2 ms";
    EXPECT_EQ(slow->demands[2].met(), false) << "300 nT of 20 000 nT are 0.86°";
    EXPECT_NEAR(slow->after->rms_deg, toDegrees(0.015), 0.05);
}

TEST(Compensation, theCurrentOfTheLogIsTakenOut)
{
    SensorModel model = forwardIron();
    model.misalignment.yaw_rad = 0.1;
    model.circuits.push_back({"light", {0, 50, 0}, 10, true});
    SensorLog log = levelLog(model, 0);
    const auto stated = compensate(log, model, {});
    EXPECT_LT(stated->after->max_deg, 1e-9) << "without a column: as the model says";
    log.currents.push_back({"light", std::vector<double>(log.size(), 10.0)});
    EXPECT_LT(compensate(log, model, {})->after->max_deg, 1e-9);
    log.currents[0].values.assign(log.size(), 0.0);
    EXPECT_GT(compensate(log, model, {})->after->max_deg, 1.0);
}

TEST(Compensation, aLogOfAnotherSensorIsTold)
{
    SensorModel other;
    other.hardIron_nT = {-9000, 8000, 0};
    const auto result = compensate(levelLog(forwardIron(), 0), other, {});
    EXPECT_THAT(together(result->warnings).english(), HasSubstr("a log of another sensor"));
}

TEST(Compensation, theReferenceMayNotBeTheCompassItself)
{
    SensorLog log = levelLog(forwardIron(), 50);
    for (std::size_t row = 0; row < log.size(); ++row)
        log.heading_deg[row] = headingOf_deg(log.at(row), 0, 0);
    const auto result = compensate(log, forwardIron(), {});
    EXPECT_FALSE(result->after);
    EXPECT_THAT(together(result->warnings).english(), HasSubstr("is what this compass itself reads"));
}

TEST(Compensation, theFastLoopIsTheSlowOne)
{
    const SensorModel model = exampleModel();
    const SensorLog log = levelLog(model, 10);
    const auto compensator = compensatorOf(model);
    std::vector<double> headings(log.size());
    levelHeadings({log.field[0], log.field[1], log.field[2]}, compensator->matrix, compensator->offset, headings);
    for (std::size_t row = 0; row < log.size(); ++row)
        ASSERT_NEAR(wrap180(headings[row] - headingOf_deg(compensator->field(log.at(row)), 0, 0)), 0, 1e-9);
}

TEST(Compensation, theCsvHasARowASample)
{
    const SensorLog log = levelLog(forwardIron(), 0);
    const std::string text = writeCompensatedCsv(log, *compensate(log, forwardIron(), {}));
    EXPECT_THAT(text, testing::StartsWith("time_s,bx_nT,by_nT,bz_nT,heading_before_deg,heading_after_deg\n0,"));
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2001);
}

} // namespace
} // namespace lubberline::test
