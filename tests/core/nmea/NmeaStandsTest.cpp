// A log that stands before it turns: hundreds of readings of one heading are one reading, with times in the log or without.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>
#include <sstream>

#include "core/nmea/NmeaSentence.h"
#include "core/nmea/NmeaStands.h"
#include "core/nmea/NmeaSwing.h"
#include "core/swing/Analysis.h"
#include "core/swing/Observations.h"

namespace lubberline {
namespace {

const ApproximateSmith kTruth{toRadians(0.8), toRadians(-3.0), toRadians(2.0), toRadians(1.2), toRadians(-0.4)};

/// The compass sentence and the reference of one second.
std::string secondOf(int second, double compass_deg, double read_deg, bool withTimes)
{
    const double made_deg = wrap360(compass_deg + deviationAt(kTruth, CompassHeading::fromDegrees(compass_deg)).degrees() + 15.0);
    char body[160];
    std::snprintf(body, sizeof body, "HCHDM,%.1f,M", wrap360(std::round(wrap360(read_deg) * 10) / 10));
    std::string log = makeNmea(body) + "\r\n";
    if (withTimes)
        std::snprintf(body, sizeof body, "GPRMC,%02d%02d%02d.00,A,4736.0,N,12218.0,W,6.0,%.1f,201125,15.0,E,A", 9 + second / 3600,
            second / 60 % 60, second % 60, made_deg);
    else
        std::snprintf(body, sizeof body, "GPVTG,%.1f,T,,M,6.0,N,11.1,K", made_deg);
    return log + makeNmea(body) + "\r\n";
}

/// Stands on compass 010 for so long, then goes round at 1°/s.
std::string standThenTurn(int stand_s, double noise_deg, bool withTimes)
{
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0.0, 1.0);
    std::string log;
    for (int second = 0; second < stand_s + 400; ++second) {
        const double compass_deg = wrap360(10.0 + std::max(0, second - stand_s));
        log += secondOf(second, compass_deg, compass_deg + noise_deg * noise(random), withTimes);
    }
    return log;
}

NmeaSwing swingOf(const std::string& log)
{
    NmeaOptions options;
    options.variation = Variation::fromDegrees(15.0);
    options.today = "2026-11-26";
    std::istringstream stream(log);
    auto swing = readNmeaSwing(stream, "stand.nmea", options);
    EXPECT_TRUE(swing) << (swing ? "" : swing.error().message.english());
    return std::move(swing.value());
}

void expectTruth(const NmeaSwing& swing, double widestB_deg, double widestA_deg, const std::string& what)
{
    const Swing record = toSwing(swing);
    const auto analysis = analyse(observationsOf(record), {.shared = record.sharedErrors});
    ASSERT_TRUE(analysis) << what;
    const std::array truth{0.8, -3.0, 2.0, 1.2, -0.4};
    for (const Coefficient which : kCoefficients) {
        const double interval_deg = toDegrees(*analysis->approximate.interval95(which));
        EXPECT_NEAR(toDegrees(*analysis->approximate.of(which)), truth[indexOf(which)], interval_deg + 0.05) << letterOf(which) << what;
        EXPECT_LT(interval_deg, which == Coefficient::A ? widestA_deg : widestB_deg) << letterOf(which) << what;
    }
}

TEST(NmeaStands, howeverLongItStandsTheTurnIsWhatCounts)
{
    for (const bool withTimes : {true, false})
        for (const double noise_deg : {0.0, 0.5})
            for (const int stand_s : {60, 600, 2000}) {
                const NmeaSwing swing = swingOf(standThenTurn(stand_s, noise_deg, withTimes));
                const std::string what = " " + std::to_string(stand_s) + " s, noise " + std::to_string(noise_deg);
                EXPECT_NEAR(static_cast<double>(swing.used), 420.0, 12.0) << what;
                // A second of delay is a degree of A: that is all that may be left open (Student's 2.0 times one degree, and the scatter).
                expectTruth(swing, 0.4, 2.3, what);
            }
}

TEST(NmeaStands, aPairThatALoggerRepeatsIsOneReading)
{
    std::string log;
    for (int time = 0; time < 300; ++time)
        log += secondOf(0, 10.0, 10.0, true);
    log += standThenTurn(0, 0.0, true);
    const NmeaSwing swing = swingOf(log);
    EXPECT_NEAR(static_cast<double>(swing.used), 401.0, 6.0); // five of the 300 are kept, a fifth of a second apart
    expectTruth(swing, 0.4, 2.3, " repeated");
}

TEST(NmeaStands, standsOnManyHeadingsAreTheSwing)
{
    std::vector<NmeaPair> pairs;
    const auto stand = [&](double heading_deg, int seconds) {
        for (int second = 0; second < seconds; ++second)
            pairs.push_back({CompassHeading::fromDegrees(heading_deg), MagneticHeading::fromDegrees(heading_deg),
                static_cast<double>(pairs.size()), 6.0, 0.0, "", true});
        for (int second = 0; second < 30; ++second) // on the way to the next
            pairs.push_back({CompassHeading::fromDegrees(heading_deg + 3 * second), MagneticHeading::fromDegrees(heading_deg + 3 * second),
                static_cast<double>(pairs.size()), 6.0, 3.0, "", true});
    };
    stand(0, 500);
    for (const double heading_deg : {90, 180, 270})
        stand(heading_deg, 60);
    std::vector<double> rates;
    for (const NmeaPair& pair : pairs)
        rates.push_back(*pair.turnRate_deg_s);
    EXPECT_EQ(leaveOutStands(pairs, rates, 1.0), 440); // 59 s from the first of 60 readings to the last
    EXPECT_FALSE(pairs[439].used);
    EXPECT_TRUE(pairs[440].used) << "the last of a stand is kept: the card has settled";
}

TEST(NmeaStands, aTurnSlowerThanAnyOtherIsNoStand)
{
    std::vector<NmeaPair> pairs;
    for (int second = 0; second < 3600; ++second)
        pairs.push_back({CompassHeading::fromDegrees(0.1 * second), MagneticHeading::fromDegrees(0.1 * second), static_cast<double>(second),
            6.0, 0.1, "", true});
    EXPECT_EQ(leaveOutStands(pairs, std::vector<double>(pairs.size(), 0.1), 1.0), 0);
}

TEST(NmeaStands, aTurnIsMeasuredWhereItTurns)
{
    std::vector<TimedHeading> steps;
    for (int step = 0; step < 1000; ++step)
        steps.push_back({static_cast<double>(step), wrap360(2.0 * std::max(0, step - 800)), {}});
    EXPECT_NEAR(turnOfStep_deg(HeadingLine(steps)), 2.0, 0.05);
    EXPECT_EQ(turnOfStep_deg(HeadingLine({})), 0.0);
}

} // namespace
} // namespace lubberline
