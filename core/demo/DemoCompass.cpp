#include "core/demo/DemoCompass.h"

#include <algorithm>
#include <cmath>

namespace lubberline {

namespace {

/// Landing compasses and theodolites are read to half a degree.
constexpr double kDatumResolution_deg = 0.5;

double roundedTo(double angle_deg, double resolution_deg) { return std::round(angle_deg / resolution_deg) * resolution_deg; }

ExactSmith exactOf(const std::array<double, 5>& coefficient_deg)
{
    return toExact(ApproximateSmith{toRadians(coefficient_deg[0]), toRadians(coefficient_deg[1]), toRadians(coefficient_deg[2]),
        toRadians(coefficient_deg[3]), toRadians(coefficient_deg[4])});
}

} // namespace

DemoMagnetism::DemoMagnetism(const DemoCompassKind& kind, DemoRandom& random)
    : m_kind(kind)
    , m_random(random)
    , m_coefficient_deg(kind.typical_deg)
{
    for (std::size_t i = 0; i < m_coefficient_deg.size(); ++i) {
        const bool hardIron = i == 1 || i == 2;
        m_coefficient_deg[i] += random.normal(hardIron ? kind.scatter_deg : kind.scatter_deg / 3);
    }
    for (double& drift_deg : m_drift_deg)
        drift_deg = random.normal(kind.scatter_deg / 3);
}

void DemoMagnetism::ageOneYear()
{
    for (std::size_t i = 0; i < m_drift_deg.size(); ++i)
        m_coefficient_deg[i + 1] += m_drift_deg[i] + m_random.normal(m_kind.scatter_deg / 6);
}

void DemoMagnetism::strike(double size_deg)
{
    // Away from zero, so that the jump shows whatever was there before.
    m_coefficient_deg[1] += std::copysign(size_deg, m_coefficient_deg[1]);
    m_coefficient_deg[2] += std::copysign(size_deg * 0.4, m_coefficient_deg[2]);
}

void DemoMagnetism::compensate()
{
    m_coefficient_deg[0] *= 0.3;
    m_coefficient_deg[1] *= 0.15;
    m_coefficient_deg[2] *= 0.15;
}

std::vector<Reading> DemoMagnetism::read(int points, double spread_deg)
{
    const ExactSmith smith = exactOf(m_coefficient_deg);
    std::vector<Reading> readings;
    for (int i = 0; i < points; ++i) {
        Reading reading;
        reading.nominal_deg = 360.0 * i / points;
        const double actual_deg = *reading.nominal_deg + m_random.between(-spread_deg, spread_deg);
        reading.magnetic = MagneticHeading::fromDegrees(roundedTo(actual_deg, kDatumResolution_deg));
        const auto shown = toCompass(*reading.magnetic, deviationAt(smith, *reading.magnetic));
        reading.compass
            = CompassHeading::fromDegrees(roundedTo(shown.degrees() + m_random.normal(m_kind.noise_deg), m_kind.resolution_deg));
        readings.push_back(reading);
    }
    return readings;
}

double largestDeviation_deg(const std::vector<Reading>& readings)
{
    double largest_deg = 0;
    for (const auto& reading : readings)
        if (reading.complete())
            largest_deg = std::max(largest_deg, std::abs(deviationOf(*reading.magnetic, *reading.compass).degrees()));
    return largest_deg;
}

} // namespace lubberline
