#include "ui/window/MainWindow.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QLabel>
#include <QMimeData>
#include <QScreen>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTimer>
#include <QVBoxLayout>

#include "ui/bench/IronBenchPage.h"
#include "ui/fleet/AircraftPage.h"
#include "ui/fleet/FleetPanel.h"
#include "ui/fleet/OverviewPage.h"
#include "ui/fleet/StartPage.h"
#include "ui/intake/ImportPanels.h"
#include "ui/intake/NewSwingPage.h"
#include "ui/kit/MessagePanel.h"
#include "ui/kit/Theme.h"
#include "ui/kit/Words.h"
#include "ui/sensor/SensorPage.h"
#include "ui/swing/SwingEditor.h"
#include "ui/swing/SwingPage.h"

namespace lubberline::ui {

MainWindow::MainWindow(db::Stores& stores, WindowServices services)
    : m_stores(stores)
    , m_services(std::move(services))
    , m_context{stores,
          [this](const Error& error) {
              fail(messageOf(error));
              showSaved(false);
          }}
    , m_recovery(m_services.recoveryFiles)
    , m_transfer([this](const Result<TransferOutcome>& outcome) { finishTransfer(outcome); },
          [this](int percent) { m_progress->setPercent(percent); })
{
    applyTheme(m_services.settings.value("view/dark", false).toBool());
    if (m_services.settings.value("view/minutes", false).toBool())
        m_style = AngleStyle::DegreesMinutes;
    setWindowTitle(tr("%1 – Lubberline").arg(QFileInfo(stores.location()).fileName()));
    setWindowIcon(icon("lubberline"));
    setAcceptDrops(true);
    buildParts();
    buildActions();
    buildStatusBar();
    resize(QSize(1440, 860).boundedTo(screen()->availableSize() - QSize(20, 40))); // with a frame, on a screen of 1366×768 too
    restoreGeometry(m_services.settings.value("window/geometry").toByteArray());
    restoreState(m_services.settings.value("window/state").toByteArray());
    connect(&m_stack, &QUndoStack::indexChanged, this, [this] { showSaved(true); });
    connect(&m_stores.changes(), &db::Changes::fleetChanged, this, &MainWindow::afterFleetChange);
    connect(m_progress, &ProgressStrip::cancelled, this, [this] { m_transfer.cancel(); });
    connect(m_naming, &NamingStrip::named, this, &MainWindow::importFile);
}

MainWindow::~MainWindow() = default;

void MainWindow::buildParts()
{
    m_fleet = new FleetPanel(m_stores);
    auto* dock = new QDockWidget(tr("Fleet"), this);
    dock->setObjectName(QStringLiteral("fleetDock"));
    dock->setWidget(m_fleet);
    dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable);
    addDockWidget(Qt::LeftDockWidgetArea, dock);
    resizeDocks({dock}, {296}, Qt::Horizontal);
    connect(m_fleet, &FleetPanel::itemChosen, this, &MainWindow::go);
    connect(m_fleet, &FleetPanel::itemOpened, this, [this] { m_pages->currentWidget()->setFocus(); });
    connect(m_fleet, &FleetPanel::failed, this, &MainWindow::fail);

    m_messages = new MessagePanel;
    m_progress = new ProgressStrip;
    m_naming = new NamingStrip;
    m_pages = new QStackedWidget;
    m_pages->addWidget(new QWidget); // nothing yet: what to show is asked after the first paint
    auto* central = new QWidget;
    auto* layout = new QVBoxLayout(central);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_messages);
    layout->addWidget(m_progress);
    layout->addWidget(m_naming);
    layout->addWidget(m_pages, 1);
    setCentralWidget(central);
}

void MainWindow::buildStatusBar()
{
    m_saved = new QLabel;
    m_saved->setObjectName(QStringLiteral("savedLabel"));
    m_readOut = new QLabel;
    m_readOut->setObjectName(QStringLiteral("readOut"));
    statusBar()->addWidget(m_saved);
    statusBar()->addPermanentWidget(m_readOut);
    showSaved(true);
}

void MainWindow::showSaved(bool saved)
{
    const QString state = m_stores.readOnly() ? tr("read only") : saved ? tr("all changes saved") : tr("THE LAST CHANGE WAS NOT SAVED");
    m_saved->setText(tr("%1 · %2 · deviation = magnetic − compass, E +").arg(QFileInfo(m_stores.location()).fileName(), state));
    m_saved->setToolTip(m_stores.location());
}

bool MainWindow::event(QEvent* event)
{
    const bool done = QMainWindow::event(event);
    if (event->type() == QEvent::Paint && !m_painted) {
        m_painted = true;
        emit firstPainted();
        QTimer::singleShot(0, this, &MainWindow::populate);
    }
    return done;
}

void MainWindow::populate()
{
    m_fleet->populate();
    m_fleet->focusTree();
    showHome();
    watchDue();
    offerRecovery();
    if (m_stores.readOnly())
        m_messages->add(MessagePanel::Kind::Information, tr("This database can only be read: nothing can be changed here."));
}

void MainWindow::showHome()
{
    const auto totals = m_stores.fleet.totals();
    if (!totals) {
        fail(messageOf(totals.error()));
        return;
    }
    if (totals->aircraft == 0) {
        turnTo(startPage());
        startPage().setFocus();
        return;
    }
    overviewPage().showFleet();
    turnTo(overviewPage());
}

void MainWindow::leaveField()
{
    if (QWidget* typing = focusWidget(); typing && m_pages->isAncestorOf(typing)) {
        typing->clearFocus();
        m_pages->currentWidget()->setFocus();
    }
}

void MainWindow::go(const FleetItem& item)
{
    leaveField();
    if (const auto* swing = std::get_if<SwingId>(&item))
        showSwing(*swing);
    else if (const auto* compass = std::get_if<CompassId>(&item)) {
        if (const auto record = m_stores.fleet.compass(*compass))
            showAircraft(record->aircraft, *compass);
        else
            fail(messageOf(record.error()));
    } else if (const auto* aircraft = std::get_if<AircraftId>(&item))
        showAircraft(*aircraft, {});
    else if (const auto* type = std::get_if<AircraftTypeId>(&item)) {
        overviewPage().showType(*type);
        turnTo(overviewPage());
    } else
        showHome();
}

void MainWindow::showSwing(SwingId id)
{
    if (guidedOpen(id)) {
        takeUpGuided(id);
        return;
    }
    const bool same = m_swingPage && m_swingPage->editor().id() == id;
    const auto look = m_swingPage ? m_swingPage->look() : SwingPage::Look();
    if (!showOn(
            m_swingPage, same, [this] { return makeSwingPage(); }, [id](SwingPage& page) { return page.showSwing(id); }))
        return;
    if (!same)
        m_swingPage->setLook(look);
    const SwingRecord& record = m_swingPage->editor().record();
    m_fleet->select({record.type.id, record.aircraft.id, record.compass.id, record.swing.id});
}

void MainWindow::showAircraft(AircraftId id, CompassId compass)
{
    const bool same = m_aircraftPage && m_aircraftPage->aircraft() == id;
    if (!showOn(
            m_aircraftPage, same, [this] { return makeAircraftPage(); },
            [id, compass](AircraftPage& page) { return page.showAircraft(id, compass); }))
        return;
    if (const auto record = m_stores.fleet.aircraft(id)) {
        std::vector<FleetItem> path{record->type, id};
        if (compass.valid())
            path.emplace_back(compass);
        m_fleet->select(path);
    }
}

void MainWindow::showNewSwing()
{
    const AircraftId aircraft = aircraftShown();
    const CompassId compass = compassShown();
    showOn(
        m_newSwingPage, false, [this] { return makeNewSwingPage(); },
        [aircraft, compass](NewSwingPage& page) {
            page.begin(aircraft, compass);
            return Result<void>();
        });
    m_newSwingPage->setFocus();
}

void MainWindow::turnTo(QWidget& page)
{
    m_pages->setCurrentWidget(&page);
    m_readOut->clear();
    updateActions();
}

/// It may be in the middle of telling us something, so it goes when it has done.
void MainWindow::retire(QWidget* page)
{
    if (!page)
        return;
    m_pages->removeWidget(page);
    page->setParent(nullptr);
    page->disconnect(this);
    page->deleteLater();
}

void MainWindow::failWith(const Error& error) { fail(messageOf(error)); }

void MainWindow::afterFleetChange()
{
    QWidget* shown = m_pages->currentWidget();
    if (shown == m_startPage && m_startPage)
        showHome();
    else if (shown == m_overviewPage && m_overviewPage)
        m_overviewPage->refresh();
}

void MainWindow::leaveRemovedSwing()
{
    if (m_aircraftPage && m_aircraftPage->aircraft().valid())
        turnTo(*m_aircraftPage);
    else
        showHome();
}

void MainWindow::fail(const QString& message) { m_messages->add(MessagePanel::Kind::Failure, message); }

SwingPage* MainWindow::makeSwingPage()
{
    auto* page = new SwingPage(m_context, m_stack);
    page->setAngleStyle(m_style);
    connect(page, &SwingPage::readOut, m_readOut, &QLabel::setText);
    connect(page, &SwingPage::failed, this, &MainWindow::fail);
    connect(page, &SwingPage::stateChanged, this, &MainWindow::updateActions);
    connect(&page->editor(), &SwingEditor::notStored, this, [this, page](int row, const Reading& wanted) {
        keepElsewhere(page->editor().record(), LostReading{row, wanted});
    });
    connect(page, &SwingPage::openSwing, this, [this](SwingId id) { showSwing(id); });
    connect(page, &SwingPage::closed, this, [this, page] {
        if (m_pages->currentWidget() == page)
            leaveRemovedSwing();
    });
    return page;
}

AircraftPage* MainWindow::makeAircraftPage()
{
    auto* page = new AircraftPage(m_context, m_stack);
    connect(page, &AircraftPage::swingChosen, this, &MainWindow::showSwing);
    connect(page, &AircraftPage::readOut, m_readOut, &QLabel::setText);
    connect(page, &AircraftPage::failed, this, &MainWindow::fail);
    return page;
}

OverviewPage& MainWindow::overviewPage()
{
    if (m_overviewPage)
        return *m_overviewPage;
    m_overviewPage = new OverviewPage(m_stores);
    m_pages->addWidget(m_overviewPage);
    connect(m_overviewPage, &OverviewPage::aircraftChosen, this, [this](AircraftId id) { showAircraft(id, {}); });
    connect(m_overviewPage, &OverviewPage::newSwingWanted, this, &MainWindow::showNewSwing);
    connect(m_overviewPage, &OverviewPage::importWanted, this, &MainWindow::chooseImport);
    connect(m_overviewPage, &OverviewPage::failed, this, &MainWindow::fail);
    return *m_overviewPage;
}

StartPage& MainWindow::startPage()
{
    if (m_startPage)
        return *m_startPage;
    m_startPage = new StartPage;
    m_pages->addWidget(m_startPage);
    connect(m_startPage, &StartPage::demonstrationWanted, this, [this] { m_services.openDemonstration(); });
    connect(m_startPage, &StartPage::importWanted, this, &MainWindow::chooseImport);
    connect(m_startPage, &StartPage::newSwingWanted, this, &MainWindow::showNewSwing);
    return *m_startPage;
}

NewSwingPage* MainWindow::makeNewSwingPage()
{
    auto* page = new NewSwingPage(m_context, m_stack);
    connect(page, &NewSwingPage::created, this, [this](SwingId id) {
        showSwing(id);
        m_swingPage->focusReadings();
    });
    connect(page, &NewSwingPage::cancelled, this, [this] {
        if (m_swingPage && m_swingPage->editor().id().valid())
            turnTo(*m_swingPage);
        else
            showHome();
    });
    return page;
}

bool MainWindow::swingShown() const { return m_swingPage && m_pages->currentWidget() == m_swingPage && m_swingPage->editor().id().valid(); }

AircraftId MainWindow::aircraftShown() const
{
    if (swingShown())
        return m_swingPage->editor().record().aircraft.id;
    return m_aircraftPage && m_pages->currentWidget() == m_aircraftPage ? m_aircraftPage->aircraft() : AircraftId();
}

CompassId MainWindow::compassShown() const
{
    if (swingShown())
        return m_swingPage->editor().record().compass.id;
    if (m_sensorPage && m_pages->currentWidget() == m_sensorPage)
        return m_sensorPage->compass();
    if (m_ironBenchPage && m_pages->currentWidget() == m_ironBenchPage)
        return m_ironBenchPage->compass();
    return m_aircraftPage && m_pages->currentWidget() == m_aircraftPage ? m_aircraftPage->compass() : CompassId();
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    leaveField();
    m_services.settings.setValue("window/geometry", saveGeometry());
    m_services.settings.setValue("window/state", saveState());
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    if (event->mimeData()->hasUrls() && !m_stores.readOnly() && event->mimeData()->urls().value(0).isLocalFile())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    const QList<QUrl> urls = event->mimeData()->urls();
    if (urls.size() > 1)
        m_messages->add(MessagePanel::Kind::Information, tr("%1 files were dropped; the first is imported.").arg(urls.size()));
    event->acceptProposedAction();
    importFile(urls.value(0).toLocalFile());
}

} // namespace lubberline::ui
