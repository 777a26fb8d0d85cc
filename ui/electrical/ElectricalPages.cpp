// How the window reaches the electrical swings of a compass.

#include "ui/electrical/ElectricalPage.h"
#include "ui/kit/PageDescription.h"

namespace lubberline::ui {

PageDescription ElectricalPage::description(PageContext& context)
{
    PageDescription page{
        QStringLiteral("electrical"), [&context] {
            auto* electrical = new ElectricalPage(context.edits, context.undo, context.today());
            connect(electrical, &ElectricalPage::makeSwing, &context.window, [&context](const Swing& swing) { context.makeSwing(swing); });
            return electrical;
        }};
    page.commands = {{MenuId::Swing, 210, tr("&Electrical swings of this compass"), tr("Ctrl+Shift+L"), "electricalSwings",
        [&context](Page& shown) {
            context.go({"electrical", shown.shown().compass});
        },
        needsCompass}};
    return page;
}

Result<void> ElectricalPage::open(const FleetItem& record)
{
    const auto* id = std::get_if<CompassId>(&record);
    return showCompass(id ? *id : CompassId());
}

} // namespace lubberline::ui
