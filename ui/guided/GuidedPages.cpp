// How the window reaches the guided swing: a compass begins one, a swing that has one open goes on with it.

#include <QSettings>
#include <QStackedWidget>

#include "ui/guided/GuidedPage.h"
#include "ui/guided/GuidedStart.h"
#include "ui/guided/TypedFigures.h"
#include "ui/intake/LivePanel.h"
#include "ui/kit/OpenSwings.h"
#include "ui/kit/PageDescription.h"
#include "ui/kit/Preferences.h"
#include "ui/kit/Words.h"
#include "ui/plots/swing/SwingPlot.h"

namespace lubberline::ui {

namespace {

bool guidedOpen(db::Stores& stores, const FleetItem& record)
{
    const auto* id = std::get_if<SwingId>(&record);
    return id && isOpenJob(stores, *id);
}

/// Goes on with the one that is chosen, or begins one for the compass that is.
void goGuided(PageContext& context, Page& page)
{
    if (const auto* guided = dynamic_cast<const GuidedPage*>(&page); guided && guided->inWork())
        return; // it is in front
    const Shown shown = page.shown();
    const FleetItem swing = shown.swing;
    if (guidedOpen(context.stores, swing))
        context.go({"guided", swing});
    else if (shown.compass.valid())
        context.go({"guided", shown.compass});
    else if (const auto open = context.stores.jobs.open(); open && !open->empty())
        context.go({"overview", {}, true}); // which offers to go on with them
    else {
        context.leaveField();
        context.fail(GuidedPage::tr("A guided swing is of one compass: choose it, or a swing of it, in the tree."));
    }
}

GuidedPage* makePage(PageContext& context)
{
    auto* page = new GuidedPage(context.stores, [&stores = context.stores] { return stores.clock().nowUtc(); });
    page->take(*context.preferences, context.settings);
    QObject::connect(page, &GuidedPage::notStored, &context.window, [&context, page](SwingId, std::size_t place, const JobEvent& event) {
        context.keep(page->job().record(), LostStep{place, event}, false);
    });
    QObject::connect(page, &GuidedPage::cancelled, &context.window, [&context] { context.go({}); });
    QObject::connect(page, &GuidedPage::abandoned, &context.window, [&context](CompassId compass) { context.go({{}, compass}); });
    QObject::connect(page, &GuidedPage::finished, &context.window, [&context](SwingId id) { context.go({{}, id}); });
    return page;
}

} // namespace

PageDescription GuidedPage::description(PageContext& context)
{
    PageDescription page{QStringLiteral("guided"), [&context] { return makePage(context); }};
    page.commands = {{MenuId::Swing, 100, tr("&Guided swing on the ramp"), tr("Ctrl+Shift+G"), "guidedSwing",
        [&context](Page& shown) { goGuided(context, shown); }, needsWriting}};
    page.shows = [&context](const FleetItem& item) { return guidedOpen(context.stores, item); };
    page.help = tr(
        "One step a page: turn to the heading, type what datum and compass read, Enter. F2 repeats a step, F3 changes the instrument, F4 leaves a heading out and says what that costs, F8 reports a fault, F11 shows the crew's display and closes it, F12 listens to instruments. "
        "A heading that was left out is read at any later time: F2, a click on it in the strip below, or the arrows there and Enter. "
        "Every figure is kept as it is typed; an interrupted swing goes on where it stood, from the overview, the tree, the page of its compass or Ctrl+Shift+G.");
    return page;
}

void GuidedPage::take(const Preferences& preferences, QSettings& settings)
{
    m_start->setUsual(
        [&preferences] { return preferences.site().toStdString(); }, [&preferences] { return preferences.instrument().toStdString(); });
    m_live->rememberIn(settings);
    // Every text that is made larger here says its size in pixels.
    for (QWidget* widget : findChildren<QWidget*>())
        if (QFont font = widget->font();
            widget->testAttribute(Qt::WA_SetFont) && font.pixelSize() > 0 && preferences.rampSize_percent() != 100) {
            font.setPixelSize(font.pixelSize() * preferences.rampSize_percent() / 100);
            widget->setFont(font);
        }
}

Result<void> GuidedPage::open(const FleetItem& record)
{
    if (const auto* swing = std::get_if<SwingId>(&record))
        return takeUp(*swing);
    const auto* compass = std::get_if<CompassId>(&record);
    return begin(compass ? *compass : CompassId());
}

/// Another window or program may have gone on with it: the next figure is of the step at which it stands now.
void GuidedPage::lookAgain()
{
    if (m_storing || !inWork() || !isVisible())
        return;
    const auto found = m_stores.jobs.jobOf(m_swing);
    if (!found || !*found || (*found)->swing != m_swing)
        return; // removed: the window leaves it
    if (!isOpenJob(m_stores, m_swing)) {
        m_typed->forget();
        m_job->close();
        emit readOut(tr("This guided swing has been ended in another window."));
        emit finished(m_swing);
        return;
    }
    if ((*found)->job.events == m_job->job().events)
        return;
    const QStringList unstored = m_typed->figures();
    if (const auto taken = takeUp(m_swing); !taken)
        emit failed(messageOf(taken.error()));
    else if (unstored.isEmpty())
        emit failed(tr("This swing has gone on in another window: it is shown as it stands there."));
    else
        emit failed(tr("This swing has gone on in another window: it is shown as it stands there. What was typed here was not stored: %1.")
                        .arg(unstored.join(QStringLiteral(", "))));
}

bool GuidedPage::inWork() const { return m_job->isOpen(); }

Shown GuidedPage::shown() const
{
    if (!inWork())
        return m_start->compass().valid() ? Shown{m_start->aircraft(), m_start->compass()} : Shown();
    const SwingRecord& record = m_job->record();
    return {record.aircraft.id, record.compass.id};
}

std::vector<FleetItem> GuidedPage::path() const
{
    if (!inWork())
        return {};
    const SwingRecord& record = m_job->record();
    return {record.type.id, record.aircraft.id, record.compass.id, record.swing.id};
}

Plot* GuidedPage::plot() const { return m_pages->currentWidget() == m_work ? m_plot : nullptr; }

} // namespace lubberline::ui
