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
    page.help = tr(
        "Describe the ferrous parts, loops and wires round the compass in the tables, or drag them in the drawing: what they do to it is computed at once. "
        "The bench is stored with the compass as a sensor model. A state in which parts are moved or switched is ticked above the tables.");
    page.outputs
        = {{MenuId::File, 200, tr("Save the &bench…"), {}, "saveBench", [](Page& shown) { dynamic_cast<IronBenchPage&>(shown).save(); }}};
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
