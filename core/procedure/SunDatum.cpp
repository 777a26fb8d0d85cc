#include "core/procedure/SunDatum.h"

#include <algorithm>
#include <cmath>

#include "core/base/Number.h"

namespace lubberline {

bool needsSun(DatumKind kind) { return kind == DatumKind::ShadowPin; }

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

} // namespace lubberline
