#include "ui/kit/Page.h"

namespace lubberline::ui {

FleetItem Shown::item() const
{
    if (compass.valid())
        return compass;
    return aircraft.valid() ? FleetItem(aircraft) : FleetItem();
}

/// A field that has the focus loses it while the page goes, and says once more that it was left: to nobody then, as the part of the page
/// that would hear it is gone already.
Page::~Page()
{
    for (QObject* part : findChildren<QObject*>())
        part->disconnect(this);
}

Result<void> Page::open(const FleetItem&) { return {}; }

bool Page::isOf(const FleetItem&) const { return false; }

void Page::takeLook(const Page&) {}

} // namespace lubberline::ui
