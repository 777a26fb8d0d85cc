#pragma once
/// The words on screen for values of core, and core's text as Qt's.

#include <QString>
#include <QStringList>

#include <optional>
#include <string>

#include "core/base/Result.h"
#include "core/record/Fleet.h"
#include "ui/text/NumberText.h"
#include "ui/text/Translated.h"

namespace lubberline::ui {

[[nodiscard]] inline QString toText(const std::string& text) { return QString::fromStdString(text); }
[[nodiscard]] inline QString toText(const Message& message) { return translated(message); }

[[nodiscard]] QString wordFor(SwingKind kind);
[[nodiscard]] QString wordFor(SwingStage stage);
[[nodiscard]] QString wordFor(SwingState state);

/// In the order of the enumerations: for combo boxes.
[[nodiscard]] QStringList swingKindWords();
[[nodiscard]] QStringList swingStageWords();
[[nodiscard]] QStringList radioStateWords();
[[nodiscard]] QStringList compassKindWords();
[[nodiscard]] QStringList compensatorWords();

/// "Su-22 · 3713 · standby compass · 2026-11-20 check swing, as found".
[[nodiscard]] QString titleOf(const SwingRecord& record);
/// "12.5", or empty; never NaN.
[[nodiscard]] QString numberText(std::optional<double> value);

} // namespace lubberline::ui
