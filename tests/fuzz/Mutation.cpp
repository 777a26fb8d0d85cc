#include "tests/fuzz/Mutation.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace lubberline::test {

namespace {

using namespace std::string_view_literals;

/// What parsers trip over: numbers at the ends of their kinds, marks of other encodings, halves of pairs, deep nesting.
constexpr std::string_view kTelling[] = {"nan"sv, "inf"sv, "-"sv, "1e999"sv, "-1e999"sv, "1e-999"sv, "0x1p5"sv, "9223372036854775808"sv,
    "-9223372036854775809"sv, "4294967296"sv, "360"sv, "-0"sv, "1,5"sv, ""sv, "\0"sv, "\r"sv, "\n\n"sv, "\""sv, "\\"sv, "\\ud800"sv,
    "\\u0000"sv, "\xEF\xBB\xBF"sv, "\xFF\xFE"sv, "\xC0\x80"sv, "\xED\xA0\x80"sv, "\xF4\x90\x80\x80"sv, "\xC2\x9B"sv, "\xE2\x80\xAE"sv,
    "\x1B[2J"sv, "null"sv, "true"sv, "[]"sv, "{}"sv, "[[[[[[[[[[[[[[[["sv, "{\"a\":{\"a\":{\"a\":"sv, ","sv, ";"sv, "\t"sv, "#"sv, "$"sv,
    "*00"sv, "endstream"sv, "/Length 99999999"sv};

} // namespace

/// SplitMix64 (Steele, Lea and Flood, 2014): std's distributions differ from one library to another.
std::uint64_t Mutation::next()
{
    std::uint64_t z = m_state += 0x9E3779B97F4A7C15ULL;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
}

/// One draw after the other: compilers evaluate arguments in orders of their own.
std::string Mutation::piece(const std::string& bytes, std::size_t longest)
{
    const std::size_t place = below(bytes.size()), length = 1 + below(longest);
    return bytes.substr(place, length);
}

/// A number that stands there becomes one that may not.
void Mutation::changeNumber(std::string& bytes)
{
    const auto isDigit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
    const auto from = std::find_if(bytes.begin() + static_cast<std::ptrdiff_t>(below(bytes.size())), bytes.end(), isDigit);
    const auto to = std::find_if_not(from, bytes.end(), isDigit);
    const std::string_view number = kTelling[below(13)];
    bytes.replace(from, to, number.begin(), number.end());
}

void Mutation::change(std::string& bytes, const std::vector<std::string>& corpus)
{
    const std::size_t place = below(bytes.size() + 1);
    switch (below(8)) {
    case 0:
        if (place < bytes.size())
            bytes[place] = static_cast<char>(static_cast<unsigned char>(bytes[place]) ^ (1U << below(8)));
        break;
    case 1:
        if (place < bytes.size())
            bytes[place] = static_cast<char>(below(256));
        break;
    case 2: bytes.insert(place, kTelling[below(std::size(kTelling))]); break;
    case 3: bytes.erase(place, 1 + below(32)); break;
    case 4: bytes.insert(place, piece(bytes, 64)); break;
    case 5: changeNumber(bytes); break;
    case 6: {
        const std::string other = piece(corpus[below(corpus.size())], 256);
        bytes.replace(place, below(64), other);
        break;
    }
    default:
        if (below(8) == 0) // most of a file that is cut short is never read
            bytes.resize(place);
        break;
    }
}

std::string Mutation::of(const std::vector<std::string>& corpus, std::size_t which)
{
    std::string bytes = corpus[which];
    for (std::size_t changes = 1 + below(6); changes > 0; --changes)
        change(bytes, corpus);
    return bytes;
}

} // namespace lubberline::test
