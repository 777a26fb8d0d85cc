#pragma once
/// The headings that a crew turns to, laid out before they are read.

#include <array>
#include <vector>

#include "ui/swing/ReadingEdits.h"

namespace lubberline::ui {

inline constexpr std::array kLayoutPoints{4, 8, 12, 16, 24, 32};

/// One row for each of `points` equally spaced nominal headings from north that no row has yet, placed so that nominals ascend.
/// Their magnetic headings stay empty: nobody has read them.
[[nodiscard]] std::vector<PlacedReading> nominalRows(const std::vector<Reading>& readings, int points);

} // namespace lubberline::ui
