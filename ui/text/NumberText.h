#pragma once
/// Numbers that people type and read.

#include <QString>

#include <optional>

namespace lubberline::ui {

/// What was typed, by core's one reader: decimal point or comma, every minus, spaces around it; none where it is no number.
[[nodiscard]] std::optional<double> typedNumber(const QString& text);
/// core's figureText(): "1.25" or "−1.25" (U+2212); what rounds to zero has no sign. What is not finite is a dash.
[[nodiscard]] QString plainNumber(double value, int decimals);
/// core's signedFigureText(): "+1.25" or "−1.25"; the same for zero.
[[nodiscard]] QString signedNumber(double value, int decimals);

} // namespace lubberline::ui
