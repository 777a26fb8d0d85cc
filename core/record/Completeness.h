#pragma once

#include "core/base/Message.h"
#include "core/record/Swing.h"

namespace lubberline {

/// What keeps a swing from being completed: no date; half a reading; fewer than four that count. Empty: nothing.
[[nodiscard]] Message missingIn(const Swing& swing);

} // namespace lubberline
