#pragma once
/// What has to be said beside the figures of a card: what makes them less than they look.

#include <optional>
#include <vector>

#include "core/record/Fleet.h"
#include "core/swing/Card.h"

namespace lubberline {

/// How the aircraft stood while its compass was read: pitch and roll of the readings that count.
struct SwungAttitude {
    struct Range {
        double least_deg = 0, most_deg = 0;
    };
    std::optional<Range> pitch, roll; ///< of the readings that state it; none does: nothing
    bool level = false;               ///< stated for every reading, and never kLevel_deg or more off
    bool tilted = false;              ///< somewhere kLevel_deg or more off
};
/// Stated angles below this are the ground's, not an attitude: 1° moves the deviation by less than a reading's error.
inline constexpr double kLevel_deg = 1;
[[nodiscard]] SwungAttitude attitudeOf(const Swing& swing);
/// That it was not level, with its angles; empty where it was, or nobody says.
[[nodiscard]] Message wordsOf(const SwungAttitude& attitude);

/// Decimals that such an angle is printed with: 4.5° is neither 4° nor 5°.
[[nodiscard]] int attitudeDecimals(double angle_deg);

/// Half width of a band as it is printed in tenths of a degree: never 0.0, as no figure is certain.
[[nodiscard]] double bandInTenths_deg(double band_rad);

/// Whether the deviation of a row is over the limit; false without one.
[[nodiscard]] bool overLimit(const CardRow& row, const std::optional<LimitsProfile>& limits);

/// Whether a row stands nearer to a heading that was to be read and was not than to any that was.
[[nodiscard]] bool skippedNear(const CardRow& row, const Swing& swing);

/// Whether a row, the spread of the rows or a reading is over what is allowed; false without limits.
[[nodiscard]] bool outOfLimits(const Card& card, const std::optional<LimitsProfile>& limits);

/// In the order of their weight: rows over the limit, the spread, suspect readings that were used, arcs where nobody read, what
/// interpolation misses, rows far from their readings, an attitude that is not level, no band.
[[nodiscard]] std::vector<Message> remarksOn(const Card& card, const SwingRecord& record);

} // namespace lubberline
