// `calibrate`: the contract of its JSON, what it writes, and what it refuses.
#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "tests/app/Program.h"

namespace lubberline::test {

using testing::HasSubstr;

namespace {

/// Soft iron diag(0.05, −0.04, 0.03) with b = d = 0.02, hard iron (3000, −2000, 1500), |B| = 48 000 nT, `noise` nT.
std::string logOf(int samples, double noise, double unit = 1, const std::string& header = "time_s,bx_nT,by_nT,bz_nT")
{
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    std::string text = header + "\n";
    for (int i = 0; i < samples; ++i) {
        double b[3] = {normal(random), normal(random), normal(random)};
        const double size = 48000 / std::sqrt(b[0] * b[0] + b[1] * b[1] + b[2] * b[2]);
        for (double& part : b)
            part *= size;
        const double m[3] = {1.05 * b[0] + 0.02 * b[1] + 3000 + noise * normal(random),
            0.02 * b[0] + 0.96 * b[1] - 2000 + noise * normal(random), 1.03 * b[2] + 1500 + noise * normal(random)};
        text += std::to_string(0.1 * i) + "," + std::to_string(m[0] / unit) + "," + std::to_string(m[1] / unit) + ","
            + std::to_string(m[2] / unit) + "\n";
    }
    return text;
}

TEST(CalibrateCommand, hasEveryKeyOfTheContract)
{
    const Sandbox sandbox;
    const auto outcome = sandbox.run({"calibrate", sandbox.write("log.csv", logOf(1000, 50)), "--field-nT", "48000", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto json = outcome.json();
    EXPECT_EQ(json.at("method"), "ellipsoid");
    EXPECT_EQ(json.at("samples"), 1000);
    EXPECT_EQ(json.at("unit"), "nT");
    EXPECT_NEAR(json.at("hard_iron_nT")[0], 3000, 15);
    EXPECT_NEAR(json.at("hard_iron_nT")[1], -2000, 15);
    EXPECT_NEAR(json.at("soft_iron")[0][0], 0.05, 5e-4);
    EXPECT_NEAR(json.at("soft_iron")[1][0], 0.02, 5e-4);
    EXPECT_NEAR(json.at("soft_iron")[2][2], 0.03, 5e-4);
    EXPECT_NEAR(json.at("sigma_nT"), 50, 3);
    EXPECT_EQ(json.at("field_nT"), 48000);
    EXPECT_EQ(json.at("verdict"), "good");
    EXPECT_LT(json.at("gate"), 0.1);
    EXPECT_GT(json.at("coverage").at("share"), 0.95);
    EXPECT_EQ(json.at("rank"), 9);
    EXPECT_EQ(json.at("parameters").size(), 9u);
    for (const char* key : {"used", "circuits", "rms_nT", "reasons", "condition_number", "not_separable", "validation", "warnings"})
        EXPECT_TRUE(json.contains(key)) << key;
}

TEST(CalibrateCommand, unitsGiveTheSameAnswer)
{
    const Sandbox sandbox;
    const auto json
        = sandbox.run({"calibrate", sandbox.write("log.csv", logOf(1000, 50, 1000, "time_s,bx_uT,by_uT,bz_uT")), "--json"}).json();
    EXPECT_EQ(json.at("unit"), "uT");
    EXPECT_NEAR(json.at("hard_iron_nT")[0], 3000, 15);
}

TEST(CalibrateCommand, aModelWithoutADipIsNotComputedWith)
{
    const Sandbox sandbox;
    const auto made = sandbox.run({"calibrate", sandbox.write("log.csv", logOf(1000, 50)), "--field-nT", "48000", "-o", "model.json"});
    ASSERT_EQ(made.status, 0);
    EXPECT_THAT(made.err, HasSubstr("the dip is not known"));
    EXPECT_EQ(nlohmann::json::parse(sandbox.read("model.json")).at("field"), nlohmann::json({{"F_nT", 48000}}));
    for (const auto& arguments : {std::vector<std::string>{"smith", "model.json"}, {"simulate", "model.json"},
             {"map", "model.json", "--x", "heading", "--y", "pitch"}, {"compensator", "model.json"}}) {
        const auto refused = sandbox.run(arguments);
        EXPECT_EQ(refused.status, 1) << arguments.front();
        EXPECT_THAT(refused.err, HasSubstr("only its size is known")) << arguments.front();
    }
    // Elsewhere the field is stated: only what changes from here to there is not told.
    const auto there = sandbox.run({"predict", "model.json", "--lat", "52", "--lon", "21", "--date", "2026-11-28", "--json"});
    ASSERT_EQ(there.status, 0) << there.err;
    EXPECT_THAT(there.json().at("warnings").dump(), HasSubstr("only its size is known"));
}

TEST(CalibrateCommand, writesModelAndHeader)
{
    const Sandbox sandbox;
    const auto log = sandbox.write("log.csv", logOf(1000, 50));
    ASSERT_EQ(sandbox.run({"calibrate", log, "--field-nT", "48000", "--dip-deg", "67", "-o", "model.json"}).status, 0);
    const auto model = nlohmann::json::parse(sandbox.read("model.json"));
    EXPECT_NEAR(model.at("field").at("H_nT"), 48000 * std::cos(67 * 3.14159265358979 / 180), 1e-3);
    EXPECT_NEAR(model.at("hard_iron_nT")[2], 1500, 15);
    EXPECT_EQ(sandbox.run({"smith", "model.json"}).status, 0);
    ASSERT_EQ(sandbox.run({"calibrate", log, "-o", "model.h"}).status, 0);
    EXPECT_THAT(sandbox.read("model.h"), HasSubstr("lubberline_self_test"));
}

TEST(CalibrateCommand, whatIsNotDeterminedIsNull)
{
    const Sandbox sandbox;
    const auto log = sandbox.write("log.csv", logOf(4, 50));
    const auto outcome = sandbox.run({"calibrate", log, "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.json().at("verdict"), "not determined");
    EXPECT_TRUE(outcome.json().at("hard_iron_nT").is_null());
    EXPECT_THAT(outcome.json().at("reasons")[0].get<std::string>(), HasSubstr("4 usable samples"));
    const auto refused = sandbox.run({"calibrate", log, "-o", "model.json"});
    EXPECT_EQ(refused.status, 1);
    EXPECT_THAT(refused.err, HasSubstr("no model is written"));
    EXPECT_EQ(sandbox.files(), std::vector<std::string>{"log.csv"});
}

/// A level turn of a sensor that is turned by 5° in its mount: A of Smith; the iron along z cannot be told.
TEST(CalibrateCommand, attitude)
{
    const Sandbox sandbox;
    std::string log = "bx_nT,by_nT,bz_nT,heading_deg,pitch_deg,roll_deg\n";
    const double degree = 3.14159265358979 / 180;
    for (int heading = 0; heading < 360; heading += 15)
        log += std::to_string(1000 + 20000 * std::cos((heading + 5) * degree)) + ","
            + std::to_string(-20000 * std::sin((heading + 5) * degree)) + ",34641.016," + std::to_string(heading) + ",0,0\n";
    const auto outcome = sandbox.run(
        {"calibrate", sandbox.write("log.csv", log), "--method", "attitude", "--field-nT", "40000", "--dip-deg", "60", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto json = outcome.json();
    EXPECT_EQ(json.at("rank"), 9);
    EXPECT_TRUE(json.at("hard_iron_nT")[0].is_null());
    EXPECT_TRUE(json.at("soft_iron")[0][2].is_null());
    EXPECT_NEAR(json.at("soft_iron")[0][1], std::sin(5 * degree), 1e-6);
    EXPECT_THAT(json.at("not_separable")[0].get<std::string>(), HasSubstr("c and P"));
    EXPECT_EQ(json.at("validation").at("blocks"), 8);
    EXPECT_LT(json.at("validation").at("rms_deg"), 1e-3);
    EXPECT_EQ(sandbox.run({"calibrate", "log.csv", "--method", "attitude"}).status, 1);
}

TEST(CalibrateCommand, whatItRefuses)
{
    const Sandbox sandbox;
    EXPECT_EQ(sandbox.run({"calibrate"}).status, 2);
    EXPECT_EQ(sandbox.run({"calibrate", "none.csv"}).status, 1);
    const auto log = sandbox.write("log.csv", logOf(100, 50));
    EXPECT_EQ(sandbox.run({"calibrate", log, "--method", "magic"}).status, 2);
    EXPECT_EQ(sandbox.run({"calibrate", log, "--lat", "52"}).status, 2);
    const auto back = sandbox.run({"calibrate", sandbox.write("back.csv", "time_s,bx_nT,by_nT,bz_nT\n1,1,2,3\n0,1,2,3\n"), "--json"});
    EXPECT_EQ(back.status, 1);
    EXPECT_TRUE(back.out.empty());
    EXPECT_THAT(back.err, HasSubstr("back.csv:3: time goes back"));
}

} // namespace
} // namespace lubberline::test
