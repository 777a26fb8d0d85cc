// How the window reaches the Earth's field, and what a compass will read elsewhere in it.

#include "core/swing/SwingField.h"
#include "ui/earth/EarthFieldPage.h"
#include "ui/earth/PredictionPage.h"
#include "ui/kit/PageDescription.h"
#include "ui/kit/Words.h"
#include "ui/plots/swing/PredictionPlot.h"
#include "ui/plots/world/WorldFieldPlot.h"

namespace lubberline::ui {

PageDescription PredictionPage::description(PageContext& context)
{
    PageDescription page{QStringLiteral("prediction"), [&context] { return new PredictionPage(context.stores); }};
    page.commands = {{MenuId::Model, 120, tr("What it will read at another &base"), tr("Ctrl+B"), "predict",
        [&context](Page& shown) {
            context.go({"prediction", shown.shown().swing});
        },
        needsSwing}};
    page.help = tr(
        "Choose the base that the aircraft moves to, or type its place: the deviation that is expected there, how sure it is, and whether a new swing is needed. "
        "From several swings at different places hard and soft iron are told apart, and the prediction is surer.");
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
    page.help = tr(
        "The Earth's field at a site or any place, on a day: variation, dip and strength, how sure the model is, and how a compass can be used there. "
        "The map shows one element over the whole world, with the place on it.");
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

Plot* PredictionPage::plot() const { return m_plot; }

Plot* EarthFieldPage::plot() const { return m_map; }

} // namespace lubberline::ui
