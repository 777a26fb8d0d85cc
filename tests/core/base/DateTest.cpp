#include <gtest/gtest.h>

#include "core/base/Date.h"

namespace lubberline {
namespace {

TEST(Date, isReadOnlyFromADayOfTheCalendar)
{
    for (const char* text : {"2026-11-23", "2024-02-29", "2000-02-29", "1999-12-31", "0000-01-01", "9999-12-31"})
        EXPECT_EQ(Date::read(text).value_or(Date()).text(), text);
    for (const char* text : {"", "2023-02-29", "1900-02-29", "2026-13-01", "2026-00-10", "2026-04-31", "2026-04-00", "2026-4-3",
             "23.11.2026", "2026/11/23", "2026-11-23T00", "2026-11-2a", "-026-11-23", "2026-+1-23", " 2026-11-23", "2026-11-23 "})
        EXPECT_FALSE(Date::read(text)) << text;
}

TEST(Date, noneStatedIsEmptyAndBeforeAllDays)
{
    EXPECT_TRUE(Date().empty());
    EXPECT_EQ(Date().text(), "");
    EXPECT_EQ(Date(), Date(""));
    EXPECT_LT(Date(), Date("0000-01-01"));
}

TEST(Date, ordersAsTheCalendarDoes)
{
    EXPECT_LT(Date("2025-12-31"), Date("2026-01-01"));
    EXPECT_LT(Date("2026-09-30"), Date("2026-10-01"));
    EXPECT_LT(Date("2026-10-09"), Date("2026-10-10"));
    EXPECT_FALSE(Date("2026-10-10") < Date("2026-10-10"));
}

TEST(Date, monthsKeepTheDayWhereThereIsOne)
{
    EXPECT_EQ(addMonths("2024-11-23", 24), Date("2026-11-23"));
    EXPECT_EQ(addMonths("2024-02-29", 12), Date("2025-02-28"));
    EXPECT_EQ(addMonths("2024-02-29", 48), Date("2028-02-29"));
    EXPECT_EQ(addMonths("2025-02-28", 36), Date("2028-02-28"));
    EXPECT_EQ(addMonths("2026-01-31", 1), Date("2026-02-28"));
    EXPECT_EQ(addMonths("2026-12-31", 2), Date("2027-02-28"));
    EXPECT_EQ(addMonths("2026-03-31", -1), Date("2026-02-28"));
}

TEST(Date, daysAcrossLeapYears)
{
    EXPECT_EQ(addDays("2024-02-28", 1), Date("2024-02-29"));
    EXPECT_EQ(addDays("2100-02-28", 1), Date("2100-03-01"));
    EXPECT_EQ(addDays("2026-01-01", -1), Date("2025-12-31"));
    EXPECT_EQ(daysBetween("2024-01-01", "2025-01-01"), 366);
    EXPECT_EQ(daysBetween("2026-11-24", "2026-11-23"), -1);
}

} // namespace
} // namespace lubberline
