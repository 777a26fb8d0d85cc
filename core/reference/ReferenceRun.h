#pragma once
/// A scenario run: error of the vertical, error of the heading, and the share of each source. A share is the run with all sources less the
/// run without it (without slaving: the gyro runs free); what the shares do not add up to is "together".

#include <array>
#include <optional>
#include <vector>

#include "core/base/Progress.h"
#include "core/reference/LongSeries.h"
#include "core/reference/Motion.h"
#include "core/reference/VerticalRun.h"

namespace lubberline {

enum class ErrorSource { Tilt, OwnDeviation, Slaving, Drift, Gimbal, Card, Together };
inline constexpr std::array kErrorSources{ErrorSource::Tilt, ErrorSource::OwnDeviation, ErrorSource::Slaving, ErrorSource::Drift,
    ErrorSource::Gimbal, ErrorSource::Card, ErrorSource::Together};

struct ErrorShare {
    ErrorSource source = ErrorSource::Together;
    LongSeries<double> error_rad;
};

struct ReferenceRun {
    LongSeries<double> time_s;
    LongSeries<double> heading_rad;      ///< magnetic, [0, 2π)
    LongSeries<AxisTilt> tilt;           ///< of the vertical; without a vertical gyro that of the apparent vertical
    LongSeries<double> headingError_rad; ///< read − magnetic
    std::vector<ErrorShare> shares;      ///< of the sources that the scenario has, and together
    std::optional<double> standoff_rad;  ///< of the vertical gyro
    std::optional<double> slavingStandoff_rad;
    std::vector<Message> warnings;
};

/// Errors: those of checkScenario(); Cancelled.
Result<ReferenceRun> runScenario(const Scenario& scenario, const Progress& progress = {});

} // namespace lubberline
