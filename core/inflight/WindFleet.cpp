// What the aircraft of a wind study say together: what they have in common, who stands out, and the words about each.

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/angle/Angle.h"
#include "core/base/Alongside.h"
#include "core/base/FileText.h"
#include "core/base/Number.h"
#include "core/fleet/Proportion.h"
#include "core/inflight/WindStudy.h"
#include "core/inflight/WindStudyParts.h"

namespace lubberline {

namespace {

constexpr double kMostOffsetAsDeclination = 0.5;
constexpr double kReversed_deg = 90.0;

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
            {MARKED_N("core", "%n report(s) that came twice counted once"), result.leftOut[static_cast<std::size_t>(LeftOut::Duplicate)]});
    if (result.late > 0)
        result.warnings.push_back(
            {MARKED_N("core",
                 "%n report(s) came long after later ones of their flight: a turn or a climb between them cannot be judged; sort the file by aircraft and time"),
                result.late});
    if (std::abs(fit.value(0)) > kReversed_deg)
        result.warnings.push_back(
            {MARKED("core",
                 "the headings that are read are %1\u00B0 from those flown: the other end of the needle, or a sensor that is mounted the wrong way round; it is to be turned before a table is made"),
                figureText(std::abs(fit.value(0)), 0)});
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
bool inControl(const AircraftWinds& one, const std::string& control) { return one.group == control || one.aircraft == control; }

void addTo(WindGroup& group, const AircraftWinds& one)
{
    ++group.aircraft;
    group.before += one.squaresBefore;
    if (one.squaresAfter.count > 0)
        ++group.corrected;
    group.after += one.squaresAfter;
}

/// @param control whose aircraft alone tell it; empty: all.
std::optional<CommonSine> commonOf(const std::vector<AircraftWinds>& all, const std::string& control)
{
    CommonSine common;
    std::vector<const AircraftWinds*> used;
    for (const auto& one : all)
        if ((control.empty() || inControl(one, control)) && one.fitted && one.fit.fit.errorsTold && one.fit.fit.told[0]
            && one.fit.fit.told[1] && one.fit.fit.told[2])
            used.push_back(&one);
    if (used.size() < 3)
        return {};
    common.aircraft = static_cast<int>(used.size());
    for (int i = 0; i < 3; ++i) {
        std::vector<double> values;
        for (const auto* one : used)
            values.push_back(one->fit.fit.value(i));
        const double median = medianOf(values);
        std::vector<double> off;
        for (const double value : values)
            off.push_back(std::abs(value - median));
        const double spread = 1.4826 * medianOf(std::move(off));
        common.value_deg(i) = median;
        common.standardError_deg(i) = 1.2533 * spread / std::sqrt(static_cast<double>(values.size())); // of a median
    }
    return common;
}

/// With its 95 % interval, by Student's factor of so few aircraft: what their own spread may as well have made is nothing in common.
Message wordsOf(const CommonSine& common, bool ofControl)
{
    const double factor = quantile(boost::math::students_t(common.aircraft - 1), 0.975);
    const double halfB = factor * common.standardError_deg(1), halfC = factor * common.standardError_deg(2);
    const auto figure = [](double value, double half) { return figureText(-value, 2) + "\u00B0 \u00B1 " + figureText(half, 2) + "\u00B0"; };
    const std::string B = figure(common.value_deg(1), halfB), C = figure(common.value_deg(2), halfC);
    if (std::abs(common.value_deg(1)) < halfB && std::abs(common.value_deg(2)) < halfC && !common.takenOut) {
        const double most_kt
            = toRadians(std::hypot(std::abs(common.value_deg(1)) + halfB, std::abs(common.value_deg(2)) + halfC)) * common.airspeed_kt;
        return {
            MARKED("core",
                "the %1 aircraft have nothing in common that their own spread does not explain (B %2, C %3, 95 %): a constant error of the "
                "reference wind of up to %4 kt could pass unseen"),
            common.aircraft, B, C, figureText(most_kt, 1)};
    }
    return {
        ofControl ? MARKED("core",
            "the aircraft that the others are held against have B %1 and C %2 (95 %) in common, as a constant error of the reference wind of "
            "%3 kt would look: their headings being right, it is one")
            : common.takenOut
            ? MARKED("core",
                "the sine that the fleet has in common, B %1 and C %2 (95 %), is taken out: a deviation that all aircraft have goes with it")
            : MARKED("core",
                "the fleet has B %1 and C %2 (95 %) in common: a deviation of them all, or a constant error of the reference "
                "wind of %3 kt; these figures cannot tell which"),
        B, C, figureText(common.asWind_kt(), 1)};
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
    const double median = medianOf(sizes);
    std::vector<double> off;
    for (const double size : sizes)
        off.push_back(std::abs(size - median));
    const double scale = std::max(medianOf(std::move(off)), 1e-6);
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].fitted && 0.6745 * (all[i].size_deg() - median) / scale > 3.5)
            rows.push_back(i);
    return rows;
}

} // namespace

/// Groups as their reports name them, and the one that the others are held against.
void WindStudy::groupUp(WindResult& result) const
{
    std::map<std::string, WindGroup> groups;
    WindGroup control;
    control.group = m_options.control;
    for (const auto& one : result.aircraft) {
        if (!one.group.empty() && one.fitted)
            addTo(groups[one.group], one);
        if (!m_options.control.empty() && one.fitted && inControl(one, m_options.control))
            addTo(control, one);
    }
    for (auto& [name, group] : groups) {
        group.group = name;
        result.groups.push_back(group);
    }
    if (m_options.control.empty())
        return;
    if (control.aircraft > 0)
        result.control = control;
    else
        result.warnings.push_back(
            {MARKED("core", "there is no group and no aircraft %1 to hold the others against"), inQuotes(m_options.control)});
}

WindResult WindStudy::finish()
{
    m_held->releaseAll(*this);
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
        fleet.push_back(std::move(own));
    }
    alongside(fleet.size(), [&](std::size_t place) { fleet[place].scatter = scatterWithin(fleet[place].flights, 3); });
    const SharedError shared = sharedErrorOf(fleet);
    double airspeed = 0;
    std::int64_t count = 0;
    const std::vector<bool> hasChanged = changed(order, shared);
    result.aircraft.resize(order.size());
    alongside(order.size(), [&](std::size_t place) { result.aircraft[place] = resultOf(*order[place], shared, hasChanged[place]); });
    for (std::size_t place = 0; place < order.size(); ++place) {
        const Aircraft* aircraft = order[place];
        AircraftWinds& one = result.aircraft[place];
        if (one.fitted) {
            warnOfCoverage(one);
            const auto n = static_cast<double>(aircraft->declined);
            const double spread = n > 2 ? aircraft->declinationSquares / n - std::pow(aircraft->declinations / n, 2) : 0;
            const bool slopeTold = n > 30 && spread > 4.0;
            const double slope
                = slopeTold ? (aircraft->declinationErrors / n - aircraft->declinations / n * aircraft->errors / n) / spread : 0;
            warnOfNorth(one, slope, slopeTold ? 2.0 / std::sqrt(n * spread) : 1, slopeTold);
            if (one.fromPositions > 0)
                one.warnings.push_back(
                    {MARKED("core",
                         "the ground velocity of %1 reports is that between positions; the steps in which these are written make it uncertain by %2 kt"),
                        one.fromPositions, figureText(one.positionError_kt, 1)});
            if (aircraft->headings > 20 && aircraft->headingOffMagnetic < 0.25 * aircraft->headingOff)
                one.warnings.push_back(
                    MARKED("core", "heading_deg is magnetic here, and not true: it agrees with the winds once the declination is added"));
        }
        result.used += one.used;
        airspeed += aircraft->airspeed;
        count += aircraft->used;
    }
    groupUp(result);
    result.common = commonOf(result.aircraft, result.control ? m_options.control : std::string());
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
        result.warnings.push_back(wordsOf(*result.common, result.control.has_value()));
    } else if (count > 0) {
        const double speed_kt = airspeed / static_cast<double>(count);
        result.warnings.push_back(
            {MARKED("core",
                 "too few aircraft to bound what they have in common: a constant error of the reference wind of 1 kt looks like %1\u00B0 of B or C and is not told apart"),
                figureText(toDegrees(1.0 / std::max(speed_kt, 1.0)), 2)});
    }
    result.bins = binsOf(result.aircraft);
    result.outliers = outliersOf(result.aircraft);
    for (std::size_t i = 0; i < kWindBands; ++i) {
        WindBand band{kWindBand_m * static_cast<double>(i), kWindBand_m * static_cast<double>(i + 1), {}, {}};
        for (const auto& one : result.aircraft) {
            band.before += one.bands[i].before;
            band.after += one.bands[i].after;
        }
        if (band.before.count > 0)
            result.altitudes.push_back(band);
    }
    for (const auto& source : m_sources) {
        const auto n = static_cast<double>(source.count);
        result.sources.push_back({source.name, source.count, source.errors / n, std::sqrt(source.across / n)});
    }
    if (m_apartCount > 0)
        result.sourcesApart_kt = std::sqrt(m_apart / static_cast<double>(m_apartCount));
    return result;
}

} // namespace lubberline
