#include <gtest/gtest.h>

#include "core/due/CalendarFile.h"

namespace lubberline {
namespace {

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
