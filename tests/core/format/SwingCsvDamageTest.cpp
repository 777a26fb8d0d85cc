// One test for each kind of damage: the error names file and line, says what is wrong and what was expected.

#include <gmock/gmock.h>

#include <filesystem>

#include "core/base/LineReader.h"
#include "tests/core/format/Support.h"

namespace lubberline::test {

using testing::HasSubstr;

namespace {

struct Damage {
    const char* name;
    std::string text;
    ErrorCode code;
    int line; ///< 0: no line
    std::vector<const char*> says;
};

constexpr auto kFormat = ErrorCode::Format;
constexpr auto kInvalid = ErrorCode::InvalidInput;

std::string row(const std::string& cells) { return kHeader + "0,358\n" + cells + "\n180,181\n"; }
std::string key(const std::string& line) { return "# aircraft: SP-TST\n" + line + "\n" + kHeader + "1,2\n"; }

const std::vector<Damage> kDamages = {
    {"empty", "", kFormat, 0, {"empty"}},
    {"onlyByteOrderMark", "\xEF\xBB\xBF", kFormat, 0, {"header"}},
    {"onlyKeys", "# aircraft: SP-TST\n", kFormat, 0, {"header"}},
    {"headerOnly", kHeader, kFormat, 0, {"no readings"}},
    {"binary",
        std::string("\x7f"
                    "ELF\x02\x01\x00\x00",
            8),
        kFormat, 0, {"binary", "UTF-8"}},
    {"nulInARow", row(std::string("90,8\0", 5)), kFormat, 0, {"binary"}},
    {"endlessLine", kHeader + std::string(kMaxLineBytes + 1, '1'), kFormat, 0, {"binary", "1 MiB"}},
    {"utf16LittleEndian",
        std::string("\xff\xfe"
                    "m\0a\0",
            6),
        kFormat, 0, {"UTF-16", "UTF-8"}},
    {"utf16BigEndian", std::string("\xfe\xff\0m\0a", 6), kFormat, 0, {"UTF-16"}},
    {"latin1", row("90,88 # 3\xB0"), kFormat, 3, {"UTF-8", "0xB0", "Windows-1252", "CSV UTF-8"}},
    {"codePage1252", key("# operator: J\xFCrgen"), kFormat, 2, {"0xFC", "# operator: J", "CSV UTF-8"}},
    {"utf16WithoutItsMark", std::string("m\0a\0g\0,\0", 8), kFormat, 0, {"UTF-16 without", "CSV UTF-8"}},
    {"zeroWidthSpace", row("90,88\u200B"), kInvalid, 3, {"compass_heading_deg", "\"88[U+200B]\""}},
    {"leftToRightMark", row("\u200E90,88"), kInvalid, 3, {"\"[U+200E]90\""}},
    {"cyrillicLetter", "magnetic_heading_deg,deviation_deg\n0,3 \u0415\n", kInvalid, 2, {"[U+0415]"}},
    {"fullWidthDigit", row("90,8\uFF18"), kInvalid, 3, {"[U+FF18]"}},
    {"unseenMarkInTheHeader", "magnetic_heading_deg,compass_heading_deg\u200B\n0,1\n", kInvalid, 1, {"compass_heading_deg[U+200B]"}},
    {"spreadsheetError", row("#N/A,88"), kInvalid, 3, {"\"#N/A\"", "spreadsheet"}},
    {"spreadsheetErrorLater", row("90,#VALUE!"), kInvalid, 3, {"#VALUE!"}},
    {"eastOrWestHeading", row("7E,88"), kInvalid, 3, {"\"7E\"", "0 to 360"}},
    {"indicationErrorWithALetter", "magnetic_heading_deg,indication_error_deg\n0,2 E\n", kInvalid, 2, {"indication_error_deg", "2 E"}},
    {"trueHeadingWithoutVariation", row("90T,88"), kInvalid, 3, {"90T", "a true heading"}},
    {"noHeader", "0,358\n90,88\n", kFormat, 1, {"no header", "magnetic_heading_deg"}},
    {"missingColumn", "magnetic_heading_deg,note\n0,a\n", kInvalid, 1,
        {"missing", "compass_heading_deg", "\"magnetic_heading_deg\", \"note\""}},
    {"onlyOtherColumns", "heading,reading\n0,1\n", kInvalid, 1, {"missing", "\"heading\", \"reading\""}},
    {"trueAndMagneticOnly", "magnetic_heading_deg,true_heading_deg\n0,1\n", kInvalid, 1, {"missing"}},
    {"deviationTwiceOnly", "deviation_deg,indication_error_deg\n1,-1\n", kInvalid, 1, {"missing"}},
    {"doubledColumn", "magnetic_heading_deg,compass_heading_deg,compass_heading_deg\n0,1,2\n", kInvalid, 1,
        {"compass_heading_deg", "twice"}},
    {"doubledUnknownColumn", "x,magnetic_heading_deg,compass_heading_deg,x\n0,1,2,3\n", kInvalid, 1, {"\"x\"", "twice"}},
    {"namelessColumn", "magnetic_heading_deg,,compass_heading_deg\n0,1,2\n", kFormat, 1, {"column 2"}},
    {"namelessLastColumn", "magnetic_heading_deg,compass_heading_deg,\n0,1,2\n", kInvalid, 2, {"3 cells", "expected 2"}},
    {"trueWithoutVariation", "true_heading_deg,compass_heading_deg\n0,1\n", kInvalid, 1, {"variation_deg"}},
    {"variationBelowTheHeader", "true_heading_deg,compass_heading_deg,magnetic_heading_deg\n1,1,1\n# variation_deg: 3\n", kInvalid, 3,
        {"variation_deg", "above"}},
    {"shortRow", row("90"), kInvalid, 3, {"1 cell", "expected 2"}},
    {"longRow", row("90,88,7"), kInvalid, 3, {"3 cells", "expected 2"}},
    {"decimalCommaBetweenCommas", row("90,5,88"), kInvalid, 3, {"3 cells"}},
    {"emptyCell", row("90,"), kInvalid, 3, {"compass_heading_deg", "empty"}},
    {"letters", row("ninety,88"), kInvalid, 3, {"magnetic_heading_deg", "\"ninety\"", "not a heading"}},
    {"unit", row("90deg,88"), kInvalid, 3, {"90deg"}},
    {"nan", row("nan,88"), kInvalid, 3, {"\"nan\"", "not a heading"}},
    {"inf", row("90,inf"), kInvalid, 3, {"compass_heading_deg", "\"inf\""}},
    {"minusInfinity", row("90,-Infinity"), kInvalid, 3, {"-Infinity"}},
    {"tooLargeNumber", row("1e400,88"), kInvalid, 3, {"1e400", "0 to 360"}},
    {"hexadecimal", row("0x10,88"), kInvalid, 3, {"0x10"}},
    {"headingBelow", row("-1,88"), kInvalid, 3, {"\"-1\"", "0 to 360"}},
    {"headingAbove", row("90,361"), kInvalid, 3, {"\"361\"", "0 to 360"}},
    {"deviationAbove", "magnetic_heading_deg,deviation_deg\n0,1\n90,180.5\n", kInvalid, 3,
        {"deviation_deg", "180.5", "between -180 and 180"}},
    {"deviationBelow", "magnetic_heading_deg,deviation_deg\n0,-181\n", kInvalid, 2, {"-181"}},
    {"pitchAbove", "magnetic_heading_deg,compass_heading_deg,pitch_deg\n0,1,91\n", kInvalid, 2, {"pitch_deg", "91", "-90 to 90"}},
    {"rollLetters", "magnetic_heading_deg,compass_heading_deg,roll_deg\n0,1,level\n", kInvalid, 2, {"roll_deg", "level"}},
    {"nominalAbove", "magnetic_heading_deg,compass_heading_deg,nominal_deg\n0,1,400\n", kInvalid, 2, {"nominal_deg", "400"}},
    {"contradiction", "magnetic_heading_deg,compass_heading_deg,deviation_deg\n0,358,2\n90,88,-2\n", kInvalid, 3,
        {"deviation_deg", "-2", "which give 2", "0.05"}},
    {"openQuote", "magnetic_heading_deg,compass_heading_deg,note\n0,1,\"open\n2,3,\n", kFormat, 2, {"not closed"}},
    {"textAfterQuote", "magnetic_heading_deg,compass_heading_deg,note\n0,1,\"a\"b\n", kFormat, 2, {"closing quote"}},
    {"openQuoteInTheHeader", "magnetic_heading_deg,\"compass_heading_deg\n1,2\n", kFormat, 1, {"not closed"}},
    {"keyTwice", key("# aircraft: SP-TWO"), kInvalid, 2, {"aircraft", "twice"}},
    {"otherKeyTwice", key("# wind: 1\n# wind: 2"), kInvalid, 3, {"wind", "twice"}},
    {"noSuchKind", key("# kind: swinging"), kInvalid, 2, {"kind", "swinging", "check, correction, calibration, air or not_stated"}},
    {"noSuchStage", key("# stage: found"), kInvalid, 2, {"stage", "as_found, as_left or not_stated"}},
    {"noSuchRadioState", key("# radio: maybe"), kInvalid, 2, {"radio", "on or off"}},
    {"dateOtherwise", key("# date: 20/11/2026"), kInvalid, 2, {"date", "20/11/2026", "YYYY-MM-DD"}},
    {"noSuchDay", key("# date: 2023-02-29"), kInvalid, 2, {"2023-02-29"}},
    {"noSuchDueDate", key("# datum_calibration_due: 2026-02-30"), kInvalid, 2, {"datum_calibration_due"}},
    {"variationLetters", key("# variation_deg: 6X"), kInvalid, 2, {"variation_deg", "6X", "between -180 and 180"}},
    {"variationAbove", key("# Variation_deg: 181"), kInvalid, 2, {"181"}},
    {"variationEastOrWest", key("# variation_deg: 6 O"), kInvalid, 2, {"6 O", "east in German"}},
    {"variationNan", key("# variation_deg: nan"), kInvalid, 2, {"nan"}},
};

} // namespace

class DamagedCsv : public testing::TestWithParam<Damage> {};

TEST_P(DamagedCsv, isRefusedInOneClearLine)
{
    const auto& damage = GetParam();
    const auto file = readCsv(damage.text);
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().code, damage.code) << file.error().message.english();
    EXPECT_EQ(file.error().file, "swing.csv");
    EXPECT_EQ(file.error().line, damage.line) << file.error().message.english();
    for (const char* words : damage.says)
        EXPECT_THAT(file.error().message.english(), HasSubstr(words));
    EXPECT_EQ(file.error().message.english().find('\n'), std::string::npos);
    EXPECT_LT(file.error().message.english().size(), 400u);
    EXPECT_THAT(file.error().message.english(), HasSubstr("expected"));
}

INSTANTIATE_TEST_SUITE_P(Kinds, DamagedCsv, testing::ValuesIn(kDamages), [](const auto& test) { return std::string(test.param.name); });

TEST(DamagedCsvFile, thatIsNotThereOrAFolder)
{
    for (const std::string& path : {std::string("nowhere/swing.csv"), std::filesystem::temp_directory_path().string()}) {
        const auto file = readSwingCsvFile(path);
        ASSERT_FALSE(file);
        EXPECT_EQ(file.error().code, ErrorCode::Io);
        EXPECT_EQ(file.error().file, path);
    }
}

TEST(DamagedCsvFile, aStreamThatFailsIsAnIoError)
{
    struct Failing : std::streambuf {
        int_type underflow() override { throw std::runtime_error("bad sector"); }
    } buffer;
    std::istream stream(&buffer);
    const auto file = readSwingCsv(stream, "swing.csv");
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().code, ErrorCode::Io);
}

TEST(DamagedCsvFile, moreThanAMillionReadingsAreNoSwing)
{
    std::string text = kHeader;
    text.reserve(5 * (kMaxReadings + 10));
    for (std::size_t i = 0; i <= kMaxReadings; ++i)
        text += "1,2\n";
    const auto file = readCsv(text);
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().line, static_cast<std::int64_t>(kMaxReadings) + 2);
    EXPECT_THAT(file.error().message.english(), HasSubstr("1000000"));
}

TEST(DamagedCsvFile, aQuoteThatSwallowsTheRestIsEndedAtAMebibyte)
{
    std::string text = "magnetic_heading_deg,compass_heading_deg,note\n0,1,\"open\n";
    while (text.size() < 2 * kMaxLineBytes)
        text += "2,3,\n";
    const auto file = readCsv(text);
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().line, 2);
    EXPECT_THAT(file.error().message.english(), HasSubstr("not closed"));
}

} // namespace lubberline::test
