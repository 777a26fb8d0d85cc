#pragma once
/// Where a coefficient comes from: what each reading adds to it. Every one of them is a sum over the readings,
///   coefficient = Σ wᵢ yᵢ
/// By least squares w = (XᵀX)⁻¹ Xᵀ, a row of it; by the point rules w is ±½, ±¼ or ⅛ (PointRules.h).

#include <optional>
#include <span>
#include <vector>

#include "core/deviation/PointRules.h"
#include "core/deviation/SmithFit.h"

namespace lubberline {

struct DerivationTerm {
    std::size_t reading = 0;
    double weight = 0;   ///< wᵢ
    double quantity = 0; ///< yᵢ: δ [rad] for the approximate coefficients and the rules; sin δ for the exact ones
    [[nodiscard]] double product() const { return weight * quantity; }
};

struct Derivation {
    std::vector<DerivationTerm> terms; ///< in the order of the readings; those of weight zero by rule are left out
    double sum = 0;                    ///< the coefficient
};

/// Of a fit to exactly these readings; none where the fit cannot tell the coefficient.
[[nodiscard]] std::optional<Derivation> derivationOf(std::span<const Observation> readings, const ApproximateFit& fit, Coefficient which);
[[nodiscard]] std::optional<Derivation> derivationOf(std::span<const Observation> readings, const ExactFit& fit, Coefficient which);
/// Of the rules as they were worked from these readings; none where they cannot tell it (D of four points).
[[nodiscard]] std::optional<Derivation> derivationOf(std::span<const Observation> readings, const PointRules& rules, Coefficient which);

} // namespace lubberline
