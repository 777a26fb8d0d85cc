#include "core/record/Completeness.h"

#include "core/record/ClockDates.h"

namespace lubberline {

namespace {

/// A, B and C and something to tell them by: the four cardinals of a correcting swing.
constexpr std::size_t kFewestReadings = 4;
constexpr std::size_t kFewestOfCheck = 2;

} // namespace

Message comesLater(Date date, Date today)
{
    if (date.empty() || date <= addDays(today, 1)) // dates are UTC: east of it, the crew is a day ahead
        return {};
    return {MARKED("core", "its date %1 is still to come (today is %2); expected the day on which it was swung"), date, today};
}

Message missingIn(const Swing& swing, Date today, DayKnown day)
{
    if (swing.date.empty())
        return MARKED("core", "its date is not stated");
    if (auto doubt = day == DayKnown::Yes ? comesLater(swing.date, today) : doubtOfDate(swing.date, today); !doubt.empty())
        return doubt;
    if (samePerson(swing.people.adjuster, swing.people.inspector))
        return {MARKED("core", "adjuster and inspector are both %1; expected another person who checks the work"), swing.people.inspector};
    for (std::size_t i = 0; i < swing.readings.size(); ++i) {
        const auto& reading = swing.readings[i];
        if (reading.exclusion || reading.magnetic.has_value() == reading.compass.has_value())
            continue;
        return Message{reading.magnetic ? MARKED("core", "reading %1 has no compass heading; fill it in or exclude it with a reason")
                                        : MARKED("core", "reading %1 has no magnetic heading; fill it in or exclude it with a reason"),
            i + 1};
    }
    const auto used = usedReadings(swing).size();
    const bool check = swing.kind == SwingKind::Check && swing.procedure == kCheckProcedure;
    if (const std::size_t fewest = check ? kFewestOfCheck : kFewestReadings; used < fewest)
        return Message{MARKED_N("core", "it has %n reading(s) that count; expected at least %1"), used, fewest};
    return {};
}

} // namespace lubberline
