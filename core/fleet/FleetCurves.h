#pragma once
/// The curves of all swings of a selection, with what one of their readings is worth, and which swings follow which.

#include <vector>

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/fleet/FleetSwings.h"
#include "core/fleet/SwingCurve.h"

namespace lubberline {

struct FleetCurves {
    std::vector<SwingCurve> curves;   ///< one a swing
    std::vector<std::int32_t> kindOf; ///< of each compass: those of one type and compass name are one kind
    std::int32_t kinds = 0;
    std::vector<double> sigma_deg; ///< of each compass: standard deviation of one deviation about its curve, pooled over its kind; never
                                   ///< less than what its divisions allow

    /// Variance of one coefficient of a swing by the scatter of its readings [deg²].
    [[nodiscard]] double variance_deg2(const FleetSwing& swing, std::size_t row, std::size_t c) const
    {
        const double sigma = sigma_deg[static_cast<std::size_t>(swing.compass)];
        return sigma * sigma * curves[row].inverse[c][c];
    }
};

/// The columns must be in order. Errors: Cancelled.
Result<FleetCurves> curvesOf(const FleetSwings& fleet, const Progress& progress = {});

/// The swings of one compass in the order of days, of the radio state that most of them have: coefficients with the radio on and off
/// are not compared.
struct CompassHistory {
    std::int32_t compass = 0;
    std::vector<std::uint32_t> rows; ///< of FleetSwings::swings
    std::vector<bool> corrected;     ///< the compass was adjusted between the one before and this one: found, then left
    std::uint32_t otherRadio = 0;    ///< swings that are not in it
};
[[nodiscard]] std::vector<CompassHistory> historiesOf(const FleetSwings& fleet);
/// Places of the histories of each kind.
[[nodiscard]] std::vector<std::vector<std::size_t>> historiesByKind(const FleetCurves& curves, std::span<const CompassHistory> histories);

} // namespace lubberline
