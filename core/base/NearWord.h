#pragma once
/// Which word was meant by a misspelt one.

#include <span>
#include <string_view>

namespace lubberline {

/// Letters to leave out, put in, change or swap with their neighbour to make one word of the other; case does not matter.
[[nodiscard]] std::size_t editDistance(std::string_view a, std::string_view b);

/// The nearest of `known` within two such edits (fewer than it has letters), the first of equals; empty: none is near.
[[nodiscard]] std::string_view nearWord(std::string_view word, std::span<const std::string_view> known);

} // namespace lubberline
