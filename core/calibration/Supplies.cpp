// What a supply's field looks like in a log: as it stands, or where sampling folds it to.

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/Number.h"
#include "core/calibration/Spectrum.h"

namespace lubberline {

namespace {

struct Supply {
    double frequency_hz;
    Pattern name;
};
constexpr std::array<Supply, 4> kSupplies{{{50, MARKED("core", "mains 50 Hz")}, {60, MARKED("core", "mains 60 Hz")},
    {400, MARKED("core", "aircraft supply 400 Hz")}, {115, MARKED("core", "115 Hz")}}};
constexpr std::array<int, 6> kHarmonics{1, 3, 5, 7, 9, 2}; // odd ones of rectifiers and gas lamps; twice, of magnetisation

Message supplyName(const Supply& supply, int harmonic)
{
    if (harmonic == 1)
        return {supply.name};
    return {MARKED("core", "harmonic %1 of %2"), harmonic, supply.name};
}

/// Generators of 400 Hz keep it to one or two parts in a hundred.
constexpr double kAircraftSupply_hz = 400, kKept = 0.02;

/// The frequency next to 400 Hz that sampling folds to a line; none within what such a supply keeps.
std::optional<double> nearAircraftSupply_hz(double frequency_hz, double rate_hz)
{
    std::optional<double> best;
    for (const double side : {-1.0, 1.0}) {
        const double near = frequency_hz * side + rate_hz * std::round((kAircraftSupply_hz - frequency_hz * side) / rate_hz);
        if (near > rate_hz / 2 && std::abs(near - kAircraftSupply_hz) <= kKept * kAircraftSupply_hz
            && (!best || std::abs(near - kAircraftSupply_hz) < std::abs(*best - kAircraftSupply_hz) - 1e-6))
            best = near;
    }
    return best;
}

} // namespace

double aliasOf_hz(double frequency_hz, double rate_hz) { return std::abs(frequency_hz - rate_hz * std::round(frequency_hz / rate_hz)); }

std::vector<LineSource> suppliesAt(double frequency_hz, bool folded, double rate_hz, double within_hz)
{
    std::vector<LineSource> found;
    for (const int harmonic : kHarmonics) {
        for (const auto& supply : kSupplies) {
            const double frequency = supply.frequency_hz * harmonic;
            if ((frequency > rate_hz / 2) == folded && std::abs(aliasOf_hz(frequency, rate_hz) - frequency_hz) <= within_hz)
                found.push_back({supplyName(supply, harmonic), folded ? std::optional(frequency) : std::nullopt});
        }
        if (!found.empty())
            break;
    }
    return found;
}

void nameLine(SpectralLine& line, double rate_hz, double within_hz)
{
    line.sources = suppliesAt(line.frequency_hz, false, rate_hz, within_hz);
    if (line.sources.empty()) {
        line.sources = suppliesAt(line.frequency_hz, true, rate_hz, within_hz);
        const auto near_hz = nearAircraftSupply_hz(line.frequency_hz, rate_hz);
        const bool named = std::any_of(line.sources.begin(), line.sources.end(),
            [](const LineSource& one) { return one.aliasOf_hz && *one.aliasOf_hz == kAircraftSupply_hz; });
        if (near_hz && !named)
            line.sources.push_back({{MARKED("core", "perhaps aircraft supply 400 Hz at %1 Hz"), figureText(*near_hz, 1)}, *near_hz});
    }
    line.source = line.sources.empty() ? Message{MARKED("core", "not known")} : line.sources.front().name;
    for (std::size_t i = 1; i < line.sources.size(); ++i)
        line.source = {MARKED("core", "%1 or %2"), line.source, line.sources[i].name};
    if (!line.sources.empty())
        line.aliasOf_hz = line.sources.front().aliasOf_hz;
}

std::vector<double> suppliesOnZero_hz(double rate_hz, double within_hz)
{
    std::vector<double> found;
    for (const auto& supply : kSupplies)
        for (const int harmonic : {1, 3, 5})
            if (aliasOf_hz(supply.frequency_hz * harmonic, rate_hz) <= within_hz)
                found.push_back(supply.frequency_hz * harmonic);
    std::sort(found.begin(), found.end());
    return found;
}

Message warningOfZero(double rate_hz, double within_hz)
{
    std::string names;
    for (const double frequency : suppliesOnZero_hz(rate_hz, within_hz))
        names += (names.empty() ? "" : ", ") + figureText(frequency, 0);
    if (names.empty())
        return {};
    return {
        MARKED("core",
            "at %1 samples a second %2 Hz fall on 0 Hz: the field of such a supply would look like hard iron; calibrate with it off, or log at another rate"),
        figureText(rate_hz, 1), names};
}

Message warningOfSlow(double rate_hz, double from_hz)
{
    constexpr double kSlow_hz = 0.5, kOfRate = 0.02;
    std::string names, at;
    for (const double frequency : suppliesOnZero_hz(rate_hz, std::min(kSlow_hz, kOfRate * rate_hz)))
        if (const double folded = aliasOf_hz(frequency, rate_hz); folded > from_hz) {
            names += (names.empty() ? "" : ", ") + figureText(frequency, 0);
            at += (at.empty() ? "" : ", ") + figureText(folded, 2);
        }
    if (names.empty())
        return {};
    return {
        MARKED("core",
            "at %1 samples a second %2 Hz fall on %3 Hz: the field of such a supply would look like hard iron that drifts; calibrate with it off, or log at another rate"),
        figureText(rate_hz, 2), names, at};
}

} // namespace lubberline
