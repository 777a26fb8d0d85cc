// A map as JSON and CSV: every key, and nothing that is not a number.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <sstream>

#include "core/format/results/MapJson.h"

namespace lubberline {
namespace {

/// Heading by pitch, roll 20°, hard iron that leaves nothing for the compass on heading 000, level.
DeviationMap someMap()
{
    SensorModel model;
    model.hardIron_nT = {-20000, 0, 0};
    DeviationMap map;
    computeMap(responseOf(model), {20000, 0},
        {{AttitudeAxis::Heading, fullRange(AttitudeAxis::Heading), 9}, {AttitudeAxis::Pitch, fullRange(AttitudeAxis::Pitch), 5}, 20}, map);
    return map;
}

TEST(MapJson, everyKeyAndNullWhereTheFieldVanishes)
{
    const auto map = someMap();
    const auto json
        = nlohmann::json::parse(toJson(map, {"a.json", {20000, 0}, {"landing light"}}, MapSource{"b.json", {18000, 40000}, {}}));
    EXPECT_EQ(json.at("kind"), "modelled");
    EXPECT_EQ(json.at("x"), "heading");
    EXPECT_EQ(json.at("y"), "pitch");
    EXPECT_EQ(json.at("held"), (nlohmann::json{{"axis", "roll"}, {"deg", 20}}));
    EXPECT_EQ(json.at("x_deg"), (nlohmann::json{0, 45, 90, 135, 180, 225, 270, 315, 360}));
    EXPECT_EQ(json.at("y_deg"), (nlohmann::json{-90, -45, 0, 45, 90}));
    EXPECT_EQ(json.at("model").at("file"), "a.json");
    EXPECT_EQ(json.at("model").at("circuits_on"), nlohmann::json{"landing light"});
    EXPECT_EQ(json.at("minus").at("H_nT"), 18000);
    ASSERT_EQ(json.at("deviation_deg").size(), 5u);
    for (int y = 0; y < 5; ++y) {
        ASSERT_EQ(json.at("deviation_deg")[static_cast<std::size_t>(y)].size(), 9u);
        for (int x = 0; x < 9; ++x) {
            const auto& value = json.at("deviation_deg")[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
            const std::size_t at = map.index(x, y);
            if (map.defined[at])
                EXPECT_NEAR(value.get<double>(), toDegrees(map.deviation_rad[at]), 1e-10);
            else
                EXPECT_TRUE(value.is_null());
        }
    }
    EXPECT_TRUE(json.at("deviation_deg")[2][0].is_null());
    EXPECT_TRUE(json.at("deviation_deg")[2][8].is_null()) << "360 is 000";
    ASSERT_FALSE(json.at("extremes").empty());
    for (const auto& extreme : json.at("extremes")) {
        EXPECT_TRUE(extreme.at("kind") == "maximum" || extreme.at("kind") == "minimum");
        EXPECT_TRUE(extreme.at("x_deg").is_number() && extreme.at("y_deg").is_number() && extreme.at("deviation_deg").is_number());
    }
    EXPECT_TRUE(json.at("vanishing").is_array());
    EXPECT_TRUE(nlohmann::json::parse(toJson(map, {}, {})).at("minus").is_null());
}

TEST(MapJson, csvHasARowForEachPoint)
{
    const auto map = someMap();
    std::istringstream csv(toCsv(map));
    std::string line;
    std::getline(csv, line);
    EXPECT_EQ(line, "heading_deg,pitch_deg,roll_deg,deviation_deg");
    std::vector<std::string> rows;
    while (std::getline(csv, line))
        rows.push_back(line);
    ASSERT_EQ(rows.size(), 45u);
    EXPECT_EQ(rows[18], "0,0,20,") << "no number where the field vanishes";
    EXPECT_EQ(rows[20], "90,0,20,-45")
        << "hard iron astern as strong as the field: from 090 the needle is drawn halfway to south, it reads 135";
}

} // namespace
} // namespace lubberline
