// `nmea`: the contract of its JSON, its Swing CSV, and what it refuses.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "core/nmea/NmeaSentence.h"
#include "tests/app/Program.h"

namespace lubberline::test {
namespace {

using Json = nlohmann::json;

/// A circle at 1°/s with a compass that reads 2° low: δ = +2 everywhere.
std::string circleLog()
{
    std::string log;
    for (int second = 0; second < 360; second += 5) {
        char body[128];
        std::snprintf(
            body, sizeof body, "GPRMC,10%02d%02d,A,5210.00,N,02057.00,E,8.0,%d.0,231126,,", second / 60, second % 60, (second + 6) % 360);
        log += makeNmea(body) + "\r\n";
        std::snprintf(body, sizeof body, "HCHDG,%d.0,,,,", (second + 358) % 360);
        log += makeNmea(body) + "\r\n";
    }
    return log;
}

TEST(NmeaCommand, json)
{
    const Sandbox sandbox;
    const auto log = sandbox.write("turn.nmea", circleLog() + "$HCHDG,12.0,,,,*00\r\n");
    const auto run = sandbox.run({"nmea", log, "--variation", "6", "--json"});
    ASSERT_EQ(run.status, 0) << run.err;
    const Json json = Json::parse(run.out);
    EXPECT_EQ(json.at("sentences"), 144);
    EXPECT_EQ(json.at("bad_checksums"), 1);
    EXPECT_EQ(json.at("pairs"), 72);
    EXPECT_EQ(json.at("used"), 72);
    EXPECT_EQ(json.at("readings").size(), 72u);
    EXPECT_EQ(json.at("readings")[1].at("compass_heading_deg"), 3.0);
    EXPECT_EQ(json.at("readings")[1].at("magnetic_heading_deg"), 5.0);
    EXPECT_EQ(json.at("readings")[1].at("time_utc"), "2026-11-23T10:00:05.000Z");
    EXPECT_NEAR(json.at("approximate").at("A_deg").get<double>(), 2.0, 1e-9);
    EXPECT_NEAR(json.at("approximate").at("B_deg").get<double>(), 0.0, 1e-9);
}

TEST(NmeaCommand, theVariationIsTakenAsTheWindowTakesIt)
{
    const Sandbox sandbox;
    const auto log = sandbox.write("turn.nmea", circleLog());
    const auto plain = sandbox.run({"nmea", log, "--variation", "-3.25", "--json"});
    ASSERT_EQ(plain.status, 0) << plain.err;
    for (const char* text : {"3.25 W", "3\u00B015'W", "\u22123,25"})
        EXPECT_EQ(sandbox.run({"nmea", log, "--variation", text, "--json"}).out, plain.out) << text;
    EXPECT_EQ(sandbox.run({"nmea", log, "--variation", "3 O"}).status, 2);
}

TEST(NmeaCommand, whatTheTurnCannotTellStandsBesideTheResult)
{
    const Sandbox sandbox;
    const auto run
        = sandbox.run({"nmea", sandbox.write("turn.nmea", circleLog()), "--variation", "6", "--variation-error", "0.5", "--json"});
    ASSERT_EQ(run.status, 0) << run.err;
    const Json json = Json::parse(run.out);
    const Json& delay = json.at("delay");
    EXPECT_TRUE(delay.at("seconds").is_null());
    EXPECT_EQ(delay.at("told_by"), "one-way turn");
    EXPECT_NEAR(delay.at("A_deg_per_s").get<double>(), -1.0, 0.01);
    const double error_s = delay.at("standard_error_s"); // a second, and what the place in the log leaves open
    EXPECT_NEAR(error_s, std::hypot(1.0, 5.0 / std::sqrt(12.0)), 1e-9);
    EXPECT_NEAR(json.at("approximate").at("standard_error_deg").at("A_deg").get<double>(), std::hypot(error_s, 0.5), 0.02);
    EXPECT_EQ(json.at("reference_source"), "GPRMC");
    EXPECT_EQ(json.at("date"), "2026-11-23");
    EXPECT_EQ(json.at("bad_headings"), 0);
    EXPECT_FALSE(json.at("wind").at("taken_out").get<bool>());
    EXPECT_TRUE(json.at("directions").is_null());
    EXPECT_NEAR(json.at("variation_of_model_deg").get<double>(), 7.0, 1.0);
    EXPECT_EQ(sandbox.run({"nmea", sandbox.path("turn.nmea"), "--date", "23.11.2026"}).status, 2);
    EXPECT_EQ(sandbox.run({"nmea", sandbox.path("turn.nmea"), "--wind", "gale"}).status, 2);
}

TEST(NmeaCommand, theCsvIsASwing)
{
    const Sandbox sandbox;
    const auto log = sandbox.write("turn.nmea", circleLog());
    const auto csv = sandbox.path("swing.csv");
    ASSERT_EQ(sandbox.run({"nmea", log, "--variation", "6", "-o", csv}).status, 0);
    const auto run = sandbox.run({"analyse", csv, "--json"});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_NEAR(Json::parse(run.out).at("approximate").at("A_deg").get<double>(), 2.0, 1e-9);
}

TEST(NmeaCommand, cutOffsAndUsage)
{
    const Sandbox sandbox;
    const auto log = sandbox.write("turn.nmea", circleLog());
    const auto run = sandbox.run({"nmea", log, "--variation", "6", "--min-speed", "9", "--json"});
    ASSERT_EQ(run.status, 0);
    const Json json = Json::parse(run.out);
    EXPECT_EQ(json.at("pairs"), 72);
    EXPECT_EQ(json.at("used"), 0);
    EXPECT_TRUE(json.at("approximate").is_null());
    EXPECT_FALSE(json.at("warnings").empty());
    EXPECT_EQ(sandbox.run({"nmea", log, "--variation", "west"}).status, 2);
    EXPECT_EQ(sandbox.run({"nmea", log, "--reference", "sun"}).status, 2);
    const auto missing = sandbox.run({"nmea", sandbox.path("none.nmea"), "--json"});
    EXPECT_EQ(missing.status, 1);
    EXPECT_NE(missing.err.find("none.nmea"), std::string::npos);
    EXPECT_TRUE(missing.out.empty());
}

} // namespace
} // namespace lubberline::test
