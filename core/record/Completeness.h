#pragma once

#include "core/base/Message.h"
#include "core/record/Swing.h"

namespace lubberline {

/// What keeps a swing from being completed: no date, or one that is still to come; half a reading; fewer than four that count;
/// one person as adjuster and inspector. Empty: nothing. @param today ISO 8601, of the clock that the caller was given (core/base/Clock.h).
[[nodiscard]] Message missingIn(const Swing& swing, Date today);

} // namespace lubberline
