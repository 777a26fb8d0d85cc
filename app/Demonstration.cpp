#include "app/Demonstration.h"

#include "app/Console.h"
#include "app/Paths.h"
#include "core/demo/DemoFleet.h"
#include "db/transfer/SignedFleet.h"
#include "db/transfer/Transfer.h"

namespace lubberline::app {

Result<std::unique_ptr<db::Stores>> openDemonstration(const std::string& option)
{
    const auto path = demonstrationPath(option);
    if (!path)
        return path.error();
    auto stores = openStores(path->toStdString(), db::OpenMode::ReadWriteCreate);
    if (!stores)
        return stores.error();
    const auto totals = (*stores)->fleet.totals();
    if (!totals)
        return totals.error();
    if (totals->swings == 0) {
        Fleet fleet = demoFleet();
        db::signInNames(fleet);
        if (const auto imported = db::importFleet((*stores)->database(), fleet, consoleProgress("storing the demonstration fleet"));
            !imported)
            return imported.error();
    }
    return stores;
}

} // namespace lubberline::app
