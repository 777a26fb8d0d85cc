#include "core/base/FileText.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/base/TerminalText.h"

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

/// Of well-formed UTF-8 of so many bytes.
char32_t codePointOf(std::string_view character)
{
    const auto lead = static_cast<unsigned char>(character[0]);
    if (character.size() == 1)
        return lead;
    char32_t point = lead & (0xFFu >> (character.size() + 1));
    for (const char c : character.substr(1))
        point = (point << 6) | (static_cast<unsigned char>(c) & 0x3Fu);
    return point;
}

struct CodePoints {
    char32_t first, last;
};
template <std::size_t N>
bool isAmong(const std::array<CodePoints, N>& ranges, char32_t point)
{
    return std::any_of(
        ranges.begin(), ranges.end(), [point](const CodePoints& range) { return point >= range.first && point <= range.last; });
}

/// Unicode 15, general category Zs, and the tab.
constexpr std::array kSpaces{CodePoints{'\t', '\t'}, CodePoints{' ', ' '}, CodePoints{0xA0, 0xA0}, CodePoints{0x1680, 0x1680},
    CodePoints{0x2000, 0x200A}, CodePoints{0x202F, 0x202F}, CodePoints{0x205F, 0x205F}, CodePoints{0x3000, 0x3000}};
/// Categories Cc, Cf, Zl and Zp, variation selectors, and letters and fillers that are drawn as nothing.
constexpr std::array kUnseen{CodePoints{0, 0x1F}, CodePoints{0x7F, 0xA0}, CodePoints{0xAD, 0xAD}, CodePoints{0x34F, 0x34F},
    CodePoints{0x600, 0x605}, CodePoints{0x61C, 0x61C}, CodePoints{0x115F, 0x1160}, CodePoints{0x1680, 0x1680}, CodePoints{0x17B4, 0x17B5},
    CodePoints{0x180B, 0x180F}, CodePoints{0x2000, 0x200F}, CodePoints{0x2028, 0x202F}, CodePoints{0x205F, 0x206F},
    CodePoints{0x2800, 0x2800}, CodePoints{0x3000, 0x3000}, CodePoints{0x3164, 0x3164}, CodePoints{0xE000, 0xF8FF},
    CodePoints{0xFE00, 0xFE0F}, CodePoints{0xFEFF, 0xFEFF}, CodePoints{0xFFA0, 0xFFA0}, CodePoints{0xFFF0, 0xFFFC},
    CodePoints{0xE0000, 0xE0FFF}};
/// Categories Cc, Zl and Zp, and the marks of direction of Unicode's annex 9.
constexpr std::array kActedOn{CodePoints{0, 0x1F}, CodePoints{0x7F, 0x9F}, CodePoints{0x61C, 0x61C}, CodePoints{0x200E, 0x200F},
    CodePoints{0x2028, 0x202E}, CodePoints{0x2066, 0x2069}};
constexpr char32_t kFirstOtherScript = 0x370; ///< Greek; below are Latin letters, whose accents are seen
/// Minus signs, primes and quotes, which figures may have.
constexpr std::array kSignsOfFigures{
    CodePoints{0x2010, 0x2013}, CodePoints{0x2018, 0x201D}, CodePoints{0x2032, 0x2033}, CodePoints{0x2212, 0x2212}};

std::string named(char32_t point)
{
    std::array<char, 16> text;
    return {text.data(), static_cast<std::size_t>(std::snprintf(text.data(), text.size(), "[U+%04X]", static_cast<unsigned>(point)))};
}

std::string hexByte(char byte)
{
    std::array<char, 8> text;
    return {text.data(),
        static_cast<std::size_t>(
            std::snprintf(text.data(), text.size(), "0x%02X", static_cast<unsigned>(static_cast<unsigned char>(byte))))};
}

std::string escaped(std::string_view text, std::string_view kept)
{
    std::string shown;
    shown.reserve(text.size());
    while (!text.empty()) {
        const std::size_t length = codePointLength(text);
        const char32_t point = length == 0 ? static_cast<unsigned char>(text[0]) : codePointOf(text.substr(0, length));
        if (length > 0 && (!isAmong(kActedOn, point) || kept.find(text[0]) != std::string_view::npos)) {
            shown += text.substr(0, length);
        } else {
            std::array<char, 16> escape;
            shown.append(escape.data(),
                static_cast<std::size_t>(
                    std::snprintf(escape.data(), escape.size(), length == 0 ? "\\x%02X" : "\\u%04X", static_cast<unsigned>(point))));
        }
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return shown;
}

std::string quoted(std::string_view text, bool figures)
{
    std::string shown = "\"";
    std::size_t taken = 0;
    while (taken < text.size() && taken < kLongestQuote) {
        const auto rest = text.substr(taken);
        const std::size_t length = codePointLength(rest);
        if (length == 0) { // no UTF-8: nothing that could be shown
            shown += '[' + hexByte(rest[0]) + ']';
            ++taken;
            continue;
        }
        if (taken + length > kLongestQuote)
            break;
        const auto character = rest.substr(0, length);
        const char32_t point = codePointOf(character);
        taken += length;
        if (isAmong(kUnseen, point)) {
            shown += named(point);
            continue;
        }
        shown += character;
        if (figures && point >= kFirstOtherScript && !isAmong(kSignsOfFigures, point))
            shown += named(point);
    }
    return shown + (taken < text.size() ? "\u2026\"" : "\"");
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

std::size_t spaceAt(std::string_view text)
{
    const std::size_t length = text.empty() ? 0 : codePointLength(text);
    return length > 0 && isAmong(kSpaces, codePointOf(text.substr(0, length))) ? length : 0;
}

std::string_view trimmed(std::string_view text)
{
    while (const std::size_t space = spaceAt(text))
        text.remove_prefix(space);
    while (!text.empty()) {
        std::size_t last = text.size() - 1;
        while (last > 0 && isContinuation(static_cast<unsigned char>(text[last])))
            --last;
        if (spaceAt(text.substr(last)) != text.size() - last)
            break;
        text = text.substr(0, last);
    }
    return text;
}

std::string inSmallLetters(std::string_view text)
{
    std::string small(text);
    for (char& c : small)
        if (c >= 'A' && c <= 'Z')
            c = static_cast<char>(c - 'A' + 'a');
    return small;
}

std::string forTerminal(std::string_view text) { return escaped(text, "\n\t"); }
std::string inOneLine(std::string_view text) { return escaped(text, {}); }
std::string inQuotes(std::string_view text) { return quoted(text, false); }
std::string figuresInQuotes(std::string_view text) { return quoted(text, true); }

Message otherEncoding(std::string_view beginning)
{
    constexpr std::size_t kEnough = 512;
    constexpr Pattern kAdvice = MARKED("core", "is %1; expected UTF-8: save it with the character set UTF-8 (in Excel: \"CSV UTF-8\")");
    const auto begins = [&](std::string_view mark) { return beginning.starts_with(mark); };
    if (begins(std::string_view("\xFF\xFE\0\0", 4)) || begins(std::string_view("\0\0\xFE\xFF", 4)))
        return {kAdvice, std::string("UTF-32")};
    if (begins("PK\x03\x04") || begins("\xD0\xCF\x11\xE0"))
        return {kAdvice, Message{MARKED("core", "a workbook of a spreadsheet program")}};
    if (begins("\xFF\xFE") || begins("\xFE\xFF"))
        return {kAdvice, std::string("UTF-16")};
    // Without its mark: figures and Latin letters have a zero in every second byte, and in no other.
    const auto text = beginning.substr(0, std::min(beginning.size(), kEnough) / 2 * 2);
    std::array<std::size_t, 2> zeros{};
    for (std::size_t i = 0; i < text.size(); ++i)
        zeros[i % 2] += text[i] == '\0';
    if (text.size() >= 4 && zeros[0] + zeros[1] > text.size() / 4 && (zeros[0] == 0 || zeros[1] == 0))
        return {kAdvice, Message{MARKED("core", "UTF-16 without its byte order mark")}};
    return {};
}

Message notUtf8(std::string_view line)
{
    std::size_t good = 0;
    while (good < line.size()) {
        const std::size_t length = codePointLength(line.substr(good));
        if (length == 0)
            break;
        good += length;
    }
    if (good == line.size())
        return {};
    constexpr std::size_t kBefore = 24;
    std::size_t from = good > kBefore ? good - kBefore : 0;
    while (from < good && isContinuation(static_cast<unsigned char>(line[from])))
        ++from;
    return {
        MARKED("core",
            "the byte %1 behind %2 is not UTF-8 (the file is in a code page such as Windows-1252); expected UTF-8: save it with the character set UTF-8 (in Excel: \"CSV UTF-8\")"),
        hexByte(line[good]), inQuotes(line.substr(from, good - from))};
}

} // namespace lubberline
