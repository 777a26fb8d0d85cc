// How the window reaches the guided swing: a compass begins one, a swing that has one open goes on with it.

#include <algorithm>

#include "ui/guided/GuidedPage.h"
#include "ui/kit/PageDescription.h"
#include "ui/plots/swing/SwingPlot.h"

namespace lubberline::ui {

namespace {

bool guidedOpen(db::Stores& stores, const FleetItem& record)
{
    const auto* id = std::get_if<SwingId>(&record);
    if (!id)
        return false;
    const auto jobs = stores.jobs.open();
    return jobs && std::any_of(jobs->begin(), jobs->end(), [id](const JobRow& job) { return job.swing == *id; });
}

/// Goes on with the one that is chosen, or begins one for the compass that is.
void goGuided(PageContext& context, const Shown& shown)
{
    const FleetItem swing = shown.swing;
    if (guidedOpen(context.stores, swing))
        context.go({"guided", swing});
    else if (shown.compass.valid())
        context.go({"guided", shown.compass});
    else {
        context.leaveField();
        context.fail(GuidedPage::tr("A guided swing is of one compass: choose it, or a swing of it, in the tree."));
    }
}

GuidedPage* makePage(PageContext& context)
{
    auto* page = new GuidedPage(context.stores, [&stores = context.stores] { return stores.clock().nowUtc(); });
    QObject::connect(page, &GuidedPage::notStored, &context.window, [&context, page](SwingId, std::size_t place, const JobEvent& event) {
        context.keep(page->job().record(), LostStep{place, event});
    });
    QObject::connect(page, &GuidedPage::cancelled, &context.window, [&context] { context.go({}); });
    QObject::connect(page, &GuidedPage::finished, &context.window, [&context](SwingId id) { context.go({{}, id}); });
    return page;
}

} // namespace

PageDescription GuidedPage::description(PageContext& context)
{
    PageDescription page{QStringLiteral("guided"), [&context] { return makePage(context); }};
    page.commands = {{MenuId::Swing, 100, tr("&Guided swing on the ramp"), tr("Ctrl+Shift+G"), "guidedSwing",
        [&context](Page& shown) { goGuided(context, shown.shown()); }, needsWriting}};
    page.shows = [&context](const FleetItem& item) { return guidedOpen(context.stores, item); };
    page.help = tr(
        "One step a page: turn to the heading, type what datum and compass read, Enter. F2 repeats a step, F4 leaves it out, F8 reports a fault, F11 shows the crew's display, F12 listens to instruments. "
        "Every figure is stored as it is typed; an interrupted swing goes on where it stood.");
    return page;
}

Result<void> GuidedPage::open(const FleetItem& record)
{
    if (const auto* swing = std::get_if<SwingId>(&record))
        return takeUp(*swing);
    const auto* compass = std::get_if<CompassId>(&record);
    return begin(compass ? *compass : CompassId());
}

Plot* GuidedPage::plot() const { return m_pages->currentWidget() == m_work ? m_plot : nullptr; }

} // namespace lubberline::ui
