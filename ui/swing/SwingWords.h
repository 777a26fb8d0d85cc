#pragma once
/// A swing's results in sentences, for people who want to know what they mean.

#include <QString>

#include "core/angle/AngleText.h"
#include "core/record/Fleet.h"
#include "core/swing/Analysis.h"

namespace lubberline::ui {

/// "Largest deviation +3.4° at 047°. Within 10° (14 CFR 25.1327)."
[[nodiscard]] QString meaningOf(const Analysis& analysis, const std::optional<LimitsProfile>& limits, AngleStyle style);

/// Why coefficients are missing, and what the headings cannot tell; empty when nothing is missing.
[[nodiscard]] QString limitationsOf(const Analysis& analysis);

} // namespace lubberline::ui
