// `map`: the contract of its JSON and CSV, the same figures as `simulate`, pictures, differences, and what it refuses.

#include <gmock/gmock.h>

#include <cmath>

#include "tests/app/Program.h"

namespace lubberline::test {

using testing::HasSubstr;

namespace {

const std::string kModel = R"({
  "field": {"H_nT": 20000, "dip_deg": 65},
  "soft_iron": [[0.03, 0.002, -0.01], [-0.004, -0.02, 0.005], [0.01, 0, 0.04]],
  "hard_iron_nT": [900, -600, 400],
  "circuits": [{"name": "landing light", "field_nT_per_A": [14, -38, 9], "current_A": 20, "on": true}],
  "misalignment_deg": {"roll": 0.5, "pitch": -0.3, "yaw": 1}
})";

double deviationIn(const nlohmann::json& map, std::size_t x, std::size_t y) { return map.at("deviation_deg").at(y).at(x).get<double>(); }

TEST(MapCommand, hasEveryKeyOfTheContract)
{
    const Sandbox sandbox;
    const auto outcome = sandbox.run({"map", sandbox.write("model.json", kModel), "--x", "heading", "--y", "roll", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const auto json = outcome.json();
    EXPECT_EQ(json.at("kind"), "modelled");
    ASSERT_EQ(json.at("x_deg").size(), 361u);
    ASSERT_EQ(json.at("y_deg").size(), 181u);
    EXPECT_EQ(json.at("x_deg")[0], 0);
    EXPECT_EQ(json.at("x_deg")[360], 360);
    EXPECT_EQ(json.at("y_deg")[0], -180);
    EXPECT_EQ(json.at("y_deg")[180], 180);
    ASSERT_EQ(json.at("deviation_deg").size(), 181u) << "rows follow y";
    double largest = -400, smallest = 400;
    for (const auto& row : json.at("deviation_deg")) {
        ASSERT_EQ(row.size(), 361u);
        for (const auto& value : row) {
            largest = std::max(largest, value.get<double>());
            smallest = std::min(smallest, value.get<double>());
        }
    }
    EXPECT_EQ(json.at("extremes")[0].at("kind"), "maximum");
    EXPECT_EQ(json.at("extremes")[0].at("deviation_deg"), largest);
    EXPECT_EQ(json.at("extremes")[1].at("kind"), "minimum");
    EXPECT_EQ(json.at("extremes")[1].at("deviation_deg"), smallest);
    EXPECT_TRUE(json.at("vanishing").empty());
    EXPECT_EQ(json.at("held"), (nlohmann::json{{"axis", "pitch"}, {"deg", 0}}));
}

TEST(MapCommand, isWhatSimulateSays)
{
    const Sandbox sandbox;
    const auto model = sandbox.write("model.json", kModel);
    const auto points
        = sandbox.run({"simulate", model, "--headings", "0:30:330", "--pitch", "-15", "--roll", "45", "--json"}).json().at("points");
    const auto overPitch = sandbox.run({"map", model, "--y", "pitch", "--roll", "45", "--size", "13x13", "--json"}).json();
    const auto overRoll = sandbox.run({"map", model, "--y", "roll", "--held", "-15", "--size", "13x9", "--json"}).json();
    ASSERT_EQ(points.size(), 12u);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double deviation_deg = points[i].at("deviation_deg");
        EXPECT_NEAR(deviationIn(overPitch, i, 5), deviation_deg, 1e-9);
        EXPECT_NEAR(deviationIn(overRoll, i, 5), deviation_deg, 1e-9);
        const auto attitudes = sandbox.run({"map", model, "--x", "pitch", "--heading", std::to_string(30 * i), "--size", "13x9", "--json"});
        EXPECT_NEAR(deviationIn(attitudes.json(), 5, 5), deviation_deg, 1e-9);
    }
}

TEST(MapCommand, csv)
{
    const Sandbox sandbox;
    const auto outcome = sandbox.run({"map", sandbox.write("model.json", kModel), "--size", "5x3", "--roll", "12.5", "-o", "map.csv"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    const std::string csv = sandbox.read("map.csv");
    EXPECT_EQ(csv.find("heading_deg,pitch_deg,roll_deg,deviation_deg\n0,-90,12.5,"), 0u) << csv;
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 16);
}

TEST(MapCommand, pictures)
{
    const Sandbox sandbox;
    const auto model = sandbox.write("model.json", kModel);
    const std::pair<const char*, const char*> files[] = {{"map.png", "\x89PNG"}, {"map.svg", "<?xml"}, {"map.pdf", "%PDF"}};
    for (const auto& [file, begin] : files) {
        const auto map = sandbox.run({"map", model, "--limit", "3", "-o", file});
        ASSERT_EQ(map.status, 0) << map.err;
        const std::string flat = sandbox.read(file);
        EXPECT_EQ(flat.rfind(begin, 0), 0u);
        EXPECT_GT(flat.size(), 10'000u);
        ASSERT_EQ(sandbox.run({"map", model, "--surface", "-o", file}).status, 0);
        EXPECT_NE(sandbox.read(file), flat) << "the surface is another picture";
    }
}

TEST(MapCommand, circuitsAndDifferences)
{
    const Sandbox sandbox;
    const auto model = sandbox.write("model.json", kModel);
    const auto on = sandbox.run({"map", model, "--size", "9x5", "--json"}).json();
    const auto off = sandbox.run({"map", model, "--size", "9x5", "--switch", "landing light=off", "--json"}).json();
    const auto difference
        = sandbox.run({"map", "--switch", "landing light=off", model, "--size", "9x5", "--minus", model, "--json"}).json();
    EXPECT_EQ(on.at("model").at("circuits_on"), nlohmann::json{"landing light"});
    EXPECT_TRUE(off.at("model").at("circuits_on").empty());
    EXPECT_EQ(difference.at("minus").at("circuits_on"), nlohmann::json{"landing light"});
    EXPECT_TRUE(on.at("minus").is_null());
    for (std::size_t y = 0; y < 5; ++y)
        for (std::size_t x = 0; x < 9; ++x) {
            EXPECT_NE(deviationIn(on, x, y), deviationIn(off, x, y));
            EXPECT_NEAR(deviationIn(difference, x, y), deviationIn(off, x, y) - deviationIn(on, x, y), 1e-9);
        }
}

TEST(MapCommand, aFieldThatVanishesIsNull)
{
    const Sandbox sandbox;
    const auto model = sandbox.write("model.json", R"({"field": {"H_nT": 20000, "dip_deg": 60}, "hard_iron_nT": [-20000, 0, 0]})");
    const auto json = sandbox.run({"map", model, "--size", "5x3", "--json"}).json();
    EXPECT_TRUE(json.at("deviation_deg")[1][0].is_null());
    EXPECT_TRUE(json.at("deviation_deg")[1][4].is_null());
    EXPECT_TRUE(json.at("deviation_deg")[1][2].is_number());
    const auto nothing = sandbox.run({"map", sandbox.write("none.json", R"({"field": {"H_nT": 0, "Z_nT": 0}})"), "-o", "map.png"});
    EXPECT_TRUE(nothing.status == 0 || nothing.err.find("none.json") != std::string::npos) << nothing.err;
}

TEST(MapCommand, aTableWithoutJson)
{
    const Sandbox sandbox;
    const auto outcome = sandbox.run({"map", sandbox.write("model.json", kModel)});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    for (const char* word :
        {"modelled", "heading and pitch", "roll 0 deg", "361 x 181", "maximum", "minimum", "model.json", "H 20000.0 nT"})
        EXPECT_THAT(outcome.out, HasSubstr(word));
}

TEST(MapCommand, refusesWithTheReasonAndLeavesNothing)
{
    const Sandbox sandbox;
    const auto model = sandbox.write("model.json", kModel);
    const auto large = sandbox.run({"map", model, "--size", "100000x100000", "-o", "map.png"});
    EXPECT_EQ(large.status, 1);
    EXPECT_THAT(large.err, HasSubstr("10000000000 points"));
    EXPECT_THAT(large.err, HasSubstr("MiB"));
    const auto circuit = sandbox.run({"map", model, "--switch", "pitot heat=on", "-o", "map.png"});
    EXPECT_EQ(circuit.status, 1);
    EXPECT_THAT(circuit.err, HasSubstr("model.json: there is no circuit \"pitot heat\"; the model has landing light"));
    EXPECT_EQ(sandbox.run({"map", model, "--minus", "other.json", "-o", "map.png"}).status, 1);
    EXPECT_EQ(sandbox.run({"map", model, "-o", "no/such/folder/map.csv"}).status, 1);
    EXPECT_EQ(
        sandbox.run({"map", sandbox.write("bad.json", R"({"field": {"H_nT": 1, "dip_deg": 0}, "hardiron_nT": [0, 0, 0]})")}).status, 1);
    const std::vector<std::vector<std::string>> wrong{{"--x", "roll", "--y", "roll"}, {"--x", "up"}, {"--pitch", "3"},
        {"--roll", "1", "--held", "1"}, {"--held", "nan"}, {"--roll", "181"}, {"--size", "361"}, {"--size", "1x9"}, {"--size", "3x3x3"},
        {"--size", "-3x3"}, {"-o", "map.txt"}, {"--surface"}, {"--surface", "-o", "map.csv"}, {"--limit", "3"},
        {"--limit", "0", "-o", "map.png"}, {"--json", "-o", "map.json"}, {"--switch", "x=maybe", "--x", "up"}};
    for (auto arguments : wrong) {
        arguments.insert(arguments.begin(), {"map", model});
        const auto outcome = sandbox.run(arguments);
        EXPECT_EQ(outcome.status, 2) << arguments[2] << ' ' << outcome.err;
        EXPECT_EQ(outcome.out, "");
    }
    EXPECT_EQ(sandbox.run({"map"}).status, 2);
    EXPECT_THAT(sandbox.files(), testing::UnorderedElementsAre("bad.json", "model.json"));
}

} // namespace
} // namespace lubberline::test
