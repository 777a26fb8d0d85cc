#include "app/Demonstration.h"

#include "app/Console.h"
#include "app/Paths.h"
#include "core/demo/DemoFleet.h"

namespace lubberline::app {

Result<std::unique_ptr<DbStorage>> openDemonstration(const std::string& option)
{
    const auto path = demonstrationPath(option);
    if (!path)
        return path.error();
    auto storage = openStorage(path->toStdString(), db::OpenMode::ReadWriteCreate);
    if (!storage)
        return storage.error();
    const auto totals = (*storage)->totals();
    if (!totals)
        return totals.error();
    if (totals->swings == 0)
        if (const auto imported = (*storage)->importFleet(demoFleet(), consoleProgress("storing the demonstration fleet")); !imported)
            return imported.error();
    return storage;
}

} // namespace lubberline::app
