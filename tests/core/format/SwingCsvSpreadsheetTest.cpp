// What Excel, LibreOffice, Numbers and Google Sheets write of a swing, and what hands write into it.

#include <gmock/gmock.h>

#include "core/base/FileText.h"
#include "core/format/csv/TextCell.h"
#include "core/swing/Analysis.h"
#include "core/swing/Observations.h"
#include "tests/core/format/Support.h"

namespace lubberline::test {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

/// The same eight readings, plainly.
const std::string kPlain = kHeader + "0,358\n45,42\n90,84\n135,131\n180,182\n225,229\n270,275\n315,318\n";
const std::vector<double> kCompass_deg{358, 42, 84, 131, 182, 229, 275, 318};

struct Spelling {
    const char* name;
    std::string text;
};

std::string utf8Mark() { return "\xEF\xBB\xBF"; }

std::string replaced(std::string text, const std::string& what, const std::string& by)
{
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
    return text;
}

/// Every row and the header with something behind them.
std::string padded(const std::string& by) { return replaced(kPlain, "\n", by + "\n"); }

const std::vector<Spelling> kSpellings = {
    {"sepLine", "sep=;\n" + replaced(kPlain, ",", ";")},
    {"sepLineOfATab", "sep=\t\n" + replaced(kPlain, ",", "\t")},
    {"sepLineInQuotes", "\"sep=;\"\r\n" + replaced(replaced(kPlain, ",", ";"), "\n", "\r\n")},
    {"sepLineSavedAgainWithCommas", "sep=;,\n" + kPlain},
    {"sepLineOfABar", utf8Mark() + "SEP=|\n" + replaced(kPlain, ",", "|")},
    {"trailingColumns", padded(",,,")},
    {"trailingColumnsInTheRowsOnly", replaced(padded(",,"), "compass_heading_deg,,", "compass_heading_deg")},
    {"trailingColumnsInTheHeaderOnly", "magnetic_heading_deg,compass_heading_deg,,\n" + kPlain.substr(kHeader.size())},
    {"trailingRows", kPlain + ",\n,\n\n , \n\"\",\"\"\n"},
    {"emptyRowsBetween", ",,\n" + replaced(kPlain, "90,84\n", ",\n90,84\n,\n")},
    {"lastCellMissing", replaced(kPlain, "compass_heading_deg", "compass_heading_deg,note")},
    {"headerInCapitals", "MAGNETIC_HEADING_DEG,Compass_Heading_Deg\n" + kPlain.substr(kHeader.size())},
    {"headerWithSpaces", "Magnetic heading deg , compass heading deg\n" + kPlain.substr(kHeader.size())},
    {"headerInQuotes", "\"magnetic_heading_deg\",\"compass_heading_deg\"\n" + kPlain.substr(kHeader.size())},
    {"decimalCommaInQuotes", replaced(replaced(kPlain, "358\n", "\"358,0\"\n"), "45,42", "\"45,0\",\"42,0\"")},
    {"noBreakSpaces", replaced(replaced(kPlain, ",", "\u00A0,\u00A0"), "\n", "\u202F\n")},
    {"noBreakSpacesInQuotes", replaced(kPlain, "358\n", "\"\u00A0358\u202F\"\n")},
    {"degreeSigns", replaced(kPlain, "358\n", "358\u00B0\n")},
    {"narrowSpaceBeforeTheDegreeSign", replaced(kPlain, "0,358\n", "000\u202F\u00B0,358\u00A0\u00BA\n")},
    {"degreesAndMinutes", replaced(kPlain, "0,358\n", "000\u00B000\u2032,358\u00B0 00\u2032\n")},
    {"points", "magnetic_heading_deg,compass_heading_deg\nN,358\nNE,42\nE,84\nse,131\nS,182\nSW,229\nW,275\nNW,318\n"},
    {"bearings", replaced(replaced(kPlain, "45,42", "N 45 E,N42E"), "315,318", "N 45\u00B0 W,N 42\u00B000' W")},
    {"statedNorth", replaced(replaced(kPlain, "45,42", "045\u00B0M,042C"), "90,84", "90 m,84 c")},
    {"scientific", replaced(kPlain, "358\n", "3.58E+02\n")},
    {"carriageReturnsAlone", replaced(kPlain, "\n", "\r")},
    {"windows", utf8Mark() + replaced(kPlain, "\n", "\r\n")},
    {"french", utf8Mark() + replaced(replaced(replaced(kPlain, ",", ";"), "358", "358,0"), "\n", "\r\n")},
    {"tabs", replaced(replaced(kPlain, ",", "\t"), "358", "358,0")},
    {"commentInQuotes", "\"# gusty, then calm\",\n" + kPlain},
};

} // namespace

class Spreadsheet : public testing::TestWithParam<Spelling> {};

TEST_P(Spreadsheet, givesTheSameReadings)
{
    const auto plain = readCsv(kPlain);
    const auto file = readCsv(GetParam().text);
    ASSERT_TRUE(file) << describe(file.error()) << "\n" << GetParam().text;
    EXPECT_EQ(file->swing, plain->swing) << GetParam().text;
    EXPECT_THAT(file->warnings, IsEmpty());
    EXPECT_THAT(compass_deg(*file), testing::ElementsAreArray(kCompass_deg));
}

INSTANTIATE_TEST_SUITE_P(Writes, Spreadsheet, testing::ValuesIn(kSpellings), [](const auto& one) { return std::string(one.param.name); });

TEST(SpreadsheetCsv, takesDeviationsAsTheCellOfTheWindowDoes)
{
    const auto file = readCsv(
        "magnetic_heading_deg,deviation_deg\n0,3.5 W\n30,3\u00B015\u2032 W\n60,\u20132\n90,\"2,5 E\"\n120,E 1\u00B0\n150,+24\u00B010\u2032\n"
        "180,\u22123\u00A0\u00B0\n210,3:15W\n");
    ASSERT_TRUE(file) << describe(file.error());
    std::vector<double> deviations_deg;
    for (const auto& reading : file->swing.readings)
        deviations_deg.push_back(deviationOf(*reading.magnetic, *reading.compass).degrees());
    const std::vector<double> expected{-3.5, -3.25, -2, 2.5, 1, 24 + 10.0 / 60, -3, -3.25};
    ASSERT_EQ(deviations_deg.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_NEAR(deviations_deg[i], expected[i], 1e-9) << i;
}

TEST(SpreadsheetCsv, trueHeadingsMayStandAmongMagneticOnes)
{
    const auto file = readCsv("# variation_deg: 6\u00B030' W\n" + kHeader + "274T,280\n90,88\n");
    ASSERT_TRUE(file) << describe(file.error());
    EXPECT_EQ(file->swing.variation_deg, -6.5);
    EXPECT_THAT(magnetic_deg(*file), ElementsAre(280.5, 90.0));
    EXPECT_EQ(file->swing.readings[0].trueHeading, TrueHeading::fromDegrees(274));
}

TEST(SpreadsheetCsv, keysComeBackFromTheirCells)
{
    const auto file
        = readCsv("# aircraft: SP-XYZ,,\n# Date: 2026-11-20,,\n\"# site: \u0141\u00F3d\u017A, stand 4\",,\n# operator:,J\u00FCrgen,\n"
                  "\"# note: the \"\"old\"\" compass\",,\n# compass: a, b,,\n# Variation_deg: 3.5 E,,\n,,\n"
                  "magnetic_heading_deg,compass_heading_deg,note\n0,358,\n90,84,\n");
    ASSERT_TRUE(file) << describe(file.error());
    EXPECT_EQ(file->aircraft, "SP-XYZ");
    EXPECT_EQ(file->swing.date, Date("2026-11-20"));
    EXPECT_EQ(file->site, "\u0141\u00F3d\u017A, stand 4");
    EXPECT_EQ(file->operatorName, "J\u00FCrgen");
    EXPECT_EQ(file->swing.note, "the \"old\" compass");
    EXPECT_EQ(file->compass, "a, b");
    EXPECT_EQ(file->swing.variation_deg, 3.5);
}

TEST(SpreadsheetCsv, aKeyInACellOfItsOwnNeedsNoColon)
{
    const auto file
        = readCsv("# aircraft;SP-XYZ;\n# site;Ramp;1\n# weather;rain\n# note, as always\nmagnetic_heading_deg;compass_heading_deg\n0;1\n");
    ASSERT_TRUE(file) << describe(file.error());
    EXPECT_EQ(file->aircraft, "SP-XYZ");
    EXPECT_EQ(file->site, "Ramp;1");
    EXPECT_TRUE(file->otherKeys.empty()); // what is no key is a comment
    EXPECT_EQ(file->swing.note, "");
}

TEST(SpreadsheetCsv, onlyTheFilesOwnSeparatorIsTakenOffAKey)
{
    const auto file = readCsv("# note: checked,\n" + replaced(kPlain, ",", ";"));
    ASSERT_TRUE(file);
    EXPECT_EQ(file->swing.note, "checked,");
}

TEST(SpreadsheetCsv, placesAreTakenAsTheWindowTakesThem)
{
    const auto file = readCsv("# latitude_deg: 51\u00B033' N\n# longitude_deg: 21.89 E\n# height_m: \"1\u00A0234,5\"\n" + kPlain);
    ASSERT_FALSE(file); // quotes inside an unquoted line belong to it
    const auto whole = readCsv("# latitude_deg: 51\u00B033' N\n# longitude_deg: W 21\u00B053'\n# height_m: 1\u00A0234,5\n" + kPlain);
    ASSERT_TRUE(whole) << describe(whole.error());
    EXPECT_DOUBLE_EQ(*whole->latitude_deg, 51.55);
    EXPECT_DOUBLE_EQ(*whole->longitude_deg, -(21 + 53.0 / 60));
    EXPECT_EQ(whole->height_m, 1234.5);
}

TEST(SpreadsheetCsv, northListedTwiceCountsOnceAndIsTold)
{
    const auto file = readCsv(kPlain + "360,358\n");
    ASSERT_TRUE(file);
    ASSERT_EQ(file->warnings.size(), 1u);
    EXPECT_THAT(file->warnings[0].english(), AllOf(HasSubstr("lines 2 and 10"), HasSubstr("000 and 360"), HasSubstr("counts once")));
    ASSERT_EQ(file->swing.readings.size(), 9u); // kept, but not used
    EXPECT_THAT(file->swing.readings[8].exclusion->reason, HasSubstr("listed twice"));
    const auto plain = analyse(observationsOf(readCsv(kPlain)->swing)), closed = analyse(observationsOf(file->swing));
    ASSERT_TRUE(plain);
    ASSERT_TRUE(closed);
    EXPECT_EQ(closed->approximate.value, plain->approximate.value);
    const auto again = readCsv(kHeader + "360,358\n90,84\n180,182\n0,358\n");
    EXPECT_FALSE(again->swing.readings[0].exclusion);
    EXPECT_TRUE(again->swing.readings[3].exclusion);
}

TEST(SpreadsheetCsv, northListedTwiceWithDifferentReadingsIsTold)
{
    const auto file = readCsv(kPlain + "360,002\n");
    ASSERT_TRUE(file);
    ASSERT_EQ(file->warnings.size(), 1u);
    EXPECT_THAT(file->warnings[0].english(), AllOf(HasSubstr("lines 2 and 10"), HasSubstr("358.0\u00B0"), HasSubstr("002.0\u00B0")));
    for (const auto& reading : file->swing.readings)
        EXPECT_FALSE(reading.exclusion);
    const auto byCompass = readCsv("compass_heading_deg,deviation_deg\n0,2\n90,3\n180,1\n360,2\n");
    ASSERT_EQ(byCompass->warnings.size(), 1u);
    EXPECT_THAT(byCompass->warnings[0].english(), HasSubstr("counts once"));
    // What the compass reads is no list: 000 on one heading and 360 on another is what was read.
    EXPECT_THAT(readCsv(kHeader + "2,0\n90,84\n355,360\n")->warnings, IsEmpty());
}

TEST(TextCell, neverBeginsAFormulaAndComesBack)
{
    for (const std::string text : {"", "plain", "=1+1", "+cmd|x", "-2+3", "@SUM(1)", "\ttab", "\rreturn", "\nline", "'tis", "'=x", "''=x",
             "' =x", " =1", "\u00A0=1", "\uFF1D1", "\uFF0B1", "a=b", "\u22122", "=a\r\nb", "a\nb", "a\r\nb", "a\rb", " both ", "\u00A0",
             "say \"=\"", "x,=1", "x;=1", "\u202ERTL"}) {
        const auto marked = withTextMark(text);
        for (const char* sign : {"=", "+", "-", "@", "\t", "\r", "\n", "\uFF1D", "\uFF0B"})
            EXPECT_THAT(std::string(trimmed(marked)), testing::Not(testing::StartsWith(sign)));
        EXPECT_EQ(textOfCell(marked), text);
        SwingRecord record = wholeRecord();
        record.swing.readings[0].note = text;
        record.swing.readings[0].exclusion = Exclusion{"x" + text};
        record.swing.readings[1].exclusion = Exclusion{text.empty() ? "x" : text};
        record.swing.readings[1].extra = {{"wind", text.empty() ? "x" : text}};
        const auto written = writeSwingCsv(record);
        const auto file = readCsv(written);
        ASSERT_TRUE(file) << describe(file.error()) << written;
        EXPECT_EQ(file->swing.readings, record.swing.readings) << written;
        EXPECT_THAT(file->warnings, testing::SizeIs(2)); // two columns that are not ours
    }
}

TEST(TextCell, numbersStayNumbers)
{
    SwingRecord record = wholeRecord();
    record.swing.readings[0].note = "-5";
    record.swing.readings[0].extra = {{"temperature_C", "-5.5"}, {"wind", "-5 kt"}};
    const auto written = writeSwingCsv(record);
    EXPECT_THAT(written, AllOf(HasSubstr(",-1.5,"), HasSubstr(",-5.5,"), HasSubstr(",'-5,"), HasSubstr(",'-5 kt\n")));
    EXPECT_EQ(readCsv(written)->swing.readings, record.swing.readings);
}

TEST(TextCell, namesOfColumnsAndParticularsBeginNoneEither)
{
    SwingRecord record = wholeRecord();
    record.aircraft.registration = "=HYPERLINK(\"http://x.invalid\";\"y\")";
    record.swing.procedure = "a,=1+1";
    record.swing.workOrder = "b;@c";
    record.swing.reason = "d,";
    record.swing.note = ",e, \"f\"";
    record.swing.readings[1].extra = {{"=x", "1"}};
    const auto written = writeSwingCsv(record);
    EXPECT_THAT(written, AllOf(HasSubstr("\n\"# procedure: a,=1+1\"\n"), HasSubstr("\n\"# work_order: b;@c\"\n"), HasSubstr(",'=x")));
    const auto file = readCsv(written);
    ASSERT_TRUE(file) << describe(file.error()) << written;
    EXPECT_EQ(file->aircraft, record.aircraft.registration);
    EXPECT_EQ(file->swing.procedure, "a,=1+1");
    EXPECT_EQ(file->swing.workOrder, "b;@c");
    EXPECT_EQ(file->swing.reason, "d,");
    EXPECT_EQ(file->swing.note, ",e, \"f\"");
    EXPECT_EQ(file->swing.readings, record.swing.readings);
}

/// A Polish deviascope sheet, its slip at the wrap mended: deviation = magnetic − compass.
TEST(PublishedRules, acrossNorth)
{
    const auto file = readCsv(kHeader + "000,040\n045,067\n090,092\n135,118\n180,143\n225,181\n270,270\n315,000\n");
    ASSERT_TRUE(file);
    const auto analysis = analyse(observationsOf(file->swing));
    ASSERT_TRUE(analysis) << describe(analysis.error());
    const auto& rules = *analysis->pointRules;
    EXPECT_NEAR(toDegrees(rules.A_rad), -1.375, 1e-9);
    EXPECT_NEAR(toDegrees(rules.B_rad), -1.0, 1e-9);
    EXPECT_NEAR(toDegrees(rules.C_rad), -38.5, 1e-9);
    EXPECT_NEAR(toDegrees(*rules.D_rad), 12.5, 1e-9);
    EXPECT_NEAR(toDegrees(rules.E_rad), -0.25, 1e-9);
}

TEST(PublishedRules, byCompassHeadings)
{
    const auto file = readCsv("compass_heading_deg,deviation_deg\n000,-2\n045,-2\n090,-6\n135,+2\n180,+4\n225,-2\n270,+5\n315,+2\n");
    ASSERT_TRUE(file);
    const auto analysis = analyse(observationsOf(file->swing));
    ASSERT_TRUE(analysis) << describe(analysis.error());
    const auto& rules = *analysis->pointRules;
    EXPECT_NEAR(toDegrees(rules.A_rad), 0.125, 1e-9);
    EXPECT_NEAR(toDegrees(rules.B_rad), -5.5, 1e-9);
    EXPECT_NEAR(toDegrees(rules.C_rad), -3.0, 1e-9);
    EXPECT_NEAR(toDegrees(*rules.D_rad), -2.0, 1e-9);
}

/// As workbooks head their columns; a unit that is not degrees makes another column of it.
TEST(SwingCsvSpreadsheet, unitsInBracketsAreRead)
{
    for (const char* header : {"Magnetic heading (deg),Compass heading (deg)", "Magnetic Heading [°],Compass Heading [°]",
             "MAGNETIC HEADING (degrees);Compass reading (°)", "magnetic heading,compass heading", "Magnetic (°),Compass (°)"}) {
        const char separator = std::string(header).find(';') == std::string::npos ? ',' : ';';
        const auto file = readCsv(std::string(header) + "\n359.5" + separator + "3\n90" + separator + "85.25\n");
        ASSERT_TRUE(file) << header << ": " << describe(file.error());
        EXPECT_THAT(magnetic_deg(*file), ElementsAre(359.5, 90.0)) << header;
        EXPECT_THAT(compass_deg(*file), ElementsAre(3.0, 85.25)) << header;
    }
    for (const char* deviation : {"Deviation (°E)", "deviation [deg]", "Deviation (deg east)", "Deviation (east +)"}) {
        const auto file = readCsv(std::string("Compass heading (°),") + deviation + "\n90,-2\n");
        ASSERT_TRUE(file) << deviation << ": " << describe(file.error());
        EXPECT_THAT(magnetic_deg(*file), ElementsAre(88.0)) << deviation;
    }
    for (const char* other : {"Deviation (°W)", "Deviation", "Deviation (rad)", "Magnetic heading (rad)", "Magnetic heading (mils)"})
        EXPECT_FALSE(readCsv(std::string("Compass heading (°),") + other + "\n90,-2\n").ok()) << other;
}

TEST(SwingCsvSpreadsheet, aTitleAboveTheHeaderIsKeptInTheNote)
{
    for (const std::string title :
        {"Compass swing of 3713\n", "Compass swing of 3713,,\n\n", "Compass,swing of,3713\n", "\"Compass swing of 3713\"\n,,\n"}) {
        const auto file = readCsv(title + kPlain);
        ASSERT_TRUE(file) << title << file.error().message.english();
        EXPECT_EQ(compass_deg(*file), kCompass_deg) << title;
        EXPECT_EQ(file->swing.note, "title: Compass swing of 3713");
        ASSERT_EQ(file->warnings.size(), 1u);
        EXPECT_THAT(file->warnings.front().english(), HasSubstr("1 row above the header"));
    }
    const auto keys = readCsv("Workshop\n# aircraft: 3713\nLine 2; rest\n" + kPlain);
    ASSERT_TRUE(keys);
    EXPECT_EQ(keys->aircraft, "3713");
    EXPECT_EQ(keys->swing.note, "title: Workshop\ntitle: Line 2 rest");
}

TEST(SwingCsvSpreadsheet, aHeaderThatIsNoneIsNotTakenForATitle)
{
    for (const std::string text : {"mag,comp\n0,358\n45,42\n", "Title\nmag,comp\n0,358\n", "Title\n\n", "{\n\"a\": \"b\"\n}\n"}) {
        const auto file = readCsv(text);
        ASSERT_FALSE(file) << text;
        EXPECT_EQ(file.error().line, 1) << text;
        EXPECT_THAT(file.error().message.english(), HasSubstr("a column is missing")) << text;
    }
    std::string many;
    for (int i = 0; i < 40; ++i)
        many += "a line of words\n";
    EXPECT_FALSE(readCsv(many + kPlain)); // that is another kind of file
}

/// Below the header stand units, below the readings what sums them up: neither is a reading.
TEST(SwingCsvSpreadsheet, unitsBelowTheHeaderAreNoReading)
{
    for (const char* units : {",deg,deg", "deg,deg,deg", "(\u00B0),[\u00B0],(\u00B0)", "st,\u00B0M,\u00B0C"}) {
        const auto file = readCsv(std::string("point,magnetic heading,compass heading\n") + units + "\nN,0,358\nE,90,91\n");
        ASSERT_TRUE(file) << units << describe(file.error());
        EXPECT_THAT(magnetic_deg(*file), ElementsAre(0.0, 90.0)) << units;
        EXPECT_THAT(compass_deg(*file), ElementsAre(358.0, 91.0)) << units;
        EXPECT_THAT(file->warnings.back().english(), HasSubstr("line 2 holds the units")) << units;
    }
    for (const char* other : {",rad,rad", ",deg,rad", ",mils,mils", ",deg,358"})
        EXPECT_FALSE(readCsv(std::string("point,magnetic heading,compass heading\n") + other + "\nN,0,358\n")) << other;
}

TEST(SwingCsvSpreadsheet, whatSumsUpTheReadingsIsNone)
{
    for (const char* sum :
        {"Mean,135,134.5", "\u015Arednia,135,134.5", "Average:,,134.5", "max. dev.,,", "(mean),135,134.5", ",Mean,134.5", "Std dev,,1.2"}) {
        const auto file = readCsv(std::string("point,magnetic heading,compass heading\nN,0,358\nE,90,91\nS,180,181\n") + sum + "\n");
        ASSERT_TRUE(file) << sum << describe(file.error());
        EXPECT_THAT(compass_deg(*file), ElementsAre(358.0, 91.0, 181.0)) << sum;
        EXPECT_THAT(file->warnings.back().english(), HasSubstr("line 5 is left out")) << sum;
    }
    const auto noted = readCsv("magnetic heading,compass heading,note\n0,358,mean\n90,91,mean of two\n135,134,Mean\n,134,Mean\n");
    ASSERT_TRUE(noted) << describe(noted.error());
    EXPECT_THAT(compass_deg(*noted), ElementsAre(358.0, 91.0, 134.0));
    EXPECT_THAT(noted->warnings.back().english(), HasSubstr("line 5 is left out"));
    EXPECT_THAT(noted->warnings.at(noted->warnings.size() - 2).english(), HasSubstr("line 4 is noted as"));
}

/// ="000" keeps the zeros in a spreadsheet; as it is, and in quotes.
TEST(SwingCsvSpreadsheet, textFormulasAreRead)
{
    const auto file
        = readCsv("magnetic heading,compass heading,note\n=\"000\",=\"358\",=\"rain, gusts\"\n\"=\"\"090\"\"\",\"=\"\"091\"\"\",calm\n");
    ASSERT_TRUE(file) << describe(file.error());
    EXPECT_THAT(magnetic_deg(*file), ElementsAre(0.0, 90.0));
    EXPECT_THAT(compass_deg(*file), ElementsAre(358.0, 91.0));
    EXPECT_EQ(file->swing.readings[0].note, "rain, gusts");
    EXPECT_FALSE(readCsv("magnetic heading,compass heading\n=A1,358\n90,91\n")); // a formula is not computed
}

} // namespace lubberline::test
