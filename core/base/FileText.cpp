#include "core/base/FileText.h"

#include <algorithm>
#include <charconv>
#include <chrono>

namespace lubberline {

namespace {

constexpr std::size_t kLongestQuote = 60;

bool isContinuation(unsigned char c) { return (c & 0xC0) == 0x80; }

/// Bytes of the code point that begins the text; 0: ill-formed (Unicode 15, table 3-7).
std::size_t codePointLength(std::string_view text)
{
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80)
        return 1;
    const std::size_t length = lead >= 0xC2 && lead <= 0xDF ? 2 : (lead & 0xF0) == 0xE0 ? 3 : lead >= 0xF0 && lead <= 0xF4 ? 4 : 0;
    if (length == 0 || text.size() < length)
        return 0;
    for (std::size_t i = 1; i < length; ++i)
        if (!isContinuation(byte(i)))
            return 0;
    const bool overlong = (lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xF0 && byte(1) < 0x90);
    const bool surrogate = lead == 0xED && byte(1) > 0x9F;
    const bool beyond = lead == 0xF4 && byte(1) > 0x8F;
    return overlong || surrogate || beyond ? 0 : length;
}

int digitsOf(std::string_view text)
{
    int value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

} // namespace

bool isUtf8(std::string_view text)
{
    while (!text.empty()) {
        const std::size_t length = codePointLength(text);
        if (length == 0)
            return false;
        text.remove_prefix(length);
    }
    return true;
}

bool isIsoDate(std::string_view text)
{
    if (text.size() != 10)
        return false;
    for (std::size_t i = 0; i < text.size(); ++i)
        if ((i == 4 || i == 7) ? text[i] != '-' : (text[i] < '0' || text[i] > '9'))
            return false;
    using namespace std::chrono;
    return year_month_day(year(digitsOf(text.substr(0, 4))), month(static_cast<unsigned>(digitsOf(text.substr(5, 2)))),
        day(static_cast<unsigned>(digitsOf(text.substr(8, 2)))))
        .ok();
}

std::string_view trimmed(std::string_view text)
{
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::string inQuotes(std::string_view text)
{
    std::size_t length = std::min(text.size(), kLongestQuote);
    while (length < text.size() && length > 0 && isContinuation(static_cast<unsigned char>(text[length])))
        --length;
    std::string shown(text.substr(0, length));
    std::replace_if(
        shown.begin(), shown.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, '?');
    return "\"" + shown + (length < text.size() ? "\u2026\"" : "\"");
}

} // namespace lubberline
