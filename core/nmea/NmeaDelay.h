#pragma once
/// The delay between the headings of a compass and what they are held against. A receiver answers late and averages, a card in its liquid
/// lags: at a turn rate r a delay d of the reference leaves −r d in the deviation, which in a steady turn one way is nothing but an A.
/// Where the aircraft turns both ways, or at different rates over the same headings, d and A part.

#include <optional>
#include <span>
#include <vector>

#include "core/nmea/HeadingLine.h"

namespace lubberline {

enum class DelayTold {
    NoTurn,   ///< steady headings: no delay shows
    OneWay,   ///< not to be told from A
    TooNoisy, ///< the turn would tell, the readings are too uneven
    BothWays,
    VaryingRate,
};

struct NmeaDelay {
    DelayTold told = DelayTold::NoTurn;
    /// The reference is that much older than the heading beside it; none where it is not told.
    std::optional<double> seconds;
    double standardError_s = 0; ///< of it; where it is not told, of a delay that nothing is known of
    double A_degPerSecond = 0;  ///< what a second of delay adds to A (its sign is that of −rate)
    int clockwise = 0, counterClockwise = 0;
};

/// What is known of a delay that the readings do not tell: receivers and damped compasses are a second late, some two.
inline constexpr double kUsualDelay_s = 1.0;

/// Turned slower than this, headings are steady: the bottom of the band for a slow turn.
inline constexpr double kSlowestTurn_deg_s = 0.2;
inline constexpr double kFastestTurn_deg_s = 3.0;

/// @param compass used headings, in order of time. @param spacing_s what the places in the log leave open of their times.
[[nodiscard]] NmeaDelay delayOf(std::span<const TimedHeading> compass, const HeadingLine& reference, double spacing_s);

/// Turn rate [deg/s] for each heading: the reference's, `delay_s` later, or where it has holes the compass's own; 0 where neither tells.
[[nodiscard]] std::vector<double> referenceRates(std::span<const TimedHeading> compass, const HeadingLine& reference, double delay_s);

} // namespace lubberline
