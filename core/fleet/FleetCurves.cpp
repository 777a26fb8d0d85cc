#include "core/fleet/FleetCurves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/fleet/ByTwoHands.h"

namespace lubberline {

namespace {

/// A pooled variance of fewer degrees of freedom is not trusted alone.
constexpr double kEnoughFreedom = 20;

struct Pool {
    double squares = 0, freedom = 0;
    void add(const SwingCurve& curve)
    {
        if (!curve.fitted())
            return;
        squares += curve.residualSquares_deg2;
        freedom += curve.degreesOfFreedom();
    }
};

std::vector<std::int32_t> kindsOf(const FleetSwings& fleet, std::int32_t& kinds)
{
    std::map<std::pair<std::string, std::string>, std::int32_t> known;
    std::vector<std::int32_t> kindOf;
    for (const auto& compass : fleet.compasses)
        kindOf.push_back(known.try_emplace({compass.type, compass.compass}, static_cast<std::int32_t>(known.size())).first->second);
    kinds = static_cast<std::int32_t>(known.size());
    return kindOf;
}

void poolScatter(const FleetSwings& fleet, FleetCurves& all)
{
    std::vector<Pool> kinds(static_cast<std::size_t>(all.kinds));
    Pool whole;
    for (std::size_t row = 0; row < all.curves.size(); ++row) {
        kinds[static_cast<std::size_t>(all.kindOf[static_cast<std::size_t>(fleet.swings[row].compass)])].add(all.curves[row]);
        whole.add(all.curves[row]);
    }
    for (std::size_t c = 0; c < fleet.compasses.size(); ++c) {
        const Pool& kind = kinds[static_cast<std::size_t>(all.kindOf[c])];
        const Pool& used = kind.freedom >= kEnoughFreedom || !(whole.freedom >= kEnoughFreedom) ? kind : whole;
        const double scatter = used.freedom > 0 ? std::sqrt(used.squares / used.freedom) : 0.0;
        all.sigma_deg.push_back(std::max({scatter, fleet.compasses[c].readingError_deg, 1e-6})); // never zero: weights are its inverse
    }
}

RadioState mostUsed(std::span<const FleetSwing> swings)
{
    std::array<int, 3> count{};
    for (const auto& swing : swings)
        ++count[static_cast<std::size_t>(swing.radio)];
    return static_cast<RadioState>(std::ranges::max_element(count) - count.begin());
}

} // namespace

Result<FleetCurves> curvesOf(const FleetSwings& fleet, const Progress& progress)
{
    FleetCurves all;
    all.curves.resize(fleet.swings.size());
    const auto fit
        = [&](std::size_t row) { all.curves[row] = fitCurve(fleet.magneticOf(fleet.swings[row]), fleet.compassOf(fleet.swings[row])); };
    if (!byTwoHands(fleet.swings.size(), 32, progress, fit))
        return Error{ErrorCode::Cancelled, MARKED("core", "cancelled")};
    all.kindOf = kindsOf(fleet, all.kinds);
    poolScatter(fleet, all);
    return all;
}

std::vector<std::vector<std::size_t>> historiesByKind(const FleetCurves& curves, std::span<const CompassHistory> histories)
{
    std::vector<std::vector<std::size_t>> ofKind(static_cast<std::size_t>(curves.kinds));
    for (std::size_t h = 0; h < histories.size(); ++h)
        ofKind[static_cast<std::size_t>(curves.kindOf[static_cast<std::size_t>(histories[h].compass)])].push_back(h);
    return ofKind;
}

std::vector<CompassHistory> historiesOf(const FleetSwings& fleet)
{
    std::vector<CompassHistory> histories;
    const std::span<const FleetSwing> swings = fleet.swings;
    for (std::size_t first = 0, next = 0; first < swings.size(); first = next) {
        for (next = first; next < swings.size() && swings[next].compass == swings[first].compass;)
            ++next;
        CompassHistory history;
        history.compass = swings[first].compass;
        const RadioState radio = mostUsed(swings.subspan(first, next - first));
        for (std::size_t row = first; row < next; ++row) {
            if (swings[row].radio != radio) {
                ++history.otherRadio;
                continue;
            }
            const bool afterFound = !history.rows.empty() && swings[history.rows.back()].stage == SwingStage::AsFound;
            history.corrected.push_back(afterFound && swings[row].stage == SwingStage::AsLeft);
            history.rows.push_back(static_cast<std::uint32_t>(row));
        }
        histories.push_back(std::move(history));
    }
    return histories;
}

} // namespace lubberline
