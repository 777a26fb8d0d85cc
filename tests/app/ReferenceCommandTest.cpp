// `reference`, `sun`, `alignment` and `grid`: their JSON, published figures through the program, and what they refuse.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "tests/app/Program.h"

namespace lubberline::test {
namespace {

void write(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

TEST(ReferenceCommand, kaytonsFirstOrderLoop)
{
    const Sandbox sandbox;
    const auto file = sandbox.path("scenario.json");
    write(file, R"({"step_s": 1, "duration_s": 300, "manoeuvres": [{"from_s": 0, "to_s": 60, "acceleration_m_s2": 0.980665}],
                    "vertical": {"loop": "first", "tau1_s": 60, "rate_compensation": true}})");
    const auto run = sandbox.run({"reference", file, "--json"});
    ASSERT_EQ(run.status, 0) << run.err;
    const auto json = run.json();
    EXPECT_NEAR(json.at("vertical_error_deg")[60].get<double>(), 5.729578 * (1 - std::exp(-1.0)), 6e-5);
    EXPECT_NEAR(json.at("vertical_error_deg")[120].get<double>(), 1.3324, 6e-5);
    EXPECT_EQ(json.at("time_s").size(), 301u);
    EXPECT_EQ(json.at("heading_error_deg").size(), 301u);
    EXPECT_EQ(json.at("shares")[0].at("source"), "tilt");
    EXPECT_EQ(json.at("shares").back().at("source"), "together");
    EXPECT_TRUE(json.at("loop").at("stable").get<bool>());
    const auto few = sandbox.run({"reference", file, "--json", "--every", "60"});
    EXPECT_EQ(few.json().at("time_s").size(), 6u);
}

TEST(ReferenceCommand, northIsZeroAndNothingHasNoSign)
{
    const Sandbox sandbox;
    const auto file = sandbox.path("scenario.json");
    write(file, R"({"step_s": 1, "duration_s": 30, "heading_deg": 1, "dip_deg": 60,
                    "manoeuvres": [{"from_s": 0, "to_s": 10, "turn_rate_deg_s": -0.1003}]})");
    const auto run = sandbox.run({"reference", file});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.out.find("360.00"), std::string::npos) << run.out; // 359.997°
    EXPECT_EQ(run.out.find("-0.000"), std::string::npos) << run.out;
}

TEST(ReferenceCommand, theExampleAndItsTable)
{
    const Sandbox sandbox;
    const std::string example = LUBBERLINE_SAMPLES "/example-scenario.csv";
    const auto table = sandbox.run({"reference", example});
    ASSERT_EQ(table.status, 0) << table.err;
    EXPECT_NE(table.out.find("levelling loop"), std::string::npos);
    const auto csv = sandbox.path("out.csv");
    ASSERT_EQ(sandbox.run({"reference", example, "-o", csv}).status, 0);
    std::string head;
    std::ifstream file(csv);
    std::getline(file, head);
    EXPECT_EQ(head.substr(0, 18), "time_s,heading_deg");
    EXPECT_NE(head.find(",together_deg"), std::string::npos);
}

TEST(ReferenceCommand, instabilityAndRefusals)
{
    const Sandbox sandbox;
    const auto file = sandbox.path("scenario.json");
    write(file, R"({"duration_s": 10, "vertical": {"loop": "third", "tau2_s": 20, "tau3_s": 10}})");
    EXPECT_NE(sandbox.run({"reference", file}).err.find("tau3 > tau2"), std::string::npos);
    EXPECT_FALSE(sandbox.run({"reference", file, "--json"}).json().at("loop").at("stable").get<bool>());
    write(file, R"({"latitude_deg": 99})");
    const auto wrong = sandbox.run({"reference", file, "--json"});
    EXPECT_EQ(wrong.status, 1);
    EXPECT_TRUE(wrong.out.empty());
    EXPECT_NE(wrong.err.find("latitude_deg"), std::string::npos);
    EXPECT_EQ(sandbox.run({"reference", sandbox.path("none.json")}).status, 1);
    EXPECT_EQ(sandbox.run({"reference", file, "--every", "0"}).status, 2);
}

TEST(SunCommand, theAlgorithmsExample)
{
    const Sandbox sandbox;
    const auto run = sandbox.run({"sun", "--lat", "39.742476", "--lon", "-105.1786", "--time", "2003-10-17T12:30:30-07:00", "--json"});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_NEAR(run.json().at("azimuth_deg").get<double>(), 194.34024, 0.02);
    EXPECT_TRUE(run.json().at("usable").get<bool>());
    const auto night = sandbox.run({"sun", "--lat", "52", "--lon", "21", "--time", "2026-12-21T22:00:00Z"});
    EXPECT_EQ(night.status, 0);
    EXPECT_NE(night.err.find("below the horizon"), std::string::npos);
    EXPECT_EQ(sandbox.run({"sun", "--lat", "52", "--lon", "21", "--time", "2026-12-21T22:00:00"}).status, 1);
    EXPECT_EQ(sandbox.run({"sun", "--lat", "92", "--lon", "21", "--time", "2026-12-21T22:00:00Z"}).status, 1);
}

/// A compass with A = +2, swung by a shadow pin: eight headings, the sun moving on; and the same with the clock an hour fast.
TEST(SunCommand, aSwingAnywhere)
{
    const Sandbox sandbox;
    const auto azimuthAt = [&](const std::string& time) {
        return sandbox.run({"sun", "--lat", "52", "--lon", "21", "--time", time, "--json"}).json().at("azimuth_deg").get<double>();
    };
    const auto fileOf = [&](int hourWritten) {
        std::string text = "time_utc,compass_heading_deg,shadow_bearing_deg\n";
        for (int i = 0; i < 8; ++i) {
            const std::string minutes = (i < 2 ? "0" : "") + std::to_string(5 * i);
            const double trueHeading = 45 * i, azimuth = azimuthAt("2026-06-01T09:" + minutes + ":00Z");
            const double compass = trueHeading - 6 - 2; // variation 6° E, deviation +2
            text += "2026-06-01T" + std::string(hourWritten < 10 ? "0" : "") + std::to_string(hourWritten) + ":" + minutes + ":00Z,"
                + std::to_string(std::fmod(compass + 360, 360)) + "," + std::to_string(std::fmod(azimuth + 180 - trueHeading + 720, 360))
                + "\n";
        }
        const auto path = sandbox.path("sun" + std::to_string(hourWritten) + ".csv");
        write(path, text);
        return path;
    };
    const auto swing = sandbox.path("swing.csv");
    const auto made = sandbox.run({"sun", "--lat", "52", "--lon", "21", "--variation", "6", "--readings", fileOf(9), "-o", swing});
    ASSERT_EQ(made.status, 0) << made.err;
    EXPECT_EQ(made.err.find("daylight"), std::string::npos) << made.err;
    const auto analysis = sandbox.run({"analyse", swing, "--json"});
    ASSERT_EQ(analysis.status, 0) << analysis.err;
    EXPECT_NEAR(analysis.json().at("approximate").at("A_deg").get<double>(), 2, 1e-3);
    // A stated variation has no error of its own; the model's has, and 5° of plumb are in B and C.
    const auto sharedOf = [&](std::vector<std::string> more) {
        std::vector<std::string> arguments{"sun", "--lat", "52", "--lon", "21", "--readings", fileOf(9), "--json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const auto run = sandbox.run(arguments);
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_EQ(run.json().at("readings").size(), 8u);
        return run.json().at("shared_error_deg");
    };
    EXPECT_LT(sharedOf({"--variation", "6"}).at("A_deg").get<double>(), 0.1);
    EXPECT_NEAR(sharedOf({"--variation", "6", "--variation-error-deg", "1"}).at("A_deg").get<double>(), 1, 0.02);
    EXPECT_NEAR(sharedOf({}).at("A_deg").get<double>(), 0.38, 0.06);
    EXPECT_GT(sharedOf({"--plumb-error-deg", "5"}).at("B_deg").get<double>(), 4);
    const auto wide = sandbox.path("wide.csv");
    ASSERT_EQ(sandbox.run({"sun", "--lat", "52", "--lon", "21", "--readings", fileOf(9), "--plumb-error-deg", "5", "-o", wide}).status, 0);
    const auto analysed = sandbox.run({"analyse", wide, "--json"});
    EXPECT_GT(analysed.json().at("approximate").at("standard_error_deg").at("B_deg").get<double>(), 4);
    EXPECT_EQ(analysed.err.find("means nothing here"), std::string::npos) << analysed.err;
    EXPECT_EQ(sandbox.run({"sun", "--lat", "52", "--lon", "21", "--readings", fileOf(9), "--json", "-o", "-"}).status, 2);
    const auto fast = sandbox.run({"sun", "--lat", "52", "--lon", "21", "--variation", "6", "--readings", fileOf(10)});
    EXPECT_EQ(fast.status, 0);
    EXPECT_NE(fast.err.find("an hour fast"), std::string::npos) << fast.err;
    const auto night = fileOf(23);
    const auto dark = sandbox.run({"sun", "--lat", "52", "--lon", "21", "--readings", night, "-o", sandbox.path("dark.csv")});
    EXPECT_EQ(dark.status, 1);
    EXPECT_NE(dark.err.find("below the horizon"), std::string::npos);
    EXPECT_EQ(sandbox.run({"sun", "--lat", "52", "--lon", "21"}).status, 2);
}

TEST(CheckCommand, headingsVerdictAndASwingToSign)
{
    const Sandbox sandbox;
    std::vector<std::string> history;
    for (int year = 2020; year < 2026; ++year) {
        std::string text = "# aircraft: SP-ABC\n# compass: standby\n# date: " + std::to_string(year)
            + "-06-01\nmagnetic_heading_deg,compass_heading_deg\n";
        for (int heading = 0; heading < 360; heading += 45)
            text += std::to_string(heading) + "," + std::to_string((heading + 358) % 360) + "\n";
        history.push_back(sandbox.path("h" + std::to_string(year) + ".csv"));
        write(history.back(), text);
    }
    std::vector<std::string> call{"check", "--date", "2026-03-01"};
    for (const auto& file : history)
        call.insert(call.end(), {"--history", file});
    auto choose = call;
    choose.push_back("--json");
    const auto chosen = sandbox.run(choose);
    ASSERT_EQ(chosen.status, 0) << chosen.err;
    EXPECT_EQ(chosen.json().at("headings_deg").size(), 3u);
    EXPECT_EQ(chosen.json().at("history").at("swings"), 6);
    EXPECT_NEAR(chosen.json().at("history").at("card").at("A_deg").get<double>(), 2, 1e-6);
    const auto readings = sandbox.path("readings.csv"), out = sandbox.path("check.csv");
    write(readings,
        "# date: 2026-03-01\n# aircraft: SP-ABC\n# compass: standby\nmagnetic_heading_deg,compass_heading_deg\n2,0\n122,120\n242,240\n");
    auto judge = call;
    judge.insert(judge.end(), {readings, "--json"});
    const auto holds = sandbox.run(judge);
    ASSERT_EQ(holds.status, 0) << holds.err;
    EXPECT_EQ(holds.json().at("verdict"), "holds");
    EXPECT_LT(holds.json().at("error_probability").get<double>(), 0.05);
    // One file a flag, before and behind the readings, which it never takes.
    const auto before = sandbox.run({"check", "--date", "2026-03-01", "--json", "--history", history[0], readings});
    EXPECT_EQ(before.json().at("verdict"),
        sandbox.run({"check", "--date", "2026-03-01", readings, "--json", "--history", history[0]}).json().at("verdict"));
    EXPECT_EQ(sandbox.run({"check", "--history", history[0], history[1], readings}).status, 2);
    // A history is of this compass, and has each swing once; what is checked is no part of it.
    const auto other = sandbox.path("other.csv");
    write(other,
        "# aircraft: SP-OTH\n# compass: no 2\n# date: 2024-01-01\nmagnetic_heading_deg,compass_heading_deg\n0,0\n120,120\n240,240\n");
    for (const auto& [file, said] :
        {std::pair{other, "this swing is of SP-OTH, no 2"}, std::pair{history[1], "once more"}, std::pair{readings, "once more"}}) {
        auto wrong = call;
        wrong.insert(wrong.end(), {"--history", file, readings});
        const auto run = sandbox.run(wrong);
        EXPECT_EQ(run.status, 1) << file;
        EXPECT_NE(run.err.find(said), std::string::npos) << run.err;
    }
    EXPECT_EQ(sandbox.run({"check", "--history", history[0], other}).status, 1) << "the readings are of another compass";
    const auto pairs = sandbox.path("pairs.csv");
    write(pairs, "first_compass_deg,second_compass_deg\n0,0\n90,90\n");
    EXPECT_EQ(sandbox.run({"compare", pairs, "--first-history", history[0], "--second-history", history[0]}).status, 1);
    EXPECT_EQ(sandbox.run({"compare", pairs, "--first-history", history[0], "--second-history", history[1]}).status, 1);
    write(readings,
        "# date: 2026-03-01\n# aircraft: SP-ABC\n# compass: standby\nmagnetic_heading_deg,compass_heading_deg\n10,0\n130,120\n242,240\n");
    EXPECT_EQ(sandbox.run(judge).json().at("verdict"), "swing it");
    judge.back() = "-o";
    judge.push_back(out);
    ASSERT_EQ(sandbox.run(judge).status, 0);
    // Readings that name no aircraft are told beside a history that does, and in the check that is written.
    const auto nameless = sandbox.path("nameless.csv");
    write(nameless, "# date: 2026-03-01\nmagnetic_heading_deg,compass_heading_deg\n2,0\n122,120\n242,240\n");
    const auto told = sandbox.run({"check", "--date", "2026-03-01", "--history", history[0], nameless, "-o", out + ".csv"});
    EXPECT_EQ(told.status, 0);
    EXPECT_NE(told.err.find("nameless.csv does not say of which aircraft and compass it is"), std::string::npos) << told.err;
    EXPECT_NE(sandbox.read("check.csv.csv").find("did not say of which aircraft they are"), std::string::npos);
    // The check is a swing that can be completed and signed with its three readings.
    const auto database = sandbox.path("fleet.lubberline");
    ASSERT_EQ(sandbox.run({"import", out, "--db", database}).status, 0);
    const auto swings = sandbox.run({"swings", "--db", database, "--json"}).json();
    const auto& list = swings.is_array() ? swings : swings.at("swings");
    const std::string id = list[0].at("record");
    const auto complete = sandbox.run({"complete", id, "--db", database});
    EXPECT_EQ(complete.status, 0) << complete.err;
    const auto sign = sandbox.run({"sign", id, "--role", "performer", "--name", "A. Tech", "--db", database});
    EXPECT_EQ(sign.status, 0) << sign.err;
    // Without a history it says what it cannot know.
    EXPECT_NE(sandbox.run({"check", readings}).err.find("no swing on record"), std::string::npos);
    EXPECT_EQ(sandbox.run({"check", "--headings", "0"}).status, 2);
}

TEST(CompareCommand, toldByADatum)
{
    const Sandbox sandbox;
    const auto pairs = sandbox.path("pairs.csv");
    std::string text = "first_compass_deg;second_compass_deg;magnetic_heading_deg\n";
    for (int heading = 0; heading < 360; heading += 45)
        text += std::to_string(heading) + ";" + std::to_string(heading + 8 < 360 ? heading + 8 : heading - 352) + ";"
            + (heading == 90 || heading == 270 ? std::to_string(heading) : "") + "\n";
    write(pairs, text);
    const auto run = sandbox.run({"compare", pairs, "--json"});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.json().at("pairs"), 8);
    EXPECT_EQ(run.json().at("pairs_with_datum"), 2);
    EXPECT_NEAR(run.json().at("difference").at("A_deg").get<double>(), -8, 0.1);
    EXPECT_GT(run.json().at("second_fault_probability").get<double>(), 0.9);
    write(pairs, "first_compass_deg\n3\n");
    EXPECT_EQ(sandbox.run({"compare", pairs}).status, 1);
}

TEST(AlignmentCommand, budgets)
{
    const Sandbox sandbox;
    const auto gyro = sandbox.run({"alignment", "gyro", "--json"});
    ASSERT_EQ(gyro.status, 0) << gyro.err;
    EXPECT_NEAR(gyro.json().at("standard_deviation_deg").get<double>(), 0.1, 0.02);
    EXPECT_EQ(gyro.json().at("budget").size(), 3u);
    EXPECT_EQ(sandbox.run({"alignment", "astro"}).status, 2);
    EXPECT_EQ(sandbox.run({"alignment", "astro", "--lat", "52", "--lon", "21", "--time", "2026-06-21T08:00:00Z"}).status, 0);
    EXPECT_EQ(sandbox.run({"alignment", "stars"}).status, 2);
}

TEST(GridCommand, nearThePole)
{
    const Sandbox sandbox;
    const auto run = sandbox.run({"grid", "--lat", "85", "--lon", "60", "--true-heading", "30", "--date", "2026.5", "--json"});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.json().at("grid_heading_deg"), 330);
    EXPECT_EQ(run.json().at("convergence_deg"), 60);
    EXPECT_GT(run.json().at("table").at("nearest").at("largest_error_deg").get<double>(), 1);
    EXPECT_EQ(sandbox.run({"grid", "--lat", "85", "--lon", "60", "--true-heading", "30", "--date", "1800"}).status, 1);
}

} // namespace
} // namespace lubberline::test
