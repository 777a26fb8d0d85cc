// How the window reaches what is due.

#include "ui/due/DuePage.h"
#include "ui/due/DueWatch.h"
#include "ui/kit/PageDescription.h"

namespace lubberline::ui {

PageDescription DuePage::description(PageContext& context)
{
    PageDescription page{QStringLiteral("due"), [&context] {
                             auto* due = new DuePage(context.edits, context.undo, context.today(), context.files);
                             connect(due, &DuePage::done, &context.window, [&context](const QString& message) { context.say(message); });
                             connect(due, &DuePage::openCompass, &context.window, [&context](AircraftId aircraft, CompassId compass) {
                                 context.go({{}, compass.valid() ? FleetItem(compass) : FleetItem(aircraft)});
                             });
                             const auto showNews = [&context, due] {
                                 if (context.due->news())
                                     due->show(context.due->news());
                             };
                             connect(context.due, &DueWatch::ready, due, showNews);
                             showNews();
                             return due;
                         }};
    page.commands = {{MenuId::Fleet, 110, tr("What is &due"), tr("Ctrl+J"), "showDue", [&context](Page&) { context.go({"due"}); }}};
    page.focus = true;
    page.help = tr(
        "What calls for a swing, and since when: by the calendar rules, by an event such as a lightning strike, by a move, or because "
        "the fleet's history expects it out of limits before its next date (due from a chance of one half on, due soon from one fifth on). "
        "Enter opens the compass. "
        "An event that needs no swing is waived, with a reason and a name that stay on the record.");
    page.outputs = {{MenuId::File, 200, tr("Write the &calendar (.ics)…"), {}, "writeCalendar",
        [](Page& shown) { dynamic_cast<DuePage&>(shown).exportCalendar(); }}};
    return page;
}

} // namespace lubberline::ui
