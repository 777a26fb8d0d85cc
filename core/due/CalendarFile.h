#pragma once
/// iCalendar (RFC 5545) of what falls due: whole-day events that any calendar program imports.

#include <span>
#include <string>

#include "core/base/Date.h"

namespace lubberline {

struct CalendarEntry {
    std::string uid; ///< the same for the same thing: an import a second time changes the entry, and makes no second one
    Date date;
    std::string summary;
    std::string description;
};

/// CRLF line ends, lines folded at 75 octets without cutting a character, text escaped. @param madeAtUtc ISO 8601, for DTSTAMP.
[[nodiscard]] std::string writeCalendar(std::span<const CalendarEntry> entries, const std::string& madeAtUtc);

} // namespace lubberline
