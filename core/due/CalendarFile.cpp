#include "core/due/CalendarFile.h"

#include <algorithm>

namespace lubberline {

namespace {

constexpr std::size_t kMostOctets = 75; // RFC 5545, 3.1

std::string escaped(const std::string& text)
{
    std::string result;
    for (const char c : text) {
        if (c == '\r')
            continue;
        if (c == '\\' || c == ';' || c == ',')
            result += '\\';
        if (c == '\n')
            result += "\\n";
        else
            result += c;
    }
    return result;
}

bool continuesCharacter(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

void addLine(std::string& file, const std::string& line)
{
    for (std::size_t begin = 0; begin < line.size();) {
        const std::size_t room = kMostOctets - (begin == 0 ? 0 : 1); // a continuation begins with a space
        std::size_t end = std::min(begin + room, line.size());
        while (end < line.size() && end > begin + 1 && continuesCharacter(line[end]))
            --end;
        file += (begin == 0 ? "" : " ") + line.substr(begin, end - begin) + "\r\n";
        begin = end;
    }
}

/// 2026-11-23 → 20261123; 2026-11-23T10:00:00Z → 20261123T100000Z.
std::string basic(std::string text)
{
    std::erase_if(text, [](char c) { return c == '-' || c == ':'; });
    return text;
}

} // namespace

std::string writeCalendar(std::span<const CalendarEntry> entries, const std::string& madeAtUtc)
{
    std::string file;
    addLine(file, "BEGIN:VCALENDAR");
    addLine(file, "VERSION:2.0");
    addLine(file, "PRODID:-//Lubberline//compass swings//EN");
    for (const auto& entry : entries) {
        addLine(file, "BEGIN:VEVENT");
        addLine(file, "UID:" + escaped(entry.uid));
        addLine(file, "DTSTAMP:" + basic(madeAtUtc));
        addLine(file, "DTSTART;VALUE=DATE:" + basic(entry.date.text()));
        addLine(file, "DTEND;VALUE=DATE:" + basic(addDays(entry.date, 1).text())); // the end is not part of the event
        addLine(file, "SUMMARY:" + escaped(entry.summary));
        if (!entry.description.empty())
            addLine(file, "DESCRIPTION:" + escaped(entry.description));
        addLine(file, "TRANSP:TRANSPARENT");
        addLine(file, "END:VEVENT");
    }
    addLine(file, "END:VCALENDAR");
    return file;
}

} // namespace lubberline
