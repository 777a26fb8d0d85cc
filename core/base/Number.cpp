#include "core/base/Number.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/base/Contract.h"

namespace lubberline {

namespace {

constexpr std::string_view kUnicodeMinus = "\u2212";

/// ASCII figures for from_chars, which takes a minus but no plus; empty when there is anything but figures.
std::string asciiFigures(std::string_view text, bool decimalComma)
{
    std::string figures;
    if (text.starts_with(kUnicodeMinus)) {
        figures.push_back('-');
        text.remove_prefix(kUnicodeMinus.size());
    } else if (text.starts_with('+') && !text.starts_with("+-")) {
        text.remove_prefix(1);
    }
    figures.append(text);
    if (decimalComma && std::count(figures.begin(), figures.end(), ',') == 1 && figures.find('.') == std::string::npos)
        std::replace(figures.begin(), figures.end(), ',', '.');
    const bool onlyFigures = figures.find_first_not_of("0123456789.+-eE") == std::string::npos;
    return onlyFigures ? figures : std::string();
}

} // namespace

FileNumber readNumber(std::string_view text, bool decimalComma)
{
    const std::string figures = asciiFigures(text, decimalComma);
    FileNumber number;
    const auto [end, fault] = std::from_chars(figures.data(), figures.data() + figures.size(), number.value);
    if (figures.empty() || end != figures.data() + figures.size() || fault == std::errc::invalid_argument)
        return {0, NumberFault::NotANumber};
    if (fault == std::errc::result_out_of_range || !std::isfinite(number.value))
        return {0, NumberFault::OutOfRange};
    return number;
}

std::string shortestNumber(double value)
{
    LUBBERLINE_EXPECT(std::isfinite(value), "a number that is written to a file is finite");
    std::array<char, 32> buffer;
    return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value + 0.0).ptr};
}

} // namespace lubberline
