#pragma once
/// Headings in time, read off at any moment between two of them.

#include <optional>
#include <vector>

namespace lubberline {

struct TimedHeading {
    double seconds = 0;
    std::optional<double> heading_deg; ///< none: nothing was known at that moment (no fix)
    std::optional<double> speed_kt;
};

/// Further apart, two neighbours say nothing of what lies between.
inline constexpr double kMostApart_s = 10.0;

class HeadingLine {
public:
    /// @param headings in order of their times.
    explicit HeadingLine(std::vector<TimedHeading> headings) : m_headings(std::move(headings)) {}

    [[nodiscard]] const std::vector<TimedHeading>& headings() const { return m_headings; }
    /// Between its neighbours, the shorter way round [deg, 0…360); none where one of them is missing or too far away.
    [[nodiscard]] std::optional<TimedHeading> at(double seconds) const;
    /// [deg/s, clockwise positive]: the line through the known headings within `half_s` on either side; none of fewer than three.
    [[nodiscard]] std::optional<double> rateAt(double seconds, double half_s) const;
    /// Usual time from one heading to the next [s]; 1 of fewer than two.
    [[nodiscard]] double step_s() const;

private:
    std::vector<TimedHeading> m_headings;
};

/// How fast the compass card turned at each heading [deg/s, clockwise positive], the faster of both sides, each over a second at
/// least: a reading between rest and a fast turn lags, too. None where no neighbour is near.
[[nodiscard]] std::vector<std::optional<double>> turnRates(const std::vector<TimedHeading>& headings);

} // namespace lubberline
