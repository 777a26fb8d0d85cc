#pragma once
/// Where the window is to go: pages ask for it with a value, and know neither each other nor the window.

#include <QString>

#include <variant>

#include "core/record/Fleet.h"

namespace lubberline::ui {

/// A record that has a place in the tree of the fleet; none: the fleet itself.
using FleetItem = std::variant<std::monostate, AircraftTypeId, AircraftId, CompassId, SwingId>;

struct Destination {
    QString page = {};     ///< PageDescription::id; empty: the page that shows such a record
    FleetItem record = {}; ///< what it is to show
    bool focus = false;    ///< with the cursor in it
};

} // namespace lubberline::ui
