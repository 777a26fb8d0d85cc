// One test for each kind of damage: the error names the path (or the line), what is wrong and what was expected.

#include <gmock/gmock.h>

#include "core/format/exchange/Exchange.h"
#include "tests/core/format/Support.h"

namespace lubberline::test {

using testing::HasSubstr;

namespace {

/// A whole file in which one piece of text is replaced by another.
struct Damage {
    const char* name;
    const char* piece;
    const char* replacement;
    ErrorCode code;
    std::vector<const char*> says;
};

constexpr auto kFormat = ErrorCode::Format;
constexpr auto kInvalid = ErrorCode::InvalidInput;
constexpr const char* kSwing = "aircraft[0].compasses[0].swings[0]";

const std::vector<Damage> kDamages = {
    {"otherFormat", "\"format\": \"lubberline\"", "\"format\": \"lubber\"", kFormat, {"format", "lubberline"}},
    {"noFormat", "\"format\": \"lubberline\",", "", kFormat, {"format: is missing"}},
    {"noVersion", "\"version\": 1,", "", kFormat, {"version: is missing"}},
    {"versionZero", "\"version\": 1", "\"version\": 0", kInvalid, {"version", "0"}},
    {"versionInWords", "\"version\": 1", "\"version\": \"one\"", kFormat, {"version", "wrong kind"}},
    {"newerVersion", "\"version\": 1", "\"version\": 9", ErrorCode::NewerSchema, {"version 9", "versions up to 8"}},
    {"newerKeyInAnOldFile", "\"variation_deg\": 7.25,\n              \"procedure\"", "\"index_removed_deg\": 1, \"procedure\"", kFormat,
        {"swings[0].index_removed_deg: is not known"}},
    {"unknownTopKey", "\"sites\": [", "\"places\": [], \"sites\": [", kFormat, {"places: is not known"}},
    {"unknownKey", "\"maker\": \"maker\"", "\"colour\": \"red\"", kFormat, {"aircraft[0].compasses[0].colour: is not known"}},
    {"doubledKey", "\"maker\": \"maker\"", "\"maker\": \"a\", \"maker\": \"b\"", kFormat,
        {"aircraft[0].compasses[0].maker: is there twice"}},
    {"doubledTopKey", "\"version\": 1", "\"version\": 1, \"version\": 1", kFormat, {"version: is there twice"}},
    {"noRegistration", "\"registration\": \"SP-TST\",", "", kFormat, {"aircraft[0].registration: is missing"}},
    {"emptyRegistration", "\"registration\": \"SP-TST\"", "\"registration\": \"\"", kInvalid, {"aircraft[0].registration: is empty"}},
    {"noType", "\"type\": \"11111111-1111-4111-8111-111111111111\",", "", kFormat, {"aircraft[0].type: is missing"}},
    {"typeNotThere", "\"type\": \"11111111", "\"type\": \"99999999", kInvalid, {"aircraft[0].type", "not there", "a type of this file"}},
    {"limitsNotThere", "\"limits\": \"55555555", "\"limits\": \"99999999", kInvalid, {"aircraft[0].compasses[0].limits", "not there"}},
    {"siteNotThere", "\"site\": \"44444444", "\"site\": \"99999999", kInvalid, {"swings[0].site", "not there"}},
    {"recordMalformed", "\"record\": \"66666666", "\"record\": \"6666-6666", kInvalid, {"swings[0].record", "UUID"}},
    {"recordInCapitals", "4666-8666-666666666666", "4666-8666-66666666666A", kInvalid, {"swings[0].record", "lower case"}},
    {"numberForText", "\"name\": \"PZL-130\"", "\"name\": 130", kFormat, {"types[0].name", "expected text"}},
    {"textForNumber", "\"resolution_deg\": 0.5", "\"resolution_deg\": \"0.5\"", kFormat,
        {"aircraft[0].compasses[0].resolution_deg", "a number"}},
    {"nullForNumber", "\"resolution_deg\": 0.5", "\"resolution_deg\": null", kFormat, {"resolution_deg", "wrong kind"}},
    {"noResolution", "\"resolution_deg\": 0.5,", "", kFormat, {"resolution_deg: is missing"}},
    {"resolutionZero", "\"resolution_deg\": 0.5", "\"resolution_deg\": 0", kInvalid, {"resolution_deg: 0 is out of range"}},
    {"textForBoolean", "\"demonstration\": true", "\"demonstration\": \"yes\"", kFormat, {"aircraft[0].demonstration", "true or false"}},
    {"objectForArray", "\"events\": []", "\"events\": {}", kFormat, {"aircraft[0].events", "an array"}},
    {"numberForObject", "\"events\": []", "\"events\": [7]", kFormat, {"aircraft[0].events[0]", "not an object"}},
    {"noSuchKind", "\"kind\": \"calibration\"", "\"kind\": \"swinging\"", kInvalid,
        {"swings[0].kind", "swinging", "check, correction, calibration, air or not_stated"}},
    {"noKind", "\"kind\": \"calibration\",", "", kFormat, {"swings[0].kind: is missing"}},
    {"noSuchState", "\"state\": \"signed\"", "\"state\": \"frozen\"", kInvalid, {"swings[0].state", "draft, complete or signed"}},
    {"noSuchCompensator", "\"compensator\": \"screws\"", "\"compensator\": \"glue\"", kInvalid, {"compasses[0].compensator", "glue"}},
    {"noSuchDay", "\"date\": \"2024-02-29\"", "\"date\": \"2023-02-29\"", kInvalid, {"swings[0].date", "2023-02-29", "YYYY-MM-DD"}},
    {"latitudeAbove", "\"latitude_deg\": 51.55", "\"latitude_deg\": 90.5", kInvalid,
        {"sites[0].latitude_deg: 90.5 is out of range", "-90 to 90"}},
    {"yearAndAHalf", "\"built_year\": 1994", "\"built_year\": 1994.5", kInvalid, {"aircraft[0].built_year", "whole"}},
    {"headingAbove", "\"magnetic_heading_deg\": 359.1", "\"magnetic_heading_deg\": 361", kInvalid,
        {"readings[0].magnetic_heading_deg: 361", "0 to 360"}},
    {"headingBelow", "\"compass_heading_deg\": 2.7", "\"compass_heading_deg\": -1", kInvalid, {"readings[0].compass_heading_deg: -1"}},
    {"numberTooLarge", "\"pitch_deg\": -1.5", "\"pitch_deg\": 1e400", kInvalid, {"readings[0].pitch_deg: is out of range"}},
    {"notANumber", "\"pitch_deg\": -1.5", "\"pitch_deg\": NaN", kFormat, {"JSON"}},
    {"emptyReason", "\"excluded\": \"door open\"", "\"excluded\": \"\"", kInvalid, {"readings[0].excluded: is empty"}},
    {"extraWithoutName", "{\"name\": \"wind\", ", "{", kFormat, {"readings[0].extra[1].name: is missing"}},
    {"cutShort", "\"readings\": [", "", kFormat, {"JSON", "whole"}},
};

std::string wholeText() { return writeExchange(toFleet(wholeRecord())); }

Result<Fleet> readDamaged(const std::string& text) { return readExchange(text, "fleet.json"); }

} // namespace

class DamagedExchange : public testing::TestWithParam<Damage> {};

TEST_P(DamagedExchange, isRefusedNamingThePath)
{
    const auto& damage = GetParam();
    std::string text = wholeText();
    const auto place = text.find(damage.piece);
    ASSERT_NE(place, std::string::npos) << damage.piece;
    text.replace(place, std::string(damage.piece).size(), damage.replacement);
    const auto fleet = readDamaged(text);
    ASSERT_FALSE(fleet);
    EXPECT_EQ(fleet.error().file, "fleet.json");
    EXPECT_EQ(fleet.error().code, damage.code) << fleet.error().message.english();
    for (const char* words : damage.says)
        EXPECT_THAT(fleet.error().message.english(), HasSubstr(words));
    EXPECT_THAT(fleet.error().message.english(), HasSubstr("expected"));
    EXPECT_EQ(fleet.error().message.english().find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, DamagedExchange, testing::ValuesIn(kDamages), [](const auto& test) { return std::string(test.param.name); });

TEST(DamagedExchangeFile, whatIsNoJsonNamesTheLine)
{
    EXPECT_EQ(readDamaged("{\n  \"format\": \"lubberline\",\n  oops\n}").error().line, 3);
    EXPECT_EQ(readDamaged("{\"format\": \"lubberline\"").error().line, 1);
    for (const std::string& text : {std::string(), std::string("  "), std::string("hello"), std::string("\xff\xfe{\0", 4),
             std::string("\0", 1), std::string("{\"a\": \"\xB0\"}")}) {
        const auto fleet = readDamaged(text);
        ASSERT_FALSE(fleet);
        EXPECT_EQ(fleet.error().code, ErrorCode::Format);
        EXPECT_THAT(fleet.error().message.english(), HasSubstr("expected"));
    }
}

TEST(DamagedExchangeFile, otherJsonIsNotOfThisFormat)
{
    for (const char* text : {"[]", "7", "null", "\"lubberline\"", "{}", "{\"format\": 1}", "{\"format\": {\"version\": 1}}"}) {
        const auto fleet = readDamaged(text);
        ASSERT_FALSE(fleet) << text;
        EXPECT_EQ(fleet.error().code, ErrorCode::Format) << text;
    }
}

TEST(DamagedExchangeFile, aNewerVersionIsNamedEvenWithKeysThatWeDoNotKnow)
{
    const auto fleet = readDamaged(R"({"format": "lubberline", "version": 9, "engines": []})");
    ASSERT_FALSE(fleet);
    EXPECT_EQ(fleet.error().code, ErrorCode::NewerSchema);
    EXPECT_THAT(fleet.error().message.english(), HasSubstr("9"));
}

TEST(DamagedExchangeFile, deepNestingIsRefusedWithoutTakingMemory)
{
    std::string objects;
    for (int i = 0; i < 200'000; ++i) // where each is named by its path, that of all takes minutes
        objects += R"({"sites":)";
    for (const std::string& deep : {std::string(200'000, '[') + std::string(200'000, ']'), std::string(200'000, '['), objects}) {
        const auto fleet = readDamaged(R"({"format": "lubberline", "version": 1, "sites": )" + deep + "}");
        ASSERT_FALSE(fleet);
        EXPECT_THAT(fleet.error().message.english(), HasSubstr("too deeply")); // and not that its end is missing: it was not read so far
        EXPECT_LT(fleet.error().message.english().size(), 500u);
    }
}

TEST(DamagedExchangeFile, theSameIdentityTwiceIsRefused)
{
    std::string text = wholeText();
    const std::string one = "33333333-3333-4333-8333-333333333333", other = "66666666-6666-4666-8666-666666666666";
    text.replace(text.find(other), other.size(), one);
    const auto fleet = readDamaged(text);
    ASSERT_FALSE(fleet);
    EXPECT_THAT(fleet.error().message.english(), testing::AllOf(HasSubstr(kSwing), HasSubstr("identity of another record")));
}

} // namespace lubberline::test
