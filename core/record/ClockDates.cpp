#include "core/record/ClockDates.h"

#include <algorithm>
#include <array>

#include "core/record/Completeness.h"

namespace lubberline {

namespace {

constexpr Date kGpsBegins = "1980-01-06";
/// Of computers, and of spreadsheets with the one calendar and the other.
constexpr std::array<Date, 5> kOthersBegin{"1970-01-01", "1899-12-30", "1899-12-31", "1900-01-01", "1904-01-01"};
constexpr Date kFirstAircraft = "1903-01-01";
/// A draft is completed within so many days; who types in an old record that happens to be of such a day can wait as long.
constexpr int kDraft_days = 7;

} // namespace

bool beginsGpsWeeks(Date date)
{
    const int since = date.empty() ? -1 : daysBetween(kGpsBegins, date);
    return since >= 0 && since % kGpsRollOver_days == 0;
}

Message doubtOfClock(Date date, Date today)
{
    if (date.empty())
        return {};
    if (date < today && (beginsGpsWeeks(date) || std::find(kOthersBegin.begin(), kOthersBegin.end(), date) != kOthersBegin.end()))
        return {MARKED("core",
                    "its date %1 is one from which clocks count that do not know the day (a receiver without a fix, a spreadsheet); "
                    "expected the day on which it was swung"),
            date};
    if (date < kFirstAircraft)
        return {MARKED("core", "its date %1 is before there were aircraft; expected the day on which it was swung"), date};
    const int ago = today.empty() ? 0 : daysBetween(date, today) + 1; // dates are UTC: in the east it is tomorrow already
    if (ago >= kGpsRollOver_days && ago % kGpsRollOver_days <= kDraft_days + 1)
        return {MARKED("core",
                    "its date %1 is what a receiver that missed the turn of the GPS week count (1024 weeks) writes for %2; "
                    "expected the day on which it was swung"),
            date, addDays(date, ago / kGpsRollOver_days * kGpsRollOver_days)};
    return {};
}

Message doubtOfDate(Date date, Date today)
{
    auto later = comesLater(date, today);
    return later.empty() ? doubtOfClock(date, today) : later;
}

} // namespace lubberline
