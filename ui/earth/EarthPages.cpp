// How the window reaches the Earth's field, and what a compass will read elsewhere in it.

#include "core/swing/SwingField.h"
#include "ui/earth/EarthFieldPage.h"
#include "ui/earth/PredictionPage.h"
#include "ui/kit/PageDescription.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

PageDescription PredictionPage::description(PageContext& context)
{
    PageDescription page{QStringLiteral("prediction"), [&context] { return new PredictionPage(context.stores); }};
    page.commands = {{MenuId::Model, 120, tr("What it will read at another &base"), tr("Ctrl+B"), "predict",
        [&context](Page& shown) {
            context.go({"prediction", shown.shown().swing});
        },
        needsSwing}};
    return page;
}

Result<void> PredictionPage::open(const FleetItem& record)
{
    const auto* id = std::get_if<SwingId>(&record);
    return showSwing(id ? *id : SwingId());
}

PageDescription EarthFieldPage::description(PageContext& context)
{
    PageDescription page{QStringLiteral("earthField"), [&context] { return new EarthFieldPage(context.stores, context.files.open); }};
    page.commands = {{MenuId::Model, 130, tr("&Earth's field"), tr("Ctrl+Shift+F"), "earthField", [&context](Page& shown) {
                          context.go({"earthField", shown.shown().swing});
                      }}};
    return page;
}

/// At the site and on the day of the swing, where these are known.
Result<void> EarthFieldPage::open(const FleetItem& record)
{
    const auto* id = std::get_if<SwingId>(&record);
    if (!id || !id->valid())
        return {};
    const auto swing = m_stores.swings.record(*id);
    if (!swing)
        return swing.error();
    if (const auto stamp = swing->swing.field ? swing->swing.field : stampFor(swing->swing, swing->site))
        showPlace(swing->site ? toText(swing->site->name) : QString(), stamp->place, toText(stamp->date));
    return {};
}

} // namespace lubberline::ui
