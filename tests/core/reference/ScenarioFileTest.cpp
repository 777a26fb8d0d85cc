// Scenario JSON and Scenario CSV: every key, the way back, what is refused and how.

#include <gtest/gtest.h>

#include "core/format/reference/ReferenceJson.h"
#include "core/format/reference/ScenarioCsv.h"
#include "core/format/reference/ScenarioJson.h"

namespace lubberline {
namespace {

const std::string kWhole = R"({"latitude_deg": 52, "dip_deg": 66, "speed_m_s": 60, "heading_deg": 350, "step_s": 0.5, "duration_s": 120,
  "manoeuvres": [{"from_s": 10, "to_s": 20, "turn_rate_deg_s": 3}, {"from_s": 30, "to_s": 40, "acceleration_m_s2": 1, "climb_m_s": 2}],
  "gusts": {"rms_m_s2": 0.5, "period_s": 12, "seed": 4},
  "vertical": {"loop": "third", "tau1_s": 50, "tau2_s": 8, "tau3_s": 400, "drift_deg_h": 1, "cutoff_deg": 5, "rate_limit_deg_min": 4,
    "reverse_rate_limit_deg_min": 3, "switch": {"dead_zone_deg": 0.2, "rate_deg_min": 5, "reverse_rate_deg_min": 6},
    "rate_compensation": true, "acceleration_correction": true, "turn_rate_error_deg_h": 2, "exact_tilt": true, "initial_tilt_deg": 7,
    "fast_levelling": {"until_s": 30, "tau1_s": 5}, "unbalance_deg_h_g": 1, "anisoelastic_deg_h_g2": 2},
  "gyro": {"drift_deg_h": 0.5, "apparent_drift": true, "slaving_tau_s": 147, "slaving_rate_deg_min": 3,
    "fast_slaving": {"above_deg": 4, "rate_deg_min": 100}, "slaving_cutout_deg_s": 1, "outer_axis_tilt_deg": 2, "spin_axis_deg": 30,
    "level_outer_axis": true, "initial_error_deg": -5, "unbalance_deg_h_g": 3, "anisoelastic_deg_h_g2": 4},
  "compass": {"kind": "needle", "model": {"field": {"H_nT": 18500, "dip_deg": 67}, "hard_iron_nT": [100, 200, 300]},
    "card": {"period_s": 14, "damping": 0.4, "liquid_lag_s": 9, "stop_deg": 18}}})";

TEST(ScenarioFile, everyKeyAndBackAgain)
{
    const auto scenario = readScenarioJson(kWhole, "s.json");
    ASSERT_TRUE(scenario) << describe(scenario.error());
    EXPECT_EQ(scenario->vertical->loop, LoopKind::Third);
    EXPECT_EQ(scenario->vertical->fastTau1_s, 5);
    EXPECT_EQ(scenario->gyro->fastRate_deg_min, 100);
    EXPECT_EQ(scenario->compass.type, CompassType::Needle);
    EXPECT_EQ(scenario->compass.model->hardIron_nT.y(), 200);
    EXPECT_EQ(scenario->compass.horizontal_nT, 18500);
    EXPECT_EQ(scenario->dip_deg, 66); // the scenario's own counts
    EXPECT_EQ(*scenario->compass.card->stop_deg, 18);
    EXPECT_EQ(scenario->manoeuvres.size(), 2u);
    const auto again = readScenarioJson(writeScenarioJson(*scenario), "again");
    ASSERT_TRUE(again) << describe(again.error());
    EXPECT_EQ(*again, *scenario);
    EXPECT_EQ(writeScenarioJson(*again), writeScenarioJson(*scenario));
}

TEST(ScenarioFile, nothingIsAScenario)
{
    const auto scenario = readScenarioJson("{}", "s.json");
    ASSERT_TRUE(scenario);
    EXPECT_EQ(*scenario, Scenario());
    const auto run = runScenario(*scenario);
    ASSERT_TRUE(run);
    EXPECT_NE(toJson(*scenario, *run).find("\"standoff_deg\": null"), std::string::npos);
    const auto regular = readScenarioJson(R"({"gusts": {"peak_m_s2": 0.6}})", "s");
    ASSERT_TRUE(regular);
    EXPECT_TRUE(regular->gusts->regular);
}

TEST(ScenarioFile, refusals)
{
    const auto says = [](const std::string& text, const char* words) {
        const auto scenario = readScenarioJson(text, "s.json");
        ASSERT_FALSE(scenario) << text;
        EXPECT_NE(describe(scenario.error()).find(words), std::string::npos) << describe(scenario.error());
    };
    says("", "s.json");
    says("[]", "s.json");
    says(R"({"latitude_deg": 91})", "latitude_deg");
    says(R"({"latitude": 9})", "latitude");
    says(R"({"vertical": {"loop": "fourth"}})", "first, damped, integral or third");
    says(R"({"vertical": {"loop": "first", "tau1_s": 0}})", "tau1_s");
    says(R"({"manoeuvres": [{"from_s": 3}]})", "manoeuvres[0].to_s");
    says(R"({"manoeuvres": [{"from_s": 3, "to_s": 2}]})", "ends before it begins");
    says(R"({"step_s": 0})", "step");
    says(R"({"duration_s": 1e6, "step_s": 0.001})", "2000000");
    says(R"({"compass": {"kind": "card"}})", "needle or flux valve");
    says(R"({"compass": {"model": {"hard_iron_nT": [1, 2, 3]}}})", "compass.model");
    says(R"({"compass": {"model": {"field": {"H_nT": 0, "Z_nT": 50000}}}})", "H above 0");
    says(R"({"gusts": {"rms_m_s2": 1, "peak_m_s2": 1}})", "again");
    says(R"({"gyro": {"slaving_tau_s": 0}})", "slaving");
}

TEST(ScenarioFile, theTable)
{
    const auto json = scenarioCsvToJson("# latitude_deg: 52\r\n# dip_deg: 66,5\n#a comment\n# duration_s: 100\n# vertical.loop: damped\n"
                                        "# vertical.rate_compensation: true\n\nfrom_s;to_s;turn_rate_deg_s\n10;20;1,5\n30;40;\n;;\n",
        "t.csv");
    ASSERT_TRUE(json) << describe(json.error());
    const auto scenario = readScenarioJson(*json, "t.csv");
    ASSERT_TRUE(scenario) << describe(scenario.error());
    EXPECT_EQ(scenario->dip_deg, 66.5);
    EXPECT_EQ(scenario->vertical->loop, LoopKind::Damped);
    EXPECT_TRUE(scenario->vertical->rateCompensation);
    ASSERT_EQ(scenario->manoeuvres.size(), 2u);
    EXPECT_EQ(scenario->manoeuvres[0].turnRate_deg_s, 1.5);
    const auto says = [](const char* text, int line, const char* words) {
        const auto wrong = scenarioCsvToJson(text, "t.csv");
        ASSERT_FALSE(wrong) << text;
        EXPECT_NE(describe(wrong.error()).find(words), std::string::npos) << describe(wrong.error());
        EXPECT_EQ(wrong.error().line, line);
    };
    says("from_s,to_s,speed\n", 1, "speed");
    says("from_s,to_s,to_s\n", 1, "twice");
    says("from_s,to_s\n1,x\n", 2, "no number");
    says("from_s,to_s\n1,2,3\n", 2, "cell a column");
    says("from_s,to_s\n1,\n", 2, "to_s");
    says("# a: 1\n# a: 2\n", 2, "twice");
    says("# a: 1\n# a.b: 2\n", 2, "inside a figure");
    says("", 0, "expected {");
}

} // namespace
} // namespace lubberline
