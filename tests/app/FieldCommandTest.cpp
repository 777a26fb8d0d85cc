// `field`: the contract of its JSON, and what it refuses.

#include <gtest/gtest.h>

#include "tests/app/Program.h"

namespace lubberline::test {
namespace {

TEST(FieldCommand, aPointOfTheReport)
{
    const Sandbox sandbox;
    const auto run = sandbox.run({"field", "--lat", "80", "--lon", "0", "--date", "2025.0", "--json"});
    ASSERT_EQ(run.status, 0) << run.err;
    const auto json = run.json(); // WMM2025 technical report, first line of its table
    EXPECT_EQ(json.at("model"), "WMM2025");
    EXPECT_NEAR(json.at("X_nT").get<double>(), 6521.6, 0.05);
    EXPECT_NEAR(json.at("Y_nT").get<double>(), 145.9, 0.05);
    EXPECT_NEAR(json.at("Z_nT").get<double>(), 54791.5, 0.05);
    EXPECT_NEAR(json.at("H_nT").get<double>(), 6523.2, 0.05);
    EXPECT_NEAR(json.at("F_nT").get<double>(), 55178.5, 0.05);
    EXPECT_NEAR(json.at("declination_deg").get<double>(), 1.28, 0.005);
    EXPECT_NEAR(json.at("inclination_deg").get<double>(), 83.21, 0.005);
    EXPECT_NEAR(json.at("rates").at("declination_deg_per_year").get<double>(), 0.52, 0.005);
    EXPECT_NEAR(json.at("rates").at("X_nT_per_year").get<double>(), -8.3, 0.05);
    EXPECT_EQ(json.at("uncertainty").at("F_nT"), 138);
    EXPECT_TRUE(json.at("warnings").empty());
}

TEST(FieldCommand, olderDatesByIgrf)
{
    const Sandbox sandbox;
    const auto run = sandbox.run({"field", "--lat", "52.2", "--lon", "21", "--date", "2005-06-01", "--json"});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.json().at("model"), "IGRF-14");
    EXPECT_TRUE(run.json().at("uncertainty").is_null());
    EXPECT_EQ(sandbox.run({"field", "--lat", "52.2", "--lon", "21", "--date", "2005-06-01"}).status, 0);
}

/// Near the north magnetic pole the field is known; it is the compass that is of no use.
TEST(FieldCommand, nearAPoleTheValuesComeWithTheWarning)
{
    const Sandbox sandbox;
    const auto run = sandbox.run({"field", "--lat", "85.8", "--lon", "139.3", "--date", "2025.0", "--json"});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_LT(run.json().at("H_nT").get<double>(), 2000.0);
    EXPECT_GT(run.json().at("Z_nT").get<double>(), 50000.0);
    ASSERT_EQ(run.json().at("warnings").size(), 1u);
    EXPECT_NE(run.json().at("warnings")[0].get<std::string>().find("blackout zone"), std::string::npos);
    const auto table = sandbox.run({"field", "--lat", "85.8", "--lon", "139.3", "--date", "2025.0"});
    EXPECT_EQ(table.status, 0);
    EXPECT_NE(table.out.find("declination"), std::string::npos);
    EXPECT_NE(table.err.find("blackout zone"), std::string::npos);
    EXPECT_EQ(sandbox.run({"field", "--lat", "90", "--lon", "0", "--date", "2026.0", "--json"}).status, 0);
    EXPECT_EQ(sandbox.run({"field", "--lat", "-90", "--lon", "0", "--date", "2026.0", "--json"}).status, 0);
}

TEST(FieldCommand, refusals)
{
    const Sandbox sandbox;
    const auto says = [&](std::vector<std::string> arguments, int status, const char* words) {
        arguments.insert(arguments.begin(), "field");
        const auto run = sandbox.run(arguments);
        EXPECT_EQ(run.status, status) << run.err;
        EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
        EXPECT_TRUE(run.out.empty());
    };
    says({"--lat", "91", "--lon", "0", "--date", "2026.0", "--json"}, 1, "latitude");
    says({"--lat", "50", "--lon", "0", "--date", "1899-12-31", "--json"}, 1, "from 1900 to 2030");
    says({"--lat", "50", "--lon", "0", "--date", "2026-02-30"}, 1, "no day of the calendar");
    says({"--lat", "50", "--lon", "0", "--date", "2020.0", "--model", "wmm2025"}, 1, "from 2025 to 2030");
    says({"--lat", "50", "--lon", "0", "--date", "2026.0", "--model", "none.cof"}, 1, "none.cof");
    says({"--lat", "north", "--lon", "0", "--date", "2026.0"}, 2, "--lat");
    says({"--lat", "50"}, 2, "required");
}

} // namespace
} // namespace lubberline::test
