// Logs of a slow turn: made from known coefficients, and damaged in the ways that logs are.

#include <gtest/gtest.h>

#include <cstdio>
#include <sstream>

#include "core/nmea/NmeaSwing.h"
#include "core/swing/Analysis.h"
#include "core/swing/Observations.h"

namespace lubberline {
namespace {

const ApproximateSmith kSmith{toRadians(1.0), toRadians(-3.0), toRadians(2.0), toRadians(0.8), toRadians(-0.4)};

std::string text(const char* format, double value)
{
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, format, value);
    return buffer;
}

std::string rmc(int second, double track_deg, double speed_kt = 8.0, const char* rest = "A,5210.00,N,02057.00,E")
{
    char body[128];
    std::snprintf(body, sizeof body, "GPRMC,%02d%02d%02d.00,%s,%.1f,%.2f,231126,,", 10 + second / 3600, second / 60 % 60, second % 60, rest,
        speed_kt, track_deg);
    return makeNmea(body) + "\r\n";
}

std::string hdg(double heading_deg, const char* talker = "HC", const char* rest = ",,,")
{
    return makeNmea(std::string(talker) + "HDG," + text("%.3f", heading_deg) + "," + rest) + "\r\n";
}

/// One circle at 1°/s: the compass by kSmith, the track true with `variation_deg`.
std::string circle(double variation_deg, const char* talker = "HC", int step_s = 1)
{
    std::string log;
    for (int second = 0; second < 360; second += step_s) {
        const auto magnetic = MagneticHeading::fromDegrees(second);
        const auto compass = compassHeadingFor(kSmith, magnetic);
        EXPECT_TRUE(compass);
        log += rmc(second, wrap360(second + variation_deg)) + hdg(compass->degrees(), talker);
    }
    return log;
}

Result<NmeaSwing> read(const std::string& log, NmeaOptions options = {})
{
    std::istringstream stream(log);
    return readNmeaSwing(stream, "turn.nmea", options);
}

NmeaOptions stated(double variation_deg)
{
    NmeaOptions options;
    options.variation = Variation::fromDegrees(variation_deg);
    return options;
}

void expectSmith(const NmeaSwing& swing, double tolerance_deg)
{
    const auto analysis = analyse(observationsOf(toSwing(swing)));
    ASSERT_TRUE(analysis);
    const auto near = [&](Coefficient which, double expected_rad) {
        EXPECT_NEAR(toDegrees(*analysis->approximate.of(which)), toDegrees(expected_rad), tolerance_deg) << letterOf(which);
    };
    near(Coefficient::A, kSmith.A_rad);
    near(Coefficient::B, kSmith.B_rad);
    near(Coefficient::C, kSmith.C_rad);
    near(Coefficient::D, kSmith.D_rad);
    near(Coefficient::E, kSmith.E_rad);
}

TEST(NmeaSwing, theCoefficientsOfATurnComeBack)
{
    const auto swing = read(circle(6.5), stated(6.5));
    ASSERT_TRUE(swing);
    EXPECT_EQ(swing->sentences, 720);
    EXPECT_EQ(swing->pairs.size(), 360u);
    EXPECT_EQ(swing->used, 360u);
    EXPECT_EQ(swing->date, Date("2026-11-23"));
    EXPECT_EQ(swing->pairs.front().timeUtc, "2026-11-23T10:00:00.000Z");
    expectSmith(*swing, 0.002);
}

TEST(NmeaSwing, westerlyVariationHasTheOtherSign)
{
    const auto swing = read(circle(-12.6), stated(-12.6));
    ASSERT_TRUE(swing);
    expectSmith(*swing, 0.002);
    EXPECT_NEAR(swing->pairs[100].magnetic.degrees(), 100.0, 1e-9);
}

TEST(NmeaSwing, variationOfTheLog)
{
    std::string log;
    for (int second = 0; second < 360; second += 10)
        log += rmc(second, wrap360(second + 7.1 * -1.0)) + hdg(second, "HC", ",,7.1,W");
    NmeaOptions options;
    options.variation = VariationOfLog{};
    for (const auto& chosen : {NmeaOptions{}, options}) {
        const auto swing = read(log, chosen);
        ASSERT_TRUE(swing);
        EXPECT_EQ(swing->variationSource, "log");
        EXPECT_NEAR(swing->variation->degrees(), -7.1, 1e-12);
        for (const auto& pair : swing->pairs)
            EXPECT_NEAR(deviationOf(pair.magnetic, pair.compass).degrees(), 0.0, 1e-9);
    }
}

TEST(NmeaSwing, variationOfTheModelAtTheLogsPlaceAndDate)
{
    NmeaOptions options;
    options.variation = VariationOfModel{};
    const auto swing = read(circle(6.5), options);
    ASSERT_TRUE(swing) << swing.error().message.english();
    EXPECT_NEAR(swing->variation->degrees(), 7.0, 1.0); // WMM2025: Warsaw has some 7° E in 2026
    EXPECT_NE(swing->variationSource.find("WMM2025 at 52.17"), std::string::npos) << swing->variationSource;
    options.variation = VariationOfLog{};
    EXPECT_FALSE(read(circle(6.5), options));
}

TEST(NmeaSwing, slowAndFastMomentsAreCutOff)
{
    std::string log;
    for (int second = 0; second < 60; ++second) {
        const double heading = second < 20 ? second : second < 40 ? 20 + 10.0 * (second - 20) : 220 + (second - 40);
        log += rmc(second, heading, second >= 50 ? 0.4 : 8.0) + hdg(heading);
    }
    const auto swing = read(log, stated(0));
    ASSERT_TRUE(swing);
    ASSERT_EQ(swing->pairs.size(), 60u);
    EXPECT_NEAR(*swing->pairs[10].turnRate_deg_s, 1.0, 1e-9);
    EXPECT_NEAR(*swing->pairs[30].turnRate_deg_s, 10.0, 1e-9);
    EXPECT_TRUE(swing->pairs[10].used);
    EXPECT_FALSE(swing->pairs[30].used); // turns too fast
    EXPECT_FALSE(swing->pairs[55].used); // stands
    EXPECT_EQ(swing->used, 20u + 9u);    // 0…19 and 41…49: at 20 and 40 the turn is fast on one side
    auto all = stated(0);
    all.minSpeed_kt = 0;
    all.maxTurnRate_deg_s = 360;
    EXPECT_EQ(read(log, all)->used, 60u);
}

TEST(NmeaSwing, theTurnRateThroughNorthIsSmall)
{
    std::string log;
    for (int second = 0; second < 10; ++second)
        log += rmc(second, wrap360(355 + second)) + hdg(wrap360(355 + second));
    const auto swing = read(log, stated(0));
    ASSERT_TRUE(swing);
    EXPECT_EQ(swing->used, 10u);
}

TEST(NmeaSwing, pastMidnightTheClockGoesOn)
{
    std::string log;
    for (int i = -2; i < 3; ++i) {
        const int second = (86400 + i) % 86400;
        char body[96];
        std::snprintf(body, sizeof body, "GPRMC,%02d%02d%02d,A,5210.00,N,02057.00,E,8.0,%d.0,%s,,", second / 3600, second / 60 % 60,
            second % 60, 100 + i, i < 0 ? "231126" : "241126");
        log += makeNmea(body) + "\n" + hdg(100 + i);
    }
    const auto swing = read(log, stated(0));
    ASSERT_TRUE(swing);
    EXPECT_NEAR(*swing->pairs[2].turnRate_deg_s, 1.0, 1e-9);
    EXPECT_EQ(swing->pairs[1].timeUtc, "2026-11-23T23:59:59.000Z");
    EXPECT_EQ(swing->pairs[2].timeUtc, "2026-11-24T00:00:00.000Z");
}

TEST(NmeaSwing, damageIsCountedAndLeftOut)
{
    std::string log = circle(0, "HC", 10);
    log.insert(0, "\xff\xfe babble\n$HCHDG,12.0,,,,*00\n");
    log += "$HCHDG,205.2,,,,\n$II"
           "HDG,205.2,,,,\n$GPRM"; // HC sends checksums, II none
    const auto swing = read(log, stated(0));
    ASSERT_TRUE(swing);
    EXPECT_EQ(swing->badChecksums, 2);
    EXPECT_EQ(swing->withoutChecksum, 1);
    EXPECT_EQ(swing->otherLines, 2); // babble, and the half sentence at the end
    EXPECT_EQ(swing->pairs.size(), 36u);
    EXPECT_EQ(swing->warnings.size(), 5u); // two talkers; variation of the model; one-way turn; checksums wrong and missing
}

TEST(NmeaSwing, aVoidFixEndsTheTrack)
{
    const std::string log = rmc(0, 10) + hdg(10) + rmc(1, 11, 8.0, "V,,,,") + hdg(11) + rmc(2, 12) + hdg(12);
    const auto swing = read(log, stated(0));
    ASSERT_TRUE(swing);
    EXPECT_EQ(swing->pairs.size(), 2u);
}

TEST(NmeaSwing, twoTalkers)
{
    const std::string both = rmc(0, 10) + hdg(10, "II") + hdg(14, "HC") + rmc(1, 11) + hdg(11, "II") + hdg(15, "HC");
    const auto compass = read(both, stated(0));
    ASSERT_TRUE(compass);
    EXPECT_EQ(compass->compassTalker, "HC");
    EXPECT_FALSE(compass->warnings.empty());
    auto options = stated(0);
    options.compassTalker = "II";
    EXPECT_DOUBLE_EQ(read(both, options)->pairs.front().compass.degrees(), 10.0);
    options.compassTalker = "HE";
    EXPECT_EQ(read(both, options).error().code, ErrorCode::InvalidInput);
    const auto unclear = read(rmc(0, 10) + hdg(10, "II") + hdg(14, "YX"), stated(0));
    ASSERT_FALSE(unclear);
    EXPECT_NE(unclear.error().message.english().find("IIHDG (1), YXHDG (1)"), std::string::npos) << unclear.error().message.english();
}

TEST(NmeaSwing, anotherInstrumentIsTheReference)
{
    NmeaOptions options;
    options.reference = NmeaReference::Magnetic;
    const auto swing = read(hdg(100, "II") + hdg(103, "HC") + hdg(200, "II") + hdg(198, "HC"), options);
    ASSERT_TRUE(swing);
    ASSERT_EQ(swing->used, 2u); // needs neither speed nor time
    EXPECT_NEAR(deviationOf(swing->pairs[0].magnetic, swing->pairs[0].compass).degrees(), -3.0, 1e-9);
    EXPECT_NEAR(deviationOf(swing->pairs[1].magnetic, swing->pairs[1].compass).degrees(), +2.0, 1e-9);
    EXPECT_FALSE(read(hdg(100) + hdg(101), options));
}

TEST(NmeaSwing, trueHeadingIsTheReference)
{
    auto options = stated(-3.0);
    options.reference = NmeaReference::HeadingTrue;
    const auto swing = read("$GPHDT,274.07,T*03\n" + hdg(276.0), options);
    ASSERT_TRUE(swing);
    EXPECT_NEAR(swing->pairs[0].magnetic.degrees(), 277.07, 1e-9); // magnetic = true − variation
    EXPECT_NEAR(deviationOf(swing->pairs[0].magnetic, swing->pairs[0].compass).degrees(), 1.07, 1e-9);
}

TEST(NmeaSwing, aCorrectedHdmIsLeftOut)
{
    std::string log;
    for (int second = 0; second < 36; ++second)
        log += rmc(second, second) + hdg(second) + makeNmea("HCHDM," + text("%.1f", second + 5.0) + ",M") + "\n";
    const auto swing = read(log, stated(0));
    ASSERT_TRUE(swing);
    EXPECT_EQ(swing->pairs.size(), 36u);
    EXPECT_DOUBLE_EQ(swing->pairs[7].compass.degrees(), 7.0);
}

TEST(NmeaSwing, whatALogLacksIsNamed)
{
    const auto says = [](const Result<NmeaSwing>& result, const char* words) {
        ASSERT_FALSE(result);
        EXPECT_NE(result.error().message.english().find(words), std::string::npos) << result.error().message.english();
        EXPECT_EQ(result.error().file, "turn.nmea");
    };
    says(read(""), "no NMEA 0183 sentence");
    says(read("$HCHDG,1.0,,,,*00\n"), "every checksum is wrong");
    says(read(rmc(0, 10)), "no compass heading");
    says(read(hdg(10), stated(0)), "no compass heading stands beside a valid track");
    says(read(hdg(10) + makeNmea("GPVTG,10.0,T,,M,8.0,N,,K") + "\n"), "no position with a date");
    says(read(hdg(10) + rmc(0, 10, 8.0, "V,,,,"), stated(0)), "no fix");
    says(read(hdg(10) + "$GPRMC,,V,,,,,,,,,,N*53\n" + makeNmea("GPVTG,,T,,M,,N,,K,N") + "\n"), "no fix: the receiver says so in all 2");
    says(read("$HCHDG,-3.0,,,,\n" + rmc(0, 10), stated(0)), "all are negative or beyond 360");
    std::string wide;
    for (const char c : rmc(0, 10) + hdg(10))
        wide += std::string(1, c) + '\0';
    says(read(wide), "UTF-16");
    says(read("\xff\xfe" + wide), "UTF-16");
    EXPECT_EQ(readNmeaSwingFile("/nowhere/turn.nmea", {}).error().code, ErrorCode::Io);
    std::istringstream stream(circle(0));
    EXPECT_EQ(readNmeaSwing(stream, "turn.nmea", {}, [](double) { return false; }).error().code, ErrorCode::Cancelled);
}

} // namespace
} // namespace lubberline
