#include <gtest/gtest.h>

#include "core/base/Calendar.h"
#include "core/due/CalendarFile.h"

namespace lubberline {
namespace {

TEST(Calendar, monthsKeepTheDayWhereThereIsOne)
{
    EXPECT_EQ(addMonths("2024-11-23", 24), "2026-11-23");
    EXPECT_EQ(addMonths("2024-02-29", 12), "2025-02-28");
    EXPECT_EQ(addMonths("2024-02-29", 48), "2028-02-29");
    EXPECT_EQ(addMonths("2025-02-28", 36), "2028-02-28");
    EXPECT_EQ(addMonths("2026-01-31", 1), "2026-02-28");
    EXPECT_EQ(addMonths("2026-12-31", 2), "2027-02-28");
    EXPECT_EQ(addMonths("2026-03-31", -1), "2026-02-28");
}

TEST(Calendar, daysAcrossLeapYears)
{
    EXPECT_EQ(addDays("2024-02-28", 1), "2024-02-29");
    EXPECT_EQ(addDays("2100-02-28", 1), "2100-03-01");
    EXPECT_EQ(addDays("2026-01-01", -1), "2025-12-31");
    EXPECT_EQ(daysBetween("2024-01-01", "2025-01-01"), 366);
    EXPECT_EQ(daysBetween("2026-11-24", "2026-11-23"), -1);
}

TEST(CalendarFile, isWhatRfc5545Wants)
{
    const CalendarEntry entry{"a1b2@lubberline", "2026-12-31", "Su-22 3713; standby compass, due", "24 months\nafter 2024-12-31 \\ swing"};
    const std::string file = writeCalendar({&entry, 1}, "2026-11-23T10:00:00Z");
    EXPECT_EQ(file,
        "BEGIN:VCALENDAR\r\nVERSION:2.0\r\nPRODID:-//Lubberline//compass swings//EN\r\nBEGIN:VEVENT\r\nUID:a1b2@lubberline\r\n"
        "DTSTAMP:20261123T100000Z\r\nDTSTART;VALUE=DATE:20261231\r\nDTEND;VALUE=DATE:20270101\r\n"
        "SUMMARY:Su-22 3713\\; standby compass\\, due\r\nDESCRIPTION:24 months\\nafter 2024-12-31 \\\\ swing\r\n"
        "TRANSP:TRANSPARENT\r\nEND:VEVENT\r\nEND:VCALENDAR\r\n");
}

TEST(CalendarFile, longLinesAreFoldedBetweenCharacters)
{
    std::string words;
    for (int i = 0; i < 60; ++i)
        words += "ż"; // two octets each
    const CalendarEntry entry{"u", "2026-12-31", words, {}};
    const std::string file = writeCalendar({&entry, 1}, "2026-11-23T10:00:00Z");
    std::size_t begin = 0;
    std::string unfolded;
    for (std::size_t end; (end = file.find("\r\n", begin)) != std::string::npos; begin = end + 2) {
        const std::string line = file.substr(begin, end - begin);
        EXPECT_LE(line.size(), 75u);
        EXPECT_NE(static_cast<unsigned char>(line[line[0] == ' ' ? 1 : 0]) & 0xc0, 0x80);
        unfolded += line[0] == ' ' ? line.substr(1) : "\n" + line;
    }
    EXPECT_NE(unfolded.find("SUMMARY:" + words), std::string::npos);
}

} // namespace
} // namespace lubberline
