#pragma once
/// Jumps and drifts of every compass of a selection, at a stated rate of false discoveries.

#include <vector>

#include "core/fleet/ChangeScatter.h"

namespace lubberline {

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
