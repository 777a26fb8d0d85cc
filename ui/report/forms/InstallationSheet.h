#pragma once
/// Where a sensor may stand, as documents: the distances that its maker asks, a source of stray field, a site turned on both ways.

#include <optional>
#include <vector>

#include "core/calibration/DipoleSource.h"
#include "core/deviation/TurnedBothWays.h"
#include "ui/report/forms/ReferenceSheet.h"

namespace lubberline::ui {

/// "kept", "too near by 0.40 m", "not looked at".
[[nodiscard]] QString distanceVerdict(const InstallationDistance& asked, std::optional<double> measured_m);
/// @param measured_m in the order of installationDistances(); none: not looked at
[[nodiscard]] QString distancesWords(const std::vector<std::optional<double>>& measured_m);
[[nodiscard]] ReferenceSheet distancesSheet(const std::vector<std::optional<double>>& measured_m);

/// @param source name of the readings' file
[[nodiscard]] ReferenceSheet dipoleSheet(const DipoleSource& found, std::size_t readings, const QString& source);
/// @param sources names of both runs' files
[[nodiscard]] ReferenceSheet siteCheckSheet(const BothWays& both, const QString& sources);

} // namespace lubberline::ui
