// `legs` and `continuous`: the contract of their JSON, the files that they write, and what they refuse.

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Number.h"
#include "core/inflight/WindVector.h"
#include "tests/app/Program.h"

namespace lubberline::test {
namespace {

std::string legsFile()
{
    std::string csv = "leg,track_deg,ground_speed_kt,compass_heading_deg\n";
    for (const double heading_deg : {10.0, 100.0, 190.0, 280.0})
        for (int i = 0; i < 3; ++i) {
            const Eigen::Vector2d ground = velocityOf(heading_deg, 60) + Eigen::Vector2d(8, -5);
            csv += "L" + shortestNumber(heading_deg) + "," + shortestNumber(directionOf_deg(ground)) + "," + shortestNumber(ground.norm())
                + "," + shortestNumber(heading_deg - 4) + "\n";
        }
    return csv;
}

TEST(LegsCommand, jsonAndSwing)
{
    const Sandbox sandbox;
    const auto file = sandbox.write("legs.csv", legsFile());
    const auto run = sandbox.run({"legs", file, "--variation", "6 E", "--json"});
    ASSERT_EQ(run.status, 0) << run.err;
    const auto json = run.json();
    EXPECT_NEAR(json.at("wind").at("speed_kt").get<double>(), std::hypot(8, 5), 1e-6);
    EXPECT_NEAR(json.at("wind").at("from_deg").get<double>(), 302.0054, 1e-3);
    EXPECT_NEAR(json.at("airspeed_kt").get<double>(), 60.0, 1e-6);
    ASSERT_EQ(json.at("legs").size(), 4u);
    EXPECT_EQ(json.at("legs")[0].at("samples"), 3);
    EXPECT_NEAR(json.at("legs")[1].at("true_heading_deg").get<double>(), 100.0, 1e-6);
    EXPECT_NEAR(json.at("legs")[1].at("deviation_deg").get<double>(), -2.0, 1e-6);
    ASSERT_EQ(sandbox.run({"legs", file, "--variation", "6", "-o", sandbox.path("swing.csv")}).status, 0);
    const auto analysed = sandbox.run({"analyse", sandbox.path("swing.csv"), "--json"});
    ASSERT_EQ(analysed.status, 0) << analysed.err;
    EXPECT_NEAR(analysed.json().at("approximate").at("A_deg").get<double>(), -2.0, 1e-6);
    // What was read once stands as it was read.
    const auto threes = sandbox.run({"legs",
        sandbox.write("raw.csv",
            "track_deg,ground_speed_kt,compass_heading_deg,variation_deg\n10,120,3,6\n102,115,93.1,6\n188,105,183,6\n281,110,273,6\n"),
        "--json"});
    ASSERT_EQ(threes.status, 0) << threes.err;
    EXPECT_EQ(threes.json().at("legs")[0].at("compass_heading_deg").get<double>(), 3.0);
    EXPECT_EQ(threes.json().at("legs")[1].at("compass_heading_deg").get<double>(), 93.1);
    EXPECT_EQ(sandbox.run({"legs", sandbox.write("two.csv", "track_deg,ground_speed_kt\n10,60\n190,70\n")}).status, 1);
}

std::string continuousLog(int from, int to, bool changes)
{
    std::string csv = "time_s,compass_heading_deg,deviation_deg\n";
    for (int i = from; i < to; ++i) {
        const double heading_deg = i * 77 % 360, heading = toRadians(heading_deg);
        const double deviation_deg = 0.5 - (changes && i >= 300 ? 5.0 : 2.0) * std::sin(heading) + 1.2 * std::cos(heading)
            + 0.5 * std::sin(12.9898 * i) * std::sqrt(2.0);
        csv += std::to_string(i) + "," + shortestNumber(heading_deg) + "," + shortestNumber(deviation_deg) + "\n";
    }
    return csv;
}

TEST(ContinuousCommand, json)
{
    const Sandbox sandbox;
    const auto run = sandbox.run({"continuous", sandbox.write("log.csv", continuousLog(0, 400, true)), "--json"});
    ASSERT_EQ(run.status, 0) << run.err;
    const auto json = run.json();
    EXPECT_EQ(json.at("updates"), 400);
    EXPECT_NEAR(json.at("state").at("C_deg").get<double>(), 1.2, 0.4);
    EXPECT_GT(json.at("standard_error_deg").at("A_deg").get<double>(), 0.0);
    ASSERT_FALSE(json.at("alarms").empty());
    EXPECT_EQ(json.at("alarms")[0].at("coefficient"), "B");
    EXPECT_GE(json.at("alarms")[0].at("time_s"), 300);
    EXPECT_LT(json.at("alarms")[0].at("change_deg").get<double>(), -1.0);
    EXPECT_TRUE(json.at("null_directions").empty());
    EXPECT_FALSE(json.at("history").empty());
    EXPECT_NEAR(json.at("noise_found_deg").get<double>(), 0.5, 0.1); // that nobody stated
    EXPECT_NEAR(json.at("noise_variance_ratio").get<double>(), 1.0, 0.4);
}

TEST(ContinuousCommand, theStateGoesFromFlightToFlight)
{
    const Sandbox sandbox;
    const auto first = sandbox.write("1.csv", continuousLog(0, 150, false)),
               second = sandbox.write("2.csv", continuousLog(150, 300, false)),
               all = sandbox.write("all.csv", continuousLog(0, 300, false));
    const auto state = sandbox.path("state.json");
    ASSERT_EQ(sandbox.run({"continuous", first, "--noise", "0.5", "--state", state}).status, 0);
    const auto after = sandbox.run({"continuous", second, "--noise", "0.5", "--state", state, "--json"});
    ASSERT_EQ(after.status, 0) << after.err;
    const auto whole = sandbox.run({"continuous", all, "--noise", "0.5", "--json"});
    for (const char* key : {"A_deg", "B_deg", "C_deg", "D_deg", "E_deg"})
        EXPECT_NEAR(after.json().at("state").at(key).get<double>(), whole.json().at("state").at(key).get<double>(), 1e-9);
    // Its means are a swing that can be analysed.
    ASSERT_EQ(sandbox.run({"continuous", all, "--swing", sandbox.path("swing.csv")}).status, 0);
    const auto analysed = sandbox.run({"analyse", sandbox.path("swing.csv"), "--json"});
    ASSERT_EQ(analysed.status, 0) << analysed.err;
    EXPECT_NEAR(analysed.json().at("approximate").at("B_deg").get<double>(), -2.0, 0.2);
    sandbox.write("state.json", "{\"format\": 3}");
    EXPECT_EQ(sandbox.run({"continuous", second, "--state", state}).status, 1);
}

/// The log of seconds from another beginning.
std::string laterBy(std::string csv, double later_s)
{
    std::istringstream lines(csv);
    std::string line, later;
    std::getline(lines, line);
    later = line + "\n";
    while (std::getline(lines, line)) {
        const auto comma = line.find(',');
        later += shortestNumber(std::stod(line.substr(0, comma)) + later_s) + line.substr(comma) + "\n";
    }
    return later;
}

TEST(ContinuousCommand, aLogCountsOnceInAState)
{
    const Sandbox sandbox;
    constexpr double kClock_s = 1.7e9;
    const auto first = sandbox.write("1.csv", laterBy(continuousLog(0, 150, false), kClock_s)),
               again = sandbox.write("again.csv", laterBy(continuousLog(0, 150, false), kClock_s)),
               longer = sandbox.write("longer.csv", laterBy(continuousLog(0, 200, false), kClock_s)),
               overlaps = sandbox.write("overlaps.csv", laterBy(continuousLog(100, 250, false), kClock_s)),
               next = sandbox.write("2.csv", laterBy(continuousLog(250, 400, false), kClock_s)),
               elapsed = sandbox.write("elapsed.csv", continuousLog(0, 150, false));
    const auto state = sandbox.path("state.json");
    const auto taken = [&](const std::string& log) { return sandbox.run({"continuous", log, "--noise", "0.5", "--state", state}); };
    ASSERT_EQ(taken(first).status, 0);
    const std::string before = sandbox.read("state.json");
    // The same readings under another name, too.
    const auto refused = taken(again);
    EXPECT_EQ(refused.status, 1);
    EXPECT_NE(refused.err.find("again.csv: is in the state already, and would count twice"), std::string::npos) << refused.err;
    EXPECT_EQ(sandbox.read("state.json"), before);
    const auto quiet = taken(next);
    EXPECT_EQ(quiet.status, 0) << quiet.err;
    EXPECT_EQ(quiet.err.find("in the state already"), std::string::npos) << quiet.err;
    // Of a log between both, and of one that goes on where the first ended, it is told.
    EXPECT_NE(taken(longer).err.find("begins with the readings of a log that is in the state already"), std::string::npos);
    EXPECT_NE(taken(overlaps).err.find("overlaps in time with a log that is in the state already"), std::string::npos);
    // Seconds from the beginning of a log say nothing of the time of another one.
    EXPECT_EQ(taken(elapsed).err.find("in the state already"), std::string::npos);
    EXPECT_EQ(taken(first).status, 1);
    const auto kept = nlohmann::json::parse(sandbox.read("state.json"));
    ASSERT_EQ(kept.at("logs").size(), 5u);
    EXPECT_EQ(kept.at("logs").at(0).at("from_s").get<double>(), kClock_s);
    EXPECT_EQ(kept.at("logs").at(0).at("readings").get<int>(), 150);
}

/// Hard iron (700, −400) nT and nothing else, at attitudes: sin δ = (P x + Q y)/H with x, y across the compass heading.
std::string attitudeLog(int from, int to)
{
    std::string csv = "time_s,compass_heading_deg,deviation_deg,pitch_deg,roll_deg,horizontal_nT,dip_deg\n";
    for (int i = from; i < to; ++i) {
        const double heading_deg = i * 77 % 360, heading = toRadians(heading_deg), pitch = toRadians(i * 13 % 31 - 15),
                     roll = toRadians(i * 29 % 41 - 20);
        const double forward = std::cos(pitch) * std::sin(heading),
                     starboard = std::sin(roll) * std::sin(pitch) * std::sin(heading) + std::cos(roll) * std::cos(heading);
        const double deviation_deg
            = toDegrees(std::asin((700 * forward - 400 * starboard) / 18700)) + 0.2 * std::sin(12.9898 * i) * std::sqrt(2.0);
        csv += std::to_string(i);
        for (const double figure : {heading_deg, deviation_deg, toDegrees(pitch), toDegrees(roll), 18700.0, 67.0})
            csv += "," + shortestNumber(figure);
        csv += "\n";
    }
    return csv;
}

TEST(ContinuousCommand, theWholeSensorModel)
{
    const Sandbox sandbox;
    const auto all = sandbox.write("all.csv", attitudeLog(0, 1200)), state = sandbox.path("state.json");
    const auto whole = sandbox.run({"continuous", all, "--whole-model", "--noise", "0.5", "--json"});
    ASSERT_EQ(whole.status, 0) << whole.err;
    const auto json = whole.json();
    EXPECT_NEAR(json.at("sensor_model").at("hard_iron_nT")[0].get<double>(), 700, 60);
    EXPECT_NEAR(json.at("sensor_model").at("hard_iron_nT")[1].get<double>(), -400, 60);
    EXPECT_NEAR(json.at("level").at("B_deg").get<double>(), toDegrees(700 / 18700.0), 0.1);
    EXPECT_NEAR(json.at("level").at("C_deg").get<double>(), toDegrees(-400 / 18700.0), 0.1);
    EXPECT_TRUE(json.at("state").contains("P_deg"));
    EXPECT_TRUE(json.at("history")[0].at("state").contains("B_deg"));
    // From flight to flight, as A to E; the two kinds do not mix.
    const auto second = sandbox.write("2.csv", attitudeLog(600, 1200));
    ASSERT_EQ(sandbox.run({"continuous", sandbox.write("1.csv", attitudeLog(0, 600)), "--whole-model", "--noise", "0.5", "--state", state})
                  .status,
        0);
    const auto after = sandbox.run({"continuous", second, "--whole-model", "--noise", "0.5", "--state", state, "--json"});
    ASSERT_EQ(after.status, 0) << after.err;
    for (const char* key : {"a_deg", "h_deg", "P_deg", "R_deg"})
        EXPECT_NEAR(after.json().at("state").at(key).get<double>(), json.at("state").at(key).get<double>(), 1e-7) << key;
    EXPECT_EQ(sandbox.run({"continuous", second, "--state", state}).status, 1);
    const auto missing = sandbox.run({"continuous", sandbox.write("level.csv", continuousLog(0, 50, false)), "--whole-model"});
    EXPECT_EQ(missing.status, 1);
    EXPECT_NE(missing.err.find("pitch_deg"), std::string::npos);
    EXPECT_EQ(sandbox.run({"continuous", all, "--whole-model", "-o", sandbox.path("report.pdf")}).status, 0);
}

TEST(ContinuousCommand, badInputIsOneErrorWithItsLine)
{
    const Sandbox sandbox;
    for (const auto& [content, words] :
        {std::pair<std::string, std::string>{"", "is empty"}, {"time_s,deviation_deg\n1,2\n", "compass_heading_deg"},
            {"time_s,compass_heading_deg\n1,2\n", "reference_heading_deg"}, {"time_s,compass_heading_deg,deviation_deg\n", "no pair"},
            {"time_s,compass_heading_deg,deviation_deg\n5,2,1\n4,2,1\n", "log.csv:3: time_s goes back"},
            {"time_s,compass_heading_deg,deviation_deg\n5,north,1\n", "log.csv:2: compass_heading_deg \"north\" is no figure"},
            {"time_s,compass_heading_deg,deviation_deg,reference_error_deg\n5,2,1,0\n", "reference_error_deg is not above 0"}}) {
        const auto run = sandbox.run({"continuous", sandbox.write("log.csv", content), "--json"});
        EXPECT_EQ(run.status, 1) << content;
        EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
    }
}

} // namespace
} // namespace lubberline::test
