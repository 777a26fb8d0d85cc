#pragma once
/// The document of a line of sight: what makes it wrong, cause by cause, and how that changes with where one looks.

#include "core/calibration/LineOfSight.h"
#include "ui/report/forms/ReferenceSheet.h"

namespace lubberline::ui {

[[nodiscard]] Table sightTable(const SightBudget& budget);
/// The whole error of a line of sight, in a sentence.
[[nodiscard]] QString sightWords(const SightBudget& budget);
[[nodiscard]] ReferenceSheet sightSheet(const SightCase& given, const SightBudget& budget);

} // namespace lubberline::ui
