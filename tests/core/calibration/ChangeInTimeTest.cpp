// Iron or gain that is another in one part of a log than in the other: told, and in the error; a log in which nothing moved is left alone.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/calibration/AttitudeFit.h"
#include "core/calibration/ChangeInTime.h"
#include "tests/core/calibration/LogMaker.h"

using namespace lubberline;
using namespace lubberline::test;

namespace {

enum class Way { Jump, Drift };

/// P more after a part of the log, or more and more.
SensorLog logWith(double iron_nT, Way way, double from = 0.5, double gain = 0, LogPlan plan = {})
{
    plan.model = exampleModel();
    plan.samples = 3000;
    SensorLog log = makeLog(plan);
    for (std::size_t row = 0; row < log.size(); ++row) {
        const double part = static_cast<double>(row) / static_cast<double>(log.size());
        const double share = way == Way::Drift ? part : part >= from ? 1 : 0;
        log.field[0][row] += share * iron_nT;
        for (auto& axis : log.field)
            axis[row] *= 1 + share * gain;
    }
    return log;
}

bool says(const std::vector<Message>& reasons, std::string_view words)
{
    return std::ranges::any_of(reasons, [&](const Message& one) { return one.english().find(words) != std::string::npos; });
}

double errorOf(const std::vector<FittedParameter>& parameters, std::string_view name)
{
    return *std::ranges::find(parameters, name, &FittedParameter::name)->standard_error;
}

} // namespace

TEST(ChangeInTime, ofIronIsToldByAnEllipsoid)
{
    for (const auto& [iron_nT, way, from] :
        {std::tuple{1500.0, Way::Jump, 0.5}, {600.0, Way::Jump, 0.5}, {-1500.0, Way::Jump, 0.25}, {1500.0, Way::Drift, 0.0}}) {
        const SensorLog log = logWith(iron_nT, way, from);
        for (const auto known : {std::optional<double>(40'000), std::optional<double>()}) {
            const auto result = fitEllipsoid(log, EllipsoidShape::General, known);
            EXPECT_EQ(result.verdict, CalibrationVerdict::Doubtful) << iron_nT;
            EXPECT_TRUE(says(result.reasons, "along x it is")) << iron_nT;
            const double off = std::abs(result.fit->hardIron.x() - 3000), error = errorOf(result.fit->parameters, "P");
            EXPECT_LT(off, 2 * error) << iron_nT;
            EXPECT_LT(std::abs(iron_nT) - off, 2 * error) << iron_nT; // nor is it right for what came after
            EXPECT_LT(errorOf(result.fit->parameters, "Q"), 100);
        }
    }
    // Its size, and where it began.
    const auto result = fitEllipsoid(logWith(1500, Way::Jump, 0.5), EllipsoidShape::General, 40'000);
    EXPECT_TRUE(says(result.reasons, "after about 150 s")) << result.reasons.front().english();
    EXPECT_NEAR(result.fit->uncertainty.covariance(9, 9), 750 * 750, 60'000);
}

TEST(ChangeInTime, ofGainIsToldByAnEllipsoid)
{
    const auto result = fitEllipsoid(logWith(0, Way::Jump, 0.5, 0.01), EllipsoidShape::General, 40'000);
    EXPECT_EQ(result.verdict, CalibrationVerdict::Doubtful);
    EXPECT_TRUE(says(result.reasons, "gain changes with time: it is +1.0 %"));
}

TEST(ChangeInTime, ofALogInWhichNothingMovedIsNone)
{
    for (unsigned seed = 1; seed <= 12; ++seed)
        for (const double tilt_deg : {180.0, 20.0}) {
            LogPlan plan;
            plan.seed = seed;
            plan.tilt_deg = tilt_deg;
            const SensorLog log = logWith(0, Way::Jump, 0.5, 0, plan);
            const auto result = fitEllipsoid(log, EllipsoidShape::General, 40'000);
            EXPECT_TRUE(result.fit->changed.empty()) << seed << " " << result.fit->changed.english();
            const auto attitude = fitAttitude(log, {plan.field, 0});
            ASSERT_TRUE(attitude);
            EXPECT_EQ(attitude->verdict, CalibrationVerdict::Good) << seed;
        }
}

TEST(ChangeInTime, isToldByAttitudeToo)
{
    for (const auto& [iron_nT, way] : {std::pair{1500.0, Way::Jump}, {600.0, Way::Jump}, {1500.0, Way::Drift}}) {
        const auto result = fitAttitude(logWith(iron_nT, way), {LogPlan().field, 0});
        ASSERT_TRUE(result);
        EXPECT_EQ(result->verdict, CalibrationVerdict::Doubtful);
        EXPECT_TRUE(says(result->reasons, "along x it is")) << iron_nT;
        EXPECT_LT(std::abs(result->model.hardIron_nT.x() - 3000), 2 * errorOf(result->parameters, "P"));
    }
    const auto result = fitAttitude(logWith(0, Way::Jump, 0.5, 0.01), {LogPlan().field, 0});
    ASSERT_TRUE(result);
    EXPECT_TRUE(says(result->reasons, "gain changes"));
}

TEST(ChangeInTime, ofAPartThatIsLeftOutWholeIsTold)
{
    // So large, and so late, that the trimming takes it for spikes: of the last tenth nothing is in use.
    const auto result = fitEllipsoid(logWith(20'000, Way::Jump, 0.9), EllipsoidShape::General, 40'000);
    EXPECT_EQ(result.verdict, CalibrationVerdict::Doubtful);
    EXPECT_TRUE(says(result.reasons, "most do not lie on what the others lie on"));
    // Spikes all over it are none.
    LogPlan plan;
    plan.spikes = 0.03;
    EXPECT_EQ(fitEllipsoid(logWith(0, Way::Jump, 0.5, 0, plan), EllipsoidShape::General, 40'000).verdict, CalibrationVerdict::Good);
}

/// A level turn tells of z nothing but a sum, which is constant: that no fit tells its parts is no change with time, and a change is one
/// of its whole size.
TEST(ChangeInTime, alongAnAxisThatIsToldAsASumOnly)
{
    LogPlan plan{.model = exampleModel(), .tilt_deg = 0, .samples = 3000};
    SensorLog log = makeLog(plan);
    const auto still = fitAttitude(log, {plan.field});
    ASSERT_TRUE(still);
    EXPECT_FALSE(says(still->reasons, "changes with time")) << still->reasons.back().english();
    for (std::size_t row = 1500; row < log.size(); ++row)
        log.field[2][row] += 600;
    const auto moved = fitAttitude(log, {plan.field});
    ASSERT_TRUE(moved);
    ASSERT_TRUE(says(moved->reasons, "along z it is +")) << together(moved->reasons).english();
    EXPECT_TRUE(says(moved->reasons, "along z it is +59") || says(moved->reasons, "along z it is +60"))
        << together(moved->reasons).english();
}
