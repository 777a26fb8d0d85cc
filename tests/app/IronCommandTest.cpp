// `iron`: the example airframe, its states, the model file that the other commands take, and what it refuses.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/app/Program.h"

namespace lubberline::test {
namespace {

const std::string kAirframe = LUBBERLINE_SAMPLES "/example-airframe.json";

TEST(IronCommand, json)
{
    const Sandbox sandbox;
    const auto run = sandbox.run({"iron", kAirframe, "--json"});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.err, "");
    const auto json = run.json();
    EXPECT_EQ(json.at("states").at("gear"), "retracted");
    ASSERT_EQ(json.at("parts").size(), 5u);
    ASSERT_EQ(json.at("circuits").size(), 2u);
    EXPECT_EQ(json.at("circuits")[0].at("field_nT_per_A").size(), 3u);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double sum = 0;
        for (const auto& part : json.at("parts"))
            sum += part.at("hard_iron_nT")[axis].get<double>();
        EXPECT_NEAR(json.at("hard_iron_nT")[axis].get<double>(), sum, 1e-9 + 1e-12 * std::abs(sum));
    }
    EXPECT_EQ(json.at("parts")[0].at("method"), "dipole");
    EXPECT_EQ(json.at("parts")[4].at("method"), "tensor");
}

TEST(IronCommand, statesMoveTheParts)
{
    const Sandbox sandbox;
    const auto up = sandbox.run({"iron", kAirframe, "--state", "gear=retracted", "--json"}).json();
    const auto down = sandbox.run({"iron", kAirframe, "--state", "gear=extended", "--json"}).json();
    EXPECT_EQ(down.at("states").at("gear"), "extended");
    EXPECT_NE(up.at("parts")[1], down.at("parts")[1]);
    EXPECT_EQ(up.at("parts")[0], down.at("parts")[0]); // the engine stays
    const auto wrong = sandbox.run({"iron", kAirframe, "--state", "gear=half"});
    EXPECT_EQ(wrong.status, 1);
    EXPECT_NE(wrong.err.find("expected retracted, extended"), std::string::npos) << wrong.err;
    EXPECT_EQ(sandbox.run({"iron", kAirframe, "--state", "gear"}).status, 2);
}

TEST(IronCommand, theModelFileIsOneForTheOtherCommands)
{
    const Sandbox sandbox;
    const auto model = sandbox.path("model.json");
    const auto run
        = sandbox.run({"iron", kAirframe, "--state", "gear=extended", "--json", "-o", model, "--H-nT", "18500", "--dip-deg", "67"});
    ASSERT_EQ(run.status, 0) << run.err;
    const auto smith = sandbox.run({"smith", model, "--json"});
    ASSERT_EQ(smith.status, 0) << smith.err;
    const auto S = run.json().at("soft_iron");
    EXPECT_NEAR(smith.json().at("lambda").get<double>(), 1 + (S[0][0].get<double>() + S[1][1].get<double>()) / 2, 1e-12);
    EXPECT_EQ(sandbox.run({"simulate", model, "--json"}).status, 0);
    const auto placed = sandbox.path("placed.json");
    ASSERT_EQ(sandbox.run({"iron", kAirframe, "-o", placed, "--lat", "52", "--lon", "21", "--date", "2026-11-23"}).status, 0);
    EXPECT_EQ(sandbox.run({"smith", placed}).status, 0);
}

TEST(IronCommand, aTableWithoutJson)
{
    const Sandbox sandbox;
    const auto run = sandbox.run({"iron", kAirframe});
    ASSERT_EQ(run.status, 0) << run.err;
    for (const char* word : {"gear: retracted", "soft iron", "tail spring", "landing light", "nT"})
        EXPECT_NE(run.out.find(word), std::string::npos) << word;
    EXPECT_NE(run.err.find("not by one another"), std::string::npos);
}

TEST(IronCommand, refusesWhatItCannotDoAndLeavesNothing)
{
    const Sandbox sandbox;
    const auto model = sandbox.path("model.json");
    EXPECT_EQ(sandbox.run({"iron", kAirframe, "-o", model}).status, 2);
    EXPECT_EQ(sandbox.run({"iron", kAirframe, "-o", model, "--H-nT", "18500"}).status, 2);
    EXPECT_EQ(sandbox.run({"iron", kAirframe, "-o", model, "--lat", "52", "--date", "2026"}).status, 2);
    EXPECT_EQ(sandbox.run({"iron", kAirframe, "-o", model, "--lat", "92", "--lon", "0", "--date", "2026"}).status, 1);
    EXPECT_EQ(sandbox.run({"iron", kAirframe, "-o", model, "--lat", "52", "--lon", "0", "--date", "soon"}).status, 1);
    EXPECT_EQ(sandbox.run({"iron"}).status, 2);
    EXPECT_EQ(sandbox.run({"iron", "missing.json"}).status, 1);
    const auto inside = sandbox.write("inside.json",
        R"({"sensor_m": [0,0,0], "parts": [{"name": "ball", "shape": "sphere", "diameter_m": 1, "placements": [{"centre_m": [0.1,0,0]}]}]})");
    const auto run = sandbox.run({"iron", inside, "--json"});
    EXPECT_EQ(run.status, 1);
    EXPECT_EQ(run.out, "");
    EXPECT_NE(run.err.find("inside.json"), std::string::npos);
    EXPECT_NE(run.err.find("“ball”"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(model));
}

} // namespace
} // namespace lubberline::test
