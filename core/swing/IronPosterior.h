#pragma once
/// What swings leave open about a compass, weighed by what is plausible: c against P and f against Q add up at one place,
///   𝔅 = (c/λ) tan I + (P/λ)/H + κ,   ℭ = (f/λ) tan I + (Q/λ)/H + μ                                          [P 7]
/// and may cancel each other there, so that no reading bounds either of them: without an assumption about their size nothing at
/// all is known about another place. κ and μ are the compass's own one-cycle error (transmission, card that is not centred), which
/// does not change with the place [K 9.4.4].

#include <span>
#include <vector>

#include "core/swing/IronSeparation.h"

namespace lubberline {

/// The sizes that are plausible before anything is read: standard deviations about 0, independent of each other.
/// The aircraft's iron: a compass that deviates by more than 20° is to be moved, one of less is compensated (Plastimo's fitting
/// instructions). 20° as two standard deviations at H 18,700 nT and dip 67.5°: c tan I = 0.145 and P/H = 0.107 together 10.4°.
/// Aircraft differ: their iron is Student-distributed about these sizes, and how large B and C are tells what kind this one is.
/// The compensator: magnets that take up to 20° away (two standard deviations of 3500 nT there), whatever the aircraft has. They
/// make 𝔅 small by cancelling c tan I, which is why a small B is no sign of little iron.
/// The compass: 0.2° each of sensor and synchro (Kayton and Fried, 9.4.4) are the least; cards and pivots are worse: 1° in all.
struct AssumedIron {
    double verticalSoft = 0.06;       ///< c/λ and f/λ
    double hardIron_nT = 2000;        ///< P/λ and Q/λ of the aircraft
    double compensator_nT = 3500;     ///< P/λ and Q/λ of the magnets set against it
    double compassOneCycle_deg = 0.7; ///< κ and μ, as angles: 1° together
    int degreesOfFreedom = 8;         ///< of the aircraft's iron; the rest is normal
    double readingError_deg = 1.0;    ///< of a reading of a swing whose own errors are not known (five readings)
    friend bool operator==(const AssumedIron&, const AssumedIron&) = default;
};

/// What may be assumed at most; each is above zero.
inline constexpr AssumedIron kMostAssumed{10, 1e6, 1e6, 90};

/// "vertical soft iron (c, f) of about 0.06, hard iron (P, Q) of about 2000 nT, …": for page, paper and files.
[[nodiscard]] Message sayAssumed(const AssumedIron& assumed);

/// One possible truth.
struct PossibleIron {
    double A = 0, D = 0, E = 0;
    double c = 0, P_nT = 0, ownB = 0; ///< parts of λ
    double f = 0, Q_nT = 0, ownC = 0;
    [[nodiscard]] ExactSmith at(const MeridianField& field) const;
};

struct IronPosterior {
    PossibleIron mean;
    std::vector<PossibleIron> draws; ///< equally likely; the same for the same swings, on every machine
};

inline constexpr int kIronDraws = 4000; ///< the 95 % bound of draws is one of 94.3 … 95.7 % (two standard errors)

/// Swings of one compass at places with H > 0. Their errors have the Student distribution of the fit's degrees of freedom.
[[nodiscard]] IronPosterior ironOf(std::span<const SwingAtPlace> swings, const AssumedIron& assumed = {});

} // namespace lubberline
