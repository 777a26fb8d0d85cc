#pragma once
/// "What will this compass read at base X on that date?" The level curve expected in another field, with its uncertainty.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/record/Site.h"
#include "core/swing/IronSeparation.h"

namespace lubberline {

struct PredictedPoint {
    MagneticHeading magnetic;
    std::optional<Deviation> deviation;            ///< none where the horizontal field vanishes
    std::optional<double> lowest_rad, highest_rad; ///< between the extremes, with two standard errors; none without deviation
};

struct Prediction {
    MeridianField there;
    std::vector<PredictedPoint> points;
    std::optional<ExactSmith> exact; ///< there; none when λ ≤ 0
    double maxAbs_rad = 0;           ///< of the middle curve
    double maxAbsPossible_rad = 0;   ///< of the band
    Message basis;                   ///< a model; one swing, between two extremes; swings at several places
    std::vector<Message> warnings;
};

/// From a model: exact, no band beyond the curve. `headings`: evenly spaced from north, `count` of them (8…3600).
Result<Prediction> predict(const SensorModel& model, const MeridianField& there, int count = 72);
/// From one swing: the middle and the band between all hard iron (𝔅 ∝ 1/H) and all vertical soft iron (𝔅 ∝ tan I), B and C each
/// by itself: the hull of the four corners, which holds everything between them, as the direction of [P 3]'s vector is
/// monotonic along a side. λ is not needed: it is the same at both places.
Result<Prediction> predict(const SwingAtPlace& swing, const MeridianField& there, int count = 72);
/// From swings at several places.
Result<Prediction> predict(const IronSeparation& separation, const MeridianField& there, int count = 72);

/// Whether it stays within limits: out when the middle curve leaves them, "may leave" when only the band does.
enum class PredictedVerdict { InLimits, MayLeaveLimits, OutOfLimits, NoLimit };
[[nodiscard]] PredictedVerdict judge(const Prediction& prediction, const std::optional<LimitsProfile>& limits);

/// The rule "swing again after a move": true when the verdict there is not InLimits, or without limits when the curve may
/// change by more than `change_deg` anywhere. The reason in words.
struct SwingAgain {
    bool needed = false;
    Message reason;
};
[[nodiscard]] SwingAgain swingAgainAfterMove(
    const Prediction& here, const Prediction& there, const std::optional<LimitsProfile>& limits, double change_deg = 3.0);

} // namespace lubberline
