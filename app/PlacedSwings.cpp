#include "app/PlacedSwings.h"

#include <algorithm>

#include "app/OpenStores.h"
#include "core/swing/SwingPlaces.h"

namespace lubberline::app {

Result<PlacedSwings> placedSwings(const std::string& database, const std::vector<std::string>& names)
{
    auto stores = openStores(database, db::OpenMode::ReadOnly);
    if (!stores)
        return stores.error();
    PlacedSwings placed;
    CompassId compass;
    std::vector<SwingId> taken;
    for (const auto& name : names) {
        const auto id = (*stores)->swings.named(name);
        if (!id)
            return id.error();
        if (std::find(taken.begin(), taken.end(), *id) != taken.end())
            return Error{ErrorCode::InvalidInput, {MARKED("app", "swing %1 is named once more; expected each swing once"), name}};
        taken.push_back(*id);
        const auto record = (*stores)->swings.record(*id);
        if (!record)
            return record.error();
        if (compass.valid() && compass != record->compass.id)
            return Error{ErrorCode::InvalidInput, {MARKED("app", "swing %1 is of another compass; expected swings of one compass"), name}};
        compass = record->compass.id;
        placed.limits = record->limits;
        auto swing = (*stores)->results.placeOf(*record);
        if (!swing)
            return Error{swing.error().code, {MARKED("app", "swing %1: %2"), name, swing.error().message}};
        placed.swings.push_back(std::move(swing.value()));
    }
    return placed;
}

} // namespace lubberline::app
