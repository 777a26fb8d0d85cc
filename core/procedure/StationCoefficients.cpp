#include "core/procedure/StationCoefficients.h"

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "core/deviation/SmithFit.h"

namespace lubberline {

namespace {

double deviation_deg(const Observation& reading) { return deviationOf(reading.magnetic, reading.compass).degrees(); }

/// Also of a compass that reads the reciprocal, whose deviations lie on both sides of ±180°.
double meanAround_deg(std::span<const double> deviations_deg)
{
    double beyond = 0;
    for (const double each : deviations_deg)
        beyond += wrap180(each - deviations_deg.front());
    return wrap180(deviations_deg.front() + beyond / static_cast<double>(deviations_deg.size()));
}

/// The deviation that was read on a cardinal before its controls were turned.
std::optional<double> cardinal_deg(std::span<const StationState> stations, double nominal_deg)
{
    for (const auto& station : stations)
        if (station.station.phase == StationPhase::AsFound && station.station.nominal_deg == nominal_deg && station.reading)
            return deviation_deg(*station.reading);
    return {};
}

} // namespace

std::optional<double> classicalCoefficient_deg(std::span<const StationState> stations, Control control)
{
    const auto north = cardinal_deg(stations, 0), east = cardinal_deg(stations, 90), south = cardinal_deg(stations, 180),
               west = cardinal_deg(stations, 270);
    if (control == Control::NorthSouth)
        return north && south ? std::optional(wrap180(*north - *south) / 2.0) : std::nullopt;
    if (control == Control::EastWest)
        return east && west ? std::optional(wrap180(*east - *west) / 2.0) : std::nullopt;
    if (!north || !east || !south || !west)
        return std::nullopt;
    return meanAround_deg(std::array{*north, *east, *south, *west});
}

std::optional<double> checkIndex_deg(std::span<const StationState> stations)
{
    std::vector<Observation> readings;
    std::vector<double> cardinals_deg;
    for (const auto& station : stations) {
        if (station.station.phase != StationPhase::Check || !station.reading)
            continue;
        readings.push_back(*station.reading);
        if (std::fmod(station.station.nominal_deg, 90.0) == 0.0)
            cardinals_deg.push_back(deviation_deg(*station.reading));
    }
    if (cardinals_deg.size() == 4)
        return meanAround_deg(cardinals_deg);
    const auto fit = fitApproximate(readings);
    if (!fit || !fit->of(Coefficient::A))
        return {};
    return toDegrees(*fit->of(Coefficient::A));
}

} // namespace lubberline
