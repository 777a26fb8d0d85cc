#include "app/SwingList.h"

namespace lubberline::app {

Result<std::vector<ListedSwing>> listSwings(DbStorage& storage, const std::string& wanted)
{
    std::vector<ListedSwing> listed;
    const auto types = storage.types();
    if (!types)
        return types.error();
    for (const auto& type : *types) {
        const auto aircraft = storage.aircraftOf(type.id);
        if (!aircraft)
            return aircraft.error();
        for (const auto& one : *aircraft) {
            if (!wanted.empty() && one.registration != wanted)
                continue;
            const auto compasses = storage.compassesOf(one.id);
            if (!compasses)
                return compasses.error();
            for (const auto& compass : *compasses) {
                const auto swings = storage.swingsOf(compass.id);
                if (!swings)
                    return swings.error();
                for (const auto& swing : *swings) {
                    const auto record = storage.recordOf(swing.id);
                    if (!record)
                        return record.error();
                    listed.push_back({type.name, one.registration, compass.name, *record, swing});
                }
            }
        }
    }
    return listed;
}

} // namespace lubberline::app
