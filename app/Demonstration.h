#pragma once

#include "app/OpenStores.h"

namespace lubberline::app {

/// Opens the demonstration database (`option`, else the one in the user's data folder) and fills it when it is empty; one that
/// has swings is left as it is, so that what was tried out in it stays.
Result<std::unique_ptr<db::Stores>> openDemonstration(const std::string& option);

} // namespace lubberline::app
