#include "core/fleet/Plants.h"
#include "core/base/Normal.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace lubberline {

namespace {

/// One A with whose it is.
struct FigureOfA {
    double A_deg = 0;
    int day = 0;
    std::int32_t compass = 0, site = -1, crew = -1;
    std::uint32_t row = 0;
};

std::vector<FigureOfA> figuresOf(const FleetSwings& fleet, const FleetCurves& curves, std::optional<SwingStage> stage)
{
    std::vector<FigureOfA> figures;
    for (std::size_t row = 0; row < fleet.swings.size(); ++row) {
        const FleetSwing& swing = fleet.swings[row];
        if (curves.curves[row].known(0) && (!stage || swing.stage == *stage))
            figures.push_back(
                {curves.curves[row].value_deg[0], swing.day, swing.compass, swing.site, swing.crew, static_cast<std::uint32_t>(row)});
    }
    std::ranges::stable_sort(figures, {}, &FigureOfA::day);
    return figures;
}

/// Mean |A| with a standard error by clusters of compasses.
struct ClusteredMean {
    double mean = 0, standardError = 0;
    std::int64_t count = 0, clusters = 0;
};
ClusteredMean meanAbs(std::span<const FigureOfA> figures)
{
    ClusteredMean result;
    std::map<std::int32_t, std::pair<double, double>> clusters; // sum of |A|, count
    for (const auto& each : figures) {
        auto& [sum, count] = clusters[each.compass];
        sum += std::abs(each.A_deg);
        count += 1;
        result.mean += std::abs(each.A_deg);
    }
    result.count = static_cast<std::int64_t>(figures.size());
    result.clusters = static_cast<std::int64_t>(clusters.size());
    if (figures.empty())
        return result;
    const auto n = static_cast<double>(figures.size()), g = static_cast<double>(clusters.size());
    result.mean /= n;
    double squares = 0;
    for (const auto& [compass, sum] : clusters)
        squares += std::pow(sum.first - sum.second * result.mean, 2);
    result.standardError = clusters.size() > 1 ? std::sqrt(squares * g / (g - 1)) / n : result.mean;
    return result;
}

std::vector<GroupOfA> groupsOf(std::span<const FigureOfA> figures, std::int32_t FigureOfA::*level, const std::vector<std::string>& names)
{
    std::vector<std::vector<FigureOfA>> members(names.size());
    for (const auto& each : figures)
        if (each.*level >= 0)
            members[static_cast<std::size_t>(each.*level)].push_back(each);
    std::vector<GroupOfA> groups;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (members[i].empty())
            continue;
        const auto abs = meanAbs(members[i]);
        GroupOfA group;
        group.name = names[i];
        group.swings = abs.count;
        group.aircraft = abs.clusters;
        for (const auto& each : members[i])
            group.meanA_deg += each.A_deg / static_cast<double>(abs.count);
        group.meanAbsA_deg = abs.mean;
        const double half = studentFactor(std::max<double>(1, static_cast<double>(abs.clusters - 1))) * abs.standardError;
        group.meanAbsA95_deg = {std::max(0.0, abs.mean - half), abs.mean + half};
        groups.push_back(std::move(group));
    }
    return groups;
}

SideOfDate sideOf(std::span<const FigureOfA> figures)
{
    SideOfDate side;
    side.swings = static_cast<std::int64_t>(figures.size());
    const auto n = static_cast<double>(figures.size());
    for (const auto& each : figures) {
        side.meanA_deg += each.A_deg / n;
        side.meanAbsA_deg += std::abs(each.A_deg) / n;
    }
    double squares = 0;
    for (const auto& each : figures)
        squares += std::pow(each.A_deg - side.meanA_deg, 2);
    side.standardDeviation_deg = figures.size() > 1 ? std::sqrt(squares / (n - 1)) : 0.0;
    return side;
}

/// √|A| is about symmetric where A is about normal, so that a mean of it may be compared.
struct Scan {
    std::size_t place = 0; ///< first of "after"
    double statistic = 0;
    std::size_t candidates = 0;
};
Scan scan(std::span<const FigureOfA> figures)
{
    constexpr std::size_t least = 8;
    std::vector<double> sum(figures.size() + 1, 0.0), squares(figures.size() + 1, 0.0);
    for (std::size_t i = 0; i < figures.size(); ++i) {
        sum[i + 1] = sum[i] + std::sqrt(std::abs(figures[i].A_deg));
        squares[i + 1] = squares[i] + std::abs(figures[i].A_deg);
    }
    Scan best;
    const std::size_t n = figures.size();
    for (std::size_t i = least; i + least <= n; ++i) {
        if (figures[i].day == figures[i - 1].day)
            continue;
        ++best.candidates;
        const auto a = static_cast<double>(i), b = static_cast<double>(n - i);
        const double before = sum[i] / a, after = (sum[n] - sum[i]) / b;
        const double va = (squares[i] - a * before * before) / (a - 1), vb = (squares[n] - squares[i] - b * after * after) / (b - 1);
        const double z = std::abs(after - before) / std::sqrt(std::max(va / a + vb / b, 1e-12));
        if (z > best.statistic) {
            best.statistic = z;
            best.place = i;
        }
    }
    return best;
}

double changeOf(double before, double after) { return before > 0 ? after / before - 1 : 0.0; }

void compareWithin(std::span<const FigureOfA> before, std::span<const FigureOfA> after, DateComparison& comparison)
{
    std::map<std::int32_t, std::array<std::pair<double, int>, 2>> sides;
    for (const auto& each : before) {
        sides[each.compass][0].first += std::abs(each.A_deg);
        ++sides[each.compass][0].second;
    }
    for (const auto& each : after) {
        sides[each.compass][1].first += std::abs(each.A_deg);
        ++sides[each.compass][1].second;
    }
    double sumBefore = 0, sumAfter = 0;
    for (const auto& [compass, side] : sides)
        if (side[0].second > 0 && side[1].second > 0) {
            ++comparison.compassesOnBothSides;
            sumBefore += side[0].first / side[0].second;
            sumAfter += side[1].first / side[1].second;
        }
    if (comparison.compassesOnBothSides > 0)
        comparison.changeWithin = changeOf(sumBefore, sumAfter);
}

DateComparison compareAt(std::span<const FigureOfA> figures, std::size_t place)
{
    const auto before = figures.first(place), after = figures.subspan(place);
    DateComparison comparison;
    comparison.day = after.front().day;
    comparison.lastBefore_day = before.back().day;
    comparison.before = sideOf(before);
    comparison.after = sideOf(after);
    comparison.change = changeOf(comparison.before.meanAbsA_deg, comparison.after.meanAbsA_deg);
    const auto a = meanAbs(before), b = meanAbs(after);
    const double relative = std::hypot(a.mean > 0 ? a.standardError / a.mean : 1.0, b.mean > 0 ? b.standardError / b.mean : 1.0);
    const double ratio = 1 + comparison.change, factor = std::exp(kNormal95 * relative); // on the logarithm: a ratio stays positive
    comparison.change95 = {ratio / factor - 1, ratio * factor - 1};
    comparison.p = 2 * normalTail(std::abs(std::log(std::max(ratio, 1e-9))) / std::max(relative, 1e-9));
    compareWithin(before, after, comparison);
    return comparison;
}

std::optional<DateComparison> trainingOf(std::span<const FigureOfA> figures, std::optional<int> given)
{
    if (given) {
        const auto place = static_cast<std::size_t>(std::ranges::lower_bound(figures, *given, {}, &FigureOfA::day) - figures.begin());
        if (place == 0 || place == figures.size())
            return {};
        auto comparison = compareAt(figures, place);
        comparison.given = true;
        comparison.day = *given;
        return comparison;
    }
    const Scan best = scan(figures);
    if (best.candidates == 0)
        return {};
    const double p = std::min(1.0, static_cast<double>(best.candidates) * 2 * normalTail(best.statistic));
    if (p > 0.01)
        return {};
    auto comparison = compareAt(figures, best.place);
    comparison.p = p;
    return comparison;
}

void watch(std::span<const FigureOfA> figures, std::int32_t FigureOfA::*level, const std::vector<std::string>& names, bool crew,
    ChartWatch& charts)
{
    constexpr std::size_t least = 8;
    std::vector<std::vector<const FigureOfA*>> members(names.size());
    for (const auto& each : figures)
        if (each.*level >= 0)
            members[static_cast<std::size_t>(each.*level)].push_back(&each);
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (members[i].size() < least)
            continue;
        std::vector<double> values;
        for (const auto* each : members[i])
            values.push_back(each->A_deg);
        const auto average = ewma(values, charts.centre_deg, charts.sigma_deg, charts.limits.weight, charts.limits.width);
        const auto sums = cusum(values, charts.centre_deg, charts.sigma_deg, charts.limits.reference, charts.limits.decision);
        std::optional<ChartAlarm> going;
        for (std::size_t k = 0; k < values.size(); ++k) {
            const double mean_deg = average.average[k];
            if (going && going->high != (mean_deg > charts.centre_deg)) {
                charts.alarms.push_back(*going);
                going.reset();
            }
            if (!average.alarm[k] && !sums.alarm[k])
                continue;
            // A sum may ring while the average is still on the other side: it is the sum that says on which side.
            const bool high = average.alarm[k] ? mean_deg > charts.centre_deg : sums.high[k] > sums.low[k];
            if (!going)
                going = ChartAlarm{crew, names[i], false, false, members[i][k]->day, 0, members[i][k]->row, mean_deg, high};
            going->ewma = going->ewma || average.alarm[k];
            going->cusum = going->cusum || sums.alarm[k];
            going->last_day = members[i][k]->day;
            if (std::abs(mean_deg - charts.centre_deg) > std::abs(going->level_deg - charts.centre_deg))
                going->level_deg = mean_deg;
        }
        if (going)
            charts.alarms.push_back(*going);
    }
}

std::optional<ChartWatch> chartsOf(const FleetSwings& fleet, std::span<const FigureOfA> figures)
{
    if (figures.size() < 8)
        return {};
    std::vector<double> values, distances;
    for (const auto& each : figures)
        values.push_back(each.A_deg);
    ChartWatch charts;
    charts.centre_deg = medianOf(values);
    for (const double value : values)
        distances.push_back(std::abs(value - charts.centre_deg));
    charts.sigma_deg = 1.4826 * medianOf(distances);
    if (!(charts.sigma_deg > 0))
        return {};
    static const auto lengths = [limits = ChartLimits{}] {
        return std::array{ewmaRunLength(limits.weight, limits.width, 0), ewmaRunLength(limits.weight, limits.width, 1),
            cusumRunLength(limits.reference, limits.decision, 0), cusumRunLength(limits.reference, limits.decision, 1)};
    }();
    charts.ewmaFalseAlarmAfter = lengths[0];
    charts.ewmaShiftFoundAfter = lengths[1];
    charts.cusumFalseAlarmAfter = lengths[2];
    charts.cusumShiftFoundAfter = lengths[3];
    watch(figures, &FigureOfA::site, fleet.sites, false, charts);
    watch(figures, &FigureOfA::crew, fleet.crews, true, charts);
    std::ranges::stable_sort(charts.alarms, {}, &ChartAlarm::day);
    return charts;
}

} // namespace

PlantReport plantsOf(const FleetSwings& fleet, const FleetCurves& curves, std::optional<SwingStage> stage, std::optional<int> trainingDay)
{
    const auto figures = figuresOf(fleet, curves, stage);
    PlantReport report;
    report.bySite = groupsOf(figures, &FigureOfA::site, fleet.sites);
    report.byCrew = groupsOf(figures, &FigureOfA::crew, fleet.crews);
    report.training = trainingOf(figures, trainingDay);
    report.charts = chartsOf(fleet, figures);
    return report;
}

} // namespace lubberline
