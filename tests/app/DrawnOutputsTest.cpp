// What the commands of flight and sensors draw and write as documents, and the compensator's JSON.

#include <gmock/gmock.h>

#include <cmath>

#include "tests/app/Program.h"

namespace lubberline::test {

using testing::HasSubstr;
using testing::StartsWith;

namespace {

constexpr double kTurn = 2 * 3.14159265358979323846;

void expectFiles(const Sandbox& sandbox, std::vector<std::string> arguments, const std::vector<std::string>& endings)
{
    for (const std::string& ending : endings) {
        std::vector<std::string> all = arguments;
        all.insert(all.end(), {"-o", "out." + ending});
        const auto outcome = sandbox.run(all);
        ASSERT_EQ(outcome.status, 0) << ending << ": " << outcome.err;
        const std::string content = sandbox.read("out." + ending);
        EXPECT_GT(content.size(), 1000u) << ending;
        EXPECT_THAT(content, StartsWith(ending == "pdf" ? "%PDF-" : ending == "png" ? "\x89PNG" : "<?xml")) << ending;
    }
}

TEST(DrawnOutputs, aScenarioIsDrawn)
{
    const Sandbox sandbox;
    const auto scenario = sandbox.write("s.json",
        R"({"latitude_deg": 52, "dip_deg": 67, "speed_m_s": 60, "heading_deg": 0, "step_s": 0.1, "duration_s": 300,
            "manoeuvres": [{"from_s": 30, "to_s": 90, "turn_rate_deg_s": 3}], "vertical": {"loop": "first", "tau1_s": 60},
            "gyro": {"drift_deg_h": 1, "slaving_tau_s": 60}, "compass": {"kind": "flux valve", "model": null}})");
    expectFiles(sandbox, {"reference", scenario}, {"png", "svg", "pdf"});
    EXPECT_EQ(sandbox.run({"reference", scenario, "-o", "out.bmp"}).status, 2);
}

TEST(DrawnOutputs, swingsInFlightAreDocuments)
{
    const Sandbox sandbox;
    std::string legs = "track_deg,ground_speed_kt,compass_heading_deg\n", log = "time_s,compass_heading_deg,deviation_deg\n";
    for (int i = 0; i < 4; ++i)
        legs += std::to_string(90 * i + 10) + "," + std::to_string(60 + 5 * i % 3) + "," + std::to_string(90 * i + 8) + "\n";
    for (int i = 0; i < 200; ++i)
        log += std::to_string(i) + "," + std::to_string(i * 77 % 360) + "," + std::to_string(2 * std::sin(kTurn * (i * 77 % 360) / 360))
            + "\n";
    expectFiles(sandbox, {"legs", sandbox.write("legs.csv", legs), "--variation", "3"}, {"pdf"});
    expectFiles(sandbox, {"continuous", sandbox.write("log.csv", log)}, {"png", "svg", "pdf"});
}

TEST(DrawnOutputs, testsOfASensorAreDocuments)
{
    const Sandbox sandbox;
    std::string log = "time_s,bx_nT,by_nT,bz_nT\n", coil = "time_s,ax_nT,ay_nT,az_nT,bx_nT,by_nT,bz_nT\n";
    for (int i = 0; i < 4096; ++i)
        log += std::to_string(i / 240.0) + ","
            + std::to_string(20000 + 30 * std::sin(kTurn * 50 * i / 240.0) + (i > 2000 ? 900 : 0) + i % 7) + "," + std::to_string(i % 3)
            + "," + std::to_string(34641 + i % 5) + "\n";
    for (int i = 0; i < 600; ++i) {
        const double x = 30000 * std::sin(kTurn * i / 97), y = 30000 * std::sin(kTurn * i / 61), z = 30000 * std::sin(kTurn * i / 41);
        coil += std::to_string(i) + "," + std::to_string(x) + "," + std::to_string(y) + "," + std::to_string(z) + ","
            + std::to_string(1.01 * x + 5 + i % 3) + "," + std::to_string(0.99 * y - 7) + "," + std::to_string(z + i % 2) + "\n";
    }
    const auto file = sandbox.write("log.csv", log);
    expectFiles(sandbox, {"spectrum", file}, {"png", "svg", "pdf"});
    expectFiles(sandbox, {"coil", sandbox.write("coil.csv", coil)}, {"pdf"});
    expectFiles(sandbox, {"interference", file, "--actions", sandbox.write("actions.csv", "time_s,action\n8.5,landing light\n")}, {"pdf"});
}

TEST(DrawnOutputs, checksOfAnInstallationAreDocuments)
{
    const Sandbox sandbox;
    std::string stray = "x_m,y_m,z_m,bx_nT,by_nT,bz_nT\n";
    for (int i = 0; i < 12; ++i) { // a moment of 10 A m² along x at the origin: 100 (3 n (m.n) - m)/d^3 nT
        const double x = 1.2 * std::cos(kTurn * i / 12), y = 1.2 * std::sin(kTurn * i / 12), z = i % 3 * 0.4;
        const double d2 = x * x + y * y + z * z, d3 = d2 * std::sqrt(d2);
        stray += std::to_string(x) + "," + std::to_string(y) + "," + std::to_string(z) + ","
            + std::to_string(1000 * (3 * x * x / d2 - 1) / d3) + "," + std::to_string(3000 * x * y / d2 / d3) + ","
            + std::to_string(3000 * x * z / d2 / d3) + "\n";
    }
    std::string clockwise = "compass_heading_deg,magnetic_heading_deg\n", other = clockwise;
    for (int i = 0; i < 12; ++i) {
        clockwise += std::to_string(30 * i) + "," + std::to_string(30 * i + 0.4 + i % 2 * 0.1) + "\n";
        other += std::to_string(330 - 30 * i) + "," + std::to_string(330 - 30 * i + i % 3 * 0.1) + "\n";
    }
    expectFiles(sandbox, {"locate", sandbox.write("stray.csv", stray)}, {"pdf"});
    expectFiles(sandbox, {"site-check", sandbox.write("cw.csv", clockwise), sandbox.write("ccw.csv", other)}, {"pdf"});
    expectFiles(sandbox, {"distances", "--measured", "1=3.2"}, {"pdf"});
}

/// The maker's list with what was measured; nothing is taken for granted that was not looked at.
TEST(Distances, areAChecklist)
{
    const Sandbox sandbox;
    const auto plain = sandbox.run({"distances"});
    EXPECT_EQ(plain.status, 0) << plain.err;
    EXPECT_THAT(plain.out, HasSubstr("1   3.0 m  electric motors"));
    EXPECT_THAT(plain.out, testing::Not(HasSubstr("not looked at")));
    const auto outcome = sandbox.run({"distances", "--measured", "1=3.0", "--measured", "2=2.1"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("loudspeakers: 3.00 m, kept\n"));
    EXPECT_THAT(outcome.out, HasSubstr("more than 1 kg: 2.10 m, TOO NEAR by 0.40 m\n"));
    EXPECT_THAT(outcome.out, HasSubstr("another flux gate: not looked at\n"));
    for (const char* bad : {"7=1", "0=1", "1.5=1", "1", "=", "1=", "1=-1", "1=nan", "1=1001", "x=1", ""})
        EXPECT_EQ(sandbox.run({"distances", std::string("--measured=") + bad}).status == 0, false) << bad;
    EXPECT_THAT(sandbox.run({"distances", "--measured", "1=1", "--measured", "1=2"}).err, HasSubstr("named twice"));
}

TEST(DrawnOutputs, windsAreHeldAgainstAControl)
{
    const Sandbox sandbox;
    std::string csv = "aircraft,flight,group,time_utc,latitude_deg,longitude_deg,heading_deg,tas_kt,ref_wind_speed_kt,ref_wind_from_deg\n";
    // Eastward along the 50th parallel at 400 kt without wind: 0.1 h are 40 nm, 1.036° of longitude.
    for (int flight = 0; flight < 4; ++flight)
        for (int i = 0; i < 10; ++i)
            csv += std::string(flight % 2 == 0 ? "L,F" : "V,F") + std::to_string(flight) + (flight % 2 == 0 ? ",laser," : ",valve,")
                + "2026-03-0" + std::to_string(1 + flight) + "T1" + std::to_string(i * 6 / 60) + ":" + (i * 6 % 60 < 10 ? "0" : "")
                + std::to_string(i * 6 % 60) + ":00Z,50.0000," + std::to_string(10 + 1.0360 * i) + "," + (flight % 2 == 0 ? "90.5" : "93")
                + ",400,0,0\n";
    const auto outcome = sandbox.run({"winds", sandbox.write("p.csv", csv), "--control", "laser", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto json = outcome.json();
    ASSERT_EQ(json.at("groups").size(), 2u);
    EXPECT_EQ(json.at("control").at("group"), "laser");
    EXPECT_EQ(json.at("aircraft")[0].at("from_positions"), 18);
    EXPECT_GT(json.at("aircraft")[0].at("position_error_kt"), 0.0);
    // 3° of heading at 400 kt across the track: 21 kt.
    EXPECT_NEAR(json.at("groups")[1].at("rmse_kt").at("before").at("transverse"), 21, 1.5);
    EXPECT_LT(json.at("groups")[0].at("rmse_kt").at("before").at("transverse"), 4.5);
    EXPECT_GT(json.at("aircraft")[1].at("rmse_of_control").at("before").at("transverse"), 4.0);
    EXPECT_EQ(
        sandbox.run({"winds", sandbox.write("q.csv", "aircraft,ref_wind_speed_kt,ref_wind_from_deg,heading_deg,tas_kt\nA,1,2,3,400\n")})
            .status,
        1);
}

TEST(CompensatorCommand, isHeldAgainstItsLimit)
{
    const Sandbox sandbox;
    const auto model = sandbox.write("m.json", R"({"field": {"H_nT": 18500, "dip_deg": 67}, "hard_iron_nT": [1500, -900, 2500]})");
    const auto outcome = sandbox.run({"compensator", model, "--pitch", "20", "--roll", "20", "--json", "-o", "set.json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto json = outcome.json();
    EXPECT_EQ(json.at("within_limit"), true);
    EXPECT_LT(json.at("best").at("residual").at("largest_deg"), 0.1);
    EXPECT_GT(json.at("level").at("residual").at("largest_deg"), 2.0);
    EXPECT_NEAR(json.at("best").at("setting").at("magnets_nT")[2], -2500, 100);
    const auto again = sandbox.run({"compensator", sandbox.path("set.json"), "--json"});
    ASSERT_EQ(again.status, 0) << again.err;
    EXPECT_LT(again.json().at("before").at("largest_deg"), 0.1);
    EXPECT_THAT(sandbox.run({"compensator", model, "--magnets-nT", "100,100,0", "--soft", "0,0"}).out, HasSubstr("IS NOT KEPT"));
    EXPECT_EQ(sandbox.run({"compensator", model, "--pitch", "95"}).status, 2);
}

} // namespace
} // namespace lubberline::test
