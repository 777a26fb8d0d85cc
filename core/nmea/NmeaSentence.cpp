#include "core/nmea/NmeaSentence.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace lubberline {

namespace {

int hexDigit(char c)
{
    if (c >= '0' && c <= '9')
        return c - '0';
    if (c >= 'A' && c <= 'F')
        return c - 'A' + 10;
    if (c >= 'a' && c <= 'f')
        return c - 'a' + 10;
    return -1;
}

std::vector<std::string> split(std::string_view body)
{
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= body.size();) {
        const std::size_t end = std::min(body.find(',', begin), body.size());
        std::string_view part = body.substr(begin, end - begin);
        while (!part.empty() && part.front() == ' ')
            part.remove_prefix(1);
        while (!part.empty() && part.back() == ' ')
            part.remove_suffix(1);
        parts.emplace_back(part);
        begin = end + 1;
    }
    return parts;
}

bool ofAddress(char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); }

/// The address that begins at `at`: "HCHDG" is talker HC and type HDG; "PGRME" is proprietary. Empty: none stands there.
std::string_view addressAt(std::string_view line, std::size_t at)
{
    std::size_t end = at;
    while (end < line.size() && ofAddress(line[end]))
        ++end;
    const std::size_t length = end - at;
    const bool proprietary = length > 0 && line[at] == 'P';
    const bool wellFormed = end < line.size() && line[end] == ',' && (proprietary ? length >= 3 && length <= 8 : length == 5);
    return wellFormed ? line.substr(at, length) : std::string_view();
}

/// Where the next sentence begins, at its `$` or `!`: one of binary data has no address behind it.
std::size_t nextBegin(std::string_view line, std::size_t from)
{
    for (std::size_t at = from; (at = line.find_first_of("$!", at)) != std::string_view::npos; ++at)
        if (!addressAt(line, at + 1).empty())
            return at;
    return std::string_view::npos;
}

/// What can stand behind a sentence that has no checksum.
bool wraps(char c) { return std::string_view("\"'`]});><\\\t").find(c) != std::string_view::npos; }

NmeaSentence sentenceOf(std::string_view body, bool hasChecksum)
{
    const std::string_view address = body.substr(0, body.find(','));
    const std::size_t talker = address.front() == 'P' ? 1 : 2;
    return {
        std::string(address.substr(0, talker)), std::string(address.substr(talker)), split(body.substr(address.size() + 1)), hasChecksum};
}

/// Behind a `*`: two digits and then no letter or digit.
ParsedNmea checked(std::string_view body, std::string_view behind)
{
    const auto ends = [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); };
    const bool digits
        = behind.size() >= 2 && hexDigit(behind[0]) >= 0 && hexDigit(behind[1]) >= 0 && (behind.size() == 2 || ends(behind[2]));
    if (!digits || hexDigit(behind[0]) * 16 + hexDigit(behind[1]) != nmeaChecksum(body))
        return {NmeaFault::BadChecksum, {}};
    return {NmeaFault::None, sentenceOf(body, true)};
}

/// The sentence whose address is the first of `text`, which ends where the next sentence or the line does.
ParsedNmea sentenceIn(std::string_view text, bool lineEnds)
{
    const std::size_t end = std::min(
        static_cast<std::size_t>(
            std::find_if(text.begin(), text.end(), [](char c) { return c == '*' || c < 0x20 || c == 0x7f || wraps(c); }) - text.begin()),
        text.size());
    const std::string_view body = text.substr(0, end);
    if (end < text.size() && text[end] == '*')
        return checked(body, text.substr(end + 1));
    const bool whole = end < text.size() ? wraps(text[end]) : lineEnds;
    return whole ? ParsedNmea{NmeaFault::None, sentenceOf(body, false)} : ParsedNmea{};
}

} // namespace

unsigned char nmeaChecksum(std::string_view betweenDollarAndStar)
{
    unsigned char sum = 0;
    for (const char c : betweenDollarAndStar)
        sum ^= static_cast<unsigned char>(c);
    return sum;
}

std::string makeNmea(std::string_view body)
{
    static constexpr std::array kDigits{'0', '1', '2', '3', '4', '5', '6', '7', '8', '9', 'A', 'B', 'C', 'D', 'E', 'F'};
    const unsigned char sum = nmeaChecksum(body);
    std::string sentence(1, '$');
    sentence.append(body).append({'*', kDigits[sum >> 4], kDigits[sum & 15]});
    return sentence;
}

std::vector<ParsedNmea> nmeaSentences(std::string_view line)
{
    while (!line.empty() && (line.back() == '\r' || line.back() == '\n' || line.back() == ' ' || line.back() == '\t'))
        line.remove_suffix(1);
    std::vector<ParsedNmea> found;
    for (std::size_t begin = nextBegin(line, 0); begin != std::string_view::npos;) {
        const std::size_t next = nextBegin(line, begin + 1);
        const std::size_t end = std::min(next, line.size());
        found.push_back(sentenceIn(line.substr(begin + 1, end - begin - 1), end == line.size()));
        begin = next;
    }
    if (found.empty() && !line.empty())
        found.push_back({});
    return found;
}

} // namespace lubberline
