#include "ui/window/MainWindow.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QKeyEvent>
#include <QLabel>
#include <QMenuBar>
#include <QMimeData>
#include <QStatusBar>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

#include "core/record/ClockDates.h"
#include "ui/due/DueWatch.h"
#include "ui/fleet/FleetPanel.h"
#include "ui/fleet/RecordEdits.h"
#include "ui/intake/ImportPanels.h"
#include "ui/kit/LengthLimits.h"
#include "ui/kit/MessagePanel.h"
#include "ui/kit/Theme.h"
#include "ui/kit/Words.h"
#include "ui/kit/fit/ControlFit.h"
#include "ui/kit/keys/Mnemonics.h"
#include "ui/kit/keys/WheelScrolls.h"
#include "ui/text/AngleWords.h"
#include "ui/window/PageStack.h"
#include "ui/window/Pages.h"
#include "ui/window/Placement.h"

namespace lubberline::ui {

namespace {

constexpr int kLeastTree_px = 200;
constexpr int kDueDelay_ms = 300;                     // many changes at once are looked at once
constexpr int kPatience_ms = 80, kTryAgain_ms = 1000; // typing goes on meanwhile

} // namespace

MainWindow::MainWindow(db::Stores& stores, WindowServices services)
    : m_stores(stores)
    , m_services(std::move(services))
    , m_preferences(m_services.settings)
    , m_context{stores,
          [this](const Error& error) {
              if (m_takingOff)
                  return;
              fail(messageOf(error));
              showSaved(false);
              m_refused = true;
          }}
    , m_recovery(m_services.recoveryFiles)
    , m_transfer([this](const Result<TransferOutcome>& outcome) { finishTransfer(outcome); },
          [this](int percent) { m_progress->setPercent(percent); })
    , m_dueWatch(new DueWatch(
          stores, [this] { return m_stores.clock().today(); }, this))
    , m_pageContext(contextOfPages())
{
    applyTheme(m_preferences.dark());
    applyTextSize(m_preferences.textSize_percent());
    setWindowIcon(icon("lubberline"));
    setAcceptDrops(true);
    // Typing must not stand still for the writer of another program: what is refused is kept, and tried again.
    static_cast<void>(m_stores.database().setPatience(kPatience_ms)); // else it waits longer
    m_tryAgain.setInterval(kTryAgain_ms);
    connect(&m_tryAgain, &QTimer::timeout, this, &MainWindow::tryWaiting);
    buildParts();
    buildActions();
    buildStatusBar();
    showPlace();
    m_placement = new Placement(*this, *m_fleet, m_services.settings, m_stores.location());
    m_placement->restore();
    qApp->installEventFilter(this);
    new LengthLimits([this](const QString& words) { m_messages->add(MessagePanel::Kind::Information, words); }, this);
    new WheelScrolls(this);
    connect(&m_stack, &QUndoStack::indexChanged, this, [this] {
        m_messages->mended();
        showSaved(true);
    });
    connect(&m_preferences, &Preferences::changed, this, &MainWindow::applyPreferences);
    rememberDatabase();
    connect(&m_stores.changes(), &db::Changes::fleetChanged, this, &MainWindow::afterFleetChange);
    connect(m_progress, &ProgressStrip::cancelled, this, [this] { m_transfer.cancel(); });
    connect(m_naming, &NamingStrip::named, this, &MainWindow::importFile);
}

/// A tree that was drawn wide on a large screen leaves the pages their room on a small one.
void MainWindow::resizeEvent(QResizeEvent* event)
{
    QMainWindow::resizeEvent(event);
    auto* dock = m_fleet ? qobject_cast<QDockWidget*>(m_fleet->parentWidget()) : nullptr;
    if (dock && dock->isVisible() && !dock->isFloating() && dock->width() > std::max(kLeastTree_px, width() * 2 / 5))
        resizeDocks({dock}, {std::max(kLeastTree_px, width() * 3 / 10)}, Qt::Horizontal);
}

/// Pages go while what they are made of is still there.
MainWindow::~MainWindow() { delete m_pages; }

PageContext MainWindow::contextOfPages()
{
    const FileQuestions files{
        [this](const QString& title, const QString& filter) { return m_services.dialogs.openFile(this, title, filter); },
        [this](const QString& title, const QString& suggestion, const QString& filter) { return askToSave(title, suggestion, filter); },
        [this](const FileToWrite& file) { write(file); }};
    PageContext context{m_stores, m_context, m_stack, m_services.settings, m_services.dialogs, *this, files};
    context.preferences = &m_preferences;
    context.pages = [this]() -> const std::vector<PageDescription>& { return m_pages->descriptions(); };
    context.pageInFront = [this] { return m_pages->description() ? m_pages->description()->id : QString(); };
    context.reopen = m_services.reopen;
    context.due = m_dueWatch;
    context.go = [this](const Destination& destination) { navigate(destination); };
    context.goBack = [this](const QString& page) { goBack(page); };
    context.say = [this](const QString& message) {
        if (!m_asked.isEmpty() && message.contains(m_asked))
            tellWritten(message, std::exchange(m_asked, {}));
        else
            m_messages->add(MessagePanel::Kind::Information, message);
    };
    context.fail = [this](const QString& message) { fail(message); };
    context.makeSwing = [this](Swing swing) { makeSwing(std::move(swing)); };
    context.keep = [this](const SwingRecord& record, std::variant<LostStep, LostReading> what, bool waits) {
        keepElsewhere(record, std::move(what), waits);
    };
    context.leaveField = [this] { leaveField(); };
    context.chooseImport = [this] { chooseImport(); };
    context.openDemonstration = [this] { m_services.openDemonstration(); };
    return context;
}

void MainWindow::buildParts()
{
    m_fleet = new FleetPanel(m_stores);
    auto* dock = new QDockWidget(tr("Fleet"), this);
    dock->setObjectName(QStringLiteral("fleetDock"));
    dock->setWidget(m_fleet);
    finishControls(*m_fleet);
    dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable);
    addDockWidget(Qt::LeftDockWidgetArea, dock);
    resizeDocks({dock}, {296}, Qt::Horizontal);
    connect(m_fleet, &FleetPanel::itemChosen, this, &MainWindow::choose);
    connect(m_fleet, &FleetPanel::itemOpened, this, [this] { m_pages->current().setFocus(); });
    connect(m_fleet, &FleetPanel::failed, this, &MainWindow::fail);
    buildCentre();
}

void MainWindow::buildCentre()
{
    m_messages = new MessagePanel;
    m_progress = new ProgressStrip;
    m_naming = new NamingStrip;
    m_pages = new PageStack(m_pageContext, allPages(m_pageContext));
    m_pages->setAngleStyle(m_preferences.angleStyle());
    connect(m_pages, &PageStack::failed, this, &MainWindow::fail);
    connect(m_pages, &PageStack::stateChanged, this, &MainWindow::updateActions);
    connect(m_pages, &PageStack::turned, this, [this] {
        m_readOut->clear();
        m_messages->turned();
        makeMnemonicsDistinct(m_pages->current(), *this);
        updateActions();
        showPlace();
    });
    connect(m_pages, &PageStack::titled, this, &MainWindow::showPlace);
    connect(m_pages, &PageStack::leftBehind, this, [this](const QString& title, const QStringList& texts) {
        m_messages->add(MessagePanel::Kind::Failure,
            tr("%1: what was typed there was refused and is not stored: %2.").arg(title, texts.join(QStringLiteral(", "))), {},
            MessagePanel::Stay::UntilClosed);
    });
    connect(m_pages, &PageStack::stateChanged, this, &MainWindow::showPlace);
    auto* central = new QWidget;
    auto* layout = new QVBoxLayout(central);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_messages);
    layout->addWidget(m_progress);
    layout->addWidget(m_naming);
    layout->addWidget(m_pages, 1);
    setCentralWidget(central);
    finishControls(*m_naming);
}

void MainWindow::buildStatusBar()
{
    m_saved = new QLabel;
    m_saved->setObjectName(QStringLiteral("savedLabel"));
    m_readOut = new QLabel;
    m_readOut->setObjectName(QStringLiteral("readOut"));
    connect(m_pages, &PageStack::readOut, this, [this](const QString& text) { m_readOut->setText(inAngleStyle(text)); });
    m_saved->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // a long name makes no window wider; the tip has all of it
    statusBar()->addWidget(m_saved, 1);
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
    m_placement->restoreTree();
    m_fleet->focusTree();
    navigate({});
    watchDue();
    watchElsewhere();
    offerRecovery();
    for (const Message& told : m_stores.database().told())
        m_messages->add(MessagePanel::Kind::Information, toText(told));
    if (m_stores.readOnly())
        m_messages->add(MessagePanel::Kind::Information, tr("This database can only be read: nothing can be changed here."), {},
            MessagePanel::Stay::UntilClosed);
}

void MainWindow::leaveField()
{
    if (QWidget* typing = focusWidget(); typing && m_pages->isAncestorOf(typing)) {
        typing->clearFocus();
        m_pages->current().setFocus();
    }
}

void MainWindow::go(const FleetItem& item) { navigate({{}, item}); }

void MainWindow::navigate(const Destination& destination)
{
    m_leaving = true; // a figure that is refused on the way out is told on the next page, too
    m_refused = false;
    leaveField();
    m_leaving = false;
    if (!m_refused) // what was not saved was said on the page that is left
        showSaved(true);
    if (const auto shown = m_pages->show(destination); !shown)
        fail(messageOf(shown.error()));
    else
        m_trail.visit({m_pages->description()->id, destination.record});
    showPlace();
}

/// What is in front already is not opened a second time.
void MainWindow::choose(const FleetItem& item)
{
    const Destination* here = m_trail.current();
    const PageDescription* front = m_pages->description();
    if (here && front && here->page == front->id && here->record == item && front->shows && front->shows(item))
        return;
    go(item);
}

void MainWindow::step(int step)
{
    leaveField();
    while (const auto place = m_trail.go(step)) {
        if (m_pages->show(*place))
            break;
        m_trail.drop(step); // its record is no more
    }
    showPlace();
}

void MainWindow::showPlace()
{
    const Page& page = m_pages->current();
    const QString file = QFileInfo(m_stores.location()).fileName();
    const QString title = page.whose().isEmpty() ? page.title() : QStringLiteral("%1 · %2").arg(page.whose(), page.title());
    setWindowTitle(title.isEmpty() ? tr("%1 – Lubberline").arg(file) : tr("%1 – %2 – Lubberline").arg(title, file));
    if (m_back) {
        m_back->setEnabled(m_trail.canGo(-1));
        m_forward->setEnabled(m_trail.canGo(+1));
    }
    if (const auto path = page.path(); !path.empty() && path != m_path) {
        m_path = path;
        m_fleet->select(path);
    }
}

void MainWindow::goBack(const QString& page)
{
    if (!m_pages->showAsLeft(page))
        navigate({});
    else
        m_trail.visit({page, m_pages->current().shown().item()});
    leaveRemoved();
    showPlace();
}

Shown MainWindow::shown() const
{
    Shown shown = m_pages->current().shown();
    shown.writable = !m_stores.readOnly();
    shown.plot = m_pages->current().plot() != nullptr;
    return shown;
}

void MainWindow::afterFleetChange() { m_pages->fleetChanged(); }

void MainWindow::fail(const QString& message)
{
    const auto stay = m_leaving ? MessagePanel::Stay::UntilClosed : MessagePanel::Stay::OnThisPage;
    m_messages->add(MessagePanel::Kind::Failure, message, {}, stay);
}

void MainWindow::keyPressEvent(QKeyEvent* event)
{
    if (event->key() != Qt::Key_Escape || !m_messages->closeShown())
        QMainWindow::keyPressEvent(event);
}

/// Found on a worker after the first paint, and whenever something changed.
void MainWindow::watchDue()
{
    auto* soon = new QTimer(this);
    soon->setSingleShot(true);
    soon->setInterval(kDueDelay_ms);
    connect(soon, &QTimer::timeout, m_dueWatch, &DueWatch::start);
    for (const auto signal : {&db::Changes::fleetChanged, &db::Changes::dueChanged, &db::Changes::sitesChanged})
        connect(&m_stores.changes(), signal, soon, qOverload<>(&QTimer::start));
    connect(m_dueWatch, &DueWatch::failed, this, &MainWindow::fail);
    connect(m_dueWatch, &DueWatch::ready, this, [this] { m_fleet->showDue(m_dueWatch->news()->lines, m_dueWatch->news()->due()); });
    connect(m_fleet, &FleetPanel::dueWanted, this, [this] { navigate({"due"}); });
    soon->start();
}

void MainWindow::makeSwing(Swing swing)
{
    const Message doubt = doubtOfDate(swing.date, m_stores.clock().today());
    auto* edit = new MakeSwing(m_context, std::move(swing), MakeSwing::Direction::Make, tr("new swing"));
    const int command = m_stack.index();
    m_stack.push(edit);
    if (m_stack.index() > command) // storage has not refused it
        showEdited(command);
    if (m_stack.index() > command && !doubt.empty())
        m_messages->add(MessagePanel::Kind::Information, tr("The swing is made; %1.").arg(toText(doubt)));
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    leaveField();
    m_placement->keep();
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
