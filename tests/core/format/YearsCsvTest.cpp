// Tables of many swings: both forms, what columns mean, dates as they are written, and one clear error for what is wrong.

#include <gmock/gmock.h>

#include <sstream>

#include "core/format/csv/YearsCsv.h"

namespace lubberline {
namespace {

struct Read {
    std::vector<YearsSwing> swings;
    std::vector<Message> warnings;
    std::string error; ///< "years.csv:3: …"
};

Read read(const std::string& text, const YearsTable& table = {})
{
    std::istringstream input(text);
    YearsReader reader(input, "years.csv", table);
    Read all;
    for (;;) {
        auto swing = reader.next();
        if (!swing) {
            all.error = describe(swing.error());
            return all;
        }
        if (!*swing)
            break;
        all.swings.push_back(std::move(**swing));
    }
    all.warnings = reader.warnings();
    return all;
}

double deviation_deg(const Reading& reading) { return deviationOf(*reading.magnetic, *reading.compass).degrees(); }

YearsTable cells(YearsCells what)
{
    YearsTable table;
    table.cells = what;
    return table;
}

const std::string kRows = "type;aircraft;compass;date;stage;0;90;180;270\n"
                          "Su-22;3201;standby;2019-05-01;as_found;1,5;-2;0;3\n"
                          "Su-22;3201;standby;2020-05-02;as_left;0,5;;0;1\n";

TEST(YearsCsv, aRowIsASwingWithHeadingsAsColumns)
{
    const auto all = read(kRows, cells(YearsCells::Deviations));
    ASSERT_EQ(all.error, "");
    ASSERT_EQ(all.swings.size(), 2u);
    const auto& first = all.swings[0];
    EXPECT_EQ(first.line, 2);
    EXPECT_EQ(first.file.type, "Su-22");
    EXPECT_EQ(first.file.aircraft, "3201");
    EXPECT_EQ(first.file.swing.date, Date("2019-05-01"));
    EXPECT_EQ(first.file.swing.stage, SwingStage::AsFound);
    EXPECT_EQ(first.file.swing.kind, SwingKind::NotStated);
    ASSERT_EQ(first.file.swing.readings.size(), 4u);
    EXPECT_DOUBLE_EQ(first.file.swing.readings[0].magnetic->degrees(), 0);
    EXPECT_NEAR(first.file.swing.readings[0].compass->degrees(), 358.5, 1e-12);
    EXPECT_NEAR(deviation_deg(first.file.swing.readings[1]), -2, 1e-12);
    EXPECT_EQ(all.swings[1].file.swing.readings.size(), 3u); // an empty cell: not read
    EXPECT_NE(first.file.swing.record, all.swings[1].file.swing.record);
    EXPECT_EQ(first.file.swing.record, read(kRows, cells(YearsCells::Deviations)).swings[0].file.swing.record);
}

TEST(YearsCsv, cellsAreWhatIsSaid)
{
    const std::string text = "aircraft,date,45,H090,135\u00B0\nA,2019-05-01,47,88,135\n";
    EXPECT_NEAR(deviation_deg(read(text, cells(YearsCells::Compass)).swings.at(0).file.swing.readings[0]), -2, 1e-12);
    auto byCompass = cells(YearsCells::Magnetic);
    byCompass.byCompass = true;
    EXPECT_NEAR(deviation_deg(read(text, byCompass).swings.at(0).file.swing.readings[0]), 2, 1e-12);
    const std::string errors = "aircraft,date,45\nA,2019-05-01,2\n";
    EXPECT_NEAR(deviation_deg(read(errors, cells(YearsCells::IndicationErrors)).swings.at(0).file.swing.readings[0]), -2, 1e-12);
    EXPECT_THAT(read(text).error, testing::StartsWith("years.csv:1: headings are columns (45")); // nothing is guessed
    byCompass.cells = YearsCells::Compass;
    EXPECT_THAT(read(text, byCompass).error, testing::HasSubstr("both compass headings"));
    EXPECT_THAT(read(text, cells(YearsCells::Magnetic)).error, testing::HasSubstr("both magnetic headings"));
}

TEST(YearsCsv, aRowIsAReading)
{
    const std::string text = "# type: Mi-17\naircraft,compass,date,stage,magnetic_heading_deg,compass_heading_deg,note,inspector\n"
                             "602,standby,2019-05-01,as found,0,359,,Sowa\n602,standby,2019-05-01,as found,90,91,gusty,Sowa\n"
                             ",,,,180,179,,\n"
                             "602,standby,2019-05-01,as left,0,0,,Sowa\n603,standby,2019-05-01,as left,0,1,,Sowa\n";
    const auto all = read(text);
    ASSERT_EQ(all.error, "");
    ASSERT_EQ(all.swings.size(), 3u);
    EXPECT_EQ(all.swings[0].file.type, "Mi-17");
    EXPECT_EQ(all.swings[0].file.swing.people.inspector, "Sowa");
    ASSERT_EQ(all.swings[0].file.swing.readings.size(), 3u); // one without particulars is of the swing above
    EXPECT_EQ(all.swings[0].file.swing.readings[1].note, "gusty");
    EXPECT_EQ(all.swings[1].line, 6);
    EXPECT_EQ(all.swings[2].file.aircraft, "603");
}

TEST(YearsCsv, aSwingThatGoesOnLaterIsAnError)
{
    const std::string head = "aircraft,date,swing,magnetic_heading_deg,deviation_deg\n";
    EXPECT_THAT(read(head + "A,2019-05-01,1,0,1\nB,2019-05-01,1,0,1\nA,2019-05-01,1,90,1\n").error,
        testing::StartsWith("years.csv:4: a swing goes on here"));
    const auto two = read(head + "A,2019-05-01,1,0,1\nB,2019-05-01,1,0,1\nA,2019-05-01,2,90,1\n"); // another of the same day
    EXPECT_EQ(two.error, "");
    EXPECT_EQ(two.swings.size(), 3u);
}

TEST(YearsCsv, columnsOfOtherNamesAreMapped)
{
    YearsTable table = cells(YearsCells::Compass);
    table.columns = {{"aircraft", "Numer boczny"}, {"date", "Data"}, {"datum_reader", "kto"}};
    table.common = {{"type", "Su-22M4"}, {"stage", "as_found"}};
    table.dates = DateOrder::DayMonthYear;
    const auto all = read("Numer boczny\tData\tkto\tzap\t0\t90\n3201\t1.5.2019\tLis\tx1\t1\t91\n", table);
    ASSERT_EQ(all.error, "");
    const auto& swing = all.swings.at(0).file;
    EXPECT_EQ(swing.aircraft, "3201");
    EXPECT_EQ(swing.type, "Su-22M4");
    EXPECT_EQ(swing.swing.date, Date("2019-05-01"));
    EXPECT_EQ(swing.swing.people.datumReader, "Lis");
    EXPECT_EQ(swing.swing.note, "zap: x1"); // kept, and told
    ASSERT_EQ(all.warnings.size(), 1u);
    EXPECT_THAT(all.warnings[0].english(), testing::HasSubstr("zap"));
    table.columns["site"] = "Lotnisko";
    EXPECT_THAT(read("Numer boczny\tData\tkto\t0\n", table).error, testing::HasSubstr("Lotnisko"));
    table.columns = {{"aeroplane", "x"}};
    EXPECT_THAT(read("x\tdate\t0\n", table).error, testing::HasSubstr("expected one of aircraft, type"));
}

TEST(YearsCsv, whatIsWrongIsToldWithItsRow)
{
    const auto deviation = cells(YearsCells::Deviations);
    const std::vector<std::pair<std::string, std::string>> wrong{
        {"", "is empty"},
        {"aircraft,date,0\n", "has a header but no rows"},
        {"date,0\n2019-05-01,1\n", ":1: no column is the aircraft"},
        {"aircraft,0\nA,1\n", ":1: no column is the date"},
        {"aircraft,date,0\nA,2019-02-29,1\n", ":2: date: \"2019-02-29\" is no day; expected YYYY-MM-DD"},
        {"aircraft,date,0\nA,1.5.2019,1\n", ":2: date: \"1.5.2019\" is no day"},
        {"aircraft,date,0\n,2019-05-01,1\n", ":2: the aircraft is not named"},
        {"aircraft,date,0\nA,,1\n", ":2: the date is not stated"},
        {"aircraft,date,0\nA,2019-05-01,1\nA,2019-05-02,none\n", ":3: column 0: deviation_deg"},
        {"aircraft,date,0\nA,2019-05-01,\n", ":2: no heading of this swing has a reading"},
        {"aircraft,date,0,000\nA,2019-05-01,1,1\n", ":1: two columns are of the heading 0"},
        {"aircraft,date,0,compass_heading_deg\nA,2019-05-01,1,1\n", ":1: headings are columns, and columns of single readings"},
        {"aircraft,date,stage,0\nA,2019-05-01,halfway,1\n", ":2: stage: \"halfway\" is not allowed"},
        {"aircraft,date,0\nA,2019-05-01,1,2\n", ":2: has 4 cells"},
    };
    for (const auto& [text, message] : wrong)
        EXPECT_THAT(read(text, deviation).error, testing::HasSubstr(message)) << text;
}

TEST(YearsCsv, northTwiceCountsOnce)
{
    const auto all = read("aircraft,date,0,90,360\nA,2019-05-01,1,2,1\n", cells(YearsCells::Deviations));
    const auto& readings = all.swings.at(0).file.swing.readings;
    ASSERT_EQ(readings.size(), 3u);
    EXPECT_TRUE(readings[2].exclusion);
}

TEST(YearsCsv, cellsThatAreSomethingElseThanSaidAreTold)
{
    const auto all = read("aircraft,date,0,90,180,270\nA,2019-05-01,1,2,3,1\n", cells(YearsCells::Compass));
    ASSERT_EQ(all.warnings.size(), 1u);
    EXPECT_THAT(all.warnings[0].english(), testing::HasSubstr("3 of 4 deviations are larger than 45"));
}

TEST(YearsCsv, datesAsTheyAreWritten)
{
    EXPECT_EQ(plainDate("31.05.2026"), Date("2026-05-31"));
    EXPECT_EQ(plainDate("5.6.2026"), Date("2026-06-05")); // with dots the day is first
    EXPECT_EQ(plainDate("2026/06/05"), Date("2026-06-05"));
    for (const char* doubtful : {"5/6/2026", "05-06-2026", "31.05.26", "31.13.2026"})
        EXPECT_FALSE(plainDate(doubtful)) << doubtful;
    EXPECT_EQ(dateAsWritten("31.12.2019", DateOrder::DayMonthYear), Date("2019-12-31"));
    EXPECT_EQ(dateAsWritten("1/2/2019", DateOrder::DayMonthYear), Date("2019-02-01"));
    EXPECT_EQ(dateAsWritten("1/2/2019", DateOrder::MonthDayYear), Date("2019-01-02"));
    EXPECT_EQ(dateAsWritten("2019/1/2", DateOrder::YearMonthDay), Date("2019-01-02"));
    EXPECT_EQ(dateAsWritten("2019-01-02", DateOrder::DayMonthYear), Date("2019-01-02")); // no other day is meant by it
    for (const char* text : {"", "31.12.19", "31.2.2019", "2019", "1.2.3.2019", "a.b.2019", "1.2.20190", "-1.2.2019"})
        EXPECT_FALSE(dateAsWritten(text, DateOrder::DayMonthYear)) << text;
}

TEST(YearsCsv, headingsInTheNamesOfColumns)
{
    const std::vector<std::pair<const char*, double>> names{
        {"0", 0}, {"045", 45}, {"H090", 90}, {"heading_135_deg", 135}, {"180\u00B0", 180}, {"22.5", 22.5}, {"360", 360}};
    for (const auto& [name, heading] : names)
        EXPECT_EQ(headingOfColumn(name), heading) << name;
    for (const char* name : {"", "h", "361", "-1", "date", "height_m", "45x", "1e2", "nan", "+5"})
        EXPECT_FALSE(headingOfColumn(name)) << name;
}

} // namespace
} // namespace lubberline
