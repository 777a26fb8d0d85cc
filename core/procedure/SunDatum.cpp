#include "core/procedure/SunDatum.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>

#include "core/base/Number.h"

namespace lubberline {

bool needsSun(DatumKind kind) { return kind == DatumKind::ShadowPin; }

bool takesSun(DatumKind kind) { return needsSun(kind) || kind == DatumKind::Astrocompass; }

TrueHeading headingBySun(const SunPosition& sun, double bearing_deg, bool ofShadow)
{
    return TrueHeading::fromDegrees(sun.azimuth_deg + (ofShadow ? 180 : 0) - bearing_deg);
}

Result<SunHeading> sunHeading(const DatumInstrument& instrument, const RawFigures& raw, const Place& place, UtcTime time,
    std::optional<Variation> variation, const SunSighting& sighting)
{
    const SunPosition sun = sunAt(place, time);
    const ErrorBudget budget = sunBudget(place, time, sighting);
    SunDoubts doubts = doubtsOf(sun, time, budget);
    if (doubts.none)
        return Error{ErrorCode::InvalidInput, doubts.warnings.front()};
    DatumInstrument trueOne = instrument;
    trueOne.givesTrue = true;
    trueOne.ahead = SightingDirection::Direct;
    RawFigures headings = raw;
    if (needsSun(instrument.kind)) // an astrocompass shows the heading itself
        for (auto* figures : {&headings.datum_deg, &headings.astern_deg})
            for (double& figure : *figures)
                figure = headingBySun(sun, figure, true).degrees();
    auto heading = datumHeading(trueOne, headings, variation);
    if (!heading)
        return heading.error();
    heading->uncertainty_deg = std::hypot(heading->uncertainty_deg, budget.total_deg());
    return SunHeading{std::move(*heading), std::move(doubts.warnings)};
}

double hourInA_deg(const Place& place, std::span<const UtcTime> times, int hours)
{
    double sum = 0;
    for (const UtcTime time : times)
        sum += wrap180(sunAt(place, time).azimuth_deg - sunAt(place, time - std::chrono::hours(hours)).azimuth_deg);
    return times.empty() ? 0 : sum / static_cast<double>(times.size());
}

Message hourDoubt(const Place& place, std::span<const UtcTime> times, double A_deg)
{
    for (const int hours : {1, -1}) {
        const double hour = hourInA_deg(place, times, hours);
        if (std::abs(hour) > 6 && std::abs(wrap180(A_deg - hour)) < std::max(2.0, 0.2 * std::abs(hour)))
            return {hours > 0
                    ? MARKED("core", "A is %1°: a clock an hour fast makes %2° of it here; look whether it shows daylight saving")
                    : MARKED("core", "A is %1°: a clock an hour slow makes %2° of it here; look whether it shows daylight saving"),
                signedFigureText(A_deg, 1), signedFigureText(hour, 1)};
    }
    return {};
}

Message hourDoubt(const SwingJob& job, const JobState& state, const Place& place)
{
    if (!takesSun(state.datum.kind))
        return {};
    std::map<int, UtcTime> taken; // the last of a station counts
    for (const JobEvent& event : job.events)
        if (const auto* reading = std::get_if<job::ReadingTaken>(&event.what))
            if (const auto time = readUtcTime(event.timeUtc))
                taken[reading->station] = *time;
    std::vector<UtcTime> times;
    std::complex<double> around;
    double first_deg = 0, sum_deg = 0;
    for (const auto& [station, time] : taken) {
        const auto& reading = state.stations[static_cast<std::size_t>(station)].reading;
        if (!reading)
            continue;
        const double deviation = deviationOf(reading->magnetic, reading->compass).degrees();
        if (times.empty())
            first_deg = deviation;
        sum_deg += wrap180(deviation - first_deg);
        around += std::polar(1.0, toRadians(reading->compass.degrees()));
        times.push_back(time);
    }
    const auto count = static_cast<double>(times.size());
    if (times.size() < 4 || std::abs(around) > 0.3 * count) // else B or C stands in the mean
        return {};
    return hourDoubt(place, times, wrap180(first_deg + sum_deg / count));
}

} // namespace lubberline
