#pragma once
/// The check without a base: a few readings, and what they make of the chance that the card does not hold any more.

#include <span>
#include <vector>

#include "core/check/CompassBelief.h"

namespace lubberline {

struct CheckOptions {
    double tolerance_deg = 3;        ///< the card holds while no heading is further from it
    std::optional<double> limit_deg; ///< of |deviation|: beyond it the compass does not hold either
    double readingError_deg = 0.7;   ///< of a deviation read on the apron, one standard deviation
    double accepted = 0.05;          ///< largest error probability with which "holds" is said
};

/// Chance that the compass does not hold, of what is believed and read. @param readings their headings as read.
[[nodiscard]] double chanceOfFault(const CompassBelief& belief, std::span<const Observation> readings, const CheckOptions& options);

struct CheckVerdict {
    bool holds = false;
    double errorProbability = 0;         ///< of the verdict
    double before = 0;                   ///< chance of a fault before the readings
    double reachable = 0;                ///< chance of a fault that would be left if every reading agreed with the card
    double largestRead_deg = 0;          ///< |read − card|
    double at_deg = 0;                   ///< compass heading of that
    std::vector<double> differences_deg; ///< read − card, one a reading
    std::vector<Message> warnings;       ///< what the check cannot know
};
/// Of a compass without history; empty: with one.
[[nodiscard]] Message whatIsUnknown(const CompassBelief& belief);
/// Readings within 5° of each other are one, their mean; that they are, and that they contradict each other, is told.
/// Errors: InvalidInput (no reading).
Result<CheckVerdict> verdictOf(const CompassBelief& belief, std::span<const Observation> readings, const CheckOptions& options);

/// "the card holds within 3° on all headings: wrong with 2 %", "swing it: …".
[[nodiscard]] Message inWords(const CheckVerdict& verdict, const CheckOptions& options);

} // namespace lubberline
