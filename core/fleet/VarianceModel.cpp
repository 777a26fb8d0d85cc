#include "core/fleet/VarianceModel.h"

#include <Eigen/Core>
#include <cmath>

#include "core/algebra/Cholesky.h"
#include "core/algebra/Products.h"

namespace lubberline {

VarianceModel::VarianceModel(std::span<const VarianceRow> rows, bool crews, bool sites)
{
    for (const auto& row : rows) {
        m_crews = crews ? std::max<Eigen::Index>(m_crews, row.crew + 1) : 0;
        m_sites = sites ? std::max<Eigen::Index>(m_sites, row.site + 1) : 0;
        m_shift += row.value;
    }
    m_count = static_cast<double>(rows.size());
    m_shift /= m_count;
    const Eigen::Index levels = m_crews + m_sites, size = levels + 2;
    m_whole = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(size);
    std::vector<Eigen::Index> touched;
    const auto note = [&](Eigen::Index place, double value) {
        if (sums[place] == 0)
            touched.push_back(place);
        sums[place] += value;
    };
    for (std::size_t first = 0, next = 0; first < rows.size(); first = next) {
        double total = 0;
        for (next = first; next < rows.size() && rows[next].aircraft == rows[first].aircraft; ++next) {
            const auto& row = rows[next];
            const double y = row.value - m_shift;
            Eigen::Index places[4];
            int used = 0;
            if (m_crews > 0)
                places[used++] = row.crew;
            if (m_sites > 0)
                places[used++] = m_crews + row.site;
            places[used++] = levels;
            for (int i = 0; i < used; ++i) {
                note(places[i], 1.0);
                for (int j = 0; j < used; ++j)
                    m_whole(places[i], places[j]) += 1.0;
                m_whole(places[i], levels + 1) += y;
                m_whole(levels + 1, places[i]) += y;
            }
            m_whole(levels + 1, levels + 1) += y * y;
            total += y;
        }
        touched.push_back(levels + 1);
        sums[levels + 1] = total;
        auto& same = m_bySize[static_cast<int>(next - first)];
        if (same.aircraft == 0)
            same.crossed = Eigen::MatrixXd::Zero(size, size);
        same.aircraft += 1;
        for (const auto i : touched)
            for (const auto j : touched)
                same.crossed(i, j) += sums[i] * sums[j];
        for (const auto i : touched)
            sums[i] = 0;
        touched.clear();
    }
}

VarianceModel::Value VarianceModel::at(const std::array<double, 3>& lambda) const
{
    // (I + λ 1 1ᵀ)⁻¹ = I − λ/(1 + nλ) 1 1ᵀ within an aircraft of n rows: it is absorbed.
    Eigen::MatrixXd left = m_whole;
    Value value;
    for (const auto& [n, same] : m_bySize) {
        left -= lambda[0] / (1 + n * lambda[0]) * same.crossed;
        value.logDeterminant += same.aircraft * std::log1p(n * lambda[0]);
    }
    const Eigen::Index levels = m_crews + m_sites;
    Eigen::Matrix2d rest = left.bottomRightCorner(2, 2);
    if (levels > 0) { // I + Λ^½ Zᵀ V_a⁻¹ Z Λ^½, which does not mind λ = 0
        Eigen::VectorXd root(levels);
        root.head(m_crews).setConstant(std::sqrt(lambda[1]));
        root.tail(m_sites).setConstant(std::sqrt(lambda[2]));
        Eigen::MatrixXd matrix = root.asDiagonal() * left.topLeftCorner(levels, levels) * root.asDiagonal();
        matrix.diagonal().array() += 1.0;
        const Eigen::MatrixXd factor = choleskyFactor(matrix);
        value.logDeterminant += 2 * factor.diagonal().array().log().sum();
        const Eigen::MatrixXd half = whitened(factor, root.asDiagonal() * left.topRightCorner(levels, 2));
        rest -= product(half.transpose(), half);
    }
    value.weight = rest(0, 0);
    value.mean = m_shift + rest(0, 1) / rest(0, 0);
    value.squares = rest(1, 1) - rest(0, 1) * rest(0, 1) / rest(0, 0);
    value.logDeterminant += std::log(rest(0, 0));
    return value;
}

} // namespace lubberline
