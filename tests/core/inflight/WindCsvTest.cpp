// Reports of wind out of a file, read by one hand and summed up by the other: what comes out is what one hand makes of them, and of two faults
// the one that stands first is told.

#include <gtest/gtest.h>

#include <sstream>

#include "core/base/Number.h"
#include "core/format/csv/WindCsv.h"
#include "core/inflight/WindVector.h"

using namespace lubberline;

namespace {

constexpr const char* kHeader
    = "aircraft,flight,ground_speed_kt,track_deg,wind_speed_kt,wind_from_deg,ref_wind_speed_kt,ref_wind_from_deg\n";

Result<WindFile> read(const std::string& csv)
{
    std::istringstream input(csv);
    return readWindCsv(input, "reports.csv", {});
}

std::string names(int from, int to)
{
    std::string rows;
    for (int i = from; i < to; ++i)
        rows += "A" + std::to_string(i) + ",F,400,90,20,270,21,268\n";
    return rows;
}

} // namespace

TEST(WindCsv, twoHandsMakeWhatOneMakes)
{
    WindStudy study{WindOptions()};
    std::string csv = kHeader;
    for (int i = 0; i < 30'000; ++i) { // heaps enough that each is filled anew, and the last is not full
        const std::string aircraft = "A" + std::to_string(i / 7 % 3), flight = "F" + std::to_string(i / 500);
        const double track = i * 37 % 360, wind = 15 + i % 11, from = i * 13 % 360;
        WindReport report;
        report.aircraft = aircraft;
        report.flight = flight;
        report.groundSpeed_kt = 400;
        report.track_deg = track;
        report.wind_kt = wind;
        report.windFrom_deg = from;
        report.reference_kt = wind + 1;
        report.referenceFrom_deg = from;
        study.add(report);
        csv += aircraft + "," + flight + ",400," + shortestNumber(track) + "," + shortestNumber(wind) + "," + shortestNumber(from) + ","
            + shortestNumber(wind + 1) + "," + shortestNumber(from) + "\n";
    }
    const auto file = read(csv);
    ASSERT_TRUE(file) << describe(file.error());
    const WindResult one = study.finish();
    ASSERT_EQ(file->result.aircraft.size(), 3u);
    EXPECT_EQ(file->result.used, one.used);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(file->result.aircraft[i].aircraft, one.aircraft[i].aircraft);
        EXPECT_EQ(file->result.aircraft[i].flights, 60);
        for (int c = 0; c < 5; ++c)
            EXPECT_EQ(file->result.aircraft[i].fit.fit.value(c), one.aircraft[i].fit.fit.value(c)); // to the last digit
    }
}

TEST(WindCsv, ofTwoFaultsTheFirstIsTold)
{
    const auto tooMany = read(kHeader + names(0, 30'000));
    ASSERT_FALSE(tooMany);
    EXPECT_EQ(tooMany.error().line, 10'002); // the row of the 10,001st aircraft
    EXPECT_NE(describe(tooMany.error()).find("more than 10000 aircraft"), std::string::npos);
    const auto laterFault = read(kHeader + names(0, 10'100) + "A1,F,four hundred,90,20,270,21,268\n");
    ASSERT_FALSE(laterFault);
    EXPECT_EQ(laterFault.error().line, 10'002);
    const auto fault = read(kHeader + names(0, 5'000) + "A1,F,four hundred,90,20,270,21,268\n" + names(5'000, 20'000));
    ASSERT_FALSE(fault);
    EXPECT_EQ(fault.error().line, 5'002);
    EXPECT_NE(describe(fault.error()).find("four hundred"), std::string::npos);
}

TEST(WindCsv, quotesAndSeparatorsFarInARowAreSeen)
{
    // Beyond the sixteen bytes that are looked at together, and across their edges.
    const auto file = read(std::string(kHeader) + "\"A, with a long name of its own\",\"F \"\"one\"\"\",400,90,20,270,21,268\n"
        + "B,F,400.0000000000000000,90.00000000000000000,20,270,21,268\n");
    ASSERT_TRUE(file) << describe(file.error());
    ASSERT_EQ(file->result.aircraft.size(), 2u);
    EXPECT_EQ(file->result.aircraft[0].aircraft, "A, with a long name of its own");
    EXPECT_EQ(file->result.used, 2);
}
