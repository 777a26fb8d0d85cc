#pragma once
/// What the error of a pair of headings is where nobody states it, and whether the one that is stated can be right: by how the pairs scatter
/// about what fits them. An alarm that trusts an error that is too small finds iron that never changed.

#include <span>
#include <vector>

#include "core/inflight/StateFilter.h"

namespace lubberline {

inline constexpr double kUsualNoise_deg = 0.5; ///< of a pair of headings, while too few are there to show it

struct HeadingRow {
    StateFilter::State h;
    double z = 0, variance = 1; ///< [deg, deg²]
};

struct HeadingScatter {
    double ratio = 1;   ///< of the variance that the rows show to the one they state
    double freedom = 0; ///< that it is known by

    /// Beyond 3 standard errors of what chance makes of 1.
    [[nodiscard]] bool contradicts() const;
    /// As of 20 degrees of freedom, those that are missing at 1.
    [[nodiscard]] double blended() const;
};

/// About the least-squares fit, without what lies beyond 4 deviations of its middle: single spikes.
[[nodiscard]] HeadingScatter scatterOf(std::span<const HeadingRow> rows);

/// The same, followed from one innovation to the next.
class NoiseScale {
public:
    explicit NoiseScale(const HeadingScatter& start = {1, 10}) : m_slow(start.ratio), m_weight(start.freedom) {}
    /// @param square of an innovation over its stated variance
    void take(double square);
    [[nodiscard]] double ratio() const;
    [[nodiscard]] HeadingScatter scatter() const { return {m_slow, m_weight}; }

private:
    double m_slow, m_weight;
    std::vector<double> m_recent; ///< a ring
    std::size_t m_place = 0;
    double m_recentSum = 0;
};

} // namespace lubberline
