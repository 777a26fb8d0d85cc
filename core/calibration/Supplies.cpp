// What a line of a spectrum may come from.
#include <algorithm>

#include "core/base/Number.h"
#include "core/calibration/Spectrum.h"

namespace lubberline {

namespace {

/// Mains stay within 0.05 Hz nearly always, within 0.2 Hz in ordinary running, and leave 0.5 Hz in emergencies only (ENTSO-E, EN 50160);
/// generators of 400 Hz keep it to one or two parts in a hundred.
struct Supply {
    double frequency_hz;
    Pattern name;
    double usually_hz, kept_hz, most_hz;
};
constexpr std::array<Supply, 4> kSupplies{
    {{50, MARKED("core", "mains 50 Hz"), 0.05, 0.2, 0.5}, {60, MARKED("core", "mains 60 Hz"), 0.05, 0.2, 0.5},
        {400, MARKED("core", "aircraft supply 400 Hz"), 0, 0, 8}, {115, MARKED("core", "115 Hz"), 0, 0, 0}}};
constexpr double kClock = 1e-4;                            ///< of the clock that a log's times come from
constexpr std::array<int, 6> kHarmonics{1, 3, 5, 7, 9, 2}; // odd ones of rectifiers and gas lamps; twice, of magnetisation

struct FoundFrequency {
    double frequency_hz = 0, within_hz = 0;
};

Message supplyName(const Supply& supply, int harmonic)
{
    if (harmonic == 1)
        return {supply.name};
    return {MARKED("core", "harmonic %1 of %2"), harmonic, supply.name};
}

/// A line is a supply's where it may lie within what the supply keeps to. A harmonic goes off with its order, but mains seldom by more than
/// 0.05 Hz at once; were every harmonic given the whole of it, half of all frequencies would have a name.
double kept_hz(const Supply& supply, int harmonic) { return harmonic == 1 ? supply.kept_hz : supply.usually_hz * harmonic; }

/// The frequencies next to a source's that sampling puts where a line stands: one below a multiple of the rate, one above; often only one is
/// near, but on zero both are alike.
std::array<double, 2> sourcesOf_hz(double line_hz, double source_hz, double rate_hz)
{
    const auto near = [&](double side) { return side * line_hz + rate_hz * std::round((source_hz - side * line_hz) / rate_hz); };
    return {near(-1), near(1)};
}

/// The supplies of the lowest harmonic that has any which falls there; those that stand as they are, or those that sampling folded.
std::vector<LineSource> suppliesAt(const FoundFrequency& at, bool folded, double rate_hz)
{
    std::vector<LineSource> found;
    for (const int harmonic : kHarmonics) {
        for (const auto& supply : kSupplies) {
            const double frequency = supply.frequency_hz * harmonic;
            const double apart_hz = at.within_hz + kClock * frequency + kept_hz(supply, harmonic);
            const auto places = sourcesOf_hz(at.frequency_hz, frequency, rate_hz);
            if (std::any_of(places.begin(), places.end(), [&](double there) {
                    return (there > rate_hz / 2 + at.within_hz) == folded && std::abs(there - frequency) <= apart_hz;
                }))
                found.push_back({supplyName(supply, harmonic), folded ? std::optional(frequency) : std::nullopt, true});
        }
        if (!found.empty())
            break;
    }
    return found;
}

/// Supplies that may go this far off, though they seldom do.
void addFarSupplies(std::vector<LineSource>& sources, const FoundFrequency& at, bool folded, double rate_hz)
{
    for (const auto& supply : kSupplies) {
        const bool named = std::any_of(
            sources.begin(), sources.end(), [&](const LineSource& one) { return one.name.english() == Message(supply.name).english(); });
        if (named || supply.most_hz == 0)
            continue;
        const auto places = sourcesOf_hz(at.frequency_hz, supply.frequency_hz, rate_hz);
        const double nearest = std::min(std::abs(places[0] - supply.frequency_hz), std::abs(places[1] - supply.frequency_hz));
        double before = 0;
        for (const double there : places) {
            const double off = std::abs(there - supply.frequency_hz);
            if ((there > rate_hz / 2 + at.within_hz) != folded || off > supply.most_hz + at.within_hz || off > nearest + 2 * at.within_hz
                || std::abs(there - before) <= at.within_hz)
                continue;
            before = there;
            sources.push_back({{MARKED("core", "perhaps %1 at %2 Hz"), Message(supply.name), figureText(there, 1)},
                folded ? std::optional(there) : std::nullopt});
        }
    }
}

} // namespace

void nameLine(SpectralLine& line, double rate_hz, double within_hz)
{
    const FoundFrequency at{line.frequency_hz, within_hz};
    for (const bool folded : {false, true}) {
        line.sources = suppliesAt(at, folded, rate_hz);
        if (line.sources.empty() || folded)
            addFarSupplies(line.sources, at, folded, rate_hz);
        if (!line.sources.empty())
            break;
    }
    line.source = line.sources.empty() ? Message{MARKED("core", "not known")} : line.sources.front().name;
    for (std::size_t i = 1; i < line.sources.size(); ++i)
        line.source = {MARKED("core", "%1 or %2"), line.source, line.sources[i].name};
    if (!line.sources.empty())
        line.aliasOf_hz = line.sources.front().aliasOf_hz;
}

double aliasOf_hz(double frequency_hz, double rate_hz) { return std::abs(frequency_hz - rate_hz * std::round(frequency_hz / rate_hz)); }

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
