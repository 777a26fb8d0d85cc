#include "core/procedure/SunDatum.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <complex>
#include <map>

#include "core/base/Number.h"
#include "core/earth/VariationError.h"
#include "core/reference/Alignment.h"
#include "core/swing/SharedDoubts.h"

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

SharedErrors sharedBySun(const Place& place, std::span<const TakenHeading> headings, const SunSighting& sighting, double variationError_deg)
{
    std::vector<CompassHeading> compass;
    SharedDoubt clock, position, leanAhead, leanRight, variation, runway, setting, drift;
    for (const TakenHeading& taken : headings) {
        compass.push_back(taken.compass);
        variation.push_back(taken.fromTrue ? variationError_deg : 0);
        runway.push_back(taken.runway_deg);
        setting.push_back(taken.setting_deg);
        drift.push_back(taken.drift_deg);
        if (!taken.bySun) {
            for (SharedDoubt* doubt : {&clock, &position, &leanAhead, &leanRight})
                doubt->push_back(0);
            continue;
        }
        const SunPosition sun = sunAt(place, *taken.bySun);
        const SunShares shares = sunShares(place, *taken.bySun, sighting);
        const double fromNose = toRadians(sun.azimuth_deg - taken.heading.degrees());
        clock.push_back(std::copysign(shares.clock_deg, sun.azimuthRate_deg_min));
        position.push_back(shares.position_deg);
        leanAhead.push_back(shares.plumb_deg * std::sin(fromNose)); // across the sun is what turns a shadow
        leanRight.push_back(shares.plumb_deg * std::cos(fromNose));
    }
    return sharedErrorsOf(compass, std::vector{clock, position, leanAhead, leanRight, variation, runway, setting, drift});
}

namespace {

/// Whether that variation was taken from the model: it is what the model says there and then.
double errorOfVariation_deg(const Swing& swing, const Place& place)
{
    constexpr double kSame_deg = 0.05;
    const auto model = swing.date.empty() ? Result<FieldModel>(Error{}) : defaultFieldModel(yearOf(swing.date));
    const auto answer = model ? model->evaluate(place, yearOf(swing.date)) : Result<FieldAnswer>(Error{});
    if (!answer || !swing.variation_deg || std::abs(wrap180(*swing.variation_deg - answer->field.variation().degrees())) > kSame_deg)
        return 0;
    return variationError_deg(*answer);
}

struct DatumInUse {
    const DatumInstrument* instrument;
    std::optional<UtcTime> since; ///< of the first reading by it
    RawFigures raw;               ///< of this reading
};

/// A direction in whole tens is the runway's designator, which names it to ten degrees.
double runwayError_deg(const RawFigures& raw)
{
    constexpr double kOfDesignator_deg = 3; // ± 5°, evenly: 10/√12
    const auto& figures = raw.datum_deg;
    const bool tens = !figures.empty() && std::ranges::all_of(figures, [](double figure) { return std::fmod(figure, 10.0) == 0; });
    return tens ? kOfDesignator_deg : RunwayAlignment().published_deg;
}

} // namespace

SharedErrors sharedErrorsOf(const SwingJob& job, const Swing& swing, const std::optional<Place>& place)
{
    std::map<std::string, DatumInUse> datumAt; // by the time of the reading
    DatumInUse datum{&job.datum, {}, {}};
    for (const JobEvent& event : job.events) {
        if (const auto* changed = std::get_if<job::DatumChanged>(&event.what)) {
            datum = {&changed->datum, {}, {}};
        } else if (const auto* reading = std::get_if<job::ReadingTaken>(&event.what)) {
            if (const auto time = readUtcTime(event.timeUtc); time && !datum.since)
                datum.since = *time;
            datum.raw = reading->raw;
            datumAt[event.timeUtc] = datum;
        }
    }
    const Variation variation = Variation::fromDegrees(swing.variation_deg.value_or(0));
    std::vector<TakenHeading> headings;
    for (const Reading& reading : swing.readings) {
        const auto found = datumAt.find(reading.timeUtc);
        if (!reading.used() || found == datumAt.end())
            continue;
        const auto time = readUtcTime(reading.timeUtc);
        const DatumInstrument& instrument = *found->second.instrument;
        const bool bySun = place && takesSun(instrument.kind) && time;
        TakenHeading taken{toTrue(*reading.magnetic, variation), *reading.compass, bySun ? std::optional(*time) : std::nullopt,
            bySun || instrument.givesTrue};
        if (instrument.kind == DatumKind::Runway)
            taken.runway_deg = runwayError_deg(found->second.raw);
        if (instrument.kind == DatumKind::TransferGyro) {
            const TransferGyro common;
            taken.setting_deg = common.setting_deg;
            const double read_min
                = found->second.since && time ? std::chrono::duration<double, std::ratio<60>>(*time - *found->second.since).count() : 0;
            taken.drift_deg = common.drift_deg_h * (common.minutes + std::max(0.0, read_min)) / 60;
        }
        headings.push_back(taken);
    }
    return sharedBySun(place.value_or(Place{}), headings, {}, place ? errorOfVariation_deg(swing, *place) : 0);
}

double hourInA_deg(const Place& place, std::span<const UtcTime> times, int hours)
{
    double sum = 0;
    for (const UtcTime time : times)
        sum += wrap180(sunAt(place, time).azimuth_deg - sunAt(place, time - std::chrono::hours(hours)).azimuth_deg);
    return times.empty() ? 0 : sum / static_cast<double>(times.size());
}

namespace {

/// What the sun's azimuth is wrong by, on the mean, where the place is this one and another was given [deg].
double elsewhereInA_deg(const Place& given, const Place& place, std::span<const UtcTime> times)
{
    double sum = 0;
    for (const UtcTime time : times)
        sum += wrap180(sunAt(given, time).azimuth_deg - sunAt(place, time).azimuth_deg);
    return times.empty() ? 0 : sum / static_cast<double>(times.size());
}

/// An A that something would make, by its size: two degrees or a fifth of it are what a compass may have besides.
bool looksLike(double A_deg, double made_deg)
{
    return std::abs(made_deg) > 6 && std::abs(wrap180(A_deg - made_deg)) < std::max(2.0, 0.2 * std::abs(made_deg));
}

} // namespace

Message sunDoubt(const Place& place, std::span<const UtcTime> times, double A_deg)
{
    for (const int hours : {1, -1})
        if (const double hour = hourInA_deg(place, times, hours); looksLike(A_deg, hour))
            return {hours > 0
                    ? MARKED("core", "A is %1°: a clock an hour fast makes %2° of it here; look whether it shows daylight saving")
                    : MARKED("core", "A is %1°: a clock an hour slow makes %2° of it here; look whether it shows daylight saving"),
                signedFigureText(A_deg, 1), signedFigureText(hour, 1)};
    constexpr double kOtherSide_deg = 150;
    if (std::abs(A_deg) > kOtherSide_deg)
        return {
            MARKED("core",
                "A is %1°: bearings of the sun that stand where those of its shadow are expected, or the reverse, make 180° of it; else "
                "the compass was read from its other side"),
            signedFigureText(A_deg, 1)};
    Place mirrored = place;
    mirrored.longitude_deg = -place.longitude_deg;
    if (const double made = elsewhereInA_deg(place, mirrored, times); looksLike(A_deg, made))
        return {MARKED("core", "A is %1°: a longitude of the other sign (%2° for %3°) makes %4° of it; east is positive"),
            signedFigureText(A_deg, 1), signedFigureText(place.longitude_deg, 1), signedFigureText(mirrored.longitude_deg, 1),
            signedFigureText(made, 1)};
    return {};
}

Message sunDoubt(const SwingJob& job, const JobState& state, const Place& place)
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
    return sunDoubt(place, times, wrap180(first_deg + sum_deg / count));
}

} // namespace lubberline
