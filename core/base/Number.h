#pragma once
/// Numbers in files: read and written without regard to the machine's locale.

#include <string>
#include <string_view>

namespace lubberline {

enum class NumberFault { None, NotANumber, OutOfRange };

struct FileNumber {
    double value = 0; ///< finite when there is no fault
    NumberFault fault = NumberFault::None;
};

/// Reads all of `text`: sign (also U+2212), digits, one decimal point (or comma where `decimalComma`), exponent.
/// "nan", "inf" and hexadecimal are not numbers; what no double can hold (1e400, 1e-400) is OutOfRange.
[[nodiscard]] FileNumber readNumber(std::string_view text, bool decimalComma = false);

/// The shortest digits that read back to the same double. @param value finite.
[[nodiscard]] std::string shortestNumber(double value);

} // namespace lubberline
