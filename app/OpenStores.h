#pragma once
/// The database of `--db` (see databasePath()).

#include <memory>
#include <string>

#include "db/stores/Stores.h"

namespace lubberline::app {

Result<std::unique_ptr<db::Stores>> openStores(const std::string& option, db::OpenMode mode);

} // namespace lubberline::app
