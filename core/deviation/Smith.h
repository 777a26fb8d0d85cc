#pragma once
/// The five Smith coefficients, approximate and exact, as values; evaluation and conversion.
///   approximate: δ = A + B sin ψ' + C cos ψ' + D sin 2ψ' + E cos 2ψ'   (argument: compass heading; angles)   [P 4]
///   exact: tan δ = (𝔄 + 𝔅 sin ψ + ℭ cos ψ + 𝔇 sin 2ψ + 𝔈 cos 2ψ) / (1 + 𝔅 cos ψ − ℭ sin ψ + 𝔇 cos 2ψ − 𝔈 sin 2ψ)
///          (argument: magnetic heading; dimensionless), by atan2 of numerator and denominator                 [P 3]

#include <array>
#include <bitset>
#include <span>

#include "core/angle/Heading.h"
#include "core/base/Result.h"

namespace lubberline {

enum class Coefficient { A, B, C, D, E };
inline constexpr std::array kCoefficients{Coefficient::A, Coefficient::B, Coefficient::C, Coefficient::D, Coefficient::E};
inline constexpr std::size_t kCoefficientCount = 5;
[[nodiscard]] constexpr std::size_t indexOf(Coefficient c) { return static_cast<std::size_t>(c); }
[[nodiscard]] constexpr char letterOf(Coefficient c) { return static_cast<char>('A' + static_cast<int>(c)); }

/// Some of the five, indexed by indexOf().
using CoefficientSet = std::bitset<kCoefficientCount>;

/// Angles [rad], for [P 4].
struct ApproximateSmith {
    double A_rad = 0, B_rad = 0, C_rad = 0, D_rad = 0, E_rad = 0;
    /// Of a compass that is far out as a whole (largeIndex_deg of SmithFit.h): B to E are by the heading that it would read if it had been
    /// turned in its mount by this, as they are by the heading as read of one that is mounted right. It is in A.
    double index_rad = 0;
    friend bool operator==(const ApproximateSmith&, const ApproximateSmith&) = default;
};

/// Dimensionless 𝔄…𝔈, for [P 3].
struct ExactSmith {
    double A = 0, B = 0, C = 0, D = 0, E = 0;
    friend bool operator==(const ExactSmith&, const ExactSmith&) = default;
};

/// One reading as the fits take it.
struct Observation {
    MagneticHeading magnetic;
    CompassHeading compass;
};

/// δ by [P 4].
[[nodiscard]] Deviation deviationAt(const ApproximateSmith& smith, CompassHeading compass);
/// One component of [P 4] alone at a compass heading [rad], e.g. B sin ψ'. Both turn the heading by the index.
[[nodiscard]] double component_rad(const ApproximateSmith& smith, Coefficient which, CompassHeading compass);
/// δ by [P 3].
[[nodiscard]] Deviation deviationAt(const ExactSmith& smith, MagneticHeading magnetic);

/// Solves ψ = ψ' + δ(ψ) for the magnetic heading on which the compass reads ψ'.
/// Errors: Numeric when two or more magnetic headings give this reading (a fold): the message names them in degrees.
Result<MagneticHeading> magneticHeadingFor(const ExactSmith& smith, CompassHeading compass);
/// Solves ψ' = ψ − δ(ψ') for the compass heading read on ψ. Errors as above.
Result<CompassHeading> compassHeadingFor(const ApproximateSmith& smith, MagneticHeading magnetic);

/// A = asin 𝔄; D = asin 𝔇; E = asin 𝔈; B = asin(𝔅 / (1 + ½ sin D)); C = asin(ℭ / (1 − ½ sin D))              [P 5]
/// Errors: Numeric when an argument of asin is not between −1 and 1 (a right angle is no small deviation, either): no
/// approximate coefficient exists, and the message names it, D first.
Result<ApproximateSmith> toApproximate(const ExactSmith& exact);
/// The inverse of [P 5]; always exists.
[[nodiscard]] ExactSmith toExact(const ApproximateSmith& approximate);

/// The same curve with all its coefficients by the heading as read: no index.
[[nodiscard]] ApproximateSmith byHeadingAsRead(const ApproximateSmith& smith);

/// The coefficients with those in `removed` set to zero.
[[nodiscard]] ApproximateSmith without(const ApproximateSmith& smith, CoefficientSet removed);
[[nodiscard]] ExactSmith without(const ExactSmith& smith, CoefficientSet removed);

} // namespace lubberline
