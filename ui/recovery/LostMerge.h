#pragma once
/// What was kept of a reading, held against what is stored by now: field by field, and what has been stored since wins.

#include "core/record/Swing.h"

namespace lubberline::ui {

/// Whether what was typed, `kept` where it differs from `before`, is what is stored.
[[nodiscard]] bool says(const Reading& now, const Reading& before, const Reading& kept);

struct MergedReading {
    Reading reading;      ///< as it is to be: what is stored, with the kept figures
    bool clashes = false; ///< something else has been stored since: nothing is to be changed
};

/// @param before as it was known when `kept` was to be stored. @param now as it is stored. @param ours as we stored it of an earlier one that
///   was kept; may be null.
[[nodiscard]] MergedReading mergedReading(const Reading& before, const Reading& kept, const Reading& now, const Reading* ours);

} // namespace lubberline::ui
