#pragma once
/// Which swings of a database are looked at as a population. What is empty leaves all in.

#include <optional>
#include <string>

#include "core/record/Swing.h"

namespace lubberline {

struct FleetSelection {
    std::string type = {}, site = {}, compass = {}, aircraft = {}; ///< names
    std::string base = {};                                         ///< where the aircraft are based now
    std::string from = {}, to = {};                                ///< ISO 8601 dates, both included
    std::optional<RadioState> radio = {};
};

} // namespace lubberline
