// How the window reaches the iron bench of a compass.

#include "ui/bench/IronBenchPage.h"
#include "ui/kit/PageDescription.h"

namespace lubberline::ui {

PageDescription IronBenchPage::description(PageContext& context)
{
    PageDescription page{QStringLiteral("ironBench"), [&context] { return new IronBenchPage(context.edits, context.undo, context.files); }};
    page.commands = {{MenuId::Model, 110, tr("&Iron bench of this compass"), tr("Ctrl+Shift+B"), "ironBench",
        [&context](Page& shown) {
            context.go({"ironBench", shown.shown().compass});
        },
        needsCompass}};
    return page;
}

Result<void> IronBenchPage::open(const FleetItem& record)
{
    const auto* id = std::get_if<CompassId>(&record);
    return showCompass(id ? *id : CompassId());
}

bool IronBenchPage::isOf(const FleetItem& record) const { return record == FleetItem(compass()); }

Shown IronBenchPage::shown() const { return {{}, compass()}; }

} // namespace lubberline::ui
