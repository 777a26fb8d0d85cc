#include "core/base/Number.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/base/Contract.h"

namespace lubberline {

namespace {

constexpr std::array<std::string_view, 6> kMinusSigns{"-", "\u2212", "\u2013", "\u2010", "\u2011", "\u2012"};
constexpr std::array<std::string_view, 3> kGroupSpaces{"\u00A0", "\u202F", "\u2009"};

bool isDigit(char c) { return c >= '0' && c <= '9'; }

std::size_t digitsAt(std::string_view text)
{
    return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), isDigit) - text.begin());
}

/// "1 234 567.5" without its spaces; the text as it is where they do not part every three digits.
std::string withoutGroups(std::string_view text)
{
    std::string figures(text.substr(0, digitsAt(text)));
    std::string_view rest = text.substr(figures.size());
    const auto space = std::find_if(kGroupSpaces.begin(), kGroupSpaces.end(), [&](std::string_view one) { return rest.starts_with(one); });
    if (space == kGroupSpaces.end() || figures.empty() || figures.size() > 3)
        return std::string(text);
    while (rest.starts_with(*space)) {
        rest.remove_prefix(space->size());
        if (digitsAt(rest) != 3)
            return std::string(text);
        figures.append(rest.substr(0, 3));
        rest.remove_prefix(3);
    }
    return figures.append(rest);
}

/// ASCII figures for from_chars, which takes a minus but no plus; empty when there is anything but figures.
std::string asciiFigures(std::string_view text, bool decimalComma)
{
    std::string figures;
    if (takeMinus(text))
        figures.push_back('-');
    else if (text.starts_with('+') && !text.starts_with("+-"))
        text.remove_prefix(1);
    figures.append(withoutGroups(text));
    if (decimalComma && std::count(figures.begin(), figures.end(), ',') == 1 && figures.find('.') == std::string::npos)
        std::replace(figures.begin(), figures.end(), ',', '.');
    const bool onlyFigures = figures.find_first_not_of("0123456789.+-eE") == std::string::npos;
    return onlyFigures ? figures : std::string();
}

/// Of the size of a number, without a sign.
std::string fixedFigures(double value, int decimals)
{
    LUBBERLINE_EXPECT(std::isfinite(value), "a number that is shown is finite");
    LUBBERLINE_EXPECT(decimals >= 0 && decimals <= 12, "0 to 12 decimals");
    std::array<char, 350> buffer; // the largest double has 309 digits before its point
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), std::abs(value), std::chars_format::fixed, decimals).ptr;
    return {buffer.data(), end};
}

std::string withSign(double value, int decimals, const char* plus)
{
    const std::string figures = fixedFigures(value, decimals);
    const bool isZero = figures.find_first_not_of("0.") == std::string::npos;
    return (isZero ? "" : value < 0 ? "\u2212" : plus) + figures;
}

} // namespace

bool takeMinus(std::string_view& text)
{
    for (const auto sign : kMinusSigns)
        if (text.starts_with(sign)) {
            text.remove_prefix(sign.size());
            return true;
        }
    return false;
}

std::string figureText(double value, int decimals) { return withSign(value, decimals, ""); }
std::string signedFigureText(double value, int decimals) { return withSign(value, decimals, "+"); }

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
