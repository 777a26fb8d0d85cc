// How the window reaches compass bases and datum instruments.

#include <utility>

#include "ui/kit/PageDescription.h"
#include "ui/sites/InstrumentsPage.h"
#include "ui/sites/SitesPage.h"

namespace lubberline::ui {

PageDescription SitesPage::description(PageContext& context)
{
    auto add = std::make_shared<bool>(false);
    PageDescription page{QStringLiteral("sites"), [&context, add] {
                             auto* sites = new SitesPage(context.edits, context.undo, context.today());
                             sites->m_addWanted = add;
                             return sites;
                         }};
    page.commands
        = {{MenuId::Fleet, 120, tr("Compass &bases"), tr("Ctrl+Alt+B"), "showSites", [&context](Page&) { context.go({"sites"}); }},
            {MenuId::Fleet, 13, tr("New &base…"), {}, "newBase",
                [&context, add](Page&) {
                    *add = true;
                    context.go({"sites"});
                },
                needsWriting},
            {MenuId::Fleet, 23, tr("Remove this base"), {}, "removeBase", [](Page& shown) { dynamic_cast<SitesPage&>(shown).removeSite(); },
                [](const Shown& shown) { return shown.writable && shown.base; }}};
    page.help = tr(
        "Compass bases: place, class and certificate, the lines that are painted there, and the survey. Paste the survey's points from a spreadsheet with Ctrl+V: whether the base is fit, and for what, follows.");
    return page;
}

Result<void> SitesPage::open(const FleetItem&)
{
    reload();
    if (std::exchange(*m_addWanted, false))
        addSite();
    return {};
}

Shown SitesPage::shown() const
{
    Shown shown;
    shown.base = !m_fields.record().record.empty();
    return shown;
}

PageDescription InstrumentsPage::description(PageContext& context)
{
    PageDescription page{
        QStringLiteral("instruments"), [&context] { return new InstrumentsPage(context.edits, context.undo, context.today()); }};
    page.commands = {{MenuId::Fleet, 130, tr("&Datum instruments"), tr("Ctrl+Shift+M"), "showInstruments",
        [&context](Page&) { context.go({"instruments"}); }}};
    page.help = tr(
        "The datum instruments, and what their figures mean: the example under the form shows what heading a figure stands for, which makes a wrong setting plain.");
    return page;
}

Result<void> InstrumentsPage::open(const FleetItem&)
{
    reload();
    return {};
}

} // namespace lubberline::ui
