#include "core/fleet/ChangeScatter.h"

#include "core/base/Middle.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/fleet/ByTwoHands.h"

namespace lubberline {

namespace {

/// So many increments, near and far, give medians that may be taken as known; fewer leave many sizes possible (ScatterPosterior.h).
constexpr std::size_t kEnoughIncrements = 600, kEnoughFar = 150;
constexpr std::size_t kEnoughOfSide = 10; ///< increments of a side of the crews' day, to tell their scatter apart

/// Corrections turn screws and mounts, which move A, B and C; soft iron stays.
bool movedByCorrection(std::size_t c) { return c < 3; }

struct Increment {
    double squared, variance, years;
    bool later; ///< both swings after the crews' day
};
struct Increments {
    std::vector<Increment> next; ///< from a swing to the next
    std::vector<Increment> far;  ///< over half of a run of swings without a correction
    std::size_t joined = 0;      ///< of the first, those that begin where the one before them ended

    /// Scatter can be told from wander, or need not be: runs of two swings have no swing in common.
    [[nodiscard]] bool enough() const
    {
        return next.size() >= kEnoughIncrements && (far.size() >= kEnoughFar || 10 * joined < next.size());
    }
};

/// d² of N(0, v + 2τ²) has its median at 0.4549 (v + 2τ²).
double swingVarianceOf(const std::vector<Increment>& increments, bool later)
{
    std::vector<double> candidates;
    for (const auto& each : increments)
        if (each.later == later)
            candidates.push_back(0.5 * (each.squared / kMedianOfChiSquare - each.variance));
    return candidates.empty() ? 0.0 : std::max(0.0, middleOf(candidates));
}

double medianYears(const std::vector<Increment>& increments)
{
    std::vector<double> years;
    for (const auto& each : increments)
        years.push_back(each.years);
    return middleOf(years);
}

/// What changes grow by over longer times is wandered: the rest of a change is there at once. Takes the wandered part out of the swings'.
void tellWander(const Increments& increments, ChangeScatter& scatter)
{
    const double near = medianYears(increments.next), longer = medianYears(increments.far) - near;
    std::vector<double> grown;
    for (const auto& each : increments.far)
        grown.push_back(
            each.squared / kMedianOfChiSquare - each.variance - 2 * (each.later ? scatter.laterVariance_deg2 : scatter.swingVariance_deg2));
    const double excess = middleOf(grown);
    if (!(excess > 0) || !(longer > 0.5 * near))
        return;
    scatter.wanderVariance_deg2_year = excess / longer;
    for (double* each : {&scatter.swingVariance_deg2, &scatter.laterVariance_deg2})
        *each = std::max(0.0, *each - 0.5 * near * scatter.wanderVariance_deg2_year);
}

/// Trained crews' scatter as a share of what it was, where both were seen often enough.
double laterShareOf(const std::vector<Increment>& increments, const ChangeScatter& scatter)
{
    constexpr double farthest = 100;
    const auto later = static_cast<std::size_t>(std::ranges::count(increments, true, &Increment::later));
    if (std::min(later, increments.size() - later) < kEnoughOfSide || !(scatter.swingVariance_deg2 > 0))
        return 1;
    return std::clamp(scatter.laterVariance_deg2 / scatter.swingVariance_deg2, 1 / farthest, farthest);
}

/// By medians, which jumps do not move.
ChangeScatter scatterOf(const Increments& all, std::optional<int> crews_day)
{
    ChangeScatter scatter;
    scatter.crews_day = crews_day;
    scatter.increments = all.next.size();
    scatter.swingVariance_deg2 = swingVarianceOf(all.next, false);
    scatter.laterVariance_deg2 = swingVarianceOf(all.next, true);
    scatter.laterShare = laterShareOf(all.next, scatter);
    scatter.known = all.enough();
    if (scatter.known && all.far.size() >= kEnoughFar)
        tellWander(all, scatter);
    return scatter;
}

void tellWalk(const std::vector<Increment>& increments, ChangeScatter& scatter)
{
    double beyond = 0, years = 0;
    for (const auto& each : increments) {
        beyond += each.squared - each.variance - 2 * (each.later ? scatter.laterVariance_deg2 : scatter.swingVariance_deg2);
        years += each.years;
    }
    scatter.walkVariance_deg2_year = years > 0 ? std::max(0.0, beyond / years) : 0.0;
}

Increment incrementOf(const DatedValue& before, const DatedValue& after, std::optional<int> crews_day)
{
    return {std::pow(after.value - before.value, 2), before.variance + after.variance, (after.day - before.day) / kDaysPerYear,
        crews_day && before.day >= *crews_day};
}

/// Two changes of each run, from its first swing to its middle and from there to its last.
void addFar(std::span<const DatedValue> series, std::optional<int> crews_day, std::vector<Increment>& far)
{
    constexpr std::size_t fewest = 3; // swings in a half
    for (std::size_t first = 0, next = 0; first < series.size(); first = next) {
        for (next = first + 1; next < series.size() && !series[next].corrected;)
            ++next;
        const std::size_t half = (next - first - 1) / 2;
        if (half + 1 < fewest)
            continue;
        for (const std::size_t from : {first, first + half})
            if (series[from + half].day > series[from].day)
                far.push_back(incrementOf(series[from], series[from + half], crews_day));
    }
}

/// Of the histories of one kind.
Increments incrementsOf(const FleetSwings& fleet, const FleetCurves& curves, std::span<const CompassHistory> histories,
    const std::vector<std::size_t>& mine, std::size_t c, std::optional<int> crews_day)
{
    Increments increments;
    ChangeScatter none;
    none.crews_day = crews_day;
    for (const auto h : mine) {
        const auto series = seriesOf(fleet, curves, histories[h], c, none).values;
        bool before = false;
        for (std::size_t i = 1; i < series.size(); ++i) {
            const bool apart = !series[i].corrected && series[i].day > series[i - 1].day;
            if (apart)
                increments.next.push_back(incrementOf(series[i - 1], series[i], crews_day));
            increments.joined += before && apart ? 1u : 0u;
            before = apart;
        }
        addFar(series, crews_day, increments.far);
    }
    return increments;
}

} // namespace

CoefficientSeries seriesOf(
    const FleetSwings& fleet, const FleetCurves& curves, const CompassHistory& history, std::size_t c, const ChangeScatter& scatter)
{
    CoefficientSeries series;
    series.values.reserve(history.rows.size());
    series.rows.reserve(history.rows.size());
    bool corrected = false; // also by swings that do not tell this coefficient
    for (std::size_t i = 0; i < history.rows.size(); ++i) {
        const auto row = history.rows[i];
        corrected = corrected || (history.corrected[i] && movedByCorrection(c));
        if (scatter.crews_day && i > 0 && fleet.swings[row].day >= *scatter.crews_day
            && fleet.swings[history.rows[i - 1]].day < *scatter.crews_day)
            corrected = true;
        if (!curves.curves[row].known(c))
            continue;
        const FleetSwing& swing = fleet.swings[row];
        series.values.push_back(
            {swing.day, curves.curves[row].value_deg[c], curves.variance_deg2(swing, row, c) + scatter.varianceAt(swing.day),
                corrected && !series.values.empty(), scatter.isLater(swing.day) ? scatter.laterShare : 1.0});
        series.rows.push_back(row);
        corrected = false;
    }
    return series;
}

std::vector<DatedValue> bareSeriesOf(
    const FleetSwings& fleet, const FleetCurves& curves, const CompassHistory& history, std::size_t c, const ChangeScatter& scatter)
{
    ChangeScatter bare;
    bare.crews_day = scatter.crews_day;
    bare.laterShare = scatter.laterShare;
    return seriesOf(fleet, curves, history, c, bare).values;
}

Result<std::vector<std::array<ChangeScatter, kCoefficientCount>>> scattersOf(const FleetSwings& fleet, const FleetCurves& curves,
    std::span<const CompassHistory> histories, std::optional<int> crews_day, const Progress& progress)
{
    const auto ofKind = historiesByKind(curves, histories);
    std::vector<std::array<ChangeScatter, kCoefficientCount>> scatters(ofKind.size());
    const auto tell = [&](std::size_t job) {
        const std::size_t k = job / kCoefficientCount, c = job % kCoefficientCount;
        const auto day = c == 0 ? crews_day : std::nullopt;
        const Increments increments = incrementsOf(fleet, curves, histories, ofKind[k], c, day);
        ChangeScatter& scatter = scatters[k][c];
        scatter = scatterOf(increments, day);
        if (!scatter.known) {
            std::map<std::size_t, std::vector<DatedValue>> series;
            for (const auto h : ofKind[k])
                series[h] = bareSeriesOf(fleet, curves, histories[h], c, scatter);
            scatter.posterior = std::make_shared<const ScatterPosterior>(series);
            const auto mean = scatter.posterior->mean();
            scatter.swingVariance_deg2 = mean.swing_deg2;
            scatter.laterVariance_deg2 = scatter.laterShare * mean.swing_deg2;
            scatter.wanderVariance_deg2_year = mean.wander_deg2_year;
        }
        tellWalk(increments.next, scatter);
    };
    if (!byTwoHands(scatters.size() * kCoefficientCount, 1, progress, tell))
        return Error{ErrorCode::Cancelled, MARKED("core", "cancelled")};
    return scatters;
}

} // namespace lubberline
