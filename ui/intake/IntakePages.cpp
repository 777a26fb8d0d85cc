// How the window reaches the ways in which a swing comes in: typed anew, or from a log.

#include "ui/intake/NewSwingPage.h"
#include "ui/intake/NmeaImportPage.h"
#include "ui/intake/YearsImportPage.h"
#include "ui/kit/PageDescription.h"
#include "ui/kit/Preferences.h"
#include "ui/plots/swing/SwingPlot.h"

namespace lubberline::ui {

PageDescription NewSwingPage::description(PageContext& context)
{
    PageDescription page{
        QStringLiteral("newSwing"), [&context] {
            auto* fresh = new NewSwingPage(context.edits, context.undo);
            fresh->setUsualSite([&context] { return context.preferences->site().toStdString(); });
            connect(fresh, &NewSwingPage::created, &context.window, [&context](SwingId id) { context.go({{}, id, true}); });
            connect(fresh, &NewSwingPage::cancelled, &context.window, [&context] { context.goBack("swing"); });
            return fresh;
        }};
    page.commands = {{MenuId::File, 100, tr("&New swing"), QKeySequence::New, "newSwing",
        [&context](Page& shown) {
            context.go({"newSwing", shown.shown().item()});
        },
        needsWriting}};
    page.focus = true;
    page.help = tr(
        "Pick the aircraft and its compass, or type new ones; Enter goes on to the next field. The readings are typed on the page that follows.");
    return page;
}

/// With the compass or aircraft already chosen; what is not known is left open.
Result<void> NewSwingPage::open(const FleetItem& record)
{
    const auto* compass = std::get_if<CompassId>(&record);
    const auto* aircraft = std::get_if<AircraftId>(&record);
    if (const auto found = compass ? m_context.stores.fleet.compass(*compass) : Result<CompassSystem>(Error{}); found)
        begin(found->aircraft, *compass);
    else
        begin(aircraft ? *aircraft : AircraftId(), {});
    return {};
}

PageDescription NmeaImportPage::description(PageContext& context)
{
    PageDescription page{
        QStringLiteral("nmeaImport"), [&context] {
            auto* log = new NmeaImportPage(context.stores, context.files);
            connect(log, &NmeaImportPage::makeSwing, &context.window, [&context](const Swing& swing) { context.makeSwing(swing); });
            return log;
        }};
    page.commands = {{MenuId::Swing, 200, tr("Swing from an &NMEA log…"), tr("Ctrl+Shift+I"), "nmeaImport",
        [&context](Page& shown) {
            context.go({"nmeaImport", shown.shown().compass});
        },
        needsCompass}};
    page.help
        = tr("Open a log of a slow turn through all headings: what of it is used, what is cut off and why, and the curve that it gives. "
             "Say what the compass is held against, and the variation where the log has none; then make a swing of it.");
    return page;
}

PageDescription YearsImportPage::description(PageContext& context)
{
    PageDescription page{
        QStringLiteral("yearsImport"), [&context] {
            auto* years = new YearsImportPage(context.stores, context.files);
            connect(years, &YearsImportPage::done, &context.window, [&context](const QString& message) { context.say(message); });
            return years;
        }};
    page.commands = {{MenuId::File, 115, tr("Records of &years…"), tr("Ctrl+Alt+I"), "yearsImport",
        [&context](Page& shown) {
            context.go({"yearsImport", shown.shown().item()});
        },
        needsWriting}};
    page.focus = true;
    page.help = tr(
        "Swings of many years on paper, typed into one table: open it, say what each column is and what stands under the headings, and look at the "
        "first swings. Records whose sign the type's D speaks against are told, never turned. What was stored is undone as one step.");
    return page;
}

Result<void> NmeaImportPage::open(const FleetItem& record)
{
    const auto* id = std::get_if<CompassId>(&record);
    return showCompass(id ? *id : CompassId());
}

Plot* NmeaImportPage::plot() const { return m_plot; }

} // namespace lubberline::ui
