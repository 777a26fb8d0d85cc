#pragma once

#include <string>

#include "core/record/Swing.h"

namespace lubberline {

/// What keeps a swing from being completed, in words: no date; half a reading; fewer than four that count. Empty: nothing.
[[nodiscard]] std::string missingIn(const Swing& swing);

} // namespace lubberline
