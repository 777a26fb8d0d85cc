#pragma once
/// Correction card: what to steer by compass to make good a magnetic heading.   STEER = FOR − δ(FOR)
/// Or the other way round: which magnetic heading it is when the compass reads so much.

#include <optional>
#include <span>
#include <vector>

#include "core/swing/Analysis.h"
#include "core/swing/Gaps.h"

namespace lubberline {

enum class CardSource {
    Fit,      ///< the exact fit at each heading
    Readings, ///< the deviation read nearest to each heading
};

/// What the even headings of the rows are.
enum class CardBy { Magnetic, Compass };

inline constexpr std::array kCardSteps_deg{10, 15, 30, 45};

struct CardOptions {
    int step_deg = 30; ///< of kCardSteps_deg
    CardSource source = CardSource::Fit;
    /// Taken out mechanically after the swing: A by turning the compass in its mount, B and C by the compensator.
    CoefficientSet removed = {};
    CardBy by = CardBy::Magnetic;
    friend bool operator==(const CardOptions&, const CardOptions&) = default;
};

/// What the card gives between its rows.
struct BetweenRows {
    double interpolated_deg = 0;     ///< linearly, between the rows before rounding, [0, 360)
    std::optional<double> curve_deg; ///< by the curve itself; none where there is none
};

struct CardRow {
    MagneticHeading magnetic; ///< FOR
    CompassHeading steer;
    Deviation residual; ///< the deviation that the card corrects for
    /// Half width of the 95 % band of this row: of the fitted curve, or, for a reading, of one reading and of how far the curve
    /// goes on from it to the row; none: the readings do not tell.
    std::optional<double> band_rad = {};
    bool unread = false;                           ///< inside an arc where nobody read
    BetweenRows halfway = {};                      ///< to the next row
    [[nodiscard]] int steerRounded_deg() const;    ///< 0…359, halves up
    [[nodiscard]] int magneticRounded_deg() const; ///< likewise
};

/// A deviation with the heading where it is.
struct DeviationThere {
    Deviation deviation;
    MagneticHeading at;
};

struct Card {
    CardOptions options;
    std::vector<CardRow> rows;
    double index_deg = 0;                 ///< of a compass that is far out as a whole; all rows have it, unless A was removed
    double residualMaxAbs_rad = 0;        ///< over the rows
    DeviationThere largestResidual;       ///< of the rows
    DeviationThere largestReading;        ///< of the readings, as the compass stands after what was removed
    double largestMisfit_rad = 0;         ///< the farthest that a reading lies off the fitted curve
    std::optional<double> widestBand_rad; ///< over all headings; none: the readings do not tell
    std::vector<ReadingGap> gaps;
    std::vector<DeviationThere> suspects; ///< readings that are suspect and were used: how far each is off the curve of the others
    double farthestReading_deg = 0;       ///< with Readings: the largest distance between a row and the reading that it is of
    double betweenRows_rad = 0;           ///< the most by which linear interpolation between two rows is off
    double betweenRowsAt_deg = 0;         ///< the heading (of the rows' kind) where
    int finerStep_deg = 0;           ///< the coarsest step where that is within kBetweenRows_deg, or the finest there is; 0: this one does
    double finerBetweenRows_rad = 0; ///< and what it leaves
};

/// Interpolating between two rows should not be worse than this: beyond, a finer card is offered.
inline constexpr double kBetweenRows_deg = 1;

/// With `Readings` the removed coefficients are those of the classical point rules where the readings allow them (the
/// worksheet's way), else of the approximate fit; with `Fit`, A is the approximate A and the exact 𝔅…𝔈 are set to zero.
/// Errors: InvalidInput (another step), Numeric (the coefficients needed could not be told; the compass folds or runs backwards,
/// on the curve or from row to row: one reading would stand for several headings, and the message names them).
Result<Card> makeCard(const Analysis& analysis, const CardOptions& options);

/// Errors: Numeric where STEER does not rise from FOR to FOR all the way around, also when both are rounded: two FOR with one
/// STEER. Names the first two.
Result<void> checkRising(std::span<const CardRow> rows, CardBy by);

/// @param heading_deg magnetic (then the answer is what to steer) or compass (then it is the magnetic heading), as the card is.
/// Errors: those of makeCard().
Result<BetweenRows> betweenRows(const Analysis& analysis, const Card& card, double heading_deg);

} // namespace lubberline
