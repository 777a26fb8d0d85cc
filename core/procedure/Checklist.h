#pragma once

#include <string>
#include <vector>

#include "core/record/Aircraft.h"

namespace lubberline {

/// What is usually ticked before the first reading of a guided swing; people may change it. Only what this compass has: a card in
/// liquid, or a variation setter. Nothing here touches the compensator: as it was found it is read first.
[[nodiscard]] std::vector<std::string> usualChecklist(const CompassSystem& compass);

} // namespace lubberline
