#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "core/swing/Analysis.h"
#include "core/swing/Observations.h"
#include "tests/core/format/Support.h"

namespace lubberline::test {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(SwingCsv, readsHeadingsAsTheyStand)
{
    const auto file = readCsv(kHeader + "359,3\n91.5,85\n");
    ASSERT_TRUE(file) << describe(file.error());
    EXPECT_THAT(magnetic_deg(*file), ElementsAre(359.0, 91.5));
    EXPECT_THAT(compass_deg(*file), ElementsAre(3.0, 85.0));
    EXPECT_TRUE(file->warnings.empty());
}

TEST(SwingCsv, threeHundredAndSixtyIsNorth)
{
    const auto file = readCsv(kHeader + "360,360\n360.0,0\n");
    ASSERT_TRUE(file);
    EXPECT_THAT(magnetic_deg(*file), ElementsAre(0.0, 0.0));
    EXPECT_THAT(compass_deg(*file), ElementsAre(0.0, 0.0));
}

TEST(SwingCsv, isTheSameInEverySpelling)
{
    const auto plain = readCsv(kHeader + "359.5,3\n90,85.25\n");
    ASSERT_TRUE(plain);
    for (const std::string& text : {
             std::string("\xEF\xBB\xBF"
                         "magnetic_heading_deg,compass_heading_deg\r\n359.5,3\r\n90,85.25\r\n"),
             std::string("magnetic_heading_deg,compass_heading_deg\n359.5,3\n90,85.25"), // no newline at the end
             std::string("compass_heading_deg;magnetic_heading_deg\n3;359,5\n85,25;90,0\n"),
             std::string("compass_heading_deg;magnetic_heading_deg\n3;359.5\n85.25;90\n"), // semicolons with points
             std::string("magnetic_heading_deg\tcompass_heading_deg\n359,5\t3\n90\t85,25\n"),
             std::string(" magnetic_heading_deg , compass_heading_deg \n\n 359.5 ,\t3 \n   \n90,+85.25\n\n"),
             std::string("\"magnetic_heading_deg\",\"compass_heading_deg\"\n\"359.5\",\"3\"\n\"90\",\"85.25\"\n"),
             std::string("# a comment\n#\nmagnetic_heading_deg,compass_heading_deg\n359.5,3\n# between rows\n90,85.25\n# end\n"),
         }) {
        const auto file = readCsv(text);
        ASSERT_TRUE(file) << describe(file.error()) << "\n" << text;
        EXPECT_EQ(file->swing, plain->swing) << text; // the identity, too
    }
}

TEST(SwingCsv, deviationGivesTheHeadingThatIsMissing)
{
    const auto fromCompass = readCsv("compass_heading_deg,deviation_deg\n0,10.5\n358,4\n2,-4\n");
    ASSERT_TRUE(fromCompass);
    EXPECT_THAT(magnetic_deg(*fromCompass), ElementsAre(10.5, 2.0, 358.0));
    const auto fromMagnetic = readCsv("magnetic_heading_deg,deviation_deg\n0,10.5\n358,-4\n");
    ASSERT_TRUE(fromMagnetic);
    EXPECT_THAT(compass_deg(*fromMagnetic), ElementsAre(349.5, 2.0));
}

TEST(SwingCsv, indicationErrorIsDeviationWithTheSignTurned)
{
    // Duncan Aviation's example of MIL-STD-765A practice: indicated - actual is +6, 0, -5, +6.
    const auto file = readCsv("magnetic_heading_deg,indication_error_deg\n0,6\n90,0\n180,-5\n270,6\n");
    ASSERT_TRUE(file);
    EXPECT_THAT(compass_deg(*file), ElementsAre(6.0, 90.0, 175.0, 276.0));
}

TEST(SwingCsv, whatIsSaidTwiceMustAgreeToATwentiethOfADegree)
{
    const std::string header = "magnetic_heading_deg,compass_heading_deg,deviation_deg\n";
    EXPECT_TRUE(readCsv(header + "2,358,4.05\n"));
    EXPECT_TRUE(readCsv(header + "2,358,3.95\n"));
    EXPECT_TRUE(readCsv(header + "180,0,-180\n")); // the same as 180
    EXPECT_FALSE(readCsv(header + "2,358,4.06\n"));
    EXPECT_FALSE(readCsv(header + "2,358,-4\n"));
    EXPECT_TRUE(readCsv("magnetic_heading_deg,compass_heading_deg,indication_error_deg\n2,358,-4\n"));
    EXPECT_TRUE(readCsv("magnetic_heading_deg,deviation_deg,indication_error_deg\n2,4,-4\n"));
    EXPECT_FALSE(readCsv("magnetic_heading_deg,deviation_deg,indication_error_deg\n2,4,4\n"));
}

TEST(SwingCsv, trueHeadingsAndVariationGiveMagneticOnes)
{
    const auto file = readCsv("# variation_deg: 6,5\ntrue_heading_deg,compass_heading_deg\n6.5,358\n3,355\n");
    ASSERT_TRUE(file) << describe(file.error());
    EXPECT_THAT(magnetic_deg(*file), ElementsAre(0.0, 356.5));
    EXPECT_EQ(file->swing.readings[0].trueHeading->degrees(), 6.5);
    EXPECT_EQ(file->swing.variation_deg, 6.5);
    EXPECT_TRUE(readCsv("# variation_deg: 6\nmagnetic_heading_deg,true_heading_deg,compass_heading_deg\n0,6,1\n90,,88\n"));
    EXPECT_FALSE(readCsv("# variation_deg: 6\nmagnetic_heading_deg,true_heading_deg,compass_heading_deg\n0,7,1\n"));
    EXPECT_TRUE(readCsv("true_heading_deg,compass_heading_deg,deviation_deg\n6,0,1\n")); // the others suffice
}

TEST(SwingCsv, keysBecomeParticulars)
{
    const auto file = readCsv("# aircraft: SP-TST\n#type:PZL-130\n# compass : standby compass\n# site: D\u0119blin\n# date: 2024-02-29\n"
                              "# kind: correction\n# stage: as left\n# radio: ON\n# operator: someone: else\n# datum: landing compass\n"
                              "# engines: running\n# electrics: on\n# inspector: E. Sowa\n# note: calm\n"
        + kHeader + "1,2\n");
    ASSERT_TRUE(file) << describe(file.error());
    EXPECT_EQ(file->aircraft, "SP-TST");
    EXPECT_EQ(file->type, "PZL-130");
    EXPECT_EQ(file->compass, "standby compass");
    EXPECT_EQ(file->site, "D\u0119blin");
    EXPECT_EQ(file->operatorName, "someone: else");
    EXPECT_EQ(file->swing.date, Date("2024-02-29"));
    EXPECT_EQ(file->swing.kind, SwingKind::Correction);
    EXPECT_EQ(file->swing.stage, SwingStage::AsLeft);
    EXPECT_EQ(file->swing.configuration.radio, RadioState::On);
    EXPECT_EQ(file->swing.configuration.engines, "running");
    EXPECT_EQ(file->swing.datum.instrument, "landing compass");
    EXPECT_EQ(file->swing.people.inspector, "E. Sowa");
    EXPECT_EQ(file->swing.note, "calm");
}

TEST(SwingCsv, otherKeysAreKeptInTheNote)
{
    const auto file = readCsv("# weather: rain\n# note: calm\n# see https://example.org/a: no key\n# https://example.org\n# wind_kt: 4\n"
        + kHeader + "1,2\n# gust: late\n");
    ASSERT_TRUE(file) << describe(file.error());
    EXPECT_THAT(
        file->otherKeys, ElementsAre(testing::Pair("weather", "rain"), testing::Pair("wind_kt", "4"), testing::Pair("gust", "late")));
    EXPECT_EQ(file->swing.note, "calm\nweather: rain\nwind_kt: 4\ngust: late");
    const auto slip = readCsv("# raido: on\n" + kHeader + "1,2\n");
    EXPECT_THAT(inEnglish(slip->warnings), testing::Contains(testing::AllOf(HasSubstr("raido"), HasSubstr("did you mean radio?"))));
}

TEST(SwingCsv, optionalColumnsMayBeEmpty)
{
    const auto file = readCsv("nominal_deg,magnetic_heading_deg,compass_heading_deg,pitch_deg,roll_deg,note,excluded\n"
                              "360,1,2,-3.5,179,\"gusts, \"\"two\"\"\",door open\n,3,4,,,,\n");
    ASSERT_TRUE(file) << describe(file.error());
    const Reading& first = file->swing.readings[0];
    EXPECT_EQ(first.nominal_deg, 0.0);
    EXPECT_EQ(first.pitch_deg, -3.5);
    EXPECT_EQ(first.roll_deg, 179.0);
    EXPECT_EQ(first.note, "gusts, \"two\"");
    EXPECT_EQ(first.exclusion->reason, "door open");
    const Reading& second = file->swing.readings[1];
    EXPECT_FALSE(second.nominal_deg || second.pitch_deg || second.roll_deg || second.exclusion);
    EXPECT_EQ(observationsOf(file->swing).size(), 1u);
    EXPECT_THAT(usedReadings(file->swing), ElementsAre(1u));
}

TEST(SwingCsv, unknownColumnsAreKeptAndNamed)
{
    const auto file = readCsv("wind,magnetic_heading_deg,compass_heading_deg,Temp C\nW 4,1,2,11\n,3,4,12\n");
    ASSERT_TRUE(file);
    EXPECT_THAT(file->swing.readings[0].extra, ElementsAre(testing::Pair("Temp C", "11"), testing::Pair("wind", "W 4")));
    EXPECT_THAT(file->swing.readings[1].extra, ElementsAre(testing::Pair("Temp C", "12")));
    EXPECT_THAT(inEnglish(file->warnings), ElementsAre(HasSubstr("Temp C"), HasSubstr("wind")));
}

TEST(SwingCsv, quotedCellsMayHoldLineBreaks)
{
    const auto file = readCsv("magnetic_heading_deg,compass_heading_deg,note\n1,2,\"first\n# no comment\r\nthird\"\n3,4,\n");
    ASSERT_TRUE(file) << describe(file.error());
    EXPECT_EQ(file->swing.readings[0].note, "first\n# no comment\r\nthird");
    ASSERT_EQ(file->swing.readings.size(), 2u);
    EXPECT_EQ(readCsv("magnetic_heading_deg,compass_heading_deg,note\n1,2,\"a\nb\"\n3,x,\n").error().line,
        4); // lines are those of the file
    // Where all rows end in CRLF, so do the lines of their cells: a line break is one.
    const auto windows = readCsv("magnetic_heading_deg,compass_heading_deg,note\r\n0,1,\"first\r\nsecond\"\r\n");
    EXPECT_EQ(windows->swing.readings[0].note, "first\nsecond");
}

TEST(SwingCsv, identityIsThatOfTheContent)
{
    const std::string rows = "1,2\n90,88\n";
    const auto id = [](const std::string& text) { return readCsv(text)->swing.record; };
    EXPECT_TRUE(isRecordId(id(kHeader + rows)));
    EXPECT_EQ(id(kHeader + rows), id(kHeader + "1.0,2.00\r\n90,88\n"));
    EXPECT_NE(id(kHeader + rows), id(kHeader + "1,2\n90,88.5\n"));
    EXPECT_NE(id(kHeader + rows), id("# aircraft: SP-TST\n" + kHeader + rows));
    EXPECT_NE(id(kHeader + rows), id("# date: 2026-01-01\n" + kHeader + rows));
    EXPECT_NE(id(kHeader + rows), id(kHeader + "90,88\n1,2\n"));
}

TEST(SwingCsv, shippedSamplesAreRead)
{
    int samples = 0;
    for (const auto& entry : std::filesystem::directory_iterator(LUBBERLINE_SAMPLES)) {
        if (entry.path().extension() != ".csv" || entry.path().stem() == "example-scenario") // a flight, no swing
            continue;
        ++samples;
        const auto file = readSwingCsvFile(entry.path().string());
        ASSERT_TRUE(file) << describe(file.error());
        EXPECT_TRUE(file->warnings.empty()) << entry.path();
        EXPECT_TRUE(analyse(observationsOf(file->swing)).ok()) << entry.path();
    }
    EXPECT_GE(samples, 8);
}

TEST(SwingCsv, largeFilesAreReadInSmallStepsWithProgress)
{
    std::string text = kHeader;
    while (text.size() < 4'000'000)
        text += "123.25,121.75\n";
    std::istringstream stream(text);
    std::vector<double> told;
    const auto file = readSwingCsv(stream, "large.csv", [&](double fraction) {
        told.push_back(fraction);
        return true;
    });
    ASSERT_TRUE(file) << describe(file.error());
    EXPECT_EQ(file->swing.readings.size(), (text.size() - kHeader.size()) / 14);
    EXPECT_GT(told.size(), 10u);
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_GE(told.front(), 0.0);
    EXPECT_EQ(told.back(), 1.0);
}

TEST(SwingCsv, readingCanBeCancelled)
{
    std::string text = kHeader;
    for (int i = 0; i < 100'000; ++i)
        text += "1,2\n";
    std::istringstream stream(text);
    const auto file = readSwingCsv(stream, "swing.csv", [](double fraction) { return fraction < 0.3; });
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().code, ErrorCode::Cancelled);
}

TEST(SwingCsvFleet, namesGiveTheSameRecordsEveryTime)
{
    const auto first = toFleet(*readCsv("# aircraft: SP-TST\n# type: PZL-130\n# compass: standby\n# site: Mielec\n" + kHeader + "1,2\n"));
    const auto second = toFleet(*readCsv("# aircraft: SP-TST\n# type: PZL-130\n# compass: standby\n# site: Mielec\n" + kHeader + "1,3\n"));
    ASSERT_TRUE(first);
    ASSERT_TRUE(second);
    EXPECT_EQ(first->types, second->types);
    EXPECT_EQ(first->aircraft, second->aircraft);
    EXPECT_EQ(first->compasses, second->compasses);
    EXPECT_EQ(first->sites, second->sites);
    EXPECT_NE(first->swings[0].record, second->swings[0].record);
    EXPECT_EQ(first->swings[0].site, first->sites[0].id);
}

TEST(SwingCsvFleet, theSameReadingsOfTwoAircraftAreTwoSwings)
{
    auto file = *readCsv(kHeader + "1,2\n");
    file.aircraft = "SP-ONE"; // named beside the file, at import
    const auto one = toFleet(file);
    file.aircraft = "SP-TWO";
    const auto two = toFleet(file);
    ASSERT_TRUE(one);
    ASSERT_TRUE(two);
    EXPECT_NE(one->swings[0].record, two->swings[0].record);
    EXPECT_EQ(one->types[0].name, "type not stated");
    EXPECT_EQ(one->compasses[0].name, "compass not stated");
}

TEST(SwingCsvFleet, needsTheAircraft)
{
    const auto fleet = toFleet(*readCsv(kHeader + "1,2\n"));
    ASSERT_FALSE(fleet);
    EXPECT_EQ(fleet.error().code, ErrorCode::InvalidInput);
    EXPECT_THAT(fleet.error().message.english(), HasSubstr("# aircraft:"));
}

} // namespace lubberline::test
