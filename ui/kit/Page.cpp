#include "ui/kit/Page.h"

namespace lubberline::ui {

FleetItem Shown::item() const
{
    if (compass.valid())
        return compass;
    return aircraft.valid() ? FleetItem(aircraft) : FleetItem();
}

Result<void> Page::open(const FleetItem&) { return {}; }

bool Page::isOf(const FleetItem&) const { return false; }

void Page::takeLook(const Page&) {}

} // namespace lubberline::ui
