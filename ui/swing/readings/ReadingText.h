#pragma once
/// The cells of the table of readings: what they say, and what typing into them does to a reading.

#include <QString>

#include <optional>
#include <vector>

#include "core/angle/AngleText.h"
#include "core/base/Result.h"
#include "core/record/Swing.h"

namespace lubberline::ui {

enum class ReadingColumn { Nominal, Magnetic, Compass, Deviation, Residual, State, Note };
inline constexpr int kReadingColumns = 7;

/// The heading or deviation of a cell, as it is held; none where there is none.
[[nodiscard]] std::optional<double> cellValue_deg(const Reading& reading, ReadingColumn column);
/// Headings and deviation as displayed; empty for what is not entered. Residual and State come from results, not from here.
[[nodiscard]] QString cellText(const Reading& reading, ReadingColumn column, AngleStyle style, int decimals);
/// As it is put into an editor: nothing that was typed is rounded away in the decimal style.
[[nodiscard]] QString editText(const Reading& reading, ReadingColumn column, AngleStyle style);

/// Applies what was typed into a cell: angles in every form of AngleText, empty to clear, "=" in Magnetic to accept the nominal
/// heading. A typed deviation sets the compass heading: compass = magnetic − deviation. A typed magnetic heading takes the
/// place of one computed from a true heading; "274T" is a true one (an air swing, a GPS), and magnetic = true − variation.
/// @param variation_deg of the swing, east positive; none: a true heading is refused.
/// Errors: InvalidInput, one sentence that says what is wrong and what was expected.
Result<void> applyTyped(Reading& reading, ReadingColumn column, const QString& text, std::optional<double> variation_deg = {});

/// What an edit of the column is called in Undo and Redo.
[[nodiscard]] QString editName(ReadingColumn column);

/// The decimals (1 or 2) with which every heading of the swing is shown as it was typed.
[[nodiscard]] int decimalsFor(const std::vector<Reading>& readings);

} // namespace lubberline::ui
