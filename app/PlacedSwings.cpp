#include "app/PlacedSwings.h"

#include "app/DbStorage.h"
#include "core/swing/SwingPlaces.h"

namespace lubberline::app {

Result<PlacedSwings> placedSwings(const std::string& database, const std::vector<std::string>& names)
{
    auto storage = openStorage(database, db::OpenMode::ReadOnly);
    if (!storage)
        return storage.error();
    PlacedSwings placed;
    CompassId compass;
    for (const auto& name : names) {
        const auto id = (*storage)->swingNamed(name);
        if (!id)
            return id.error();
        const auto record = (*storage)->swingRecord(*id);
        if (!record)
            return record.error();
        if (compass.valid() && compass != record->compass.id)
            return Error{ErrorCode::InvalidInput, "swing " + name + " is of another compass; expected swings of one compass"};
        compass = record->compass.id;
        placed.limits = record->limits;
        auto swing = swingAtPlace(*record);
        if (!swing)
            return Error{swing.error().code, "swing " + name + ": " + swing.error().message};
        placed.swings.push_back(std::move(swing.value()));
    }
    return placed;
}

} // namespace lubberline::app
