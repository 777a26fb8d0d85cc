#include "core/angle/AngleText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/angle/PrintedHeading.h"
#include "core/base/FileText.h"
#include "core/base/Number.h"

namespace lubberline {

namespace {

enum class Sign { None, Plus, Minus };

/// An angle as it was typed: sign, figures, letters.
struct TypedAngle {
    Sign sign = Sign::None;
    double magnitude_deg = 0;
    char before = 0, after = 0; ///< N, S, E, W (after: T, M, C, O too), or none
};

/// Walks over the text; every take… moves on only when it finds what it looks for.
class Scanner {
public:
    explicit Scanner(std::string_view text) : m_rest(text) {}

    [[nodiscard]] bool atEnd() const { return m_rest.empty(); }
    bool skipSpaces()
    {
        const auto before = m_rest.size();
        while (const std::size_t space = spaceAt(m_rest))
            m_rest.remove_prefix(space);
        return m_rest.size() != before;
    }
    bool take(std::string_view what)
    {
        if (!m_rest.starts_with(what))
            return false;
        m_rest.remove_prefix(what.size());
        return true;
    }
    template <std::size_t N>
    bool takeAny(const std::array<std::string_view, N>& signs)
    {
        return std::any_of(signs.begin(), signs.end(), [this](std::string_view sign) { return take(sign); });
    }
    bool takeMinusSign() { return takeMinus(m_rest); }
    /// Digits with at most one decimal point or comma. An exponent has a sign, as spreadsheets write it (3.58E+02): E is east.
    std::optional<double> takeNumber()
    {
        std::string figures;
        std::size_t length = 0, marks = 0;
        const auto takeDigits = [&] {
            const auto before = figures.size();
            for (; length < m_rest.size() && isDigit(m_rest[length]); ++length)
                figures += m_rest[length];
            return figures.size() != before;
        };
        takeDigits();
        m_twoDigits = figures.size() >= 2;
        for (; length < m_rest.size() && (m_rest[length] == '.' || m_rest[length] == ','); ++marks) {
            figures += '.';
            ++length;
            takeDigits();
        }
        if (const auto rest = m_rest.substr(length);
            rest.size() > 2 && (rest[0] == 'E' || rest[0] == 'e') && (rest[1] == '+' || rest[1] == '-') && isDigit(rest[2])) {
            figures.append(rest.substr(0, 2));
            length += 2;
            takeDigits();
            ++marks; // not a whole number of degrees with minutes to follow
        }
        const FileNumber number = readNumber(figures);
        if (number.fault != NumberFault::None)
            return {};
        m_wholeNumber = marks == 0;
        m_rest.remove_prefix(length);
        return number.value;
    }
    [[nodiscard]] bool lastNumberWasWhole() const { return m_wholeNumber; }
    [[nodiscard]] bool lastNumberBeganWithTwoDigits() const { return m_twoDigits; }
    /// Letters of ASCII, as capitals.
    std::string takeLetters()
    {
        std::string letters;
        for (; !m_rest.empty() && isLetter(m_rest.front()); m_rest.remove_prefix(1))
            letters += static_cast<char>(m_rest.front() & ~0x20);
        return letters;
    }

private:
    static bool isDigit(char c) { return c >= '0' && c <= '9'; }
    static bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

    std::string_view m_rest;
    bool m_wholeNumber = false, m_twoDigits = false;
};

/// Degree sign, ordinal indicator, ring above, ring operator: keyboards have one or the other.
constexpr std::array<std::string_view, 4> kDegreeSigns{"\u00B0", "\u00BA", "\u02DA", "\u2218"};
constexpr std::array<std::string_view, 3> kSecondSigns{"\"", "\u2033", "\u201D"};
constexpr std::array<std::string_view, 2> kTwoMinuteSigns{"''", "\u2032\u2032"}; ///< seconds, too
constexpr std::array<std::string_view, 6> kMinuteSigns{"'", "\u2032", "\u2019", "\u2018", "\u00B4", "`"};

Sign takeSign(Scanner& scanner)
{
    if (scanner.takeMinusSign())
        return Sign::Minus;
    return scanner.take("+") ? Sign::Plus : Sign::None;
}

/// One of the letters, or a whole word of the four winds; none: no letter, or another word.
std::optional<char> letterIn(const std::string& word, std::string_view letters)
{
    static constexpr std::array<std::string_view, 4> kWords{"EAST", "WEST", "NORTH", "SOUTH"};
    const bool known = word.size() == 1 || std::find(kWords.begin(), kWords.end(), word) != kWords.end();
    if (!known || letters.find(word.front()) == std::string_view::npos)
        return {};
    return word.front();
}

/// What parts degrees from minutes, or minutes from seconds: a sign, a colon or a space.
struct Divider {
    bool divides = false;
    bool marked = false; ///< not by a space alone
};
template <std::size_t N>
Divider takeDivider(Scanner& scanner, const std::array<std::string_view, N>& signs)
{
    Divider divider;
    divider.divides = scanner.skipSpaces();
    divider.marked = scanner.takeAny(signs) || scanner.take(":");
    divider.divides |= divider.marked;
    scanner.skipSpaces();
    return divider;
}

/// The seconds that may follow minutes; false when there is something wrong with them.
bool takeSeconds(Scanner& scanner, double& magnitude_deg)
{
    const bool wholeMinutes = scanner.lastNumberWasWhole();
    scanner.skipSpaces();
    if (scanner.takeAny(kSecondSigns) || scanner.takeAny(kTwoMinuteSigns))
        return false; // 3°15": the minutes are missing
    if (!takeDivider(scanner, kMinuteSigns).marked)
        return true;
    const auto seconds = scanner.takeNumber();
    if (!seconds)
        return true;
    if (!wholeMinutes || *seconds >= 60.0)
        return false;
    magnitude_deg += *seconds / 3600.0;
    scanner.skipSpaces();
    if (!scanner.takeAny(kSecondSigns))
        scanner.takeAny(kTwoMinuteSigns);
    scanner.skipSpaces();
    return true;
}

/// [letter] [sign] degrees [divider minutes [divider seconds]] [letter]
/// @param before, after  the letters that may stand there, with those that are known to be wrong and are told.
std::optional<TypedAngle> scanAngle(std::string_view text, std::string_view before, std::string_view after)
{
    Scanner scanner(text);
    TypedAngle angle;
    scanner.skipSpaces();
    if (const auto word = scanner.takeLetters(); !word.empty()) {
        const auto letter = letterIn(word, before);
        if (!letter)
            return {};
        angle.before = *letter;
        scanner.skipSpaces();
    }
    angle.sign = takeSign(scanner);
    scanner.skipSpaces();
    const auto degrees = scanner.takeNumber();
    if (!degrees)
        return {};
    angle.magnitude_deg = *degrees;
    const bool wholeDegrees = scanner.lastNumberWasWhole();
    const Divider divider = takeDivider(scanner, kDegreeSigns);
    if (const auto minutes = divider.divides ? scanner.takeNumber() : std::nullopt) {
        if (!wholeDegrees || *minutes >= 60.0)
            return {};
        // "8 4" may be 84, 8.4 or 8°04': minutes that only a space parts from the degrees have their two digits.
        if (!divider.marked && !scanner.lastNumberBeganWithTwoDigits())
            return {};
        angle.magnitude_deg += *minutes / 60.0;
        if (!takeSeconds(scanner, angle.magnitude_deg))
            return {};
    }
    if (const auto word = scanner.takeLetters(); !word.empty()) {
        const auto letter = letterIn(word == "OST" || word == "OUEST" ? "O" : word, after);
        if (!letter)
            return {};
        angle.after = *letter;
    }
    scanner.skipSpaces();
    return scanner.atEnd() ? std::optional(angle) : std::nullopt;
}

/// "NE", "NEbN", "NE by N" and "NE/N" as eighths of a right angle from north.
std::optional<double> pointOfCompass(std::string_view text)
{
    static constexpr std::array<std::string_view, 32> kPoints{"N", "NBE", "NNE", "NEBN", "NE", "NEBE", "ENE", "EBN", "E", "EBS", "ESE",
        "SEBE", "SE", "SEBS", "SSE", "SBE", "S", "SBW", "SSW", "SWBS", "SW", "SWBW", "WSW", "WBS", "W", "WBN", "WNW", "NWBW", "NW", "NWBN",
        "NNW", "NBW"};
    Scanner scanner(text);
    scanner.skipSpaces();
    std::string name = scanner.takeLetters();
    if (name.empty())
        return {};
    const bool spaced = scanner.skipSpaces();
    if (spaced ? scanner.take("by") || scanner.take("BY") || scanner.take("By") : scanner.take("/")) {
        scanner.skipSpaces();
        name += "B" + scanner.takeLetters();
    }
    scanner.skipSpaces();
    const auto found = std::find(kPoints.begin(), kPoints.end(), name);
    if (found == kPoints.end() || !scanner.atEnd())
        return {};
    return 11.25 * static_cast<double>(found - kPoints.begin());
}

Error notAnAngle(std::string_view text, const Message& what, const Message& expected)
{
    return {ErrorCode::InvalidInput, {MARKED("core", "%1 is %2; expected %3"), figuresInQuotes(text), what, expected}};
}

/// An O is told before the rest: the figures may be right.
Error ambiguousO(std::string_view text)
{
    return notAnAngle(
        text, MARKED("core", "not clear: an O is east in German and west in French"), MARKED("core", "E or W, or a number with its sign"));
}

/// "NO", "OSO": a point in German (Ost) or in French (ouest).
bool isPointWithO(std::string_view text)
{
    const auto name = trimmed(text);
    return name.size() <= 3 && name.find_first_of("Oo") != std::string_view::npos
        && name.find_first_not_of("NSWOnswo") == std::string_view::npos;
}

struct Winds {
    char positive = 0, negative = 0; ///< none where neither has a letter
    [[nodiscard]] std::string letters() const { return positive ? std::string{positive, negative} : std::string(); }
};

Result<double> parseAngle(std::string_view text, Winds winds, double most_deg, const Message& expected)
{
    const auto angle = scanAngle(text, winds.letters(), winds.letters() + (winds.positive == 'E' ? "O" : ""));
    if (!angle)
        return notAnAngle(text, MARKED("core", "not an angle"), expected);
    if (angle->after == 'O')
        return ambiguousO(text);
    const int signs = (angle->sign != Sign::None) + (angle->before != 0) + (angle->after != 0);
    if (signs > 1)
        return notAnAngle(text, MARKED("core", "signed twice"),
            {MARKED("core", "a sign or %1 or %2, not both"), std::string(1, winds.positive), std::string(1, winds.negative)});
    if (angle->magnitude_deg > most_deg)
        return notAnAngle(text, MARKED("core", "too large"), expected);
    const char letter = angle->before ? angle->before : angle->after;
    const bool negative = angle->sign == Sign::Minus || (letter != 0 && letter == winds.negative);
    return negative ? 0.0 - angle->magnitude_deg : angle->magnitude_deg;
}

Pattern nameOf(North north)
{
    switch (north) {
    case North::True: return MARKED("core", "a true heading");
    case North::Magnetic: return MARKED("core", "a magnetic heading");
    default: return MARKED("core", "a compass heading");
    }
}

constexpr Pattern kExpectedHeading = MARKED("core", "degrees from 0 to 360, such as 47.5 or 47°30', or a point such as NE");

/// N 45 E, S 12 30 W.
Result<WrittenHeading> headingOfBearing(std::string_view text, const TypedAngle& angle)
{
    if (angle.sign != Sign::None || angle.magnitude_deg > 90.0)
        return notAnAngle(text, MARKED("core", "not a bearing from north or south"), MARKED("core", "0 to 90 degrees, such as N 45 E"));
    const double fromMeridian_deg = angle.after == 'E' ? angle.magnitude_deg : -angle.magnitude_deg;
    return WrittenHeading{wrap360(angle.before == 'N' ? fromMeridian_deg : 180.0 - fromMeridian_deg)};
}

std::string padded(std::string figures, std::size_t wholeDigits)
{
    const auto whole = std::min(figures.find('.'), figures.size());
    return whole < wholeDigits ? std::string(wholeDigits - whole, '0') + figures : figures;
}

/// "3°15'": the minutes are rounded first, so that 59.96' carries into the degrees.
std::string degreesMinutes(long long minutes, std::size_t wholeDigits)
{
    return padded(std::to_string(minutes / 60), wholeDigits) + "\u00B0" + padded(std::to_string(minutes % 60), 2) + "'";
}

} // namespace

Result<double> parseSignedAngle_deg(std::string_view text)
{
    return parseAngle(text, {'E', 'W'}, 180.0, MARKED("core", "degrees such as 3.25, -3.25, 3.25W or 3°15'W, between -180 and 180"));
}

Result<double> parsePlainAngle_deg(std::string_view text, double most_deg)
{
    return parseAngle(text, {}, most_deg, {MARKED("core", "degrees from -%1 to %1, such as 3.25 or -3°15'"), shortestNumber(most_deg)});
}

Result<double> parseLatitude_deg(std::string_view text)
{
    return parseAngle(text, {'N', 'S'}, 90.0, MARKED("core", "degrees from -90 to 90, north positive, such as 51.55, 51°33'N or 33.9 S"));
}

Result<WrittenHeading> parseWrittenHeading(std::string_view text)
{
    if (const auto point_deg = pointOfCompass(text))
        return WrittenHeading{*point_deg};
    const auto angle = scanAngle(text, "NS", "EWTMCO");
    const bool bearing = angle && angle->before != 0;
    if (bearing && (angle->after == 'E' || angle->after == 'W'))
        return headingOfBearing(text, *angle);
    if ((angle && angle->after == 'O') || isPointWithO(text))
        return ambiguousO(text);
    if (angle && !bearing && (angle->after == 'E' || angle->after == 'W'))
        return notAnAngle(text, MARKED("core", "not a heading: it has an E or a W"), kExpectedHeading);
    if (!angle || bearing || (angle->sign == Sign::Minus && angle->magnitude_deg > 0.0))
        return notAnAngle(text, MARKED("core", "not a heading"), kExpectedHeading);
    if (angle->magnitude_deg > 360.0)
        return notAnAngle(text, MARKED("core", "out of range"), kExpectedHeading);
    WrittenHeading heading{wrap360(angle->magnitude_deg)};
    heading.fullTurn = angle->magnitude_deg == 360.0;
    if (angle->after != 0)
        heading.north = angle->after == 'T' ? North::True : angle->after == 'M' ? North::Magnetic : North::Compass;
    return heading;
}

Result<double> parseHeading_deg(std::string_view text, North meant)
{
    const auto heading = parseWrittenHeading(text);
    if (!heading)
        return heading.error();
    if (heading->north == North::NotSaid || heading->north == meant)
        return heading->heading_deg;
    return notAnAngle(text, nameOf(heading->north), meant == North::NotSaid ? Message(kExpectedHeading) : Message(nameOf(meant)));
}

std::string formatHeading(double heading_deg, AngleStyle style, int decimals)
{
    if (style == AngleStyle::DegreesMinutes)
        return degreesMinutes(std::llround(wrap360(heading_deg) * 60.0) % (360 * 60), 3);
    return padded(figureText(printedHeading_deg(heading_deg, decimals), decimals), 3) + "\u00B0";
}

std::string formatSignedAngle(double angle_deg, AngleStyle style, int decimals)
{
    if (style == AngleStyle::DegreesMinutes) {
        const auto minutes = std::llround(std::abs(angle_deg) * 60.0);
        return degreesMinutes(minutes, 1) + (minutes == 0 ? "" : angle_deg < 0 ? "W" : "E");
    }
    return signedFigureText(angle_deg, decimals) + "\u00B0";
}

} // namespace lubberline
