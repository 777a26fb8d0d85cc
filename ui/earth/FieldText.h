#pragma once
/// What people type into forms, checked.

#include <QString>

#include <optional>

#include "core/base/Result.h"

namespace lubberline::ui {

/// ISO 8601, "2026-11-20"; empty where `mayBeEmpty`. Errors: InvalidInput.
Result<Date> parseDate(const QString& text, bool mayBeEmpty);
/// A signed angle in any form of AngleText, or empty. Errors: InvalidInput.
Result<std::optional<double>> parseOptionalAngle_deg(const QString& text);
/// A positive number of degrees, decimal point or comma. Errors: InvalidInput.
Result<double> parsePositive_deg(const QString& text);
/// A year from 1900 to 2200, or empty. Errors: InvalidInput.
Result<std::optional<int>> parseYear(const QString& text);

} // namespace lubberline::ui
