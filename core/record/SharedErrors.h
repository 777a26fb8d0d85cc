#pragma once
/// What all readings of a swing share: the datum's own error, the variation that made magnetic headings of true ones, the delay of a
/// log, the wind in which its tracks were made. More readings make none of it smaller, and no scatter shows it.

#include <array>
#include <string>
#include <string_view>

#include "core/base/Result.h"

namespace lubberline {

struct SharedErrors {
    std::array<double, 5> of_deg{}; ///< standard errors of A, B, C, D, E [deg]; 0: none is known
    [[nodiscard]] bool any() const;
    friend bool operator==(const SharedErrors&, const SharedErrors&) = default;
};

/// "0.6" is A's; else each behind its letter: "A 0.6 B 0.2". Nothing: none is known. Errors: InvalidInput.
[[nodiscard]] Result<SharedErrors> readSharedErrors(std::string_view text);
/// "A 0.6 B 0.2", which reads back to the same; empty where none is known.
[[nodiscard]] std::string textOf(const SharedErrors& errors);

} // namespace lubberline
