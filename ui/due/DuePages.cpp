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
    return page;
}

} // namespace lubberline::ui
