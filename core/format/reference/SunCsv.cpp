#include "core/format/reference/SunCsv.h"

#include <array>

#include "core/angle/AngleText.h"
#include "core/base/WholeFile.h"
#include "core/format/reference/SmallTable.h"

namespace lubberline {

namespace {

constexpr std::array<std::string_view, 4> kSunColumns{"time_utc", "compass_heading_deg", "shadow_bearing_deg", "sun_bearing_deg"};

Result<SunReading> readingOf(const SmallRow& row)
{
    const auto named = [](std::size_t column, const Error& error) {
        return Error{error.code, {MARKED("core", "%1: %2"), std::string(kSunColumns[column]), error.message}};
    };
    const auto time = readUtcTime(row[0]);
    if (!time)
        return named(0, time.error());
    const auto compass = parseHeading_deg(row[1], North::Compass);
    if (!compass)
        return named(1, compass.error());
    if (row[2].empty() == row[3].empty())
        return Error{ErrorCode::InvalidInput, MARKED("core", "expected a bearing of the shadow or of the sun, one of them in each row")};
    const std::size_t column = row[2].empty() ? 3 : 2;
    const auto bearing = parseHeading_deg(row[column]);
    if (!bearing)
        return named(column, bearing.error());
    return SunReading{*time, row[0], CompassHeading::fromDegrees(*compass), *bearing, column == 2};
}

} // namespace

Result<std::vector<SunReading>> readSunCsv(std::string_view text, const std::string& name)
{
    std::vector<SunReading> readings;
    const auto read = readSmallTable(text, name, kSunColumns, 2, [&readings](const SmallRow& row) -> Result<void> {
        auto reading = readingOf(row);
        if (!reading)
            return reading.error();
        readings.push_back(std::move(*reading));
        return {};
    });
    return read ? Result<std::vector<SunReading>>(std::move(readings)) : Result<std::vector<SunReading>>(read.error());
}

Result<std::vector<SunReading>> readSunCsvFile(const std::string& path)
{
    const auto text = readWholeFile(path, MARKED("core", "a table of compass headings and bearings of the sun"));
    return text ? readSunCsv(*text, nameOfInput(path)) : Result<std::vector<SunReading>>(text.error());
}

} // namespace lubberline
