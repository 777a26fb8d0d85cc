#include "core/procedure/Checklist.h"

namespace lubberline {

std::vector<std::string> usualChecklist()
{
    return {
        "compass serviceable: clear liquid, free card, lamp, lubber line, no bubble",
        "no magnetic items on persons; non-magnetic tools only",
        "clear of steel, pipes, cables and other aircraft",
        "movable ferrous items, doors, seats and gear in flight position",
        "compensator at zero: dots on the screws in line with those on the case",
        "variation setter at 000.0",
    };
}

} // namespace lubberline
