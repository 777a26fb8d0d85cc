#pragma once
/// From Poisson's parameters to Smith's coefficients, with where each comes from [P 7]:
///   λ = 1 + (a+e)/2;  𝔄 = (d−b)/2λ;  𝔅 = (c tan I + P/H)/λ;  ℭ = (f tan I + Q/H)/λ;  𝔇 = (a−e)/2λ;  𝔈 = (d+b)/2λ
/// P and Q hold everything that is constant in body axes (hard iron, soft constant, currents); a misaligned sensor's gain and
/// offset take the place of 1 + S and p. Then iron that a straight sensor would not see level (g, h, k, R) tells, too.

#include <optional>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "core/deviation/Smith.h"
#include "core/earth/EarthField.h"
#include "core/sensor/SensorModel.h"

namespace lubberline {

/// What one cause adds to an exact coefficient, at the sensor as it is mounted: the terms of a coefficient add up to it, to
/// rounding. Terms that are zero are left out; they stand in the order of the coefficients, and the largest of each come first.
struct SmithTerm {
    Coefficient coefficient;
    Message cause;    ///< "soft iron a", "soft iron c (dip)", "hard iron P", "soft constant D1", "circuit landing light",
                      ///< "misalignment"
    double value = 0; ///< dimensionless
};

struct PoissonSmith {
    double lambda = 1; ///< directive force: mean horizontal field at the sensor as a part of H
    ExactSmith exact;
    std::optional<ApproximateSmith> approximate;
    Message whyNoApproximate; ///< names the coefficient when |argument of asin| ≥ 1
    std::vector<SmithTerm> terms;
};

/// The level deviation of readSensor() is deviationAt(exact, ψ), with no approximation.
/// Errors: Numeric: H is 0 (tan I and P/H do not exist), λ ≤ 0 (the iron turns the compass round: no coefficients describe it).
Result<PoissonSmith> smithOf(const SensorModel& model, const MeridianField& field);

} // namespace lubberline
