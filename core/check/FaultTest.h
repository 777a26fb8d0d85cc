#pragma once

#include <algorithm>
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
        : m_card(card)
        , m_tolerance_deg(tolerance_deg)
        , m_limit_deg(limit_deg)
    {
        for (std::size_t i = 0; i < kHeadings; ++i) {
            const double heading = 10.0 * static_cast<double>(i);
            m_row[i] = rowAt(heading);
            m_card_deg[i] = deviationAt(card, CompassHeading::fromDegrees(heading)).degrees();
        }
    }
    /// Chance that the card does not hold on a heading, where the change there is N(0, spread²).
    [[nodiscard]] double chanceAt(double compass_deg, double spread_deg) const
    {
        double low = -m_tolerance_deg, high = m_tolerance_deg;
        if (m_limit_deg) {
            const double card_deg = deviationAt(m_card, CompassHeading::fromDegrees(compass_deg)).degrees();
            low = std::max(low, -*m_limit_deg - card_deg);
            high = std::min(high, *m_limit_deg - card_deg);
        }
        if (!(low < high))
            return 1;
        const double scale = std::max(spread_deg, 1e-9) * std::sqrt(2.0);
        return (std::erfc(-low / scale) + std::erfc(high / scale)) / 2;
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
    ApproximateSmith m_card;
    double m_tolerance_deg;
    std::optional<double> m_limit_deg;
    std::array<Eigen::Matrix<double, 5, 1>, kHeadings> m_row;
    std::array<double, kHeadings> m_card_deg{};
};

} // namespace lubberline
