#include "core/base/Clock.h"
#include "core/base/UtcTime.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>

namespace lubberline {

namespace {

using namespace std::chrono;

Clock standingAt(sys_days day, milliseconds time)
{
    return {[=] { return Clock::Time(day + time); }};
}

} // namespace

TEST(Clock, saysTheTimeAsItIsStored)
{
    const Clock clock = standingAt(2026y / November / 6, hours(9) + minutes(5) + seconds(7) + milliseconds(40));
    EXPECT_EQ(clock.today(), Date("2026-11-06"));
    EXPECT_EQ(clock.nowUtc(), "2026-11-06T09:05:07Z");
    EXPECT_EQ(clock.nowUtc_ms(), "2026-11-06T09:05:07.040Z");
    EXPECT_EQ(standingAt(2024y / February / 29, hours(24) - milliseconds(1)).nowUtc_ms(), "2024-02-29T23:59:59.999Z");
    EXPECT_EQ(standingAt(1969y / December / 31, hours(23)).nowUtc(), "1969-12-31T23:00:00Z");
}

TEST(Clock, ofTheMachineIsUtcWhereverTheMachineIs)
{
    const std::string before = machineClock().nowUtc();
    setenv("TZ", "Pacific/Kiritimati", 1); // fourteen hours ahead
    tzset();
    const std::string after = machineClock().nowUtc();
    unsetenv("TZ");
    tzset();
    EXPECT_EQ(before.substr(0, 4), after.substr(0, 4));
    EXPECT_LE(before, after);
    const sys_time<milliseconds> now = machineClock().now();
    EXPECT_LT(abs(floor<seconds>(now).time_since_epoch() - seconds(std::time(nullptr))), seconds(60));
}

TEST(UtcText, isAMomentOfTheCalendarInUtc)
{
    for (const char* text : {"2026-11-06T09:05:07Z", "2026-11-06T09:05:07.040Z", "2026-11-06T09:05Z", "2024-02-29T23:59:59Z"})
        EXPECT_TRUE(isUtcText(text)) << text;
    for (const char* text :
        {"", "Z", "half past nine", "2026-11-06", "2026-13-45", "2026-11-06T25:00:00Z", "2026-02-29T09:00:00Z", "2026-11-06 09:05:07Z",
            "2026-11-06T09:05:07", "2026-11-06T09:05:07+02:00", "2026-11-06T09:05:07Z\n", "-1", "999999999999", "2026-11-06T09:61:00Z"})
        EXPECT_FALSE(isUtcText(text)) << text;
    for (const auto& text : {machineClock().nowUtc(), machineClock().nowUtc_ms()})
        EXPECT_TRUE(isUtcText(text)) << text;
}

} // namespace lubberline
