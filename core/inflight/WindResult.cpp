#include <algorithm>
#include <cmath>

#include "core/angle/Angle.h"
#include "core/base/Alongside.h"
#include "core/base/Number.h"
#include "core/fleet/Proportion.h"
#include "core/inflight/WindStudy.h"
#include "core/inflight/WindStudyParts.h"

namespace lubberline {

namespace {

constexpr double kChangesKept = 0.05; ///< false discoveries among the aircraft that are said to have changed
constexpr double kSecondChange = 0.01;
constexpr std::size_t kLeastBetweenChanges = 2;

WindRow rowAt(double heading_deg)
{
    const double heading = toRadians(heading_deg);
    WindRow row;
    row << 1.0, std::sin(heading), std::cos(heading), std::sin(2 * heading), std::cos(2 * heading);
    return row;
}

std::vector<FlightTold> toldBy(std::span<const FlightSums* const> flights, double scatter, const SharedError& shared, int columns)
{
    std::vector<FlightTold> told;
    told.reserve(flights.size());
    for (const FlightSums* flight : flights)
        told.push_back(toldByFlight(*flight, scatter, shared, columns));
    return told;
}

FlightSums together(std::span<const FlightSums* const> flights)
{
    FlightSums sum;
    for (const FlightSums* flight : flights)
        sum += *flight;
    return sum;
}

/// Mean over flights, with the error of the means of flights.
void airspeedOffset(std::span<const FlightSums* const> flights, AircraftWinds& result)
{
    double sum = 0, count = 0, squares = 0;
    for (const FlightSums* flight : flights) {
        sum += flight->airspeedOffset;
        count += static_cast<double>(flight->count);
    }
    if (count == 0)
        return;
    result.airspeedOffset_kt = sum / count;
    const auto n = static_cast<double>(flights.size());
    for (const FlightSums* flight : flights)
        squares += std::pow(flight->airspeedOffset - static_cast<double>(flight->count) * *result.airspeedOffset_kt, 2);
    if (n > 1)
        result.airspeedOffsetError_kt = std::sqrt(squares * n / (n - 1)) / count;
}

/// The places of changes within flights [from, to), found one inside the other.
void changesWithin(std::span<const FlightSums* const> flights, std::size_t from, double scatter, const SharedError& shared, double limit,
    std::vector<std::pair<std::size_t, WindChange>>& found)
{
    const auto told = toldBy(flights, scatter, shared, 3);
    const ClusteredFit fit = fitFlights(told, together(flights), 3, true);
    const auto change = largestChange(told, fit, shared.freedom);
    if (!change || change->p > limit)
        return;
    found.emplace_back(from + change->after, *change);
    const std::size_t split = change->after + 1;
    if (split > kLeastBetweenChanges)
        changesWithin(flights.first(split), from, scatter, shared, kSecondChange, found);
    if (flights.size() - split > kLeastBetweenChanges)
        changesWithin(flights.subspan(split), from + split, scatter, shared, kSecondChange, found);
}

/// Errors that were counted from 0° to 360°, as they are told.
void takeOffATurn(AircraftWinds& result)
{
    if (result.fit.fit.value(0) <= 180.0)
        return;
    for (ClusteredFit* fit : {&result.fit.fit, &result.secondOrder})
        fit->value(0) -= fit->told[0] ? 360.0 : 0.0;
    if (result.beforeChange && result.beforeChange->told[0])
        result.beforeChange->value(0) -= 360.0;
    for (auto& sector : result.sectors)
        if (sector.count > 0)
            sector.error_deg -= 360.0;
    for (auto& dot : result.dots)
        dot.error_deg -= 360.0;
}

std::string flightName(const std::string& name, std::size_t place) { return name.empty() ? "#" + std::to_string(place + 1) : name; }

/// Of flights, one after the other: what their winds are on the reference's.
struct WindGain {
    double on = 0, squares = 0;
    std::int64_t count = 0, flights = 0;
    void add(const FlightSums& flight)
    {
        on += flight.windOnReference;
        squares += flight.referenceSquares;
        count += flight.count;
        ++flights;
    }
    [[nodiscard]] double value() const { return on / squares; } ///< 1 where both have one unit
    [[nodiscard]] bool told() const
    {
        constexpr double kReference_kt = 7;                 // ahead
        constexpr std::int64_t kReports = 60, kFlights = 3; // the reference's own error is one for a flight
        return count >= kReports && flights >= kFlights && on > 0 && squares >= kReference_kt * kReference_kt * static_cast<double>(count);
    }
};

struct UnitChange {
    std::size_t after = 0; ///< the last flight before it
    double factor = 1;
};

/// Knots against metres a second: where the winds' size on the reference's changes most, and by that factor.
std::optional<UnitChange> unitChange(std::span<const FlightSums* const> flights)
{
    constexpr double kKnotsInMetres = 1.9438445, kWithin = 0.15;
    WindGain all, before;
    for (const FlightSums* flight : flights)
        all.add(*flight);
    UnitChange most;
    for (std::size_t after = 0; after + 1 < flights.size(); ++after) {
        before.add(*flights[after]);
        const WindGain since{all.on - before.on, all.squares - before.squares, all.count - before.count, all.flights - before.flights};
        if (!before.told() || !since.told())
            continue;
        if (const double factor = since.value() / before.value(); std::abs(std::log(factor)) > std::abs(std::log(most.factor)))
            most = {after, factor};
    }
    return std::abs(std::abs(std::log(most.factor)) - std::log(kKnotsInMetres)) < kWithin ? std::optional(most) : std::nullopt;
}

} // namespace

double tableFactor(TableFactor which, int order)
{
    const double x = kPi / 8.0 * order;
    switch (which) {
    case TableFactor::Paper: return order == 1 ? 1.05 : 1.0;
    case TableFactor::Exact: return std::pow(x / std::sin(x), 2);
    case TableFactor::None: return 1.0;
    }
    return 1.0;
}

Message wordsFor(LeftOut why)
{
    switch (why) {
    case LeftOut::NoReference: return MARKED("core", "no reference wind");
    case LeftOut::NoWind: return MARKED("core", "no wind of its own, and no heading with airspeed");
    case LeftOut::Rolling: return MARKED("core", "rolling");
    case LeftOut::Climbing: return MARKED("core", "climbing or descending");
    case LeftOut::Turning: return MARKED("core", "turning");
    case LeftOut::Slow: return MARKED("core", "airspeed too low");
    case LeftOut::Duplicate: return MARKED("core", "the same report again");
    }
    return {};
}

double AircraftWinds::size_deg() const { return std::hypot(fit.fit.value(1), fit.fit.value(2)) + std::abs(fit.fit.value(0)); }

double AircraftWinds::errorAt_deg(double heading_deg) const { return fit.fit.value.dot(rowAt(heading_deg)); }

std::array<double, 8> AircraftWinds::table_deg(TableFactor factor) const
{
    std::array<double, 8> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        WindRow row = rowAt(45.0 * static_cast<double>(i));
        row.segment<2>(1) *= tableFactor(factor, 1);
        row.tail<2>() *= tableFactor(factor, 2);
        table[i] = -fit.fit.value.dot(row) + 0.0;
    }
    return table;
}

double CommonSine::asWind_kt() const { return toRadians(std::hypot(value_deg(1), value_deg(2))) * airspeed_kt; }

/// Flights with reports that are used, in order of time.
std::vector<const WindStudy::Flight*> WindStudy::inOrder(const Aircraft& aircraft)
{
    std::vector<const Flight*> order;
    for (const auto& flight : aircraft.flights)
        if (flight.sums.count > 0)
            order.push_back(&flight);
    std::stable_sort(order.begin(), order.end(), [](const Flight* a, const Flight* b) { return a->from_s < b->from_s; });
    return order;
}

/// Which aircraft changed, with few false ones among those that are said to have.
std::vector<bool> WindStudy::changed(const std::vector<const Aircraft*>& all, const SharedError& shared) const
{
    std::vector<double> chances(all.size(), 1.0);
    alongside(all.size(), [&](std::size_t place) {
        std::vector<const FlightSums*> flights;
        for (const auto* flight : inOrder(*all[place]))
            flights.push_back(&flight->sums);
        if (flights.size() > 2 && shared.freedom > 0) {
            const auto told = toldBy(flights, scatterWithin(flights, 3), shared, 3);
            if (const auto change = largestChange(told, fitFlights(told, together(flights), 3, true), shared.freedom))
                chances[place] = change->p;
        }
    });
    return discoveries(chances, kChangesKept, chances.size());
}

AircraftWinds WindStudy::resultOf(const Aircraft& aircraft, const SharedError& shared, bool hasChanged) const
{
    const bool sharedKnown = shared.freedom > 0;
    AircraftWinds result;
    result.aircraft = aircraft.name;
    result.observations = aircraft.observations;
    result.used = aircraft.used;
    result.group = aircraft.group;
    result.dots = aircraft.dots;
    result.fromPositions = aircraft.fromPositions;
    if (aircraft.fromPositions > 0)
        result.positionError_kt = std::sqrt(aircraft.positionSquares / static_cast<double>(aircraft.fromPositions));
    result.leftOut = aircraft.leftOut;
    result.late = aircraft.late;
    result.sectors = aircraft.sectors;
    for (auto& sector : result.sectors)
        if (sector.count > 0) {
            sector.heading_deg /= static_cast<double>(sector.count);
            sector.error_deg /= static_cast<double>(sector.count);
        }
    const auto order = inOrder(aircraft);
    std::vector<const FlightSums*> flights;
    for (const Flight* flight : order)
        flights.push_back(&flight->sums);
    result.flights = static_cast<int>(flights.size());
    if (flights.empty()) {
        const auto most = std::max_element(result.leftOut.begin(), result.leftOut.end());
        result.warnings.push_back({MARKED("core", "no report can be used; %1 of %2 are left out for this: %3"), *most, result.observations,
            wordsFor(kLeftOut[static_cast<std::size_t>(most - result.leftOut.begin())])});
        return result;
    }
    const FlightSums all = together(flights);
    result.declinationOut = all.withoutTold == 0;
    result.meanDeclination_deg = all.declined > 0 ? all.declination / static_cast<double>(all.declined) : 0;
    if (all.withoutTold > 0)
        result.warnings.push_back(
            {MARKED("core",
                 "the declination is not taken out of %1 of %2 reports (no position or no time): their argument is the true heading"),
                all.withoutTold, all.count});
    if (const Message fault = aircraft.sense.fault(); !fault.empty() && !m_options.believed) {
        result.warnings.push_back(
            {MARKED("core", "%1; nothing is fitted until it is said which (winds from or towards, kt or m/s, or as the file says)"),
                fault});
        return result;
    }
    if (const auto change = unitChange(flights); change && !m_options.believed) {
        result.warnings.push_back(
            {MARKED("core",
                 "the winds change by a factor of %1 between the flights %2 and %3, as knots and metres a second would; nothing is fitted until the file has one unit, or it is said that it has"),
                figureText(change->factor, 2), flightName(order[change->after]->name, change->after),
                flightName(order[change->after + 1]->name, change->after + 1)});
        return result;
    }
    if (shared.sine_deg > 0)
        result.sharedSine_deg = shared.sine_deg;
    const double scatter = scatterWithin(flights, 3);

    std::vector<std::pair<std::size_t, WindChange>> changes;
    if (hasChanged)
        changesWithin(flights, 0, scatter, shared, 1.0, changes);
    std::sort(changes.begin(), changes.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [after, change] : changes)
        result.changes.push_back(
            {flightName(order[after]->name, after), flightName(order[after + 1]->name, after + 1), change.p, change.step_deg});

    // Each part between changes by itself; the last one is what the aircraft is now.
    std::vector<std::size_t> begins{0};
    for (const auto& change : changes)
        begins.push_back(change.first + 1);
    for (std::size_t part = 0; part < begins.size(); ++part) {
        const std::size_t end = part + 1 < begins.size() ? begins[part + 1] : flights.size();
        const std::span<const FlightSums* const> own = std::span(flights).subspan(begins[part], end - begins[part]);
        const FlightSums sums = together(own);
        ClusteredFit first = fitFlights(toldBy(own, scatter, shared, 3), sums, 3, sharedKnown);
        ClusteredFit second;
        auto told = toldBy(own, scatter, shared, 5);
        second = fitFlights(told, sums, 5, sharedKnown);
        const bool secondTold = second.told[3] && second.told[4];
        const double secondP = secondTold ? chanceOfNoSecondOrder(second) : 1.0;
        ClusteredFit used = secondTold && secondP < 0.05 ? second : first;
        if (used.columns == 3)
            told = toldBy(own, scatter, shared, 3);
        for (std::size_t f = 0; f < own.size(); ++f) {
            const WindRow without = own.size() < 2 ? WindRow::Zero() : valueWithout(used, told[f]);
            for (const auto& [band, forms] : order[begins[part] + f]->forms) {
                result.bands[band].before += windSquares(forms, WindRow::Zero());
                if (own.size() >= 2 && !aircraft.reversed) // the forms are those of small angles
                    result.bands[band].after += windSquares(forms, without);
            }
        }
        if (part + 2 == begins.size())
            result.beforeChange = used;
        if (part + 1 == begins.size()) {
            result.fit.fit = used;
            result.secondOrder = second;
            result.secondOrderTold = secondTold;
            result.secondOrderP = secondP;
            result.flightsFitted = static_cast<int>(own.size());
            airspeedOffset(own, result);
        }
    }
    for (const WindBand& band : result.bands) {
        result.squaresBefore += band.before;
        result.squaresAfter += band.after;
    }
    result.before = result.squaresBefore.rmse();
    if (result.squaresAfter.count > 0)
        result.after = result.squaresAfter.rmse();
    result.fitted = result.fit.fit.rank > 0;
    if (aircraft.reversed)
        takeOffATurn(result);
    return result;
}

} // namespace lubberline
