#pragma once

#include <QString>

#include "core/record/Fleet.h"

namespace lubberline::ui {

/// "3713 standby compass 2026-11-20": a file name without ending or characters that file systems dislike.
[[nodiscard]] QString fileStem(const SwingRecord& record);

} // namespace lubberline::ui
