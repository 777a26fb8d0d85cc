#include "core/fleet/FleetSwings.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "core/base/Date.h"

namespace lubberline {

namespace {

constexpr Date kEpoch = "1970-01-01";

/// @return for each old place the new one
std::vector<std::int32_t> sortNames(std::vector<std::string>& names)
{
    std::vector<std::int32_t> order(names.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(
        order, [&](auto a, auto b) { return names[static_cast<std::size_t>(a)] < names[static_cast<std::size_t>(b)]; });
    std::vector<std::int32_t> place(names.size());
    std::vector<std::string> sorted;
    sorted.reserve(names.size());
    for (const auto old : order) {
        if (sorted.empty() || sorted.back() != names[static_cast<std::size_t>(old)])
            sorted.push_back(names[static_cast<std::size_t>(old)]);
        place[static_cast<std::size_t>(old)] = static_cast<std::int32_t>(sorted.size()) - 1;
    }
    names = std::move(sorted);
    return place;
}

auto nameKey(const FleetCompass& c) { return std::tie(c.type, c.aircraft, c.compass); }

std::vector<std::int32_t> sortCompasses(std::vector<FleetCompass>& compasses)
{
    std::vector<std::int32_t> order(compasses.size());
    std::iota(order.begin(), order.end(), 0);
    const auto at = [&](std::int32_t i) -> FleetCompass& { return compasses[static_cast<std::size_t>(i)]; };
    std::ranges::stable_sort(order, [&](auto a, auto b) { return nameKey(at(a)) < nameKey(at(b)); });
    std::vector<FleetCompass> sorted;
    sorted.reserve(compasses.size());
    std::vector<std::int32_t> place(compasses.size());
    for (const auto old : order) {
        place[static_cast<std::size_t>(old)] = static_cast<std::int32_t>(sorted.size());
        sorted.push_back(std::move(at(old)));
        std::ranges::sort(sorted.back().events);
    }
    compasses = std::move(sorted);
    return place;
}

void sortReadings(FleetSwings& fleet, std::vector<std::pair<double, double>>& room)
{
    for (const auto& swing : fleet.swings) {
        double* magnetic = fleet.magnetic_deg.data() + swing.first;
        double* compass = fleet.compass_deg.data() + swing.first;
        if (std::is_sorted(magnetic, magnetic + swing.count)
            && std::adjacent_find(magnetic, magnetic + swing.count) == magnetic + swing.count)
            continue;
        room.resize(swing.count);
        for (std::uint32_t i = 0; i < swing.count; ++i)
            room[i] = {magnetic[i], compass[i]};
        std::ranges::sort(room);
        for (std::uint32_t i = 0; i < swing.count; ++i)
            std::tie(magnetic[i], compass[i]) = room[i];
    }
}

struct BeforeByContent {
    const FleetSwings* fleet;
    bool operator()(const FleetSwing& a, const FleetSwing& b) const
    {
        const auto key = [](const FleetSwing& s) { return std::tuple(s.compass, s.day, s.stage, s.radio, s.site, s.crew, s.count); };
        if (key(a) != key(b))
            return key(a) < key(b);
        const auto readings = [&](const FleetSwing& s) { return std::pair(fleet->compassOf(s), fleet->magneticOf(s)); };
        const auto [ca, ma] = readings(a);
        const auto [cb, mb] = readings(b);
        if (!std::ranges::equal(ca, cb))
            return std::ranges::lexicographical_compare(ca, cb);
        return std::ranges::lexicographical_compare(ma, mb);
    }
};

void gatherReadings(FleetSwings& fleet)
{
    std::uint32_t next = 0;
    if (std::ranges::all_of(fleet.swings, [&](const FleetSwing& s) { return std::exchange(next, next + s.count) == s.first; }))
        return;
    std::vector<double> magnetic, compass;
    magnetic.reserve(fleet.magnetic_deg.size());
    compass.reserve(fleet.compass_deg.size());
    for (auto& swing : fleet.swings) {
        const auto first = static_cast<std::uint32_t>(magnetic.size());
        std::ranges::copy(fleet.magneticOf(swing), std::back_inserter(magnetic));
        std::ranges::copy(fleet.compassOf(swing), std::back_inserter(compass));
        swing.first = first;
    }
    fleet.magnetic_deg = std::move(magnetic);
    fleet.compass_deg = std::move(compass);
}

} // namespace

void putInOrder(FleetSwings& fleet)
{
    const auto sitePlace = sortNames(fleet.sites), crewPlace = sortNames(fleet.crews);
    const auto compassPlace = sortCompasses(fleet.compasses);
    for (auto& swing : fleet.swings) {
        swing.compass = compassPlace[static_cast<std::size_t>(swing.compass)];
        swing.site = swing.site < 0 ? -1 : sitePlace[static_cast<std::size_t>(swing.site)];
        swing.crew = swing.crew < 0 ? -1 : crewPlace[static_cast<std::size_t>(swing.crew)];
    }
    std::vector<std::pair<double, double>> room;
    sortReadings(fleet, room);
    const BeforeByContent before{&fleet};
    if (!std::ranges::is_sorted(fleet.swings, before))
        std::ranges::stable_sort(fleet.swings, before);
    gatherReadings(fleet);
    std::ranges::sort(fleet.leftOut, {}, &SwingsLeftOut::reason);
}

std::optional<int> dayOfDate(std::string_view date)
{
    const auto day = Date::read(date);
    return day ? std::optional(daysBetween(kEpoch, *day)) : std::nullopt;
}

std::string dateOfDay(int day) { return addDays(kEpoch, day).text(); }

} // namespace lubberline
