#pragma once
/// The whole sensor model followed from headings read in flight. Of a compass that reads ψ' in the level plane, whatever the attitude,
///   sin δ = Σ g_i (S b + p/H)_i,  b = Rx(φ)Ry(θ)(cos ψ, −sin ψ, tan dip),  g = what a field along each body axis does across ψ'  [P 6, K 9.13]
/// exactly and linear in S and p. A scale that all axes share turns no heading: S is told less k in its diagonal, so k is 0 here.

#include <array>

#include "core/earth/EarthField.h"
#include "core/inflight/StateFilter.h"
#include "core/sensor/SensorModel.h"

namespace lubberline {

/// a, b, c, d, e, f, g, h as degrees (57.3 times the figure), and P, Q, R over H as degrees.
inline constexpr std::array kModelNames{"a", "b", "c", "d", "e", "f", "g", "h", "P", "Q", "R"};
inline constexpr int kModelStates = static_cast<int>(kModelNames.size());

struct FlownAt {
    double pitch_deg = 0, roll_deg = 0; ///< nose up, starboard down positive
    MeridianField field;
};

/// @param horizontal_nT that P, Q and R are counted over. Its product with the state is 57.3 sin δ.
[[nodiscard]] StateFilter::State modelRow(double compass_deg, double deviation_deg, const FlownAt& at, double horizontal_nT);
/// Rows of the level A to E in a field.
[[nodiscard]] std::array<StateFilter::State, 5> levelRows(const MeridianField& field, double horizontal_nT);
[[nodiscard]] SensorModel modelOf(const StateFilter::State& state_deg, double horizontal_nT);

} // namespace lubberline
