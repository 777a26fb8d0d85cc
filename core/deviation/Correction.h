#pragma once
/// What to make the compass read when correcting on the cardinals: the figures of a correction swing.
///   C = (δN − δS)/2, B = (δE − δW)/2, A = mean of the four.
/// To remove a term T(ψ) of δ = ψ − ψ' on heading ψ, set the compass to read (reading now) + T(ψ)
/// (the compensation worksheet of docs/bibliography.md, question 1: C = −6, on S 170 → 176; B = +2, on W 265 → 263).

#include <array>
#include <span>
#include <vector>

#include "core/deviation/Smith.h"

namespace lubberline {

enum class Cardinal { N, E, S, W };
[[nodiscard]] char letterOf(Cardinal cardinal);

struct CorrectionStep {
    Coefficient coefficient = Coefficient::C; ///< C on N and S, B on E and W
    Cardinal on = Cardinal::N;
    MagneticHeading magnetic; ///< the actual heading of the reading
    CompassHeading compassReads;
    CompassHeading makeCompassRead;
};

struct Correction {
    double A_rad = 0, B_rad = 0, C_rad = 0;
    std::array<CorrectionStep, 4> steps; ///< C on N, C on S, B on E, B on W
};

/// Takes the readings whose magnetic headings are nearest to N, E, S, W.
/// Errors: InvalidInput when a cardinal has no reading within kPointTolerance_deg: it is named.
Result<Correction> correctionSteps(std::span<const Observation> readings);

} // namespace lubberline
