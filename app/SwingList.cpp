#include "app/SwingList.h"

namespace lubberline::app {

Result<std::vector<ListedSwing>> listSwings(db::Stores& stores, const std::string& wanted)
{
    std::vector<ListedSwing> listed;
    const auto types = stores.fleet.types();
    if (!types)
        return types.error();
    for (const auto& type : *types) {
        const auto aircraft = stores.fleet.aircraftOf(type.id);
        if (!aircraft)
            return aircraft.error();
        for (const auto& one : *aircraft) {
            if (!wanted.empty() && one.registration != wanted)
                continue;
            const auto compasses = stores.fleet.compassesOf(one.id);
            if (!compasses)
                return compasses.error();
            for (const auto& compass : *compasses) {
                const auto swings = stores.swings.swingsOf(compass.id);
                if (!swings)
                    return swings.error();
                for (const auto& swing : *swings) {
                    const auto record = stores.swings.recordOf(swing.id);
                    if (!record)
                        return record.error();
                    const auto radio = db::radioOf(stores.database(), swing.id);
                    if (!radio)
                        return radio.error();
                    listed.push_back({type.name, one.registration, compass.name, *record, swing, *radio,
                        db::signedMark(stores.database(), swing.id, swing.state)});
                }
            }
        }
    }
    return listed;
}

} // namespace lubberline::app
