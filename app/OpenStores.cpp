#include "app/OpenStores.h"

#include "app/Paths.h"

namespace lubberline::app {

Result<std::unique_ptr<db::Stores>> openStores(const std::string& option, db::OpenMode mode)
{
    const auto path = databasePath(option);
    if (!path)
        return path.error();
    return db::openStores(*path, mode);
}

} // namespace lubberline::app
