#pragma once
/// What the figures of the instruments that tell the aircraft's heading mean.

#include <optional>
#include <string>
#include <vector>

#include "core/angle/Heading.h"
#include "core/base/Date.h"
#include "core/base/Result.h"
#include "core/record/DatumInstrument.h"
#include "core/record/RawFigures.h"

namespace lubberline {

/// A magnetic heading of several figures.
struct DatumHeading {
    MagneticHeading magnetic;
    double spread_deg = 0;                 ///< largest − smallest of the figures from one side; 0 with one
    std::optional<double> collimation_deg; ///< half of what ahead and astern differ by (astern turned by 180°): a figure of quality
    double uncertainty_deg = 0;            ///< standard: resolution/√12 and the scatter of the mean
};

/// Whether the instrument can send its headings by wire. All others are read by a person, or are no heading before they are computed: what
/// a cable says is none of their figures.
[[nodiscard]] bool sendsHeadings(DatumKind kind);

/// Mean of the figures, turned and corrected as the instrument says. Where it was sighted both ways: mean of both, astern
/// turned by 180°. Errors: InvalidInput: no figure; a true instrument without variation; figures from one side more than 10°
/// apart (a slip: names them); ahead and astern more than 10° apart after turning (one of them was read the other way round:
/// says so).
Result<DatumHeading> datumHeading(const DatumInstrument& instrument, const RawFigures& raw, std::optional<Variation> variation);

/// Mean of the compass's figures, with their spread. Errors: InvalidInput: none; more than 10° apart.
struct CompassFigure {
    CompassHeading compass;
    double spread_deg = 0;
    double uncertainty_deg = 0; ///< standard
};
Result<CompassFigure> compassFigure(const RawFigures& raw, double resolution_deg);

/// Circular mean [°, 0…360) of headings that lie within half a circle.
[[nodiscard]] double meanHeading_deg(const std::vector<double>& headings_deg);

/// Whether its calibration is over on that day (ISO 8601 dates): it may be used on the day itself.
[[nodiscard]] bool calibrationOver(const DatumInstrument& instrument, Date date);

} // namespace lubberline
