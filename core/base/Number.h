#pragma once
/// Numbers as text: the one reader of what stands in files and of what people type, and the figures that people read. Without
/// regard to the machine's locale.

#include <string>
#include <string_view>

namespace lubberline {

enum class NumberFault { None, NotANumber, OutOfRange };

struct FileNumber {
    double value = 0; ///< finite when there is no fault
    NumberFault fault = NumberFault::None;
};

/// Reads all of `text`: sign, digits, one decimal point (or comma where `decimalComma`: where no comma can be a separator),
/// exponent. Minus is the hyphen, U+2212, the en dash U+2013, the figure dash U+2012, or the hyphens U+2010 and U+2011. The thousands may be parted by
/// no-break spaces U+00A0 and U+202F or the thin space U+2009, one kind and every three digits; anywhere else they are an error.
/// "nan", "inf" and hexadecimal are not numbers; what no double can hold (1e400, 1e-400) is OutOfRange.
[[nodiscard]] FileNumber readNumber(std::string_view text, bool decimalComma = false);

/// Takes one of the minus signs above off the beginning of `text`; false where there is none.
bool takeMinus(std::string_view& text);

/// "−2.0", "3.5": for people, with U+2212; what rounds to zero has no sign. @param value finite. @param decimals 0 … 12.
[[nodiscard]] std::string figureText(double value, int decimals);
/// "−2.0", "+3.5", "0.0".
[[nodiscard]] std::string signedFigureText(double value, int decimals);

/// The shortest digits that read back to the same double. @param value finite.
[[nodiscard]] std::string shortestNumber(double value);

} // namespace lubberline
