#include "core/record/Completeness.h"

namespace lubberline {

namespace {

/// A, B and C and something to tell them by: the four cardinals of a correcting swing.
constexpr std::size_t kFewestReadings = 4;

} // namespace

std::string missingIn(const Swing& swing)
{
    if (swing.date.empty())
        return "its date is not stated";
    for (std::size_t i = 0; i < swing.readings.size(); ++i) {
        const auto& reading = swing.readings[i];
        if (reading.exclusion || reading.magnetic.has_value() == reading.compass.has_value())
            continue;
        return "reading " + std::to_string(i + 1) + " has no " + (reading.magnetic ? "compass heading" : "magnetic heading")
            + "; fill it in or exclude it with a reason";
    }
    const auto used = usedReadings(swing).size();
    if (used < kFewestReadings)
        return "it has " + std::to_string(used) + " readings that count; expected at least " + std::to_string(kFewestReadings);
    return {};
}

} // namespace lubberline
