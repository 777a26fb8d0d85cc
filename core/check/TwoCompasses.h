#pragma once
/// Two compasses of one aircraft, read together: which of them moved. Each corrected by its card, they differ by
///   m1 − m2 = −x(ψ1')·Δ1 + x(ψ2')·Δ2
/// so that their readings alone never tell Δ1 from −Δ2; what does is how each of them changes (its kind, its history), and any reading
/// beside which the true magnetic heading stands. What moved both alike is not in the difference at all.

#include "core/check/TwoMinuteCheck.h"

namespace lubberline {

struct PairReading {
    CompassHeading first, second;
    std::optional<MagneticHeading> datum; ///< a runway, a base, the sun
};

enum class Moved { Neither, First, Second, Both };

struct PairVerdict {
    std::array<double, 4> probability{}; ///< of neither, first, second, both
    /// That is named; none: one of them moved, and it is not told which.
    std::optional<Moved> named;
    double errorProbability = 0;                 ///< of what is named
    double firstFault = 0, secondFault = 0;      ///< chance that each card does not hold
    std::array<double, 5> difference_deg{};      ///< of m1 − m2, coefficients A … E over the mean of both headings
    std::array<double, 5> differenceError_deg{}; ///< standard errors, with what is believed before
    double rms_deg = 0;
    /// Both differ from the datum by this much, datum − compass as corrected, and by little else: the datum may be what is out.
    std::optional<double> datumOut_deg;
    std::size_t readings = 0, withDatum = 0, headings = 0; ///< headings: bins of 10° that have a reading
    std::vector<Message> warnings;
};

inline constexpr double kNamedFrom = 0.8; ///< a compass is named from this probability on

/// Readings of one bin of 10° are one reading: a log's neighbours are not independent. "Moved" is a card that does not hold
/// (CheckOptions). Errors: InvalidInput (no pair).
Result<PairVerdict> compareCompasses(
    const CompassBelief& first, const CompassBelief& second, std::span<const PairReading> pairs, const CheckOptions& options);

[[nodiscard]] Message inWords(const PairVerdict& verdict);

/// Why a compass of that aircraft is to be swung, with its name: that which moved, or that one of both did. Empty: both hold, or nothing
/// is sure enough to make a swing due.
[[nodiscard]] Message whySwing(const PairVerdict& verdict, const std::string& first, const std::string& second);

} // namespace lubberline
