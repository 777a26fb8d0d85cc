#pragma once
/// Jumps and drifts of every compass of a selection, at a stated rate of false discoveries, and what a coefficient of one swing is worth
/// beside its own readings: crews, bases and the compass itself scatter it from swing to swing.

#include <vector>

#include "core/fleet/FleetCurves.h"
#include "core/fleet/JumpTest.h"

namespace lubberline {

/// Of one kind of compass and one coefficient, from what happened between swings without a correction between them.
struct ChangeScatter {
    std::size_t increments = 0;
    double swingVariance_deg2 = 0;       ///< of a swing beyond its fit; by the median, which jumps do not move
    double walkVariance_deg2_year = 0;   ///< by which a coefficient wanders in a year, jumps included
    double wanderVariance_deg2_year = 0; ///< likewise by the median, which jumps do not move: what is wandered is no jump and no drift
    bool known = false;                  ///< enough increments to take the first as known
    /// Trends are larger than their errors throughout the kind: then a jump is only what no trend explains.
    bool driftIsCommon = false;
    /// Of A where crews were trained: from this day on their errors are others, and what it does at that day is theirs.
    std::optional<int> crews_day = {};
    double laterVariance_deg2 = 0;

    [[nodiscard]] double varianceAt(int day) const { return crews_day && day >= *crews_day ? laterVariance_deg2 : swingVariance_deg2; }
};

struct FleetJump {
    std::int32_t compass = 0;
    std::size_t coefficient = 0;
    std::uint32_t afterRow = 0, beforeRow = 0; ///< the swings between which it happened
    double change_deg = 0, standardError_deg = 0;
    double p = 1;      ///< over all places of its series, before it was held against the others
    std::string event; ///< that lies between them; empty: none is known
};

struct FleetDrift {
    std::int32_t compass = 0;
    std::size_t coefficient = 0;
    Drift drift;
    std::uint32_t firstRow = 0, lastRow = 0;
};

struct FleetChanges {
    std::vector<std::array<ChangeScatter, kCoefficientCount>> scatter;        ///< by kind
    std::vector<FleetJump> jumps;                                             ///< kept at the rate; by compass, day and coefficient
    std::vector<FleetDrift> drifts;                                           ///< kept at the rate; by p
    std::vector<std::array<std::optional<Drift>, kCoefficientCount>> driftOf; ///< by history: every one that can be told
    std::size_t tested = 0;                                                   ///< series in which a jump could be looked for
};

inline constexpr double kFalseDiscoveryRate = 0.1;

/// The coefficient of a compass's swings as a dated series; `rows` are the swings.
struct CoefficientSeries {
    std::vector<DatedValue> values;
    std::vector<std::uint32_t> rows;
};
[[nodiscard]] CoefficientSeries seriesOf(
    const FleetSwings& fleet, const FleetCurves& curves, const CompassHistory& history, std::size_t c, const ChangeScatter& scatter);

/// @param crews_day  from which A is read by other crews, or by trained ones (Plants.h). Errors: Cancelled.
Result<FleetChanges> changesOf(const FleetSwings& fleet, const FleetCurves& curves, std::span<const CompassHistory> histories,
    std::optional<int> crews_day = {}, double rate = kFalseDiscoveryRate, const Progress& progress = {});

/// The coefficients that jumped where this one did.
[[nodiscard]] CoefficientSet jumpedTogether(const FleetChanges& changes, const FleetJump& jump);

/// What is likely to have changed where these coefficients jumped at one time.
enum class LikelyPart { Mount, Magnets, Transmission, Corrector, Several };
[[nodiscard]] LikelyPart likelyPart(CoefficientSet jumped, CompassKind kind);
[[nodiscard]] Message inWords(LikelyPart part);

} // namespace lubberline
