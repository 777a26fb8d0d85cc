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
