#pragma once

#include <limits>

#include "core/base/Message.h"

namespace lubberline {

/// Both ends belong to it.
struct NumberRange {
    double least = std::numeric_limits<double>::lowest();
    double most = std::numeric_limits<double>::max();
    [[nodiscard]] bool has(double number) const { return number >= least && number <= most; } ///< what is no number is in none
};

/// "a number from −90 to 90", for what was expected.
[[nodiscard]] Message inWords(const NumberRange& range);

} // namespace lubberline
