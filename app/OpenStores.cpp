#include "app/OpenStores.h"

#include "app/Console.h"
#include "app/Paths.h"

namespace lubberline::app {

Result<std::unique_ptr<db::Stores>> openStores(const std::string& option, db::OpenMode mode)
{
    const auto path = databasePath(option);
    if (!path)
        return path.error();
    auto stores = db::openStores(*path, mode);
    keepPrivate(*path); // SQLite has made its files by now
    if (stores)
        for (const auto& told : inEnglish((*stores)->database().told()))
            say(told);
    return stores;
}

} // namespace lubberline::app
