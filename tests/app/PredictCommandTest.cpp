// `predict` and `separate`: the contract of their JSON, held against each other, and what they refuse.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/app/Program.h"

namespace lubberline::test {
namespace {

using Json = nlohmann::json;

const std::string kModel
    = R"({"field": {"lat_deg": 52.2, "lon_deg": 21, "alt_m": 100, "date": "2026-11-23"}, "hard_iron_nT": [1000, 0, 0]})";

/// A demonstration with magnetometers that were swung far apart; the record ids of one compass's swings, the newest first.
struct Demonstration {
    Sandbox sandbox;
    std::vector<std::string> swings;
    Demonstration()
    {
        EXPECT_EQ(sandbox.run({"demo", "--no-window", "--db", "demo.lubberline"}).status, 0);
        std::string aircraft;
        const Json listed = sandbox.run({"swings", "--db", "demo.lubberline", "--json"}).json(); // by value: the loop refers into it
        for (const auto& swing : listed.at("swings"))
            if (swing.at("compass") == "AHRS magnetometer" && (aircraft.empty() || swing.at("aircraft") == aircraft)) {
                aircraft = swing.at("aircraft");
                swings.push_back(swing.at("record"));
            }
        EXPECT_GE(swings.size(), 3u);
    }
};

TEST(PredictCommand, fromAModel)
{
    const Sandbox sandbox;
    const auto run
        = sandbox.run({"predict", sandbox.write("model.json", kModel), "--lat", "1.3", "--lon", "103.9", "--date", "2026-11-23", "--json"});
    ASSERT_EQ(run.status, 0) << run.err;
    const Json json = run.json();
    const double H = json.at("there").at("H_nT");
    EXPECT_NEAR(H, 41000, 1500);
    const Json& east = json.at("points").at(18); // every 5 degrees
    EXPECT_EQ(east.at("magnetic_heading_deg"), 90.0);
    EXPECT_NEAR(east.at("deviation_deg").get<double>(), std::atan(1000 / H) * 180 / 3.14159265358979, 1e-6); // P ahead, on east
    EXPECT_EQ(east.at("lowest_deg"), east.at("highest_deg"));
    EXPECT_NEAR(json.at("exact").at("B").get<double>(), 1000 / H, 1e-12);
    EXPECT_EQ(json.at("verdict"), "no_limit");
    EXPECT_TRUE(json.at("swing_again").contains("needed"));
    EXPECT_TRUE(json.at("bounds").at("probability").is_null()); // a model assumes nothing
    EXPECT_EQ(json.at("max_change").at("expected_deg"), json.at("max_change").at("bound_deg"));
}

TEST(PredictCommand, fromOneSwingAndFromSwingsAtSeveralPlaces)
{
    const Demonstration demo;
    const std::vector<std::string> there{"--db", "demo.lubberline", "--lat", "-32", "--lon", "115.9", "--date", "2026-11-23", "--json"};
    const auto width = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "predict");
        arguments.insert(arguments.end(), there.begin(), there.end());
        const auto run = demo.sandbox.run(arguments);
        EXPECT_EQ(run.status, 0) << run.err;
        const Json json = run.json();
        double widest = 0;
        for (const auto& point : json.at("points"))
            widest = std::max(widest, point.at("highest_deg").get<double>() - point.at("lowest_deg").get<double>());
        EXPECT_NE(json.at("verdict"), "no_limit");
        EXPECT_EQ(json.at("bounds").at("probability"), 0.95);
        for (const char* size : {"c_f", "P_Q_nT", "compensator_nT", "compass_one_cycle_deg"})
            EXPECT_GT(json.at("bounds").at("assumed_sizes").at(size).get<double>(), 0) << size;
        EXPECT_GE(json.at("max_change").at("bound_deg"), json.at("max_change").at("expected_deg"));
        if (json.at("verdict") != "out_of_limits") {
            EXPECT_NE(json.at("swing_again").at("reason").get<std::string>().find("95 %, assuming"), std::string::npos);
        }
        return widest;
    };
    const double one = width({"--swing", demo.swings[0]});
    const double three = width({"--swing", demo.swings[0], "--swing", demo.swings[1], "--swing", demo.swings[2]});
    EXPECT_GT(one, 0.5);
    EXPECT_LT(three, one);
    EXPECT_LT(width({"--swing", demo.swings[0], "--assume-soft", "0.01", "--assume-magnets-nT", "500", "--assume-hard-nT", "500"}), one);
}

TEST(PredictCommand, refusals)
{
    const Sandbox sandbox;
    const auto model = sandbox.write("model.json", kModel);
    const auto status = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "predict");
        const auto run = sandbox.run(arguments);
        EXPECT_TRUE(run.out.empty());
        EXPECT_FALSE(run.err.empty());
        return run.status;
    };
    EXPECT_EQ(status({model, "--lat", "91", "--lon", "0", "--date", "2026-11-23"}), 1);
    EXPECT_EQ(status({model, "--lat", "50", "--lon", "0", "--date", "2042-11-23"}), 1);
    EXPECT_EQ(status({model, "--lat", "85.8", "--lon", "139.3", "--date", "2026-11-23"}), 1); // blackout
    EXPECT_EQ(status({model, "--lat", "50", "--lon", "0", "--date", "2026-11-23", "--assume-soft", "-1"}), 2);
    EXPECT_EQ(status({"--lat", "50", "--lon", "0", "--date", "2026-11-23"}), 2);
    EXPECT_EQ(status({model, "--lat", "50", "--lon", "0", "--date", "2026-11-23", "-o", "curve.xls"}), 2);
    EXPECT_EQ(status({"--swing", "none", "--db", "none.lubberline", "--lat", "50", "--lon", "0", "--date", "2026-11-23"}), 1);
}

TEST(PredictCommand, csv)
{
    const Sandbox sandbox;
    const auto model = sandbox.write("model.json", kModel);
    ASSERT_EQ(sandbox.run({"predict", model, "--lat", "50", "--lon", "0", "--date", "2026-11-23", "-o", "curve.csv"}).status, 0);
    EXPECT_TRUE(sandbox.read("curve.csv").starts_with("magnetic_heading_deg,deviation_deg,lowest_deg,highest_deg\n0,"));
}

TEST(SeparateCommand, tellsTheIronOfTheDemonstration)
{
    const Demonstration demo;
    const auto run = demo.sandbox.run(
        {"separate", "--db", "demo.lubberline", "--swing", demo.swings[0], "--swing", demo.swings[1], "--swing", demo.swings[2], "--json"});
    ASSERT_EQ(run.status, 0) << run.err;
    const Json json = run.json();
    for (const char* key : {"c", "f", "P_nT", "Q_nT"}) {
        EXPECT_GT(json.at(key).at("standard_error").get<double>(), 0.0) << key;
        EXPECT_GT(std::abs(json.at(key).at("value").get<double>()), json.at(key).at("standard_error").get<double>()) << key;
    }
    EXPECT_LT(json.at("condition_number").get<double>(), 30.0);
    EXPECT_EQ(json.at("known").size(), 7u);
    EXPECT_EQ(demo.sandbox.run({"separate", "--db", "demo.lubberline", "--swing", demo.swings[0]}).status, 1);
}

} // namespace
} // namespace lubberline::test
