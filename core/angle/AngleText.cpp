#include "core/angle/AngleText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/base/Number.h"

namespace lubberline {

namespace {

enum class Sign { None, Plus, Minus };

/// An angle as it was typed: sign, figures, letter.
struct TypedAngle {
    Sign sign = Sign::None;
    double magnitude_deg = 0;
    char letter = 0; ///< 'E', 'W' or none
};

/// Walks over the text; every take… moves on only when it finds what it looks for.
class Scanner {
public:
    explicit Scanner(std::string_view text) : m_rest(text) {}

    [[nodiscard]] bool atEnd() const { return m_rest.empty(); }
    bool skipSpaces()
    {
        const auto before = m_rest.size();
        while (take(" ") || take("\t") || take("\u00A0")) {}
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
        for (const auto sign : signs)
            if (take(sign))
                return true;
        return false;
    }
    bool takeMinusSign() { return takeMinus(m_rest); }
    /// Digits with at most one decimal point or comma; no exponent: nobody types one, and E is east.
    std::optional<double> takeNumber()
    {
        std::string figures;
        std::size_t length = 0, marks = 0;
        for (; length < m_rest.size(); ++length) {
            const char c = m_rest[length];
            const bool mark = c == '.' || c == ',';
            if (!mark && (c < '0' || c > '9'))
                break;
            marks += mark;
            figures += mark ? '.' : c;
        }
        const FileNumber number = readNumber(figures);
        if (marks > 1 || number.fault != NumberFault::None)
            return {};
        m_wholeNumber = marks == 0;
        m_rest.remove_prefix(length);
        return number.value;
    }
    [[nodiscard]] bool lastNumberWasWhole() const { return m_wholeNumber; }

private:
    std::string_view m_rest;
    bool m_wholeNumber = false;
};

constexpr std::array<std::string_view, 2> kDegreeSigns{"\u00B0", "\u00BA"};
constexpr std::array<std::string_view, 3> kMinuteSigns{"'", "\u2032", "\u2019"};

Sign takeSign(Scanner& scanner)
{
    if (scanner.takeMinusSign())
        return Sign::Minus;
    return scanner.take("+") ? Sign::Plus : Sign::None;
}

char takeLetter(Scanner& scanner)
{
    if (scanner.take("E") || scanner.take("e"))
        return 'E';
    return scanner.take("W") || scanner.take("w") ? 'W' : '\0';
}

/// What parts degrees from minutes: a degree sign, a colon or a space.
bool takeDivider(Scanner& scanner)
{
    const bool space = scanner.skipSpaces();
    const bool divided = scanner.takeAny(kDegreeSigns) || scanner.take(":") || space;
    scanner.skipSpaces();
    return divided;
}

/// [sign] degrees [divider minutes [']] [letter]
std::optional<TypedAngle> scanAngle(std::string_view text)
{
    Scanner scanner(text);
    TypedAngle angle;
    scanner.skipSpaces();
    angle.sign = takeSign(scanner);
    scanner.skipSpaces();
    const auto degrees = scanner.takeNumber();
    if (!degrees)
        return {};
    angle.magnitude_deg = *degrees;
    const bool wholeDegrees = scanner.lastNumberWasWhole();
    const bool divided = takeDivider(scanner);
    if (const auto minutes = divided ? scanner.takeNumber() : std::nullopt) {
        if (!wholeDegrees || *minutes >= 60.0)
            return {};
        angle.magnitude_deg += *minutes / 60.0;
        scanner.takeAny(kMinuteSigns);
        scanner.skipSpaces();
    }
    angle.letter = takeLetter(scanner);
    scanner.skipSpaces();
    return scanner.atEnd() ? std::optional(angle) : std::nullopt;
}

Error notAnAngle(std::string_view text, Pattern what, Pattern expected)
{
    return {ErrorCode::InvalidInput, {MARKED("core", "\"%1\" is %2; expected %3"), text, what, expected}};
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
    constexpr Pattern kExpected = MARKED("core", "degrees such as 3.25, -3.25, 3.25W or 3\u00B015'W, between -180 and 180");
    const auto angle = scanAngle(text);
    if (!angle)
        return notAnAngle(text, MARKED("core", "not an angle"), kExpected);
    if (angle->letter && angle->sign != Sign::None)
        return notAnAngle(text, MARKED("core", "signed twice"), MARKED("core", "a sign or E or W, not both"));
    if (angle->magnitude_deg > 180.0)
        return notAnAngle(text, MARKED("core", "too large"), kExpected);
    const bool negative = angle->sign == Sign::Minus || angle->letter == 'W';
    return negative ? 0.0 - angle->magnitude_deg : angle->magnitude_deg;
}

Result<double> parseHeading_deg(std::string_view text)
{
    constexpr Pattern kExpected = MARKED("core", "degrees from 0 to 360, such as 47.5 or 47\u00B030'");
    const auto angle = scanAngle(text);
    if (!angle)
        return notAnAngle(text, MARKED("core", "not a heading"), kExpected);
    if (angle->letter)
        return notAnAngle(text, MARKED("core", "not a heading: it has an E or a W"), kExpected);
    if (angle->magnitude_deg > 360.0 || (angle->sign == Sign::Minus && angle->magnitude_deg > 0.0))
        return notAnAngle(text, MARKED("core", "not a heading"), kExpected);
    return wrap360(angle->magnitude_deg);
}

std::string formatHeading(double heading_deg, AngleStyle style, int decimals)
{
    const double wrapped_deg = wrap360(heading_deg);
    if (style == AngleStyle::DegreesMinutes)
        return degreesMinutes(std::llround(wrapped_deg * 60.0) % (360 * 60), 3);
    const std::string figures = figureText(wrapped_deg, decimals);
    return padded(figures.starts_with("360") ? figureText(0.0, decimals) : figures, 3) + "\u00B0";
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
