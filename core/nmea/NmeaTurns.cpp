#include "core/nmea/NmeaTurns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/deviation/SmithFit.h"

namespace lubberline {

std::optional<NmeaDirections> directionsOf(std::span<const NmeaPair> pairs, std::span<const double> rates_deg_s)
{
    std::array<std::vector<Observation>, 2> ways;
    std::size_t next = 0;
    for (const auto& pair : pairs) {
        if (!pair.used)
            continue;
        const double rate = rates_deg_s[next++];
        if (std::abs(rate) >= kSlowestTurn_deg_s)
            ways[rate > 0.0 ? 0 : 1].push_back({pair.magnetic, pair.compass});
    }
    constexpr std::size_t kFewest = 20;
    if (ways[0].size() < kFewest || ways[1].size() < kFewest)
        return {};
    const auto right = fitApproximate(ways[0]), left = fitApproximate(ways[1]);
    if (!right || !left || right->parameters < 5 || left->parameters < 5)
        return {};
    NmeaDirections directions{toDegrees(*right->of(Coefficient::A)), toDegrees(*left->of(Coefficient::A)), 0.0};
    for (const auto& one : ways[0].size() < ways[1].size() ? ways[0] : ways[1])
        directions.largestDifference_deg = std::max(directions.largestDifference_deg,
            std::abs(wrap180(deviationAt(right->smith(), one.compass).degrees() - deviationAt(left->smith(), one.compass).degrees())));
    return directions;
}

} // namespace lubberline
