#pragma once
/// The population of a selection: mean and spread of deviation at each magnetic heading, and of the coefficients; one aircraft one vote
/// (the mean of its swings), or one swing one vote.

#include <optional>
#include <span>
#include <vector>

#include "core/deviation/Harmonics.h"
#include "core/fleet/FleetCurves.h"

namespace lubberline {

enum class FleetVote { Aircraft, Swing };

struct PatternOptions {
    int grid = 8; ///< headings, evenly spaced from north; 3 … 360
    FleetVote vote = FleetVote::Aircraft;
    std::optional<SwingStage> stage; ///< none: both
};

/// Everything in degrees; what cannot be told has no value.
struct PatternPoint {
    double heading_deg = 0;
    int units = 0; ///< aircraft, or swings, that have a say here
    std::optional<double> mean_deg;
    std::optional<double> standardDeviation_deg; ///< of their deviations, as found in the data
    std::optional<double> between_deg;           ///< the same with the fits' own error taken out
    std::optional<double> percentile5_deg, percentile50_deg, percentile95_deg;
    std::int64_t moved = 0; ///< swings that have no reading within half a step, and enter along their own curve
};

struct CoefficientOutlier {
    std::uint32_t row = 0; ///< a swing of it
    double value_deg = 0;
    double distance = 0; ///< 0.6745 (x − median)/MAD: beyond ±3.5 (Iglewicz and Hoaglin 1993)
};

struct CoefficientSpread {
    int units = 0;
    std::optional<double> mean_deg, standardError_deg, standardDeviation_deg, between_deg;
    std::optional<double> percentile5_deg, percentile50_deg, percentile95_deg;
    std::vector<CoefficientOutlier> outliers; ///< the farthest first
    std::vector<double> values_deg;           ///< sorted: for a histogram
};

struct PopulationPattern {
    std::size_t swings = 0; ///< that it is made of
    std::vector<PatternPoint> points;
    std::vector<double> maxima_deg, minima_deg; ///< headings of those of the mean, on the grid
    std::optional<double> largestSpread_deg;    ///< heading of the largest standard deviation
    std::array<CoefficientSpread, kCoefficientCount> coefficients;
    std::vector<HarmonicOrder> mean, spread; ///< harmonics of the mean and of the standard deviation; empty where a heading has none
};

[[nodiscard]] PopulationPattern patternOf(const FleetSwings& fleet, const FleetCurves& curves, const PatternOptions& options);

/// A swing's deviation at a magnetic heading: the reading nearest to it within half a step, moved along the swing's own curve and its
/// residual kept; without one the curve alone; without a curve a reading on the heading itself.
struct GridValue {
    double deviation_deg = 0;
    bool read = false; ///< by a reading
};
[[nodiscard]] std::optional<GridValue> valueAt(
    const FleetSwings& fleet, const FleetSwing& swing, const SwingCurve& curve, double magnetic_deg, double halfStep_deg);

/// Places of the highest (or lowest) of a closed row of figures; a level stretch counts once, by its first.
[[nodiscard]] std::vector<std::size_t> peaksOf(std::span<const double> around, bool highest);

} // namespace lubberline
