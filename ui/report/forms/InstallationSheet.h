#pragma once
/// The distances of a flux gate from what disturbs it, as its maker asks, as a document.

#include <optional>
#include <vector>

#include "core/calibration/DipoleSource.h"
#include "ui/report/forms/ReferenceSheet.h"

namespace lubberline::ui {

/// "kept", "too near by 0.40 m", "not looked at".
[[nodiscard]] QString distanceVerdict(const InstallationDistance& asked, std::optional<double> measured_m);
/// @param measured_m in the order of installationDistances(); none: not looked at
[[nodiscard]] QString distancesWords(const std::vector<std::optional<double>>& measured_m);
[[nodiscard]] ReferenceSheet distancesSheet(const std::vector<std::optional<double>>& measured_m);

} // namespace lubberline::ui
