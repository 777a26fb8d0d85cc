// `winds`: the contract of its JSON, its tables, and what it refuses.

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Number.h"
#include "core/inflight/WindVector.h"
#include "tests/app/Program.h"

namespace lubberline::test {
namespace {

/// Six flights of one aircraft whose headings read 0.5 + 2 sin − 1 cos (of the heading read) too much, beside a reference without error.
std::string observations(const std::string& separator = ",", double windUnit = 1.0)
{
    std::string csv;
    for (const char* name : {"aircraft", "flight", "time_utc", "ground_speed_kt", "track_deg", "wind_speed_kt", "wind_from_deg",
             "ref_wind_speed_kt", "ref_wind_from_deg"})
        csv += (csv.empty() ? "" : separator) + std::string(name);
    csv += "\n";
    for (int flight = 0; flight < 6; ++flight)
        for (int i = 0; i < 24; ++i) {
            const double read_deg = 15.0 * i;
            const double e_deg
                = 0.5 + 2.0 * std::sin(toRadians(read_deg)) - std::cos(toRadians(read_deg)) + 0.01 * ((i * 7 + flight * 3) % 5 - 2);
            const Eigen::Vector2d wind = velocityOf(40.0 * flight, 25), ground = velocityOf(read_deg - e_deg, 400) + wind;
            const Eigen::Vector2d reported = ground - velocityOf(read_deg, 400);
            char time[32];
            std::snprintf(time, sizeof time, "2026-03-%02dT%02d:%02d:00Z", flight + 1, 10 + i / 12, i % 12 * 5);
            csv += "SP-LRA" + separator + "LO" + std::to_string(flight) + separator + time;
            for (const double one : {ground.norm(), directionOf_deg(ground), windUnit * reported.norm(), directionOf_deg(-reported),
                     wind.norm(), directionOf_deg(-wind)})
                csv += separator + shortestNumber(one);
            csv += "\n";
        }
    return csv;
}

TEST(WindsCommand, json)
{
    const Sandbox sandbox;
    const auto run = sandbox.run({"winds", sandbox.write("obs.csv", observations()), "--json"});
    ASSERT_EQ(run.status, 0) << run.err;
    const auto json = run.json();
    const auto& one = json.at("aircraft").at(0);
    EXPECT_EQ(one.at("aircraft"), "SP-LRA");
    EXPECT_EQ(one.at("flights"), 6);
    EXPECT_EQ(one.at("observations"), 144);
    EXPECT_EQ(one.at("used"), 144);
    EXPECT_NEAR(one.at("fit").at("in_phase_deg").get<double>(), 2.0, 0.01);
    EXPECT_NEAR(one.at("fit").at("quadrature_deg").get<double>(), -1.0, 0.01);
    EXPECT_NEAR(one.at("fit").at("offset_deg").get<double>(), 0.5, 0.01);
    EXPECT_GT(one.at("fit").at("standard_error_deg").at("in_phase_deg").get<double>(), 0.0);
    EXPECT_NEAR(one.at("smith").at("A_deg").get<double>(), -0.5, 0.01); // deviation is magnetic − compass
    EXPECT_NEAR(one.at("smith").at("B_deg").get<double>(), -2.0, 0.01);
    EXPECT_NEAR(one.at("smith").at("C_deg").get<double>(), 1.0, 0.01);
    EXPECT_EQ(one.at("table_factor"), 1.05);
    ASSERT_EQ(one.at("table").size(), 8u);
    EXPECT_EQ(one.at("table")[2].at("heading_deg"), 90);
    EXPECT_NEAR(one.at("table")[2].at("correction_deg").get<double>(), -0.5 - 1.05 * 2.0, 0.01);
    EXPECT_NEAR(one.at("tables").at("exact").at("factor").get<double>(), 1.053029, 1e-6);
    EXPECT_LT(
        one.at("rmse_kt").at("after").at("transverse").get<double>(), 0.1 * one.at("rmse_kt").at("before").at("transverse").get<double>());
    EXPECT_TRUE(one.at("change").is_null());
    EXPECT_TRUE(json.at("common").is_null());
    EXPECT_FALSE(json.at("warnings").empty());
}

TEST(WindsCommand, tableCsvAndSeparators)
{
    const Sandbox sandbox;
    const auto run
        = sandbox.run({"winds", sandbox.write("obs.csv", observations(";")), "--factor", "none", "-o", sandbox.path("table.csv")});
    ASSERT_EQ(run.status, 0) << run.err;
    const std::string table = sandbox.read("table.csv");
    EXPECT_NE(table.find("# factor: 1 (none)"), std::string::npos) << table;
    EXPECT_NE(table.find("SP-LRA,90,-2.5"), std::string::npos) << table;
}

TEST(WindsCommand, metresASecondUnderAHeadingOfKnotsAreAskedFor)
{
    const Sandbox sandbox;
    const auto file = sandbox.write("obs.csv", observations(",", 1852.0 / 3600.0));
    const auto asked = sandbox.run({"winds", file, "--json"});
    ASSERT_EQ(asked.status, 0) << asked.err;
    EXPECT_TRUE(asked.json().at("aircraft").at(0).at("fit").is_null());
    EXPECT_NE(asked.out.find("m/s"), std::string::npos);
    const auto told = sandbox.run({"winds", file, "--wind-unit", "m/s", "--json"});
    EXPECT_NEAR(told.json().at("aircraft").at(0).at("fit").at("in_phase_deg").get<double>(), 2.0, 0.01);
}

TEST(WindsCommand, badInputIsOneErrorWithItsLine)
{
    const Sandbox sandbox;
    const std::string header = "ground_speed_kt,track_deg,wind_speed_kt,wind_from_deg,ref_wind_speed_kt,ref_wind_from_deg\n";
    for (const auto& [content, words] : {std::pair<std::string, std::string>{"", "is empty"}, {header, "no reports"},
             {header + "400,90,20,ten,20,270\n", "obs.csv:2: wind_from_deg \"ten\" is no figure"},
             {header + "400,90,20,10,20,470\n", "obs.csv:2: ref_wind_from_deg is \"470\"; expected 0 to 360"},
             {header + "-4,90,20,10,20,270\n", "ground_speed_kt"}, {"ground_speed_kt,track_deg\n400,90\n", "there is no column"},
             {header + "400,90,20,10,20,270,5,6\n", "has 8 cells"}, {"ground_speed_kt,ground_speed_m_s,track_deg\n", "say the same"}}) {
        const auto run = sandbox.run({"winds", sandbox.write("obs.csv", content), "--json"});
        EXPECT_EQ(run.status, 1) << content;
        EXPECT_TRUE(run.out.empty()) << run.out;
        EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
    }
}

} // namespace
} // namespace lubberline::test
