#include <gmock/gmock.h>

#include <cmath>

#include <nlohmann/json.hpp>

#include "core/format/results/AnalysisJson.h"
#include "core/swing/Observations.h"
#include "tests/core/format/Support.h"

namespace lubberline::test {

namespace {

Analysis analysisOf(const std::string& csv)
{
    auto analysis = analyse(observationsOf(readCsv(csv)->swing));
    EXPECT_TRUE(analysis.ok()) << (analysis.ok() ? "" : analysis.error().message.english());
    return std::move(analysis.value());
}

nlohmann::json jsonOf(const std::string& csv) { return nlohmann::json::parse(toJson(analysisOf(csv))); }

/// Compass Compensation Worksheet Examples (QNSC PEWB), question 1.
const std::string kCheck = kHeader + "317,316\n0,358\n47,42\n93,89\n135,134\n179,177\n225,220\n273,269\n";
const std::string kCorrection = kHeader + "359,3\n91,85\n178,170\n267,265\n";

} // namespace

TEST(AnalysisJson, publishedFiguresComeOutWithoutANoisyLastDigit)
{
    // NGA Handbook of Magnetic Compass Adjustment (2004), art. 501: A 1.0 B 12.0 C 8.0 D 5.0 E 1.5 by the eight-point rules.
    const std::string text = toJson(
        analysisOf("compass_heading_deg,deviation_deg\n0,10.5\n45,20.0\n90,11.5\n135,-1.2\n180,-5.5\n225,-8.0\n270,-12.5\n315,-6.8\n"));
    const auto json = nlohmann::json::parse(text);
    EXPECT_EQ(json["point_rules"]["A_deg"], 1.0);
    EXPECT_EQ(json["point_rules"]["B_deg"], 12.0);
    EXPECT_EQ(json["point_rules"]["C_deg"], 8.0);
    EXPECT_EQ(json["point_rules"]["D_deg"], 5.0);
    EXPECT_EQ(json["point_rules"]["E_deg"], 1.5);
    EXPECT_EQ(json["point_rules"]["points"], 8);
    EXPECT_EQ(json["point_rules"]["argument"], "compass");
    EXPECT_EQ(json["summary"]["max_abs_deviation_deg"], 20.0);
    EXPECT_EQ(json["summary"]["at_magnetic_heading_deg"], 65.0);
    EXPECT_EQ(json["summary"]["spread_deg"], 32.5);
    EXPECT_THAT(text, testing::HasSubstr("\"magnetic_heading_deg\": 65.0"));
    EXPECT_THAT(text, testing::Not(testing::EndsWith("\n")));
}

/// Parts that are written one after another are the document, to the byte, that a reader would write again.
TEST(AnalysisJson, isTheSameDocumentWhetherWrittenInPartsOrWhole)
{
    const Analysis analysis = analysisOf(kCheck);
    const auto removal = removeComponents(analysis, CoefficientSet("00110"));
    ASSERT_TRUE(removal);
    for (const Removal* removed : {static_cast<const Removal*>(nullptr), &*removal}) {
        std::vector<std::string> parts;
        writeJson(analysis, removed, [&](std::string_view part) { parts.emplace_back(part); });
        EXPECT_EQ(parts.size(), analysis.readings.size() + 3);
        std::string whole;
        for (const auto& part : parts)
            whole += part;
        EXPECT_EQ(whole, toJson(analysis, removed));
        const auto document = nlohmann::ordered_json::parse(whole);
        EXPECT_EQ(document.dump(2), whole);
        EXPECT_EQ(document["readings"].size(), 8u);
        EXPECT_EQ(document.contains("removal"), removed != nullptr);
        EXPECT_EQ(document.back(), removed ? document["removal"] : document["warnings"]);
    }
}

TEST(AnalysisJson, keepsReadingsInTheirOrderAsRead)
{
    const auto json = jsonOf(kCheck);
    ASSERT_EQ(json["readings"].size(), 8u);
    EXPECT_EQ(json["readings"][0]["magnetic_heading_deg"], 317.0);
    EXPECT_EQ(json["readings"][1]["compass_heading_deg"], 358.0);
    EXPECT_EQ(json["readings"][1]["deviation_deg"], 2.0);
    EXPECT_TRUE(json["readings"][0]["outlier"].is_boolean());
    EXPECT_TRUE(json["readings"][0]["studentised_residual"].is_number());
}

TEST(AnalysisJson, agreesWithTheResultObjectToTheLastDegree)
{
    const Analysis analysis = analysisOf(kCheck);
    const auto json = nlohmann::json::parse(toJson(analysis));
    EXPECT_NEAR(json["approximate"]["B_deg"], toDegrees(*analysis.approximate.of(Coefficient::B)), 1e-12);
    EXPECT_EQ(json["exact"]["B"], *analysis.exact.of(Coefficient::B)); // dimensionless: untouched
    EXPECT_NEAR(json["approximate"]["standard_error_deg"]["B_deg"], toDegrees(*analysis.approximate.standardError[1]), 1e-12);
    EXPECT_NEAR(json["approximate"]["rms_deg"], toDegrees(analysis.approximate.rms_rad), 1e-12);
    EXPECT_EQ(json["harmonics"]["orders"].size(), analysis.harmonics.orders.size());
    EXPECT_EQ(json["harmonics"]["argument"], "magnetic");
    EXPECT_EQ(json["harmonics"]["method"], "least squares"); // the headings are not equally spaced
}

TEST(AnalysisJson, whatCannotBeToldIsNull)
{
    const auto json = jsonOf(kCorrection);
    EXPECT_TRUE(json["approximate"]["D_deg"].is_null()); // sin 2ψ′ is nearly 0 on all four cardinals; cos 2ψ′ is ±1: they tell E
    EXPECT_TRUE(json["approximate"]["standard_error_deg"]["D_deg"].is_null());
    EXPECT_TRUE(json["approximate"]["E_deg"].is_number());
    EXPECT_TRUE(json["exact"]["D"].is_null());
    EXPECT_TRUE(json["point_rules"]["D_deg"].is_null());
    EXPECT_EQ(json["point_rules"]["points"], 4);
    EXPECT_FALSE(json["warnings"].empty());
    const auto bunched = jsonOf(kHeader + "0,1\n1,2\n2,3\n");
    EXPECT_TRUE(bunched["point_rules"].is_null());
    EXPECT_TRUE(bunched["approximate"]["A_deg"].is_null());
    EXPECT_TRUE(bunched["approximate"]["rms_deg"].is_null());
    EXPECT_TRUE(bunched["readings"][0]["residual_approximate_deg"].is_null());
}

TEST(AnalysisJson, neverHasNanOrInfinity)
{
    Analysis analysis = analysisOf(kCheck);
    analysis.approximate.conditionNumber = std::numeric_limits<double>::infinity();
    analysis.harmonics.conditionNumber = std::numeric_limits<double>::quiet_NaN();
    const auto json = nlohmann::json::parse(toJson(analysis));
    EXPECT_TRUE(json["approximate"]["condition_number"].is_null());
    EXPECT_TRUE(json["harmonics"]["condition_number"].is_null());
}

TEST(AnalysisJson, cardFiguresAreExactWithTheRoundedOnesBeside)
{
    const auto card = makeCard(analysisOf(kCheck), {45, CardSource::Readings, CoefficientSet(1)});
    ASSERT_TRUE(card) << card.error().message.english();
    const auto json = nlohmann::json::parse(toJson(*card, {}));
    const std::array<double, 8> sheet{1, 43, 89, 137, 181, 223, 269, 317}; // worksheet question 1
    ASSERT_EQ(json["rows"].size(), 8u);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(json["rows"][i]["for_deg"], 45.0 * static_cast<double>(i));
        EXPECT_EQ(json["rows"][i]["steer_deg"], sheet[i]);
        EXPECT_EQ(json["rows"][i]["steer_rounded_deg"], static_cast<int>(sheet[i]));
    }
    EXPECT_EQ(json["residual_max_abs_deg"], 2.0);
}

TEST(AnalysisJson, correctionListsBothHeadingsOfEachPair)
{
    const auto correction = correctionSteps(observationsOf(readCsv(kCorrection)->swing));
    ASSERT_TRUE(correction);
    const auto json = nlohmann::json::parse(toJson(*correction));
    EXPECT_EQ(json["C_deg"], -6.0); // worksheet question 1
    EXPECT_EQ(json["B_deg"], 2.0);
    EXPECT_EQ(json["A_deg"], 3.0);
    std::string order;
    for (const auto& step : json["steps"])
        order += step["coefficient"].get<std::string>() + step["on"].get<std::string>() + " ";
    EXPECT_EQ(order, "CN CS BE BW ");
    EXPECT_EQ(json["steps"][1]["compass_reads_deg"], 170.0);
    EXPECT_EQ(json["steps"][1]["make_compass_read_deg"], 176.0);
    EXPECT_EQ(json["steps"][3]["make_compass_read_deg"], 263.0);
}

} // namespace lubberline::test
