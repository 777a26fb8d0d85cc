#pragma once
/// The approximate curve of one swing, for a hundred thousand of them: normal equations instead of QR, which the accepted
/// condition allows (kConditionLimit squared is 400: twelve digits are left).
///   δ = A + B sin z + C cos z + D sin 2z + E cos 2z, z: compass heading; everything in degrees                       [P 4]

#include <array>
#include <cstdint>
#include <span>

#include "core/deviation/Smith.h"

namespace lubberline {

using FiveTerms = std::array<double, kCoefficientCount>;

/// 1, sin z, cos z, sin 2z, cos 2z.
[[nodiscard]] FiveTerms termsAt(double compass_deg);

struct SwingCurve {
    FiveTerms value_deg{};                          ///< zero where not known
    std::array<std::array<double, 5>, 5> inverse{}; ///< (XᵀX)⁻¹: covariance for unit variance of a reading; zero where not known
    std::uint8_t knownBits = 0; ///< which of the five the headings tell: 31, 23 (cardinals), 15 (intercardinals), 7 or 0
    std::int32_t readings = 0, parameters = 0;
    double residualSquares_deg2 = 0;
    double maxAbs_deg = 0; ///< of the deviations read
    bool farOut = false;   ///< it reads the reciprocal, or is far out as a whole (largeIndex_deg of SmithFit.h): no curve of a population

    [[nodiscard]] bool known(std::size_t c) const { return (knownBits >> c & 1U) != 0; }
    [[nodiscard]] bool fitted() const { return knownBits != 0; }
    [[nodiscard]] int degreesOfFreedom() const { return readings - parameters; }
};

/// Headings [deg], as many of each. Five coefficients where the headings tell five within kConditionLimit; where they are the four
/// cardinals (or intercardinals) A, B, C and E (or D); else A, B, C; else none: the cut of core/deviation/SmithFit.h.
[[nodiscard]] SwingCurve fitCurve(std::span<const double> magnetic_deg, std::span<const double> compass_deg);

/// The curve at a compass heading, and at a magnetic one (the compass heading that belongs to it is looked for by Newton).
[[nodiscard]] double curveAtCompass_deg(const FiveTerms& value_deg, double compass_deg);
struct CurvePoint {
    double deviation_deg = 0;
    double compass_deg = 0;
};
[[nodiscard]] CurvePoint curveAtMagnetic(const FiveTerms& value_deg, double magnetic_deg);

/// Variance of the curve at a compass heading for unit variance of a reading.
[[nodiscard]] double curveVariance(const SwingCurve& curve, double compass_deg);

/// The largest |δ| of the curve over headings, every 5°.
[[nodiscard]] double largestOf_deg(const FiveTerms& value_deg);

} // namespace lubberline
