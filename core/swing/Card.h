#pragma once
/// Correction card: what to steer by compass to make good a magnetic heading.   STEER = FOR − δ(FOR)

#include <span>
#include <vector>

#include "core/swing/Analysis.h"

namespace lubberline {

enum class CardSource {
    Fit,      ///< the exact fit at each heading
    Readings, ///< the deviation read nearest (in magnetic heading) to each heading
};

struct CardOptions {
    int step_deg = 30; ///< 30 or 45
    CardSource source = CardSource::Fit;
    /// Taken out mechanically after the swing: A by turning the compass in its mount, B and C by the compensator.
    CoefficientSet removed = {};
};

struct CardRow {
    MagneticHeading magnetic; ///< FOR
    CompassHeading steer;
    Deviation residual;                         ///< the deviation that the card corrects for
    [[nodiscard]] int steerRounded_deg() const; ///< 0…359, halves up
};

struct Card {
    std::vector<CardRow> rows;
    double residualMaxAbs_rad = 0;
};

/// With `Readings` the removed coefficients are those of the classical point rules where the readings allow them (the
/// worksheet's way), else of the approximate fit; with `Fit`, A is the approximate A and the exact 𝔅…𝔈 are set to zero.
/// Errors: InvalidInput (a step other than 30 or 45), Numeric (the coefficients needed could not be told).
Result<Card> makeCard(const Analysis& analysis, const CardOptions& options);

} // namespace lubberline
