#pragma once
/// The quick way through long files of figures.

#include <string_view>

namespace lubberline {

/// A figure as programs write it, all of `text`. False: readNumber() (core/base/Number.h) has to say what it is.
/// Short decimals are an integer below 2⁵³ over a power of ten below 10²³, which is rounded once, as from_chars would [Clinger 1990].
[[nodiscard]] bool takePlainNumber(std::string_view text, double& value);

} // namespace lubberline
