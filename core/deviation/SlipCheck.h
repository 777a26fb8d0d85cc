#pragma once
/// Judges a reading as it is made: against the curve that the last swing and the readings before it let expect, and against the
/// slips that people make. Bayes' rule over "as read" and each slip; the answer is a probability, not just "outlier".
///   expectation: δ = xᵀβ + ε, x = (1, sin ψ', cos ψ', sin 2ψ', cos 2ψ') [P 4], β normal (the last swing's coefficients, or
///   none), brought up to date by the readings before this one; ε normal with the reading's noise.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/deviation/Smith.h"

namespace lubberline {

enum class Slip {
    SwappedDigits, ///< 269 for 296
    Reciprocal,    ///< read from the other side: 180° off
    FiveDegrees,   ///< the neighbouring mark of the card: 5° off
    TenDegrees,    ///< the neighbouring figure of the card: 10° off
    HundredDegrees,
    WrongSign,   ///< the deviation was applied the wrong way round
    WrongRow,    ///< it fits another heading of the list
    Unexplained, ///< off the curve, by no slip that has a name
};

enum class SlippedFigure { Compass, Datum };

struct SlipCandidate {
    Slip slip = Slip::TenDegrees;
    SlippedFigure figure = SlippedFigure::Compass;
    double meant_deg = 0;   ///< the figure that was meant; WrongRow: the nominal heading that it fits
    double probability = 0; ///< 0…1, given the reading
};

struct SlipJudgement {
    CompassHeading expected;               ///< what the compass should read on this heading
    double expectedError_deg = 0;          ///< standard deviation of what it should read, reading noise included
    double probabilityAsRead = 1;          ///< that nothing slipped
    double probabilityUnexplained = 0;     ///< something is wrong, but none of the slips explains it
    std::vector<SlipCandidate> candidates; ///< the likeliest first; those of at least 1 %
    /// More likely wrong than right: worth a second look while the aircraft still stands there.
    [[nodiscard]] bool lookAgain() const { return probabilityAsRead < 0.5; }
};

/// What is expected before any reading of this swing.
struct ExpectedCurve {
    ApproximateSmith mean = {};
    ApproximateSmith standardDeviation = {};
};
/// Without a swing before: zero within what aircraft compasses have (A 3°, B and C 10°, D 3°, E 2°: our choice, wide on
/// purpose).
[[nodiscard]] ExpectedCurve anyCurve();
/// After the last swing: its coefficients within what changes from swing to swing (A 1°, B and C 3°, D and E 0.7°: our choice).
[[nodiscard]] ExpectedCurve curveAfter(const ApproximateSmith& lastSwing);

struct SlipContext {
    ExpectedCurve expected = anyCurve();
    std::span<const Observation> earlier;      ///< readings of this swing that count
    double resolution_deg = 1.0;               ///< of the compass
    std::optional<double> nominal_deg;         ///< the heading that the crew was to turn to
    std::span<const double> otherNominals_deg; ///< of the rows that this reading could belong to instead
};

[[nodiscard]] SlipJudgement judgeReading(const Observation& reading, const SlipContext& context);

} // namespace lubberline
