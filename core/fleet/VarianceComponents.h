#pragma once
/// Where a figure's scatter comes from: y = μ + aircraft + crew + site + residual, each random with a variance of its own, by restricted
/// maximum likelihood. With λ = variance / residual variance:
///   criterion(λ, σ²) = (N − 1) ln σ² + q(λ)/σ² + ln|I + ΛZᵀZ| + ln(1ᵀV⁻¹1) + (N − 1) ln 2π, V = I + ZΛZᵀ, q = yᵀV⁻¹y − (1ᵀV⁻¹y)²/1ᵀV⁻¹1,
/// which for one factor is the closed form w_i = n_i/(1 + n_i λ). Aircraft are absorbed, crews and sites solved by Cholesky.
/// Intervals are those of the profile of the criterion (it rises by χ²₁), never symmetric ones.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/base/Message.h"
#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/fleet/Proportion.h"

namespace lubberline {

/// One figure with the levels that it belongs to.
struct VarianceRow {
    double value = 0;
    std::int32_t aircraft = 0;
    std::int32_t crew = -1, site = -1; ///< -1: not stated
};

struct VarianceComponent {
    double variance = 0;
    Interval interval;
};

struct VarianceReport {
    std::size_t rows = 0;
    double mean = 0, meanStandardError = 0, criterion = 0;
    std::optional<VarianceComponent> aircraft, crew, site; ///< none: the data cannot tell it from another
    VarianceComponent residual;
    std::vector<Message> notTold; ///< why a component is missing
};

/// In any order of rows. Errors: InvalidInput (fewer than two rows), Numeric (all equal), Cancelled.
Result<VarianceReport> varianceComponents(std::vector<VarianceRow> rows, double confidence = 0.95, const Progress& progress = {});

/// Exact interval of the share of the groups' variance in the whole, one way, balanced: from F = MSB/MSE (Searle, Casella and McCulloch 1992).
[[nodiscard]] Interval intraclassInterval(double F, int groups, int each, double confidence = 0.95);

} // namespace lubberline
