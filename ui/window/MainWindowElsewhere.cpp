// What another window or a command stores: it is shown, and what it has removed is left.

#include <QApplication>
#include <QTimer>

#include "ui/window/MainWindow.h"
#include "ui/window/PageStack.h"

namespace lubberline::ui {

namespace {

constexpr int kElsewhere_ms = 1000; // a page does not show for long what another window has changed

} // namespace

void MainWindow::watchElsewhere()
{
    auto* now_and_then = new QTimer(this);
    now_and_then->setInterval(kElsewhere_ms);
    connect(now_and_then, &QTimer::timeout, this, &MainWindow::lookElsewhere);
    now_and_then->start();
    lookElsewhere();
}

namespace {

/// Whether there is such a record; where that cannot be read, somebody else says so.
bool isThere(db::Stores& stores, const FleetItem& item)
{
    const auto found = [](const auto& result) { return result || result.error().code != ErrorCode::NotFound; };
    if (const auto* type = std::get_if<AircraftTypeId>(&item))
        return found(stores.fleet.type(*type));
    if (const auto* aircraft = std::get_if<AircraftId>(&item))
        return found(stores.fleet.aircraft(*aircraft));
    if (const auto* compass = std::get_if<CompassId>(&item))
        return found(stores.fleet.compass(*compass));
    const auto* swing = std::get_if<SwingId>(&item);
    return !swing || found(stores.swings.recordOf(*swing));
}

/// From the type down to the record that a page is of; none: it is of no record.
std::vector<FleetItem> pathOf(const Page& page)
{
    auto path = page.path();
    return path.empty() ? std::vector{page.shown().item()} : path;
}

} // namespace

void MainWindow::lookElsewhere()
{
    if (QApplication::activeModalWidget())
        return; // what a question was asked of stays as it is until that is answered
    const auto changed = m_stores.changedElsewhere();
    if (!changed || !*changed)
        return;
    const QString title = m_pages->current().title();
    const FleetItem shown = pathOf(m_pages->current()).back();
    m_stores.changes().announceAll();
    if (isThere(m_stores, shown))
        return;
    leaveRemoved();
    if (QWidget* keys = focusWidget()) // the Enter that ends a figure is to open nothing here
        keys->clearFocus();
    fail(tr("%1 has been removed in another window or by another program.").arg(title));
}

/// A page whose record is no more is left for what that was part of.
void MainWindow::leaveRemoved()
{
    const PageDescription* front = m_pages->description();
    if (!front)
        return;
    std::vector<FleetItem> path = pathOf(m_pages->current());
    if (isThere(m_stores, path.back()))
        return;
    while (!path.empty() && !isThere(m_stores, path.back()))
        path.pop_back();
    const QString left = front->id;
    navigate({{}, path.empty() ? FleetItem() : path.back()});
    m_pages->drop(left);
}

} // namespace lubberline::ui
