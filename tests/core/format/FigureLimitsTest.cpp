// Tables of figures are read row by row; what is kept of each name, aircraft or leg has an end.

#include <gmock/gmock.h>

#include <sstream>

#include "core/format/csv/InflightCsv.h"
#include "core/format/csv/WindCsv.h"

namespace lubberline::test {

namespace {

using testing::HasSubstr;

const std::string kWindHeader
    = "aircraft,flight,ground_speed_kt,track_deg,wind_speed_kt,wind_from_deg,ref_wind_speed_kt,ref_wind_from_deg\n";

std::string windRow(const std::string& aircraft, const std::string& flight) { return aircraft + "," + flight + ",300,90,20,270,21,268\n"; }

std::string windFault(const std::string& rows)
{
    std::istringstream input(kWindHeader + rows);
    const auto read = readWindCsv(input, "winds.csv", WindOptions{});
    return read ? std::string() : describe(read.error());
}

} // namespace

TEST(FigureLimits, namesOfWindReportsAreShort)
{
    EXPECT_THAT(windFault(windRow(std::string(200, 'A'), "F1")), testing::Not(HasSubstr("bytes")));
    EXPECT_THAT(windFault(windRow("A", "F1") + windRow(std::string(201, 'A'), "F1")), HasSubstr("winds.csv:3: aircraft has 201 bytes"));
    EXPECT_THAT(windFault(windRow("A", std::string(100'000, 'F'))), HasSubstr("winds.csv:2: flight has 100000 bytes"));
}

TEST(FigureLimits, aircraftOfWindReportsAreCounted)
{
    std::string rows;
    for (int i = 0; i < 10'001; ++i)
        rows += windRow("A" + std::to_string(i), "F");
    EXPECT_THAT(windFault(rows), HasSubstr("winds.csv:10002: there are more than 10000 aircraft"));
}

TEST(FigureLimits, legsAreCountedAndTheirNamesShort)
{
    std::string rows = "time_s,compass_heading_deg,deviation_deg,leg\n";
    for (int i = 0; i < 10'001; ++i)
        rows += std::to_string(i) + ",90,1," + (i % 2 ? "a" : "b") + "\n"; // each begins another
    std::istringstream log(rows);
    const auto swing = readContinuousCsv(log, "log.csv", ContinuousOptions{});
    ASSERT_FALSE(swing);
    EXPECT_THAT(describe(swing.error()), HasSubstr("log.csv:10002: there are more than 10000 legs"));
    std::istringstream legs("track_deg,ground_speed_kt,leg\n90,300," + std::string(201, 'x') + "\n");
    const auto read = readLegsCsv(legs, "legs.csv");
    ASSERT_FALSE(read);
    EXPECT_THAT(describe(read.error()), HasSubstr("legs.csv:2: leg has 201 bytes"));
}

TEST(FigureLimits, commentsAboveAHeaderTakeNoMoreThanTheyMay)
{
    std::string above;
    for (int i = 0; i < 20; ++i)
        above += "# " + std::string(1'000'000, 'x') + "\n";
    std::istringstream input(above + kWindHeader + windRow("A", "F"));
    const auto read = readWindCsv(input, "winds.csv", WindOptions{});
    EXPECT_TRUE(read) << describe(read.error());
}

} // namespace lubberline::test
