#include "core/deviation/Correction.h"

#include <cmath>
#include <string>

#include "core/deviation/PointRules.h"
#include "core/deviation/SmithFit.h"
#include "core/deviation/SmithRows.h"

namespace lubberline {

namespace {

constexpr std::array kCardinals{Cardinal::N, Cardinal::E, Cardinal::S, Cardinal::W};

double headingOf_deg(Cardinal cardinal) { return 90.0 * static_cast<double>(cardinal); }

Result<Observation> readingOn(std::span<const Observation> readings, Cardinal cardinal)
{
    const Observation* nearest = nullptr;
    double nearest_deg = kPointTolerance_deg;
    for (const auto& reading : readings) {
        const double distance_deg = std::abs(wrap180(reading.magnetic.degrees() - headingOf_deg(cardinal)));
        if (distance_deg < nearest_deg || (!nearest && distance_deg <= nearest_deg)) {
            nearest = &reading;
            nearest_deg = distance_deg;
        }
    }
    if (nearest)
        return *nearest;
    return Error{ErrorCode::InvalidInput,
        {MARKED("core", "no reading on %1 (within 11.25° of magnetic heading %2°); a correction needs readings on N, E, S and W"),
            letterOf(cardinal), static_cast<int>(headingOf_deg(cardinal))}};
}

/// The term is added to what the compass reads now: (reading) + B sin ψ or C cos ψ at the cardinal, that is ± the coefficient.
CorrectionStep stepFor(Coefficient coefficient, Cardinal on, const Observation& reading, double coefficient_deg)
{
    const double sign = on == Cardinal::N || on == Cardinal::E ? 1.0 : -1.0;
    return {coefficient, on, reading.magnetic, reading.compass,
        CompassHeading::fromDegrees(reading.compass.degrees() + sign * coefficient_deg)};
}

} // namespace

char letterOf(Cardinal cardinal) { return "NESW"[static_cast<int>(cardinal)]; }

Result<Correction> correctionSteps(std::span<const Observation> readings)
{
    std::array<Observation, 4> on;
    std::array<double, 4> deviation_deg{};
    const double index_deg = largeIndex_deg(readings);
    for (const Cardinal cardinal : kCardinals) {
        const auto reading = readingOn(readings, cardinal);
        if (!reading)
            return reading.error();
        const auto i = static_cast<std::size_t>(cardinal);
        on[i] = *reading;
        deviation_deg[i] = aboutIndex_deg(*reading, index_deg);
    }
    const auto [n, e, s, w] = deviation_deg;
    const double A_deg = (n + e + s + w) / 4, B_deg = (e - w) / 2, C_deg = (n - s) / 2;
    Correction correction;
    correction.A_rad = toRadians(A_deg);
    correction.B_rad = toRadians(B_deg);
    correction.C_rad = toRadians(C_deg);
    correction.steps = {stepFor(Coefficient::C, Cardinal::N, on[0], C_deg), stepFor(Coefficient::C, Cardinal::S, on[2], C_deg),
        stepFor(Coefficient::B, Cardinal::E, on[1], B_deg), stepFor(Coefficient::B, Cardinal::W, on[3], B_deg)};
    return correction;
}

} // namespace lubberline
