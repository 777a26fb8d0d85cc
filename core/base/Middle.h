#pragma once
/// The middle of figures.

#include <algorithm>
#include <cstddef>
#include <vector>

namespace lubberline {

/// The middle value, the upper one of two: never between figures that were there. Expects at least one.
[[nodiscard]] inline double middleOf(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace lubberline
