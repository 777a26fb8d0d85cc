#pragma once
/// "What will this compass read at base X on that date?" The level curve expected in another field, with its uncertainty.
/// A level swing tells nothing of g, h, k and R, so that only level curves are predicted.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/record/Site.h"
#include "core/swing/IronPosterior.h"

namespace lubberline {

/// How likely what is true lies within the bounds that are stated, if the assumed sizes are plausible ones.
inline constexpr double kBoundProbability = 0.95;

struct PredictedPoint {
    MagneticHeading magnetic;
    std::optional<Deviation> deviation;            ///< none where the horizontal field vanishes
    std::optional<double> lowest_rad, highest_rad; ///< of the band; none without deviation
};

/// The largest |change| of the deviation over heading, from here to there.
struct PredictedChange {
    double expected_rad = 0;
    double bound_rad = 0; ///< it is no larger with kBoundProbability; of a model: the change itself
};

struct Prediction {
    MeridianField there;
    std::vector<PredictedPoint> points; ///< the whole curve lies in the band with kBoundProbability
    std::optional<ExactSmith> exact;    ///< there; none when λ ≤ 0
    double maxAbs_rad = 0;              ///< of the middle curve
    double maxAbsPossible_rad = 0;      ///< of the band
    std::optional<PredictedChange> change;
    std::optional<AssumedIron> assumed; ///< of swings; a model needs none
    Message basis;                      ///< a model; one swing; swings at several places
    std::vector<Message> warnings;
};

/// From where to where.
struct Move {
    std::optional<MeridianField> here; ///< none: the change is not told
    MeridianField there;
};

/// From a model: exact, no band beyond the curve. `headings`: evenly spaced from north, `count` of them (8…720).
Result<Prediction> predict(const SensorModel& model, const Move& move, int count = 72);
/// From swings of one compass, at one place or several: everything that they leave open (core/swing/IronPosterior.h), carried to
/// the other place. λ is not needed: it is the same at both, as are A, D and E.
/// Errors: H there in the blackout zone; several swings: those of separateIron().
Result<Prediction> predict(std::span<const SwingAtPlace> swings, const Move& move, const AssumedIron& assumed = {}, int count = 72);
/// From one swing, moved from where it was made.
Result<Prediction> predict(const SwingAtPlace& swing, const MeridianField& there, int count = 72);

/// Whether it stays within limits: out when the middle curve leaves them, "may leave" when only the band does.
enum class PredictedVerdict { InLimits, MayLeaveLimits, OutOfLimits, NoLimit };
[[nodiscard]] PredictedVerdict judge(const Prediction& prediction, const std::optional<LimitsProfile>& limits);

/// The rule "swing again after a move": needed when the verdict there is neither InLimits nor NoLimit, or the bound of the change
/// is more than `change_deg`. The reason in words, with how sure it is and what is assumed.
struct SwingAgain {
    bool needed = false;
    Message reason;
};
/// None where the prediction knows no place to come from.
[[nodiscard]] std::optional<SwingAgain> swingAgainAfterMove(
    const Prediction& prediction, const std::optional<LimitsProfile>& limits, double change_deg = 3.0);

} // namespace lubberline
