// `simulate`: the contract of its JSON, its Swing CSV, which `analyse` reads, and what it refuses.

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

/// Hard iron that just cancels H on north.
const std::string kCancelled = R"({"field": {"H_nT": 20000, "dip_deg": 60}, "hard_iron_nT": [-20000, 0, 0]})";

TEST(SimulateCommand, hasEveryKeyOfTheContract)
{
    const Sandbox sandbox;
    const auto outcome = sandbox.run({"simulate", sandbox.write("model.json", kModel), "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto points = outcome.json().at("points");
    ASSERT_EQ(points.size(), 24u) << "0:15:345";
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_EQ(points[i].at("heading_deg"), 15.0 * static_cast<double>(i));
        EXPECT_EQ(points[i].at("pitch_deg"), 0);
        EXPECT_EQ(points[i].at("roll_deg"), 0);
        EXPECT_EQ(points[i].at("field_nT").size(), 3u);
        const double apart_deg = points[i].at("heading_deg").get<double>() - points[i].at("compass_heading_deg").get<double>()
            - points[i].at("deviation_deg").get<double>();
        EXPECT_NEAR(std::remainder(apart_deg, 360), 0, 1e-12) << "deviation = magnetic - compass";
    }
}

TEST(SimulateCommand, hardIronByHand)
{
    const Sandbox sandbox;
    const auto model = sandbox.write("model.json", R"({"field": {"H_nT": 20000, "dip_deg": 60}, "hard_iron_nT": [-2000, 0, 0]})");
    const auto points = sandbox.run({"simulate", model, "--headings", "0,90", "--json"}).json().at("points");
    ASSERT_EQ(points.size(), 2u);
    EXPECT_NEAR(points[0].at("deviation_deg"), 0, 1e-12);
    // A north-seeking pole ahead drives the needle west of north when the nose is east: the compass reads high.
    EXPECT_NEAR(points[1].at("compass_heading_deg"), 90 + std::atan(0.1) * 180 / 3.14159265358979323846, 1e-9);
    EXPECT_NEAR(points[1].at("field_nT")[0], -2000, 1e-9);
    EXPECT_NEAR(points[1].at("field_nT")[1], -20000, 1e-9);
}

TEST(SimulateCommand, attitude)
{
    const Sandbox sandbox;
    const auto model = sandbox.write("model.json", R"({"field": {"H_nT": 20000, "dip_deg": 60}, "hard_iron_nT": [0, 0, 3000]})");
    const auto level = sandbox.run({"simulate", model, "--headings", "0", "--json"}).json();
    EXPECT_NEAR(level.at("points")[0].at("deviation_deg"), 0, 1e-12);
    const auto heeled = sandbox.run({"simulate", model, "--headings", "0", "--roll", "10", "--pitch", "-5", "--json"}).json();
    EXPECT_NEAR(heeled.at("points")[0].at("roll_deg"), 10, 1e-12);
    EXPECT_NEAR(heeled.at("points")[0].at("pitch_deg"), -5, 1e-12);
    EXPECT_LT(heeled.at("points")[0].at("deviation_deg"), -1) << "the pole above drives the needle to port, west";
}

TEST(SimulateCommand, theCsvIsASwingThatGivesTheCoefficientsBack)
{
    const Sandbox sandbox;
    const auto model = sandbox.write("model.json", kModel);
    ASSERT_EQ(sandbox.run({"simulate", model, "-o", sandbox.path("swing.csv")}).status, 0);
    const auto analysed = sandbox.run({"analyse", sandbox.path("swing.csv"), "--json"});
    ASSERT_EQ(analysed.status, 0) << analysed.err;
    const auto expected = sandbox.run({"smith", model, "--json"}).json();
    for (const char* letter : {"A", "B", "C", "D", "E"})
        EXPECT_NEAR(analysed.json().at("exact").at(letter), expected.at("exact").at(letter), 1e-9) << letter;
    EXPECT_LT(analysed.json().at("exact").at("rms_deg"), 1e-9);
}

TEST(SimulateCommand, jsonIntoAFile)
{
    const Sandbox sandbox;
    const auto model = sandbox.write("model.json", kModel);
    ASSERT_EQ(sandbox.run({"simulate", model, "-o", sandbox.path("points.json")}).status, 0);
    EXPECT_EQ(nlohmann::json::parse(sandbox.read("points.json")), sandbox.run({"simulate", model, "--json"}).json());
}

TEST(SimulateCommand, headingsAsRangesAndLists)
{
    const Sandbox sandbox;
    const auto model = sandbox.write("model.json", kModel);
    const auto headings = [&](const std::string& text) {
        std::vector<double> found;
        const auto json = sandbox.run({"simulate", model, "--headings", text, "--json"}).json();
        for (const auto& point : json.at("points"))
            found.push_back(point.at("heading_deg"));
        return found;
    };
    EXPECT_EQ(headings("0:0.1:0.3"), (std::vector<double>{0, 0.1, 0.2, 0.3})) << "rounding loses no heading";
    EXPECT_EQ(headings("10:45:100"), (std::vector<double>{10, 55, 100}));
    EXPECT_EQ(headings("10:45:99"), (std::vector<double>{10, 55}));
    EXPECT_EQ(headings("90:1:90"), (std::vector<double>{90}));
    EXPECT_EQ(headings("270, 0,45.5"), (std::vector<double>{270, 0, 45.5}));
    EXPECT_EQ(headings("360"), (std::vector<double>{0}));
}

TEST(SimulateCommand, badOptionsAreUsageErrors)
{
    const Sandbox sandbox;
    const auto model = sandbox.write("model.json", kModel);
    for (const char* headings : {"", "0:15", "0:15:345:1", "0:0:345", "0:-15:345", "345:15:0", "north", "0,,90", "0:15:361", "-1",
             "0:1e-9:360", "nan", "0:nan:345", "0x10"}) {
        const auto outcome = sandbox.run({"simulate", model, "--headings", headings, "--json"});
        EXPECT_EQ(outcome.status, 2) << headings;
        EXPECT_THAT(outcome.err, HasSubstr("--headings")) << headings;
        EXPECT_TRUE(outcome.out.empty()) << headings;
    }
    EXPECT_EQ(sandbox.run({"simulate", model, "--pitch", "91"}).status, 2);
    EXPECT_EQ(sandbox.run({"simulate", model, "--roll", "nan"}).status, 2);
    EXPECT_EQ(sandbox.run({"simulate", model, "-o", sandbox.path("swing.pdf")}).status, 2);
    EXPECT_EQ(sandbox.run({"simulate", model, "--json", "-o", sandbox.path("swing.csv")}).status, 2);
    EXPECT_EQ(sandbox.run({"simulate"}).status, 2);
    EXPECT_EQ(sandbox.files(), std::vector<std::string>{"model.json"});
}

TEST(SimulateCommand, whereTheFieldVanishesThereIsNoHeading)
{
    const Sandbox sandbox;
    const auto model = sandbox.write("model.json", kCancelled);
    const auto outcome = sandbox.run({"simulate", model, "--headings", "0:90:270", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto points = outcome.json().at("points");
    ASSERT_EQ(points.size(), 4u);
    EXPECT_TRUE(points[0].at("compass_heading_deg").is_null());
    EXPECT_TRUE(points[0].at("deviation_deg").is_null());
    EXPECT_TRUE(points[1].at("deviation_deg").is_number());
    EXPECT_THAT(outcome.err, HasSubstr("vanishes on heading 0"));

    ASSERT_EQ(sandbox.run({"simulate", model, "-o", sandbox.path("swing.csv")}).status, 0);
    EXPECT_EQ(sandbox.run({"analyse", sandbox.path("swing.csv"), "--json"}).json().at("readings").size(), 23u);
    EXPECT_THAT(sandbox.run({"simulate", model}).out, HasSubstr("-"));
}

TEST(SimulateCommand, whereNothingIsLeftThereIsNoSwing)
{
    const Sandbox sandbox;
    const auto model = sandbox.write("pole.json", R"({"field": {"H_nT": 0, "Z_nT": 56000}})");
    const auto outcome = sandbox.run({"simulate", model, "-o", sandbox.path("swing.csv")});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr("vanishes on every heading"));
    EXPECT_EQ(sandbox.files(), std::vector<std::string>{"pole.json"});
    EXPECT_EQ(sandbox.run({"simulate", model, "--json"}).json().at("points").size(), 24u);
}

TEST(SimulateCommand, whatItRefuses)
{
    const Sandbox sandbox;
    const auto bad = sandbox.write("bad.json", R"({"field": {"H_nT": 20000, "dip_deg": 60}, "hard_iron_nT": [1, 2]})");
    const auto outcome = sandbox.run({"simulate", bad, "-o", sandbox.path("swing.csv")});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr("bad.json: hard_iron_nT"));
    EXPECT_EQ(sandbox.files(), std::vector<std::string>{"bad.json"});
    const auto model = sandbox.write("model.json", kModel);
    EXPECT_EQ(sandbox.run({"simulate", model, "-o", sandbox.path("no/such/folder/swing.csv")}).status, 1);
}

} // namespace
} // namespace lubberline::test
