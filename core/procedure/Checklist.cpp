#include "core/procedure/Checklist.h"

namespace lubberline {

std::vector<std::string> usualChecklist(const CompassSystem& compass)
{
    const bool remote = compass.kind == CompassKind::RemoteUnstabilised || compass.kind == CompassKind::RemoteStabilised;
    std::vector<std::string> items{
        remote ? "compass system serviceable: no warning flag, indicator lit and steady"
               : "compass serviceable: clear liquid, free card, lamp, lubber line, no bubble",
        "no magnetic items on persons; non-magnetic tools only",
        "clear of steel, pipes, cables and other aircraft",
        "movable ferrous items, doors, seats and gear in flight position",
    };
    if (compass.compensator != Compensator::None)
        items.push_back("compensator as it was found: not touched before the readings as found are taken");
    if (remote)
        items.push_back("variation setter at 000.0");
    return items;
}

} // namespace lubberline
