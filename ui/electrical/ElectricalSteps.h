#pragma once

#include <QStringList>

#include "core/record/ElectricalSwing.h"

namespace lubberline::ui {

/// What to turn, from table F1: "at 180: half of +0.6° with N–S: 180.6 → 180.3" …; empty where nothing is told yet.
[[nodiscard]] QStringList electricalSteps(const FourPointTable& table);

} // namespace lubberline::ui
