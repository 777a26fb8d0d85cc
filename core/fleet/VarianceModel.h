#pragma once
/// Private to VarianceComponents: the criterion of the mixed model for given λ, from sums that are made once.

#include <map>
#include <vector>

#include <Eigen/Core>

#include "core/fleet/VarianceComponents.h"

namespace lubberline {

class VarianceModel {
public:
    /// Rows sorted by aircraft; which of the three factors take part. Levels of crews and sites are counted from 0.
    VarianceModel(std::span<const VarianceRow> rows, bool crews, bool sites);

    struct Value {
        double squares = 0;          ///< q
        double logDeterminant = 0;   ///< ln|I + ΛZᵀZ| + ln(1ᵀV⁻¹1)
        double mean = 0, weight = 0; ///< generalised least squares, 1ᵀV⁻¹1
    };
    /// @param lambda ≥ 0 of aircraft, crew, site; those that take no part are not looked at.
    [[nodiscard]] Value at(const std::array<double, 3>& lambda) const;
    [[nodiscard]] double count() const { return m_count; }

private:
    struct SameSize { ///< aircraft of one number of rows, summed: absorbing weighs all of them alike
        double aircraft = 0;
        Eigen::MatrixXd crossed; ///< Σ zzᵀ of [levels, 1, y], z the aircraft's sums
    };
    std::map<int, SameSize> m_bySize;
    Eigen::MatrixXd m_whole; ///< Σ over rows of [levels, 1, y][levels, 1, y]ᵀ
    Eigen::Index m_crews = 0, m_sites = 0;
    double m_count = 0, m_shift = 0; ///< y is taken from its mean: sums of squares keep their digits
};

} // namespace lubberline
