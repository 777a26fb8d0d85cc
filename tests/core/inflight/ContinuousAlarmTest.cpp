// The alarm of the continuous swing where logs are flown on legs, with errors that last: how often it is false, and what it names.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>
#include <vector>

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

/// Series of 1400 updates; from the 600th on errors are `times` as large for `rough` updates, and at the 700th B may jump.
std::vector<ContinuousResult> flyThrough(int series, double times, int rough, double jump_deg, double correlation = 0)
{
    std::vector<ContinuousResult> flown;
    for (int one = 0; one < series; ++one) {
        Draws log(static_cast<std::uint64_t>(9000 + one));
        ContinuousSwing swing({});
        double error = log.noise(), heading_deg = 0;
        for (int i = 0; i < 1400; ++i) {
            if (correlation == 0 || i % 20 == 0)
                heading_deg = log.heading();
            ContinuousSample sample;
            sample.time_s = i;
            sample.compassHeading_deg = wrap360(heading_deg + log.noise());
            error = correlation * error + std::sqrt(1 - correlation * correlation) * log.noise();
            Smith truth = kIron;
            truth(1) += i >= 700 ? jump_deg : 0.0;
            sample.deviation_deg = rowOn(sample.compassHeading_deg).dot(truth) + 0.5 * (i >= 600 && i < 600 + rough ? times : 1.0) * error;
            swing.add(sample);
        }
        flown.push_back(swing.finish());
    }
    return flown;
}

TEST(ContinuousSwing, airThatTurnsRoughIsNoChangeOfIron)
{
    // Of 300 series 18 % to 20 % have a false alarm, 24 % at five times; nearly all had, some three each.
    for (const auto& [times, rough, most] : {std::tuple{1.5, 400, 15}, {2.0, 200, 15}, {3.0, 200, 15}, {3.0, 60, 15}, {5.0, 200, 17}}) {
        const auto flown = flyThrough(40, times, rough, 0);
        EXPECT_LE(std::ranges::count_if(flown, [](const auto& one) { return !one.alarms.empty(); }), most) << times << ' ' << rough;
    }
    // And hides none: 3 degrees in air three times as rough.
    const auto hidden = flyThrough(20, 3, 800, 3);
    EXPECT_GE(std::ranges::count_if(hidden,
                  [](const auto& one) {
                      return std::ranges::any_of(one.alarms,
                          [](const auto& alarm) { return alarm.time_s >= 700 && alarm.time_s < 800 && alarm.coefficient == "B"; });
                  }),
        16);
}

TEST(ContinuousSwing, theIntervalHoldsTheChange)
{
    // Of 300 series 94 % to 99 %.
    for (const auto& [jump_deg, correlation, least] : {std::tuple{0.5, 0.0, 52}, {1.0, 0.0, 54}, {2.0, 0.0, 54}, {1.0, 0.9, 50}}) {
        int found = 0, held = 0;
        std::vector<double> lengths;
        for (const auto& one : flyThrough(60, 1, 0, jump_deg, correlation)) {
            const auto alarm = std::ranges::find_if(one.alarms, [](const auto& each) { return each.time_s >= 700; });
            if (alarm == one.alarms.end())
                continue;
            ++found;
            held += alarm->from_s <= 700 && alarm->to_s >= 700 ? 1 : 0;
            EXPECT_LE(alarm->from_s, alarm->since_s);
            EXPECT_LE(alarm->since_s, alarm->to_s);
            EXPECT_LE(alarm->to_s, alarm->time_s);
            lengths.push_back(alarm->to_s - alarm->from_s);
        }
        EXPECT_GE(found, 56) << jump_deg;
        EXPECT_GE(held, least) << jump_deg << ' ' << correlation;
        std::ranges::sort(lengths);
        EXPECT_LT(lengths[lengths.size() / 2], correlation > 0 ? 250 : 60 / jump_deg);
    }
}

} // namespace
