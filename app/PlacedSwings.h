#pragma once
/// Swings of the database with the fields that they were made in.

#include <optional>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "core/record/Site.h"
#include "core/swing/IronSeparation.h"

namespace lubberline::app {

struct PlacedSwings {
    std::vector<SwingAtPlace> swings;
    std::optional<LimitsProfile> limits; ///< of their compass
};

/// By record ids or their beginnings; all of one compass. Errors: those of the database; NotFound; InvalidInput (of several
/// compasses, no field known, too few headings).
Result<PlacedSwings> placedSwings(const std::string& database, const std::vector<std::string>& names);

} // namespace lubberline::app
