#pragma once

#include <array>
#include <cmath>
#include <optional>

#include <Eigen/Core>

#include "core/check/CompassBelief.h"

namespace lubberline {

/// Whether a card holds after its coefficients changed: on every tenth degree.
class FaultTest {
public:
    FaultTest(const ApproximateSmith& card, double tolerance_deg, std::optional<double> limit_deg)
        : m_tolerance_deg(tolerance_deg)
        , m_limit_deg(limit_deg)
    {
        for (std::size_t i = 0; i < kHeadings; ++i) {
            const double heading = 10.0 * static_cast<double>(i);
            m_row[i] = rowAt(heading);
            m_card_deg[i] = deviationAt(card, CompassHeading::fromDegrees(heading)).degrees();
        }
    }
    [[nodiscard]] bool isFault(const Eigen::Matrix<double, 5, 1>& change_deg) const
    {
        for (std::size_t i = 0; i < kHeadings; ++i) {
            const double change = m_row[i].dot(change_deg);
            if (std::abs(change) > m_tolerance_deg || (m_limit_deg && std::abs(m_card_deg[i] + change) > *m_limit_deg))
                return true;
        }
        return false;
    }

private:
    static constexpr std::size_t kHeadings = 36;
    double m_tolerance_deg;
    std::optional<double> m_limit_deg;
    std::array<Eigen::Matrix<double, 5, 1>, kHeadings> m_row;
    std::array<double, kHeadings> m_card_deg{};
};

} // namespace lubberline
