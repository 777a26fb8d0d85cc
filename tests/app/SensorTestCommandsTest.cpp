// `compensate`, `spectrum`, `coil`, `interference`: the contract of their JSON.
#include <gmock/gmock.h>

#include <cmath>

#include "tests/app/Program.h"

namespace lubberline::test {

using testing::HasSubstr;

namespace {

constexpr double kTurn = 2 * 3.14159265358979323846;

/// A level turn at 240 samples a second with P = 2000 nT on H = 20 000 nT, and 50 Hz of 30 nT along x.
std::string turnLog()
{
    std::string log = "time_s,bx_nT,by_nT,bz_nT,heading_deg,pitch_deg,roll_deg\n";
    for (int i = 0; i < 4096; ++i) {
        const double time = i / 240.0, heading = kTurn * i / 4096;
        log += std::to_string(time) + "," + std::to_string(2000 + 20000 * std::cos(heading) + 30 * std::sin(kTurn * 50 * time)) + ","
            + std::to_string(-20000 * std::sin(heading)) + ",34641," + std::to_string(heading * 360 / kTurn) + ",0,0\n";
    }
    return log;
}

/// A calibration's uncertainty goes with its model: into the map of the log, the map of the model and a prediction elsewhere.
TEST(CalibrateCommand, theUncertaintyGoesWithTheModel)
{
    const Sandbox sandbox;
    std::string log = "time_s,bx_nT,by_nT,bz_nT,heading_deg,pitch_deg,roll_deg\n";
    for (int i = 0; i < 1200; ++i) { // all attitudes, by whole turns of three angles
        const double h = std::fmod(kTurn * i * 7 / 1200, kTurn), p = 0.9 * std::sin(kTurn * i * 11 / 1200),
                     r = 3 * std::sin(kTurn * i * 5 / 1200);
        const double x = 20000 * std::cos(p) * std::cos(h) - 34641 * std::sin(p), y = -20000 * std::sin(h),
                     z = 20000 * std::sin(p) * std::cos(h) + 34641 * std::cos(p);
        const double noise = 60 * std::sin(12.9898 * i) + 50 * std::sin(78.233 * i);
        log += std::to_string(0.1 * i) + "," + std::to_string(x + 2000 + noise) + ","
            + std::to_string(y * std::cos(r) + z * std::sin(r) - noise) + ","
            + std::to_string(-y * std::sin(r) + z * std::cos(r) + noise / 2) + "," + std::to_string(h * 360 / kTurn) + ","
            + std::to_string(p * 360 / kTurn) + "," + std::to_string(r * 360 / kTurn) + "\n";
    }
    const auto file = sandbox.write("log.csv", log);
    const auto fit = sandbox.run({"calibrate", file, "--field-nT", "40000", "--dip-deg", "60", "-o", "model.json"});
    ASSERT_EQ(fit.status, 0) << fit.err;
    const auto model = nlohmann::json::parse(sandbox.read("model.json"));
    ASSERT_EQ(model.at("covariance").size(), 12u);
    EXPECT_GT(model.at("covariance")[9][9], 0);
    const auto map = sandbox.run({"map", "model.json", "--json"});
    ASSERT_EQ(map.status, 0) << map.err;
    EXPECT_GT(map.json().at("standard_deviation_deg")[90][90], 0);
    const auto there = sandbox.run({"predict", "model.json", "--lat", "52", "--lon", "21", "--date", "2026-06-01", "--json"});
    ASSERT_EQ(there.status, 0) << there.err;
    EXPECT_GT(there.json().at("max_abs_possible_deg"), there.json().at("max_abs_deviation_deg"));
    const auto compensated = sandbox.run({"compensate", file, "--model", "model.json", "--json", "-o", "after.pdf"});
    ASSERT_EQ(compensated.status, 0) << compensated.err;
    const auto cells = compensated.json().at("deviation_map"); // its own: json() gives a new one each time
    ASSERT_FALSE(cells.empty());
    EXPECT_TRUE(cells[0].at("standard_deviation_deg").is_number());
    EXPECT_TRUE(cells[0].at("after_deg").is_number());
    EXPECT_EQ(sandbox.read("after.pdf").substr(0, 5), "%PDF-");
    ASSERT_EQ(sandbox.run({"calibrate", file, "--field-nT", "40000", "--dip-deg", "60", "-o", "fit.pdf"}).status, 0);
    EXPECT_EQ(sandbox.read("fit.pdf").substr(0, 5), "%PDF-");
    const auto asymmetric
        = sandbox.run({"map", sandbox.write("bad.json", R"({"field": {"H_nT": 20000, "dip_deg": 60}, "covariance": [[1, 2]]})")});
    EXPECT_NE(asymmetric.status, 0);
    EXPECT_THAT(asymmetric.err, HasSubstr("covariance"));
}

/// Nose north, looking east over a dip of 60°: 0.1° of the helmet's pitch are 0.1° tan 60° of azimuth.
TEST(LineOfSightCommand, hasEveryKeyOfTheContract)
{
    const Sandbox sandbox;
    const auto outcome = sandbox.run({"line-of-sight", "--field-nT", "40000", "--dip-deg", "60", "--look-deg", "90,0,0", "--turret-deg",
        "0,0,90", "--tilt-error-deg", "0,0.1", "--cockpit-nT", "0,1000,0", "--json", "-o", "sight.pdf"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto json = outcome.json();
    EXPECT_NEAR(json.at("line_of_sight").at("aircraft").at("azimuth_deg"), 90, 1e-9);
    EXPECT_NEAR(json.at("line_of_sight").at("turret").at("azimuth_deg"), 0, 1e-9);
    EXPECT_NEAR(json.at("helmet").at("heading_deg"), 90, 1e-9);
    EXPECT_NEAR(json.at("standard_deviation").at("turret").at("azimuth_deg"), 0.1732, 1e-3);
    EXPECT_NEAR(json.at("stays").at("turret").at("azimuth_deg"), -2.862, 1e-3);
    EXPECT_NEAR(json.at("whole").at("aircraft").at("azimuth_deg"), 2.867, 1e-3);
    EXPECT_EQ(json.at("causes").size(), 12u);
    EXPECT_EQ(json.at("causes")[2].at("kind"), "stays");
    EXPECT_EQ(json.at("sweep").size(), 51u);
    EXPECT_EQ(json.at("cockpit_tracking_field"), "not modelled");
    EXPECT_EQ(sandbox.read("sight.pdf").substr(0, 5), "%PDF-");
    const auto without = sandbox.run({"line-of-sight", "--look-deg", "90,0,0"});
    EXPECT_NE(without.status, 0);
    EXPECT_THAT(without.err, HasSubstr("--dip-deg"));
}

TEST(CompensateCommand, hasEveryKeyOfTheContract)
{
    const Sandbox sandbox;
    const auto log = sandbox.write("log.csv", turnLog());
    const auto model = sandbox.write("model.json", R"({"field": {"H_nT": 20000, "dip_deg": 60}, "hard_iron_nT": [2000, 0, 0]})");
    const auto outcome = sandbox.run({"compensate", log, "--model", model, "--latency-ms", "2", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto json = outcome.json();
    EXPECT_EQ(json.at("samples"), 4096);
    EXPECT_NEAR(json.at("rate_hz"), 240, 0.1);
    EXPECT_NEAR(json.at("heading_error").at("before").at("max_deg"), 5.74, 0.1);
    EXPECT_LT(json.at("heading_error").at("after").at("max_deg"), 0.1);
    EXPECT_EQ(json.at("heading_error").at("sign"), "read - magnetic");
    EXPECT_EQ(json.at("deviation_map_sign"), "magnetic - read");
    EXPECT_EQ(json.at("attitude"), "of the log");
    for (const char* key : {"mean_deg", "rms_deg", "p95_deg"})
        EXPECT_TRUE(json.at("heading_error").at("after").contains(key)) << key;
    EXPECT_GT(json.at("field_spread_nT").at("before"), 500);
    EXPECT_EQ(json.at("demands").size(), 3u);
    EXPECT_EQ(json.at("demands")[1].at("met"), true);
    ASSERT_EQ(sandbox.run({"compensate", log, "--model", model, "-o", "out.csv"}).status, 0);
    EXPECT_THAT(sandbox.read("out.csv"), HasSubstr("heading_after_deg"));
    EXPECT_EQ(sandbox.run({"compensate", log, "--model", model, "-o", log}).status, 1);
}

TEST(SpectrumCommand, hasEveryKeyOfTheContract)
{
    const Sandbox sandbox;
    const auto log = sandbox.write("log.csv", turnLog());
    const auto outcome = sandbox.run({"spectrum", log, "--column", "bx_nT", "--max-delay-ms", "3.5", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto json = outcome.json();
    EXPECT_EQ(json.at("column"), "bx_nT");
    EXPECT_EQ(json.at("frequency_hz").size(), json.at("density_nT2_per_hz").size());
    ASSERT_GE(json.at("lines").size(), 1u);
    EXPECT_NEAR(json.at("lines")[0].at("frequency_hz"), 50, 0.2);
    EXPECT_NEAR(json.at("lines")[0].at("amplitude_nT"), 30, 1);
    EXPECT_TRUE(json.at("lines")[0].at("alias_of_hz").is_null());
    EXPECT_LE(json.at("filter").at("delay_ms"), 3.5001);
    ASSERT_EQ(sandbox.run({"spectrum", log, "-o", "psd.csv"}).status, 0);
    EXPECT_THAT(sandbox.read("psd.csv"), testing::StartsWith("frequency_hz,density_nT2_per_hz\n0,"));
    EXPECT_EQ(sandbox.run({"spectrum", log, "--column", "bq"}).status, 1);
}

TEST(CoilCommand, hasEveryKeyOfTheContract)
{
    const Sandbox sandbox;
    std::string log = "ax_nT,ay_nT,az_nT,bx_nT,by_nT,bz_nT\n";
    for (int axis = 0; axis < 3; ++axis)
        for (const int a : {-60000, -30000, 0, 30000, 60000}) {
            const int x = axis == 0 ? a : 0, y = axis == 1 ? a : 0, z = axis == 2 ? a : 0;
            log += std::to_string(x) + "," + std::to_string(y) + "," + std::to_string(z) + "," + std::to_string(1.01 * x + 100) + ","
                + std::to_string(0.99 * y - 50) + "," + std::to_string(1.0 * z) + "\n";
        }
    const auto outcome = sandbox.run({"coil", sandbox.write("coil.csv", log), "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto json = outcome.json();
    EXPECT_NEAR(json.at("scale")[0], 1.01, 1e-9);
    EXPECT_NEAR(json.at("scale")[1], 0.99, 1e-9);
    EXPECT_NEAR(json.at("bias_nT")[0], 100, 1e-6);
    EXPECT_TRUE(json.at("temperature_nT_per_c").is_null());
    for (const char* key : {"non_orthogonality_deg", "misalignment_deg", "hysteresis_nT", "noise_nT"})
        EXPECT_TRUE(json.contains(key)) << key;
}

/// A bench kept with a compass: compared a year later, in the errors of a swing by its own log too, removed again.
TEST(CoilCommand, aBenchIsKeptComparedAndInTheErrors)
{
    const Sandbox sandbox;
    const auto bench = [&](const std::string& name, double bias_nT) {
        std::string log = "ax_nT,ay_nT,az_nT,bx_nT,by_nT,bz_nT\n";
        int row = 0;
        for (int axis = 0; axis < 3; ++axis)
            for (const int a : {-60000, -30000, 0, 30000, 60000, 30000, 0, -30000}) {
                const int x = axis == 0 ? a : 0, y = axis == 1 ? a : 0, z = axis == 2 ? a : 0, noise = row++ % 2 ? 300 : -300;
                log += std::to_string(x) + "," + std::to_string(y) + "," + std::to_string(z) + "," + std::to_string(x + bias_nT + noise)
                    + "," + std::to_string(y - noise) + "," + std::to_string(z + noise) + "\n";
            }
        return sandbox.write(name, log);
    };
    const std::string swing
        = "# aircraft: 3713\n# compass: remote\n# date: 2026-06-01\n# latitude_deg: 52\n# longitude_deg: 21\nmagnetic_deg,compass_deg\n"
          "0,1\n45,46\n90,91\n135,136\n180,181\n225,226\n270,271\n315,316\n";
    const auto file = sandbox.write("swing.csv", swing);
    ASSERT_EQ(sandbox.run({"import", file, "--db", "f.db"}).status, 0);
    const auto first
        = sandbox.run({"coil", bench("first.csv", 100), "--keep", "3713", "--date", "2024-05-01", "--serial", "S 12", "--db", "f.db"});
    ASSERT_EQ(first.status, 0) << first.err;
    EXPECT_THAT(first.err, HasSubstr("kept as "));
    ASSERT_EQ(sandbox.run({"coil", bench("second.csv", 160), "--keep", "3713", "--date", "2026-05-01", "--serial", "S 12", "--db", "f.db"})
                  .status,
        0);
    const auto history = sandbox.run({"coil", "--history", "3713", "--db", "f.db", "--json"});
    ASSERT_EQ(history.status, 0) << history.err;
    const auto benches = history.json().at("benches");
    ASSERT_EQ(benches.size(), 2u);
    EXPECT_EQ(benches[0].at("log"), "second.csv");
    EXPECT_EQ(benches[0].at("result").at("range_nT"), 60000);
    EXPECT_NEAR(benches[0].at("drift").at("bias_nT_per_year")[0], 30, 0.1);
    EXPECT_NEAR(benches[0].at("drift").at("bias_nT_per_year")[1], 0, 0.1);
    EXPECT_GT(benches[0].at("drift").at("bias_interval95_nT_per_year")[0], 30) << "noise of 300 nT tells no drift of 30";
    EXPECT_TRUE(benches[1].at("drift").is_null());
    EXPECT_THAT(sandbox.run({"coil", "--history", "3713", "--db", "f.db"}).out, HasSubstr("since 2024-05-01"));
    const auto with = sandbox.run({"analyse", file, "--bench", "second.csv", "--json"});
    ASSERT_EQ(with.status, 0) << with.err;
    EXPECT_THAT(with.out, HasSubstr("by its coil bench, noise"));
    ASSERT_EQ(sandbox.run({"coil", "--history", "3713", "--remove", benches[0].at("record"), "--db", "f.db"}).status, 0);
    EXPECT_EQ(sandbox.run({"coil", "--history", "3713", "--db", "f.db", "--json"}).json().at("benches").size(), 1u);
    EXPECT_EQ(sandbox.run({"coil", "first.csv", "--history", "3713", "--db", "f.db"}).status, 2);
    EXPECT_NE(sandbox.run({"coil", "--history", "3714", "--db", "f.db"}).status, 0);
}

TEST(InterferenceCommand, hasEveryKeyOfTheContract)
{
    const Sandbox sandbox;
    std::string log = "time_s,bx_nT,by_nT,bz_nT\n";
    for (int i = 0; i < 100; ++i)
        log += std::to_string(i) + "," + (i < 50 ? "18000" : "18700") + ",0,44000\n";
    sandbox.write("log.csv", log);
    sandbox.write("actions.csv", "time_s,action\n50,landing light on\n");
    const auto outcome = sandbox.run({"interference", "log.csv", "--actions", "actions.csv", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto json = outcome.json();
    EXPECT_EQ(json.at("passes"), false);
    EXPECT_EQ(json.at("actions")[0].at("action"), "landing light on");
    EXPECT_EQ(json.at("actions")[0].at("from_s"), 50);
    EXPECT_EQ(json.at("actions")[0].at("change_nT")[0], 700);
    EXPECT_EQ(json.at("actions")[0].at("worst_at_s")[0], 50);
    EXPECT_EQ(
        sandbox.run({"interference", "log.csv", "--actions", "actions.csv", "--limits-nT", "800,500,800", "--json"}).json().at("passes"),
        true);
    sandbox.write("bad.csv", "time_s,action\n50,a\n40,b\n");
    const auto bad = sandbox.run({"interference", "log.csv", "--actions", "bad.csv"});
    EXPECT_EQ(bad.status, 1);
    EXPECT_THAT(bad.err, HasSubstr("bad.csv:3: time goes back"));
}

} // namespace
} // namespace lubberline::test
