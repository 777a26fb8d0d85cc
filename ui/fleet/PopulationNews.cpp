#include "ui/fleet/PopulationNews.h"

#include <algorithm>
#include <cmath>

#include "db/stores/PopulationStore.h"

namespace lubberline::ui {

namespace {

constexpr int kFirstLook = 1500; ///< swings: read and computed well within a third of a second

}

Result<std::shared_ptr<const PopulationNews>> populationNews(
    const db::Stores& from, const FleetSelection& selection, FleetOptions options, bool firstLook, const Progress& progress)
{
    auto stores = from.openForWorker();
    if (!stores)
        return stores.error();
    const auto part = [&progress](double begin, double end) {
        return [&progress, begin, end](double f) { return progress(begin + f * (end - begin)); };
    };
    auto fleet = db::PopulationStore((*stores)->database()).columns(selection, part(0, 0.4), firstLook ? kFirstLook : 0);
    if (!fleet)
        return fleet.error();
    options.variance = options.changes = !firstLook;
    auto report = fleetReportOf(*fleet, options, part(0.4, 1.0));
    if (!report)
        return report.error();
    return std::shared_ptr<const PopulationNews>(
        std::make_shared<PopulationNews>(PopulationNews{std::move(fleet.value()), std::move(report.value()), selection, firstLook}));
}

std::vector<SwingBehind> swingsBehind(const PopulationNews& news, double heading_deg)
{
    const auto& [fleet, report, selection, firstLook] = news;
    double mean = 0;
    for (const auto& point : report.pattern.points)
        if (std::abs(point.heading_deg - heading_deg) < 1e-6)
            mean = point.mean_deg.value_or(0);
    std::vector<SwingBehind> all;
    for (std::size_t row = 0; row < fleet.swings.size(); ++row)
        if (!report.options.stage || fleet.swings[row].stage == *report.options.stage)
            if (const auto value = valueAt(fleet, fleet.swings[row], report.curves.curves[row], heading_deg, 180.0 / report.options.grid))
                all.push_back({row, *value});
    std::stable_sort(all.begin(), all.end(), [mean](const SwingBehind& a, const SwingBehind& b) {
        return std::abs(a.value.deviation_deg - mean) > std::abs(b.value.deviation_deg - mean);
    });
    return all;
}

} // namespace lubberline::ui
