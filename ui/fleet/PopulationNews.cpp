#include "ui/fleet/PopulationNews.h"

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

} // namespace lubberline::ui
