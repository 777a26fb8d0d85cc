#pragma once
/// What a revision of a swing changes, field by field and reading by reading: for those who sign it.

#include <string>
#include <vector>

#include "core/base/Message.h"
#include "core/record/Swing.h"

namespace lubberline {

struct SwingDifference {
    Message what;   ///< "date", "reading 3, compass"
    Message before; ///< empty: it was not stated
    Message after;  ///< empty: it is not stated any more
    friend bool operator==(const SwingDifference&, const SwingDifference&) = default;
};

/// Particulars first, then the readings by their place in the table. Identity, state, signatures and revision are not compared;
/// nor is the site's name: only whether it is another.
[[nodiscard]] std::vector<SwingDifference> differencesBetween(const Swing& before, const Swing& after);

} // namespace lubberline
