#include <algorithm>
#include <cmath>
#include <limits>

#include "core/angle/Angle.h"
#include "core/base/Number.h"
#include "core/fleet/Proportion.h"
#include "core/inflight/WindStudy.h"
#include "core/inflight/WindStudyParts.h"

namespace lubberline {

namespace {

constexpr double kChangesKept = 0.05; ///< false discoveries among the aircraft that are said to have changed
constexpr double kSecondChange = 0.01;
constexpr std::size_t kLeastBetweenChanges = 2;
constexpr double kMostOffsetAsDeclination = 0.5;

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
    const auto change = largestChange(told, fit, shared.freedom * 3);
    if (!change || change->p > limit)
        return;
    found.emplace_back(from + change->after, *change);
    const std::size_t split = change->after + 1;
    if (split > kLeastBetweenChanges)
        changesWithin(flights.first(split), from, scatter, shared, kSecondChange, found);
    if (flights.size() - split > kLeastBetweenChanges)
        changesWithin(flights.subspan(split), from + split, scatter, shared, kSecondChange, found);
}

std::string flightName(const std::string& name, std::size_t place) { return name.empty() ? "#" + std::to_string(place + 1) : name; }

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
    std::vector<double> chances;
    for (const auto* aircraft : all) {
        std::vector<const FlightSums*> flights;
        for (const auto* flight : inOrder(*aircraft))
            flights.push_back(&flight->sums);
        double p = 1;
        if (flights.size() > 2) {
            const auto told = toldBy(flights, scatterWithin(flights, 3), shared, 3);
            if (const auto change = largestChange(told, fitFlights(told, together(flights), 3, true), 3 * shared.freedom))
                p = change->p;
        }
        chances.push_back(p);
    }
    return discoveries(chances, kChangesKept, chances.size());
}

AircraftWinds WindStudy::resultOf(const Aircraft& aircraft, const SharedError& shared, bool hasChanged) const
{
    const bool sharedKnown = shared.freedom > 0;
    AircraftWinds result;
    result.aircraft = aircraft.name;
    result.observations = aircraft.observations;
    result.used = aircraft.used;
    result.leftOut = aircraft.leftOut;
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
        result.warnings.push_back(MARKED("core", "no report can be used"));
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
    WindSquares before, after;
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
            const WindSquares as = windSquares(*own[f], WindRow::Zero());
            before.total += as.total;
            before.across += as.across;
            before.count += as.count;
            if (own.size() < 2)
                continue;
            const WindSquares corrected = windSquares(*own[f], valueWithout(used, told[f]));
            after.total += corrected.total;
            after.across += corrected.across;
            after.count += corrected.count;
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
    result.before = before.rmse();
    if (after.count > 0)
        result.after = after.rmse();
    result.fitted = result.fit.fit.rank > 0;
    return result;
}

namespace {

/// "p = 0.012", "p < 0.0001".
std::string chanceText(double p) { return p < 1e-4 ? "p < 0.0001" : "p = " + figureText(p, p < 0.001 ? 4 : 3); }

void warnOfCoverage(AircraftWinds& result)
{
    const ClusteredFit& fit = result.fit.fit;
    std::string missing;
    for (const auto& [column, name] : {std::pair{0, "A"}, {1, "B"}, {2, "C"}})
        if (!fit.told[column])
            missing += (missing.empty() ? "" : ", ") + std::string(name);
    if (!missing.empty())
        result.warnings.push_back({MARKED("core", "the headings that were flown do not tell %1: no figure is given for it"), missing});
    if (result.flightsFitted == 1)
        result.warnings.push_back(MARKED("core",
            "one flight only: what its reports share (an error of the reference wind) cannot be told from deviation, and nothing is held out"));
    if (!result.secondOrderTold)
        result.warnings.push_back(MARKED("core", "the headings that were flown do not tell D and E"));
    else if (!result.secondOrderUsed())
        result.warnings.push_back({MARKED("core", "D and E are told, and are not surely there (%1): the table is that of A, B and C"),
            chanceText(result.secondOrderP)});
    else
        result.warnings.push_back({MARKED("core", "D and E are there (%1): the table is no sine"), chanceText(result.secondOrderP)});
    for (const auto& change : result.changes)
        result.warnings.push_back(
            {MARKED("core", "the deviation changed between the flights %1 and %2 (%3); the fit is of the flights since"),
                change.afterFlight, change.beforeFlight, chanceText(change.p)});
    if (result.leftOut[static_cast<std::size_t>(LeftOut::Duplicate)] > 0)
        result.warnings.push_back(
            {MARKED_N("core", "%n report(s) came twice and count once"), result.leftOut[static_cast<std::size_t>(LeftOut::Duplicate)]});
}

/// In the headings of a heading column, or in winds that were computed with magnetic headings.
void warnOfNorth(AircraftWinds& result, double slope, double slopeError, bool slopeTold)
{
    const double offset = result.fit.fit.value(0), declination = result.meanDeclination_deg;
    if (slopeTold && std::abs(slope + 1.0) < 0.2 && slopeError < 0.1)
        result.warnings.push_back(MARKED("core",
            "the heading error follows the declination from place to place: the winds were made with magnetic headings that were taken as true"));
    else if (!slopeTold && result.fit.fit.told[0] && std::abs(declination) > 3.0
        && std::abs(offset + declination) < kMostOffsetAsDeclination + 2.0 * result.fit.fit.standardError(0))
        result.warnings.push_back(
            {MARKED("core",
                 "the offset, %1\u00B0, is the declination, %2\u00B0, the other way: the headings may be magnetic and taken as true"),
                figureText(offset, 1), figureText(declination, 1)});
}

/// Weighted by the inverse of variances, with the variance between aircraft (DerSimonian and Laird's moment).
std::optional<CommonSine> commonOf(const std::vector<AircraftWinds>& all)
{
    CommonSine common;
    std::vector<const AircraftWinds*> used;
    for (const auto& one : all)
        if (one.fitted && one.fit.fit.errorsTold && one.fit.fit.told[0] && one.fit.fit.told[1] && one.fit.fit.told[2])
            used.push_back(&one);
    if (used.size() < 3)
        return {};
    common.aircraft = static_cast<int>(used.size());
    for (int i = 0; i < 3; ++i) {
        std::vector<double> values;
        for (const auto* one : used)
            values.push_back(one->fit.fit.value(i));
        std::sort(values.begin(), values.end());
        const double median = percentileOf(values, 0.5);
        std::vector<double> off;
        for (const double value : values)
            off.push_back(std::abs(value - median));
        std::sort(off.begin(), off.end());
        const double spread = 1.4826 * percentileOf(off, 0.5);
        common.value_deg(i) = median;
        common.standardError_deg(i) = 1.2533 * spread / std::sqrt(static_cast<double>(values.size())); // of a median
    }
    return common;
}

std::vector<WindBin> binsOf(const std::vector<AircraftWinds>& all)
{
    constexpr std::array kEdges_deg{0.0, 1.0, 2.0, 3.0, 5.0, 10.0, std::numeric_limits<double>::infinity()};
    std::vector<WindBin> bins;
    for (std::size_t i = 0; i + 1 < kEdges_deg.size(); ++i)
        bins.push_back({kEdges_deg[i], kEdges_deg[i + 1], 0});
    for (const auto& one : all)
        if (one.fitted)
            for (auto& bin : bins)
                if (one.size_deg() >= bin.from_deg && one.size_deg() < bin.to_deg)
                    ++bin.aircraft;
    return bins;
}

/// By the modified z-score of the size (Iglewicz and Hoaglin 1993): above 3.5.
std::vector<std::size_t> outliersOf(const std::vector<AircraftWinds>& all)
{
    std::vector<double> sizes;
    for (const auto& one : all)
        if (one.fitted)
            sizes.push_back(one.size_deg());
    if (sizes.size() < 5)
        return {};
    std::sort(sizes.begin(), sizes.end());
    const double median = percentileOf(sizes, 0.5);
    std::vector<double> off;
    for (const double size : sizes)
        off.push_back(std::abs(size - median));
    std::sort(off.begin(), off.end());
    const double scale = std::max(percentileOf(off, 0.5), 1e-6);
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].fitted && 0.6745 * (all[i].size_deg() - median) / scale > 3.5)
            rows.push_back(i);
    return rows;
}

} // namespace

WindResult WindStudy::finish() const
{
    WindResult result;
    result.observations = m_observations;
    std::vector<const Aircraft*> order;
    for (const auto& aircraft : m_aircraft)
        order.push_back(&aircraft);
    std::sort(order.begin(), order.end(), [](const Aircraft* a, const Aircraft* b) { return a->name < b->name; });
    std::vector<AircraftFlights> fleet;
    for (const auto* aircraft : order) {
        AircraftFlights own;
        for (const auto* flight : inOrder(*aircraft))
            own.flights.push_back(&flight->sums);
        if (own.flights.empty() || (!aircraft->sense.fault().empty() && !m_options.believed))
            continue;
        own.scatter = scatterWithin(own.flights, 3);
        fleet.push_back(std::move(own));
    }
    const SharedError shared = sharedErrorOf(fleet);
    double airspeed = 0;
    std::int64_t count = 0;
    const std::vector<bool> hasChanged = changed(order, shared);
    for (std::size_t place = 0; place < order.size(); ++place) {
        const Aircraft* aircraft = order[place];
        AircraftWinds one = resultOf(*aircraft, shared, hasChanged[place]);
        if (one.fitted) {
            warnOfCoverage(one);
            const auto n = static_cast<double>(aircraft->declined);
            const double spread = n > 2 ? aircraft->declinationSquares / n - std::pow(aircraft->declinations / n, 2) : 0;
            const bool slopeTold = n > 30 && spread > 4.0;
            const double slope
                = slopeTold ? (aircraft->declinationErrors / n - aircraft->declinations / n * aircraft->errors / n) / spread : 0;
            warnOfNorth(one, slope, slopeTold ? 2.0 / std::sqrt(n * spread) : 1, slopeTold);
            if (aircraft->headings > 20 && aircraft->headingOffMagnetic < 0.25 * aircraft->headingOff)
                one.warnings.push_back(
                    MARKED("core", "heading_deg is magnetic here, and not true: it agrees with the winds once the declination is added"));
        }
        result.used += one.used;
        airspeed += aircraft->airspeed;
        count += aircraft->used;
        result.aircraft.push_back(std::move(one));
    }
    result.common = commonOf(result.aircraft);
    if (result.common) {
        result.common->airspeed_kt = count > 0 ? airspeed / static_cast<double>(count) : 0;
        if (m_options.removeCommon) {
            result.common->takenOut = true;
            for (auto& one : result.aircraft)
                for (int i = 1; one.fitted && i < 3; ++i)
                    if (one.fit.fit.told[i]) {
                        one.fit.fit.value(i) -= result.common->value_deg(i);
                        one.fit.fit.covariance(i, i) += std::pow(result.common->standardError_deg(i), 2);
                    }
        }
        result.warnings.push_back({result.common->takenOut
                ? MARKED("core",
                    "the sine that the fleet has in common, B %1\u00B0 and C %2\u00B0, is taken out: a deviation that all aircraft have goes with it")
                : MARKED("core",
                    "the fleet has B %1\u00B0 and C %2\u00B0 in common: a deviation of them all, or a constant error of the reference wind of %3 kt; these figures cannot tell which"),
            figureText(-result.common->value_deg(1), 2), figureText(-result.common->value_deg(2), 2),
            figureText(result.common->asWind_kt(), 1)});
    } else if (count > 0) {
        const double speed_kt = airspeed / static_cast<double>(count);
        result.warnings.push_back(
            {MARKED("core",
                 "too few aircraft to bound what they have in common: a constant error of the reference wind of 1 kt looks like %1\u00B0 of B or C and is not told apart"),
                figureText(toDegrees(1.0 / std::max(speed_kt, 1.0)), 2)});
    }
    result.bins = binsOf(result.aircraft);
    result.outliers = outliersOf(result.aircraft);
    for (std::size_t i = 0; i < m_bands.size(); ++i)
        if (m_bands[i].count > 0)
            result.altitudes.push_back({1000.0 * static_cast<double>(i), 1000.0 * static_cast<double>(i + 1), m_bands[i]});
    for (const auto& source : m_sources) {
        const auto n = static_cast<double>(source.count);
        result.sources.push_back({source.name, source.count, source.errors / n, std::sqrt(source.across / n)});
    }
    if (m_apartCount > 0)
        result.sourcesApart_kt = std::sqrt(m_apart / static_cast<double>(m_apartCount));
    return result;
}

} // namespace lubberline
