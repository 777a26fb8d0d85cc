#include "core/fleet/SignCheck.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

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

std::vector<SuspectCompass> suspectSigns(std::span<const DOfSwing> swings)
{
    std::map<std::int32_t, std::vector<std::size_t>> placesOf; // of a compass
    std::size_t kinds = 0;
    for (std::size_t place = 0; place < swings.size(); ++place) {
        placesOf[swings[place].compass].push_back(place);
        kinds = std::max(kinds, static_cast<std::size_t>(swings[place].kind) + 1);
    }
    const auto kindOfCompass
        = [&](const std::vector<std::size_t>& places) { return static_cast<std::size_t>(swings[places.front()].kind); };
    std::vector<std::vector<double>> medians(kinds);
    for (const auto& [compass, places] : placesOf) {
        std::vector<double> values;
        for (const auto place : places)
            values.push_back(swings[place].D_deg);
        medians[kindOfCompass(places)].push_back(medianOf(std::move(values)));
    }
    std::vector<std::optional<KindOfD>> kindsOfD(kinds);
    std::ranges::transform(medians, kindsOfD.begin(), kindOf);
    std::vector<SuspectCompass> suspects;
    for (const auto& [compass, places] : placesOf) {
        const auto& kind = kindsOfD[kindOfCompass(places)];
        if (!kind)
            continue;
        SuspectCompass suspect{compass, {}, places.size(), 0, kind->median_deg};
        std::vector<double> turned;
        for (const auto place : places) {
            const double sd = std::sqrt(swings[place].variance_deg2 + kind->spread_deg * kind->spread_deg);
            const double D = swings[place].D_deg, apart = std::abs(D - kind->median_deg), apartTurned = std::abs(D + kind->median_deg);
            if (std::abs(kind->median_deg) > kClear * sd && apart > kClear * sd && apartTurned < 0.5 * apart) {
                suspect.swings.push_back(place);
                turned.push_back(D);
            }
        }
        if (turned.empty())
            continue;
        suspect.D_deg = medianOf(std::move(turned));
        suspects.push_back(std::move(suspect));
    }
    return suspects;
}

std::vector<SignSuspicion> suspectSigns(const FleetSwings& fleet, const FleetCurves& curves)
{
    std::vector<DOfSwing> swings;
    std::vector<std::uint32_t> rows;
    for (std::uint32_t row = 0; row < fleet.swings.size(); ++row) {
        const auto& swing = fleet.swings[row];
        if (!curves.curves[row].known(kD))
            continue;
        swings.push_back({swing.compass, curves.kindOf[static_cast<std::size_t>(swing.compass)], curves.curves[row].value_deg[kD],
            curves.variance_deg2(swing, row, kD)});
        rows.push_back(row);
    }
    std::vector<SignSuspicion> suspicions;
    for (const auto& suspect : suspectSigns(swings)) {
        SignSuspicion suspicion{suspect.compass, {}, suspect.all, suspect.D_deg, suspect.siblingsD_deg};
        for (const auto place : suspect.swings)
            suspicion.rows.push_back(rows[place]);
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
