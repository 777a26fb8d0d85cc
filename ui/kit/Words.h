#pragma once
/// What pages call a swing, and core's text as Qt's.

#include <QString>

#include <optional>
#include <string>

#include "core/base/Result.h"
#include "core/record/Fleet.h"
#include "ui/text/ChoiceWords.h"
#include "ui/text/NumberText.h"

namespace lubberline::ui {

[[nodiscard]] inline QString toText(const std::string& text) { return QString::fromStdString(text); }
[[nodiscard]] inline QString toText(Date day) { return toText(day.text()); } ///< ISO 8601
[[nodiscard]] inline QString toText(const Message& message) { return translated(message); }

/// "Su-22 · 3713 · standby compass · 2026-11-20 check swing, as found".
[[nodiscard]] QString titleOf(const SwingRecord& record);
/// "12.5", or empty; never NaN.
[[nodiscard]] QString numberText(std::optional<double> value);

} // namespace lubberline::ui
