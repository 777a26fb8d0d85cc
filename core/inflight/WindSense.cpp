#include "core/inflight/WindSense.h"

#include <algorithm>
#include <cmath>

namespace lubberline {

namespace {

constexpr double kKnotsPerMetreASecond = 3600.0 / 1852.0;
constexpr std::array<double, 6> kHypotheticalFactor{
    1, -1, kKnotsPerMetreASecond, -kKnotsPerMetreASecond, 1 / kKnotsPerMetreASecond, -1 / kKnotsPerMetreASecond};
constexpr std::int64_t kFewest = 12;
/// So much nearer must another reading of the figures be.
constexpr double kClearly = 0.2;
constexpr double kTellingWind_kt = 4.0;

std::size_t bestOf(const std::array<double, 6>& sums)
{
    return static_cast<std::size_t>(std::min_element(sums.begin(), sums.end()) - sums.begin());
}

} // namespace

void WindSense::take(const WindReport& report, const double ground[2], const double wind[2], const double reference[2])
{
    ++m_count;
    // Along the track alone: across it the heading error stands in the reported wind.
    const auto sizeOf = [](double east, double north) { return std::sqrt(east * east + north * north); };
    const double speed = std::max(sizeOf(ground[0], ground[1]), 1e-9);
    const auto along = [&](double east, double north) { return (ground[0] * east + ground[1] * north) / speed; };
    const bool hasAirspeed = std::isfinite(report.tas_kt);
    m_triangles += hasAirspeed ? 1 : 0;
    for (std::size_t h = 0; h < kHypotheses; ++h) {
        const double east = kHypotheticalFactor[h] * wind[0], north = kHypotheticalFactor[h] * wind[1];
        if (hasAirspeed)
            m_triangle[h] += std::pow(report.tas_kt - sizeOf(ground[0] - east, ground[1] - north), 2);
        m_apart[h] += std::pow(along(reference[0] - east, reference[1] - north), 2);
    }
    for (std::size_t sense = 0; sense < 2; ++sense) {
        const double sign = sense == 0 ? -1.0 : 1.0;
        const double airspeed = sizeOf(ground[0] + sign * reference[0], ground[1] + sign * reference[1]);
        m_airspeed[sense] += airspeed;
        m_airspeedSquares[sense] += airspeed * airspeed;
    }
    m_reference += std::pow(along(reference[0], reference[1]), 2);
}

Message WindSense::fault() const
{
    const auto n = static_cast<double>(m_count);
    if (m_count < kFewest || m_reference < n * kTellingWind_kt * kTellingWind_kt)
        return {};
    const std::array<Pattern, 6> ofWind{MARKED("core", "the reported winds are not what their column says"),
        MARKED("core", "the reported winds fit when they are taken as blowing towards the direction given, and not from it"),
        MARKED("core", "the reported winds fit when they are taken as m/s, and not as knots"),
        MARKED("core", "the reported winds fit when they are taken as m/s and as blowing towards the direction given"),
        MARKED("core", "the reported winds fit when they are taken as twice too large (knots that were converted twice)"),
        MARKED("core", "the reported winds fit when they are taken as twice too large and as blowing towards the direction given")};
    if (m_triangles >= kFewest && 2 * m_triangles > m_count) {
        if (const std::size_t best = bestOf(m_triangle); best != 0 && m_triangle[best] < kClearly * m_triangle[0])
            return ofWind[best];
    }
    const std::array<Pattern, 6> ofReference{MARKED("core", "the reference winds are not what their column says"),
        MARKED("core", "reported and reference winds blow against each other: one of them is given as blowing towards, and not from"),
        MARKED("core", "the reported winds are half of the reference winds: one of them is in m/s, and not in knots"),
        MARKED("core", "reported and reference winds are in two units and blow against each other"),
        MARKED("core", "the reference winds are half of the reported winds: one of them is in m/s, and not in knots"),
        MARKED("core", "reported and reference winds are in two units and blow against each other")};
    if (const std::size_t best = bestOf(m_apart);
        best != 0 && m_apart[best] < kClearly * m_apart[0] && m_apart[best] < kClearly * m_reference)
        return ofReference[best];
    const auto spread = [&](std::size_t sense) { return m_airspeedSquares[sense] / n - std::pow(m_airspeed[sense] / n, 2); };
    constexpr std::int64_t kEnoughForSpread = 40;
    if (m_triangles == 0 && m_count >= kEnoughForSpread && spread(1) < kClearly * spread(0))
        return MARKED(
            "core", "airspeeds are far more even when both winds are taken as blowing towards the directions given, and not from them");
    return {};
}

} // namespace lubberline
