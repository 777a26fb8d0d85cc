// Bench JSON: the example, the way there and back, damage named by its path.

#include <gtest/gtest.h>

#include <cmath>

#include "core/format/exchange/BenchJson.h"
#include "core/iron/BenchModel.h"

using namespace lubberline;

namespace {

const std::string kSmall = R"({"sensor_m": [0, 0, 0],
 "parts": [{"name": "leg", "shape": "cylinder", "diameter_m": 0.1, "length_m": 1, "group": "gear",
            "placements": [{"state": "up", "centre_m": [1, 0, 0]}, {"state": "down", "centre_m": [1, 0, 1], "pitch_deg": 90}]},
           {"name": "ball", "shape": "sphere", "diameter_m": 0.1, "susceptibility": 5, "placements": [{"centre_m": [0, 2, 0]}]}],
 "circuits": [{"name": "lamp", "current_A": 2, "on": true, "conductors": [{"kind": "wire", "points_m": [[1, 1, 0], [2, 1, 0]]},
              {"kind": "loop", "centre_m": [1, 1, 1], "normal": [0, 0, 1], "diameter_m": 0.1}]}]})";

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    const auto place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    return place == std::string::npos ? text : text.replace(place, from.size(), to);
}

std::string faultOf(const std::string& text)
{
    const auto bench = readBenchJson(text, "bench.json");
    if (bench)
        return "read";
    EXPECT_EQ(bench.error().file, "bench.json");
    return bench.error().message.english();
}

} // namespace

TEST(BenchJson, ReadsWhatItSays)
{
    const auto bench = readBenchJson(kSmall, "bench.json");
    ASSERT_TRUE(bench.ok()) << bench.error().message.english();
    ASSERT_EQ(bench->parts.size(), 2U);
    EXPECT_EQ(std::get<Cylinder>(bench->parts[0].shape), (Cylinder{0.1, 1}));
    EXPECT_NEAR(bench->parts[0].placements[1].pitch_rad, 1.5707963267948966, 1e-15);
    EXPECT_EQ(bench->parts[1].susceptibility, 5);
    EXPECT_EQ(std::get<CurrentLoop>(bench->circuits[0].conductors[1]).turns, 1);
    EXPECT_EQ(std::get<WirePath>(bench->circuits[0].conductors[0]).points_m.size(), 2U);
}

TEST(BenchJson, ReadsBackEqualAndIsWrittenTheSameAgain)
{
    IronBench bench = *readBenchJson(kSmall, "bench.json");
    bench.parts.push_back(
        {"odd", Ellipsoid{{0.1, 1.0 / 3, 2e-3}}, 1e-7, {0.1, -1e-300, 0}, {}, {{{}, {0.1 + 0.2, -1, 1e-17}, 0.1, -1.2, 3}}});
    bench.parts.push_back({"“tray” \n\t\\ ü", Box{{0.1, 0.2, 0.3}}, 0, {0, 0, 0}, {}, {{{}, {1, 2, 3}, 0, 0, 0}}});
    bench.parts[3].coercivity_A_per_m = 412.5;
    const auto text = writeBenchJson(bench);
    const auto back = readBenchJson(text, "again");
    ASSERT_TRUE(back.ok()) << back.error().message.english();
    EXPECT_EQ(back->parts[0], bench.parts[0]);
    EXPECT_EQ(back->parts[3], bench.parts[3]);
    EXPECT_EQ(back->circuits, bench.circuits);
    const auto& odd = back->parts[2];
    EXPECT_EQ(odd.shape, bench.parts[2].shape);
    EXPECT_EQ(odd.remanence_T, bench.parts[2].remanence_T);
    EXPECT_EQ(odd.placements[0].centre_m, bench.parts[2].placements[0].centre_m);
    EXPECT_NEAR(odd.placements[0].pitch_rad, -1.2, 1e-12);
    EXPECT_EQ(writeBenchJson(*back), text);
    EXPECT_EQ(writeBenchJson(*readBenchJson(writeBenchJson({}), "empty")), writeBenchJson({}));
}

TEST(BenchJson, TheExampleAirframeIsReadAndItsGearMovesTheModel)
{
    const auto bench = readBenchJsonFile(LUBBERLINE_SAMPLES "/example-airframe.json");
    ASSERT_TRUE(bench.ok()) << bench.error().message.english();
    EXPECT_EQ(groupsOf(*bench).size(), 1U);
    const auto up = benchModel(*bench, {{"gear", "retracted"}}), down = benchModel(*bench, {{"gear", "extended"}});
    ASSERT_TRUE(up.ok() && down.ok());
    EXPECT_GT((up->model.hardIron_nT - down->model.hardIron_nT).norm(), 10);
    EXPECT_LT(up->model.softIron.norm(), 0.2); // an airframe, not a furnace
    EXPECT_LT(up->model.hardIron_nT.norm(), 10'000);
}

TEST(BenchJson, NamesWhatIsMissingUnknownOrMisspelt)
{
    EXPECT_NE(faultOf(replaced(kSmall, "\"sensor_m\": [0, 0, 0],", "")).find("sensor_m"), std::string::npos);
    EXPECT_NE(faultOf(replaced(kSmall, "\"susceptibility\"", "\"suceptibility\"")).find("parts[1].suceptibility"), std::string::npos);
    EXPECT_NE(faultOf(replaced(kSmall, "\"diameter_m\": 0.1, \"length_m\": 1,", "\"diameter_m\": 0.1,")).find("parts[0].length_m"),
        std::string::npos);
    EXPECT_NE(
        faultOf(replaced(kSmall, "\"length_m\": 1,", "\"length_m\": 1, \"length_m\": 2,")).find("parts[0].length_m"), std::string::npos);
    EXPECT_NE(
        faultOf(replaced(kSmall, "\"cylinder\"", "\"cilinder\"")).find("expected box, cylinder, ellipsoid or sphere"), std::string::npos);
    EXPECT_NE(faultOf(replaced(kSmall, "\"wire\"", "\"cable\"")).find("expected loop or wire"), std::string::npos);
    EXPECT_NE(faultOf(replaced(kSmall, "\"on\": true, ", "")).find("circuits[0].on"), std::string::npos);
    EXPECT_NE(faultOf(replaced(kSmall, "\"centre_m\": [0, 2, 0]", "\"center_m\": [0, 2, 0]")).find("center_m"), std::string::npos);
    EXPECT_NE(faultOf(replaced(kSmall, "\"current_A\": 2, ", "")).find("circuits[0].current_A"), std::string::npos);
}

TEST(BenchJson, NamesWrongValuesByTheirPath)
{
    EXPECT_NE(faultOf(replaced(kSmall, "\"length_m\": 1", "\"length_m\": 0")).find("parts[0].length_m"), std::string::npos);
    EXPECT_NE(faultOf(replaced(kSmall, "\"length_m\": 1", "\"length_m\": \"1\"")).find("parts[0].length_m"), std::string::npos);
    EXPECT_NE(
        faultOf(replaced(kSmall, "\"susceptibility\": 5", "\"susceptibility\": -5")).find("parts[1].susceptibility"), std::string::npos);
    EXPECT_NE(faultOf(replaced(kSmall, "[0, 2, 0]", "[0, 2]")).find("parts[1].placements[0].centre_m"), std::string::npos);
    EXPECT_NE(faultOf(replaced(kSmall, "[0, 2, 0]", "[0, 2, 1e400]")).find("parts[1].placements[0].centre_m"), std::string::npos);
    EXPECT_NE(faultOf(replaced(kSmall, "[2, 1, 0]", "[2, 1, \"x\"]")).find("circuits[0].conductors[0].points_m[1]"), std::string::npos);
    EXPECT_NE(faultOf(replaced(kSmall, "[[1, 1, 0], [2, 1, 0]]", "[[1, 1, 0]]")).find("circuits[0]"), std::string::npos);
    EXPECT_NE(faultOf(replaced(kSmall, "\"state\": \"down\"", "\"state\": \"up\"")).find("twice"), std::string::npos);
    EXPECT_NE(faultOf(replaced(kSmall, "\"group\": \"gear\",", "")).find("no group"), std::string::npos);
    EXPECT_NE(faultOf(replaced(kSmall, "\"pitch_deg\": 90", "\"pitch_deg\": 900")).find("pitch_deg"), std::string::npos);
    EXPECT_NE(faultOf(replaced(kSmall, "\"diameter_m\": 0.1}", "\"diameter_m\": 0.1, \"turns\": 0}")).find("turns"), std::string::npos);
    EXPECT_NE(faultOf(replaced(kSmall, "\"diameter_m\": 0.1}", "\"diameter_m\": 0.1, \"turns\": 1.5}")).find("turns"), std::string::npos);
}

/// Cut anywhere, or with any letter changed, it is read or refused, and never more.
TEST(BenchJson, DamageEndsInAMessage)
{
    for (std::size_t end = 0; end + 2 < kSmall.size(); ++end)
        EXPECT_NE(faultOf(kSmall.substr(0, end)), "read") << end;
    for (std::size_t i = 0; i < kSmall.size(); ++i)
        for (const char letter : {'0', '}', '"', '-', '\xff'}) {
            std::string damaged = kSmall;
            damaged[i] = letter;
            const auto bench = readBenchJson(damaged, "damaged");
            EXPECT_TRUE(!bench || readBenchJson(writeBenchJson(*bench), "again").ok());
        }
    for (const char* text : {"", "[]", "null", "7", "{}", "{\"parts\": 3, \"sensor_m\": [0,0,0]}"})
        EXPECT_NE(faultOf(text), "read") << text;
    EXPECT_EQ(readBenchJsonFile("/nowhere/bench.json").error().code, ErrorCode::Io);
}
