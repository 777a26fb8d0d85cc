#include "core/procedure/StationCoefficients.h"

#include <cmath>
#include <vector>

#include "core/deviation/SmithFit.h"

namespace lubberline {

namespace {

double deviation_deg(const Observation& reading) { return deviationOf(reading.magnetic, reading.compass).degrees(); }

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
        return north && south ? std::optional((*north - *south) / 2.0) : std::nullopt;
    if (control == Control::EastWest)
        return east && west ? std::optional((*east - *west) / 2.0) : std::nullopt;
    return north && east && south && west ? std::optional((*north + *east + *south + *west) / 4.0) : std::nullopt;
}

std::optional<double> checkIndex_deg(std::span<const StationState> stations)
{
    std::vector<Observation> readings;
    double cardinals = 0.0;
    int count = 0;
    for (const auto& station : stations) {
        if (station.station.phase != StationPhase::Check || !station.reading)
            continue;
        readings.push_back(*station.reading);
        if (std::fmod(station.station.nominal_deg, 90.0) == 0.0)
            cardinals += deviation_deg(*station.reading), ++count;
    }
    if (count == 4)
        return cardinals / 4.0;
    const auto fit = fitApproximate(readings);
    if (!fit || !fit->of(Coefficient::A))
        return {};
    return toDegrees(*fit->of(Coefficient::A));
}

} // namespace lubberline
