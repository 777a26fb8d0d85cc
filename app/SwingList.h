#pragma once

#include <string>
#include <vector>

#include "app/OpenStores.h"
#include "db/stores/SwingMarks.h"

namespace lubberline::app {

/// A swing with the names of what it is of.
struct ListedSwing {
    std::string type, aircraft, compass;
    RecordId record;
    SwingRow row;
    RadioState radio = RadioState::NotStated;
    db::SignedMark mark = db::SignedMark::No;
};

/// In order of type, aircraft and compass, the newest first. @param aircraft of this registration only; empty: all.
Result<std::vector<ListedSwing>> listSwings(db::Stores& stores, const std::string& aircraft = {});

} // namespace lubberline::app
