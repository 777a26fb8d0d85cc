// The alarm of the continuous swing where logs are flown on legs, with errors that last: how often it is false, and what it names.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/angle/Angle.h"
#include "core/inflight/ContinuousSwing.h"

using namespace lubberline;

namespace {

using Smith = Eigen::Matrix<double, 5, 1>;
const Smith kIron = (Smith() << 0.5, -2.0, 1.2, 0.4, -0.3).finished();

Smith rowOn(double compass_deg) { return continuousRow(compass_deg, {}, 0); }

struct Draws {
    std::mt19937_64 engine;
    std::normal_distribution<double> normal;
    explicit Draws(std::uint64_t seed) : engine(seed) {}
    double noise() { return normal(engine); }
    double heading() { return std::uniform_real_distribution<double>(0, 360)(engine); }
};

struct OnLegs {
    int falseAlarms = 0, found = 0, named = 0, maybe = 0, within = 0;
    std::vector<double> delays;
};

/// Series of 1400 updates on legs of 20, with errors of 0.5° that last; B may jump by 1° in their middle.
OnLegs flyLegs(int series, double correlation, double jump_deg)
{
    OnLegs told;
    for (int one = 0; one < series; ++one) {
        Draws log(static_cast<std::uint64_t>(500 + one));
        ContinuousSwing swing({});
        double error = log.noise(), leg_deg = 0;
        for (int i = 0; i < 1400; ++i) {
            if (i % 20 == 0)
                leg_deg = log.heading();
            ContinuousSample sample;
            sample.time_s = i;
            sample.compassHeading_deg = wrap360(leg_deg + log.noise());
            error = correlation * error + std::sqrt(1 - correlation * correlation) * log.noise();
            Smith truth = kIron;
            truth(1) += i >= 700 ? jump_deg : 0.0;
            sample.deviation_deg = rowOn(sample.compassHeading_deg).dot(truth) + 0.5 * error;
            swing.add(sample);
        }
        const auto result = swing.finish();
        const auto after = std::ranges::find_if(result.alarms, [](const ContinuousAlarm& alarm) { return alarm.time_s >= 700; });
        told.falseAlarms += jump_deg == 0 ? !result.alarms.empty() : after != result.alarms.begin();
        if (jump_deg == 0 || after == result.alarms.end())
            continue;
        ++told.found;
        told.delays.push_back(after->time_s - 700);
        const bool named = after->coefficient == "B";
        told.named += named;
        told.maybe += named || std::ranges::find(after->orElse, "B") != after->orElse.end();
        told.within += named && std::abs(after->change_deg - jump_deg) < 2 * after->standardError_deg;
    }
    std::ranges::sort(told.delays);
    return told;
}

TEST(ContinuousSwing, errorsThatLastRaiseNoMoreFalseAlarms)
{
    // Of 60 series: none to 3 at 0.5 to 0.9, 4 to 7 beyond, where 10 % are stated.
    for (const double correlation : {0.5, 0.8, 0.9, 0.95, 0.98})
        EXPECT_LE(flyLegs(40, correlation, 0).falseAlarms, 8) << correlation;
    const OnLegs lasting = flyLegs(30, 0.9, 1);
    EXPECT_LE(lasting.falseAlarms, 4);
    ASSERT_GE(lasting.found, 29);
    EXPECT_LT(lasting.delays[15], 100); // 60; 10 where errors do not last
    EXPECT_GE(lasting.maybe, 29);
    EXPECT_GE(lasting.within, 22);
}

TEST(ContinuousSwing, aChangeIsNamedByMoreThanTheLegOnWhichItWasSeen)
{
    // On the leg of the alarm any coefficient explains it: of 60 changes 46 were named B, 38 within 2 standard errors; now 60 and 53.
    const OnLegs told = flyLegs(30, 0, 1);
    ASSERT_GE(told.found, 29);
    EXPECT_LT(told.delays[15], 20);
    EXPECT_GE(told.named, 29);
    EXPECT_GE(told.within, 25);

    // While nothing but that leg was flown, the others are said.
    Draws log(3);
    ContinuousSwing swing({});
    for (int i = 0; i < 620; ++i) {
        ContinuousSample sample;
        sample.time_s = i;
        sample.compassHeading_deg = i < 600 ? log.heading() : 70.0;
        Smith truth = kIron;
        truth(1) += i >= 600 ? 1.5 : 0.0;
        sample.deviation_deg = rowOn(sample.compassHeading_deg).dot(truth) + 0.3 * log.noise();
        swing.add(sample);
    }
    const auto result = swing.finish();
    ASSERT_EQ(result.alarms.size(), 1u);
    EXPECT_GE(result.alarms[0].orElse.size(), 3u);
    EXPECT_TRUE(std::ranges::any_of(
        result.warnings, [](const Message& one) { return one.english().find("or another coefficient did") != std::string::npos; }));
}

} // namespace
