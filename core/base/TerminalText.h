#pragma once

#include <string>
#include <string_view>

namespace lubberline {

/// For a terminal, which acts on control characters and turns text about on marks of direction: each of them, a byte that is no UTF-8
/// too, stands there as an escape, \u001B (what JSON means by it, too). Line ends and tabs stay.
[[nodiscard]] std::string forTerminal(std::string_view text);
/// The same of a name, a note or a message: line ends and tabs are escaped, too.
[[nodiscard]] std::string inOneLine(std::string_view text);

} // namespace lubberline
