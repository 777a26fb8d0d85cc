#pragma once
/// A day of the calendar, or none stated. All dates of records are UTC days; there is no time zone in them. In files, in the
/// database and on paper a day is ISO 8601 (YYYY-MM-DD) and none is an empty text.

#include <chrono>
#include <compare>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace lubberline {

class Date {
public:
    constexpr Date() = default; ///< none stated
    /// A day written in the source, or "" for none: one that is no day does not compile.
    template <std::size_t size>
    consteval Date(const char (&iso)[size]) : Date(size == 1 ? Date() : read(std::string_view(iso, size - 1)).value())
    {
    }
    /// Of the years 0 to 9999 (what ISO 8601 writes with four digits), and a day of the calendar: anything else is a broken contract.
    explicit Date(std::chrono::year_month_day day);

    /// @return the day that YYYY-MM-DD names: 2024-02-29 does, 2023-02-29 does not. None for anything else, the empty text too.
    [[nodiscard]] static constexpr std::optional<Date> read(std::string_view iso);

    [[nodiscard]] constexpr bool empty() const { return m_month == 0; } ///< none is stated
    [[nodiscard]] std::chrono::year_month_day day() const;              ///< one is stated
    [[nodiscard]] std::string text() const;                             ///< "2026-11-26"; empty: none stated

    /// Earlier days first; none stated is before all of them.
    friend constexpr auto operator<=>(Date, Date) = default;

private:
    constexpr Date(int year, int month, int day)
        : m_year(static_cast<short>(year))
        , m_month(static_cast<unsigned char>(month))
        , m_day(static_cast<unsigned char>(day))
    {
    }
    short m_year = 0;
    unsigned char m_month = 0, m_day = 0; ///< both 0: none stated
};

constexpr std::optional<Date> Date::read(std::string_view iso)
{
    if (iso.size() != 10 || iso[4] != '-' || iso[7] != '-')
        return {};
    const auto number = [iso](std::size_t begin, std::size_t digits) {
        int value = 0;
        for (const char c : iso.substr(begin, digits))
            value = c >= '0' && c <= '9' && value >= 0 ? 10 * value + (c - '0') : -1;
        return value;
    };
    const int year = number(0, 4), month = number(5, 2), day = number(8, 2);
    if (year < 0 || month < 1 || day < 1)
        return {};
    const std::chrono::year_month_day named(
        std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)), std::chrono::day(static_cast<unsigned>(day)));
    return named.ok() ? std::optional(Date(year, month, day)) : std::nullopt;
}

/// The same day `months` later; where that month has no such day, its last one (29 February + 12 months is 28 February).
[[nodiscard]] Date addMonths(Date date, int months);
[[nodiscard]] Date addDays(Date date, int days);
/// to − from, in days.
[[nodiscard]] int daysBetween(Date from, Date to);

} // namespace lubberline
