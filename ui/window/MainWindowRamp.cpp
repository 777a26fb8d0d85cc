// The work on the ramp: the guided swing, and how the window reaches it.

#include <QAction>
#include <QDateTime>
#include <QMenu>
#include <QStackedWidget>

#include <algorithm>

#include "ui/guided/GuidedPage.h"
#include "ui/pages/SwingPage.h"
#include "ui/readings/SwingEditor.h"
#include "ui/style/Words.h"
#include "ui/window/MainWindow.h"

namespace lubberline::ui {

std::string MainWindow::nowUtc() const
{
    return m_services.nowUtc ? m_services.nowUtc() : QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
}

bool MainWindow::guidedOpen(SwingId id)
{
    const auto jobs = m_storage.openJobs();
    return jobs && std::any_of(jobs->begin(), jobs->end(), [id](const JobRow& job) { return job.swing == id; });
}

/// Goes on with the one that is chosen, or begins one for the compass that is.
void MainWindow::showGuided()
{
    if (swingShown() && guidedOpen(m_swingPage->editor().id()))
        takeUpGuided(m_swingPage->editor().id());
    else
        beginGuided(compassShown());
}

void MainWindow::beginGuided(CompassId compass)
{
    leaveField();
    if (!compass.valid()) {
        fail(tr("A guided swing is of one compass: choose it, or a swing of it, in the tree."));
        return;
    }
    if (const auto begun = guidedPage().begin(compass); !begun) {
        fail(messageOf(begun.error()));
        return;
    }
    turnTo(guidedPage());
    guidedPage().setFocus();
}

void MainWindow::takeUpGuided(SwingId swing)
{
    leaveField();
    if (const auto taken = guidedPage().takeUp(swing); !taken) {
        fail(messageOf(taken.error()));
        return;
    }
    turnTo(guidedPage());
}

GuidedPage& MainWindow::guidedPage()
{
    if (m_guidedPage)
        return *m_guidedPage;
    m_guidedPage = new GuidedPage(m_storage, [this] { return nowUtc(); });
    m_pages->addWidget(m_guidedPage);
    connect(m_guidedPage, &GuidedPage::failed, this, &MainWindow::fail);
    connect(m_guidedPage, &GuidedPage::cancelled, this, &MainWindow::showHome);
    connect(m_guidedPage, &GuidedPage::finished, this, [this](SwingId id) { showSwing(id); });
    return *m_guidedPage;
}

} // namespace lubberline::ui
