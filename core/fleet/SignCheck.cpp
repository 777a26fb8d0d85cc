#include "core/fleet/SignCheck.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/Number.h"
#include "core/fleet/Proportion.h"

namespace lubberline {

namespace {

constexpr std::size_t kD = 3, kFewestSiblings = 4;
constexpr double kClear = 4.0; ///< standard deviations by which the type's D must be from nothing
constexpr double kNormalOfMad = 1.4826;

struct KindOfD {
    double median_deg = 0, spread_deg = 0;
};

/// Of the compasses' medians; those on the other side of nothing than most are not counted, so that a turned half does not hide itself.
std::optional<KindOfD> kindOf(const std::vector<double>& medians_deg)
{
    const auto positive = static_cast<std::size_t>(std::ranges::count_if(medians_deg, [](double d) { return d > 0; }));
    if (2 * positive == medians_deg.size())
        return {}; // which half is turned cannot be told
    std::vector<double> most;
    for (const double d : medians_deg)
        if ((d > 0) == (2 * positive > medians_deg.size()))
            most.push_back(d);
    if (most.size() < kFewestSiblings)
        return {};
    KindOfD kind{medianOf(most), 0};
    std::vector<double> distance;
    for (const double d : most)
        distance.push_back(std::abs(d - kind.median_deg));
    kind.spread_deg = kNormalOfMad * medianOf(distance);
    return kind;
}

} // namespace

std::vector<SignSuspicion> suspectSigns(const FleetSwings& fleet, const FleetCurves& curves)
{
    std::map<std::int32_t, std::vector<std::uint32_t>> rowsOf;
    for (std::size_t row = 0; row < fleet.swings.size(); ++row)
        if (curves.curves[row].known(kD))
            rowsOf[fleet.swings[row].compass].push_back(static_cast<std::uint32_t>(row));
    const auto valueOf = [&](std::uint32_t row) { return curves.curves[row].value_deg[kD]; };
    std::vector<std::vector<double>> medians(static_cast<std::size_t>(curves.kinds));
    for (const auto& [compass, rows] : rowsOf) {
        std::vector<double> values;
        for (const auto row : rows)
            values.push_back(valueOf(row));
        medians[static_cast<std::size_t>(curves.kindOf[static_cast<std::size_t>(compass)])].push_back(medianOf(values));
    }
    std::vector<SignSuspicion> suspicions;
    for (const auto& [compass, rows] : rowsOf) {
        const auto kind = kindOf(medians[static_cast<std::size_t>(curves.kindOf[static_cast<std::size_t>(compass)])]);
        if (!kind)
            continue;
        SignSuspicion suspicion;
        suspicion.compass = compass;
        suspicion.swings = rows.size();
        suspicion.siblingsD_deg = kind->median_deg;
        std::vector<double> turned;
        for (const auto row : rows) {
            const double sd = std::sqrt(curves.variance_deg2(fleet.swings[row], row, kD) + kind->spread_deg * kind->spread_deg);
            const double apart = std::abs(valueOf(row) - kind->median_deg), apartTurned = std::abs(valueOf(row) + kind->median_deg);
            if (std::abs(kind->median_deg) > kClear * sd && apart > kClear * sd && apartTurned < 0.5 * apart) {
                suspicion.rows.push_back(row);
                turned.push_back(valueOf(row));
            }
        }
        if (turned.empty())
            continue;
        suspicion.D_deg = medianOf(turned);
        suspicions.push_back(std::move(suspicion));
    }
    return suspicions;
}

Message inWords(const SignSuspicion& suspicion, const FleetSwings& fleet)
{
    const auto& compass = fleet.compasses[static_cast<std::size_t>(suspicion.compass)];
    return {
        MARKED("core",
            "%1 · %2: D is %3° in %4 of %5 swings (%6 to %7) where its siblings have %8°: the sign of these records is suspect; nothing was turned"),
        compass.aircraft, compass.compass, signedFigureText(suspicion.D_deg, 1), suspicion.rows.size(), suspicion.swings,
        dateOfDay(fleet.swings[suspicion.rows.front()].day), dateOfDay(fleet.swings[suspicion.rows.back()].day),
        signedFigureText(suspicion.siblingsD_deg, 1)};
}

} // namespace lubberline
