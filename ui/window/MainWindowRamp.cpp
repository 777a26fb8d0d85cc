// The work on the ramp: the guided swing, and how the window reaches it.

#include <QAction>
#include <QLabel>
#include <QMenu>
#include <QStackedWidget>
#include <QTimer>

#include <algorithm>

#include "ui/due/DuePage.h"
#include "ui/due/DueWatch.h"
#include "ui/electrical/ElectricalPage.h"
#include "ui/fleet/FleetPanel.h"
#include "ui/fleet/RecordEdits.h"
#include "ui/guided/GuidedPage.h"
#include "ui/intake/NmeaImportPage.h"
#include "ui/kit/MessagePanel.h"
#include "ui/kit/Words.h"
#include "ui/sites/InstrumentsPage.h"
#include "ui/sites/SitesPage.h"
#include "ui/swing/SwingEditor.h"
#include "ui/swing/SwingPage.h"
#include "ui/window/MainWindow.h"

namespace lubberline::ui {

namespace {

constexpr int kDueDelay_ms = 300; // many changes at once are looked at once

}

std::string MainWindow::nowUtc() const { return m_stores.clock().nowUtc(); }

bool MainWindow::guidedOpen(SwingId id)
{
    const auto jobs = m_stores.jobs.open();
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
    showOn(
        m_guidedPage, false, [this] { return makeGuidedPage(); }, [compass](GuidedPage& page) { return page.begin(compass); });
}

void MainWindow::takeUpGuided(SwingId swing)
{
    leaveField();
    showOn(
        m_guidedPage, false, [this] { return makeGuidedPage(); }, [swing](GuidedPage& page) { return page.takeUp(swing); });
}

GuidedPage* MainWindow::makeGuidedPage()
{
    auto* page = new GuidedPage(m_stores, [this] { return nowUtc(); });
    connect(page, &GuidedPage::failed, this, &MainWindow::fail);
    connect(page, &GuidedPage::notStored, this, [this, page](SwingId, std::size_t place, const JobEvent& event) {
        keepElsewhere(page->job().record(), LostStep{place, event});
    });
    connect(page, &GuidedPage::cancelled, this, &MainWindow::showHome);
    connect(page, &GuidedPage::finished, this, [this](SwingId id) { showSwing(id); });
    return page;
}

/// Found on a worker after the first paint, and whenever something changed.
void MainWindow::watchDue()
{
    m_dueWatch = new DueWatch(
        m_stores, [this] { return m_stores.clock().today(); }, this);
    auto* soon = new QTimer(this);
    soon->setSingleShot(true);
    soon->setInterval(kDueDelay_ms);
    connect(soon, &QTimer::timeout, m_dueWatch, &DueWatch::start);
    for (const auto signal : {&db::Changes::fleetChanged, &db::Changes::dueChanged, &db::Changes::sitesChanged})
        connect(&m_stores.changes(), signal, soon, qOverload<>(&QTimer::start));
    connect(m_dueWatch, &DueWatch::failed, this, &MainWindow::fail);
    connect(m_dueWatch, &DueWatch::ready, this, [this] {
        m_fleet->showDue(m_dueWatch->news()->lines, m_dueWatch->news()->due());
        if (m_duePage)
            m_duePage->show(m_dueWatch->news());
    });
    connect(m_fleet, &FleetPanel::dueWanted, this, &MainWindow::showDue);
    soon->start();
}

void MainWindow::showDue()
{
    leaveField();
    if (m_dueWatch->news())
        duePage().show(m_dueWatch->news());
    turnTo(duePage());
    duePage().setFocus();
}

DuePage& MainWindow::duePage()
{
    if (m_duePage)
        return *m_duePage;
    m_duePage = new DuePage(
        m_stores, [this] { return m_stores.clock().today(); }, fileQuestions());
    m_pages->addWidget(m_duePage);
    connect(m_duePage, &DuePage::failed, this, &MainWindow::fail);
    connect(m_duePage, &DuePage::done, this, [this](const QString& message) { report({}, message); });
    connect(m_duePage, &DuePage::openCompass, this, &MainWindow::showAircraft);
    return *m_duePage;
}

template <class Page>
Page* MainWindow::wired(Page* page)
{
    connect(page, &Page::failed, this, &MainWindow::fail);
    if constexpr (requires { &Page::readOut; })
        connect(page, &Page::readOut, m_readOut, &QLabel::setText);
    if constexpr (requires { &Page::makeSwing; })
        connect(page, &Page::makeSwing, this, &MainWindow::makeSwing);
    return page;
}

template <class Page, class Make>
Page& MainWindow::pageOf(Page*& place, Make make)
{
    if (!place) {
        place = wired(make());
        m_pages->addWidget(place);
    }
    return *place;
}

/// What could not be stored when the drive failed is put in when the user says so.
void MainWindow::offerRecovery()
{
    const auto lost = m_recovery.entriesFor(m_stores.location());
    if (lost.empty() || m_stores.readOnly())
        return;
    QStringList subjects;
    for (const auto& entry : lost)
        if (!subjects.contains(toText(entry.subject)))
            subjects += toText(entry.subject);
    m_messages->add(MessagePanel::Kind::Failure,
        tr("%n figures or steps could not be stored last time and were kept: %1.", nullptr, static_cast<int>(lost.size()))
            .arg(subjects.join(QStringLiteral("; "))),
        tr("Put them in"), [this] {
            const auto restored = m_recovery.restore(m_stores);
            if (restored.done > 0)
                m_messages->add(MessagePanel::Kind::Information, tr("%n were put in.", nullptr, restored.done));
            for (const QString& failure : restored.failures)
                fail(failure);
        });
}

void MainWindow::keepElsewhere(const SwingRecord& record, std::variant<LostStep, LostReading> what)
{
    const LostEntry entry{m_stores.location().toStdString(), record.swing.id, record.swing.record,
        record.aircraft.registration + ", " + record.compass.name + ", " + record.swing.date, std::move(what)};
    if (const auto kept = m_recovery.keep(entry); kept)
        m_messages->add(MessagePanel::Kind::Information, tr("What could not be stored is kept and offered at the next start."));
    else
        fail(messageOf(kept.error()));
}

void MainWindow::showSites()
{
    leaveField();
    auto& page = pageOf(m_sitesPage, [this] { return new SitesPage(m_context, m_stack, [this] { return m_stores.clock().today(); }); });
    page.reload();
    turnTo(page);
}

void MainWindow::showInstruments()
{
    leaveField();
    auto& page = pageOf(m_instrumentsPage, [this] { return new InstrumentsPage(m_stores, [this] { return m_stores.clock().today(); }); });
    page.reload();
    turnTo(page);
}

void MainWindow::showElectrical()
{
    const CompassId compass = compassShown();
    leaveField();
    showOn(
        m_electricalPage, false, [this] { return wired(new ElectricalPage(m_stores, [this] { return m_stores.clock().today(); })); },
        [compass](ElectricalPage& page) { return page.showCompass(compass); });
}

void MainWindow::showNmeaImport()
{
    const CompassId compass = compassShown();
    leaveField();
    showOn(
        m_nmeaPage, false, [this] { return wired(new NmeaImportPage(m_stores, fileQuestions())); },
        [compass](NmeaImportPage& page) { return page.showCompass(compass); });
}

void MainWindow::makeSwing(Swing swing)
{
    auto* edit = new MakeSwing(m_context, std::move(swing), MakeSwing::Direction::Make, tr("new swing"));
    const int command = m_stack.index();
    m_stack.push(edit);
    if (m_stack.index() > command) // storage has not refused it
        showEdited(command);
}

} // namespace lubberline::ui
