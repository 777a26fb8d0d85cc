// Menus, toolbar and shortcuts of the main window.

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenuBar>
#include <QMouseEvent>
#include <QPlainTextEdit>
#include <QSettings>
#include <QToolBar>

#include <algorithm>
#include <map>

#include "ui/fleet/FleetPanel.h"
#include "ui/kit/Edit.h"
#include "ui/kit/Theme.h"
#include "ui/kit/keys/Mnemonics.h"
#include "ui/plots/base/Plot.h"
#include "ui/window/MainWindow.h"
#include "ui/window/PageStack.h"

namespace lubberline::ui {

QAction* MainWindow::addCommand(QMenu& menu, const Command& command)
{
    auto* action = menu.addAction(command.text);
    action->setShortcut(command.keys);
    action->setObjectName(command.name);
    connect(action, &QAction::triggered, this, [this, act = command.act] {
        const Page* before = &m_pages->current();
        act(m_pages->current());
        Page& page = m_pages->current();
        if (&page != before && !page.isAncestorOf(focusWidget())) // what is typed next is meant for what was asked for
            page.setFocus();
    });
    if (command.needs)
        m_needs.emplace_back(action, command.needs);
    return action;
}

/// In the order of their places, with a line between hundreds.
void MainWindow::addCommands(QMenu& menu, const std::vector<Command>& commands)
{
    std::map<QString, QMenu*> submenus;
    for (std::size_t i = 0; i < commands.size(); ++i) {
        const Command& command = commands[i];
        if (i > 0 && command.place / 100 != commands[i - 1].place / 100)
            menu.addSeparator();
        QMenu* place = &menu;
        if (!command.submenu.isEmpty()) {
            QMenu*& submenu = submenus[command.submenu];
            if (!submenu)
                submenu = menu.addMenu(command.submenu);
            place = submenu;
        }
        addCommand(*place, command);
    }
}

void MainWindow::buildActions()
{
    std::map<MenuId, std::vector<Command>> commands;
    for (const Command& command : ownCommands())
        commands[command.menu].push_back(command);
    for (const PageDescription& page : m_pages->descriptions())
        for (const Command& command : page.commands)
            commands[command.menu].push_back(command);
    for (const PageDescription& page : m_pages->descriptions())
        for (const Command& output : page.outputs)
            commands[MenuId::File].push_back(output);
    const std::pair<MenuId, QString> menus[] = {{MenuId::File, tr("&File")}, {MenuId::Edit, tr("&Edit")}, {MenuId::Swing, tr("&Swing")},
        {MenuId::Fleet, tr("F&leet")}, {MenuId::Model, tr("&Model")}, {MenuId::View, tr("&View")}, {MenuId::Help, tr("&Help")}};
    for (const auto& [id, title] : menus) {
        QMenu& menu = *menuBar()->addMenu(title);
        auto& own = commands[id];
        std::stable_sort(own.begin(), own.end(), [](const Command& a, const Command& b) { return a.place < b.place; });
        if (id == MenuId::Edit)
            buildEditMenu(menu);
        addCommands(menu, own);
        if (id == MenuId::File)
            addRecent(menu);
        if (id == MenuId::View)
            addViewChoices(menu);
        connect(&menu, &QMenu::aboutToShow, &menu, [&menu] { makeMnemonicsDistinct(menu); });
    }
    for (const PageDescription& page : m_pages->descriptions())
        for (const Command& output : page.outputs)
            m_outputs.emplace_back(findChild<QAction*>(output.name), page.id);
    m_back = findChild<QAction*>(QStringLiteral("back"));
    m_forward = findChild<QAction*>(QStringLiteral("forward"));
    QStringList titles;
    for (const QAction* menu : menuBar()->actions())
        titles += menu->text();
    titles = distinctMnemonics(titles);
    for (qsizetype i = 0; i < titles.size(); ++i)
        menuBar()->actions()[i]->setText(titles[i]);
    buildToolBar();
    updateActions();
    showPlace();
    connect(m_pages, &PageStack::turned, this, &MainWindow::showOutputs);
    showOutputs();
}

/// Those of other pages are gone from the menu; the toolbar keeps its buttons where they are.
void MainWindow::showOutputs()
{
    const PageDescription* front = m_pages->description();
    // F11 is the crew's display on the ramp
    m_fullScreen->setShortcut(front && front->id == QStringLiteral("guided") ? QKeySequence() : QKeySequence(Qt::Key_F11));
    const auto* bar = findChild<QToolBar*>(QStringLiteral("mainTools"));
    for (const auto& [action, page] : m_outputs)
        action->setVisible((front && front->id == page) || bar->actions().contains(action));
    for (const QAction* menu : menuBar()->actions())
        makeMnemonicsDistinct(*menu->menu());
}

/// Those that are of no page.
std::vector<Command> MainWindow::ownCommands()
{
    const QString exports = tr("&Export exchange file");
    std::vector<Command> commands{
        {MenuId::File, 400, tr("&Import…"), tr("Ctrl+I"), "import", [this](Page&) { chooseImport(); }, needsWriting},
        {MenuId::File, 410, tr("This &aircraft…"), {}, "exportAircraft", [this](Page&) { exportExchange(false); }, needsAircraft, exports},
        {MenuId::File, 411, tr("The whole &fleet…"), {}, "exportFleet", [this](Page&) { exportExchange(true); }, nullptr, exports},
        {MenuId::File, 900, tr("&Quit"), QKeySequence::Quit, "quit", [this](Page&) { close(); }},
        {MenuId::Fleet, 150, tr("Go to the &tree"), tr("Ctrl+T"), "focusTree", [this](Page&) { m_fleet->focusTree(); }},
    };
    for (const auto& more : {plotCommands(), databaseCommands()})
        commands.insert(commands.end(), more.begin(), more.end());
    return commands;
}

std::vector<Command> MainWindow::plotCommands()
{
    const auto onPlot = [](auto act) {
        return [act](Page& shown) {
            if (Plot* plot = shown.plot())
                act(*plot);
        };
    };
    return {
        {MenuId::View, 10, tr("&Back"), tr("Alt+Left"), "back", [this](Page&) { step(-1); }},
        {MenuId::View, 20, tr("&Forward"), tr("Alt+Right"), "forward", [this](Page&) { step(+1); }},
        {MenuId::View, 110, tr("&Reset the zoom"), tr("Ctrl+0"), "resetZoom", onPlot([](Plot& plot) { plot.resetZoom(); }), needsPlot},
        {MenuId::View, 120, tr("Cop&y the plot"), tr("Ctrl+Shift+Y"), "copyPlot", onPlot([](Plot& plot) { plot.copyToClipboard(); }),
            needsPlot},
        {MenuId::View, 130, tr("E&xport the plot…"), tr("Ctrl+Shift+E"), "exportPlot",
            onPlot([](Plot& plot) { plot.exportInteractively(); }), needsPlot},
    };
}

void MainWindow::addViewChoices(QMenu& menu)
{
    menu.addSeparator();
    const auto toggle = [&](const QString& text, const QKeySequence& keys, const char* name, bool on, auto act) {
        auto* action = menu.addAction(text);
        action->setObjectName(QLatin1String(name));
        action->setShortcut(keys);
        action->setCheckable(true);
        action->setChecked(on);
        connect(action, &QAction::toggled, this, act);
        return action;
    };
    m_minutes = toggle(tr("Degrees and &minutes"), tr("Ctrl+M"), "minutes", m_preferences.angleStyle() == AngleStyle::DegreesMinutes,
        [this](bool on) { m_preferences.setAngleStyle(on ? AngleStyle::DegreesMinutes : AngleStyle::DecimalDegrees); });
    m_dark = toggle(tr("&Dark"), tr("Ctrl+Shift+D"), "dark", m_preferences.dark(), [this](bool on) { m_preferences.setDark(on); });
    const int step = Preferences::kStep_percent;
    addCommand(
        menu, {MenuId::View, 900, tr("&Larger text"), QKeySequence::ZoomIn, "largerText", [this, step](Page&) { setTextSize(step); }});
    addCommand(
        menu, {MenuId::View, 900, tr("Smaller te&xt"), QKeySequence::ZoomOut, "smallerText", [this, step](Page&) { setTextSize(-step); }});
    addCommand(menu, {MenuId::View, 900, tr("&Usual text size"), tr("Ctrl+Shift+0"), "usualText", [this](Page&) { setTextSize(0); }});
    menu.addSeparator();
    m_fullScreen = toggle(tr("&Full screen"), Qt::Key_F11, "fullScreen", isFullScreen(), [this](bool on) { setFullScreen(on); });
    auto* dock = findChild<QDockWidget*>(QStringLiteral("fleetDock"))->toggleViewAction();
    dock->setShortcut(tr("F9"));
    menu.addAction(dock);
}

void MainWindow::buildToolBar()
{
    auto* bar = addToolBar(tr("Main tools"));
    bar->setObjectName(QStringLiteral("mainTools"));
    bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    bar->setIconSize({18, 18});
    bar->setMovable(false);
    const std::pair<const char*, const char*> tools[] = {{"newSwing", "swing"}, {"guidedSwing", "guided"}, {"import", "import"},
        {"report", "report"}, {"card30", "card"}, {"undo", "undo"}, {"redo", "redo"}};
    for (const auto& [name, picture] : tools) {
        auto* action = findChild<QAction*>(QString::fromLatin1(name));
        action->setIcon(icon(QString::fromLatin1(picture)));
        bar->addAction(action);
    }
    findChild<QAction*>(QStringLiteral("newSwing"))->setIconText(tr("New swing"));
    findChild<QAction*>(QStringLiteral("guidedSwing"))->setIconText(tr("Guided swing"));
    findChild<QAction*>(QStringLiteral("import"))->setIconText(tr("Import"));
    findChild<QAction*>(QStringLiteral("report"))->setIconText(tr("Report"));
    findChild<QAction*>(QStringLiteral("card30"))->setIconText(tr("Card"));
    m_undo->setIconText(tr("Undo"));
    m_redo->setIconText(tr("Redo"));
}

void MainWindow::updateActions()
{
    const Shown now = shown();
    for (const auto& [action, usable] : m_needs)
        action->setEnabled(usable(now));
}

namespace {

/// With Ctrl: what every program does in a field. Without it: all that is typed.
bool editsText(const QKeyEvent& key)
{
    if (!(key.modifiers() & Qt::ControlModifier) || (key.modifiers() & Qt::AltModifier))
        return true;
    switch (key.key()) {
    case Qt::Key_A:
    case Qt::Key_C:
    case Qt::Key_V:
    case Qt::Key_X:
    case Qt::Key_Z:
    case Qt::Key_Y:
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_Home:
    case Qt::Key_End:
    case Qt::Key_Insert:
    case Qt::Key_Delete:
    case Qt::Key_Backspace: return true;
    default: return false;
    }
}

} // namespace

bool MainWindow::eventFilter(QObject* object, QEvent* event)
{
    // A field takes only the keys of editing: Ctrl+U is no "erase to the left" where it goes to the aircraft.
    if (event->type() == QEvent::ShortcutOverride && (qobject_cast<QLineEdit*>(object) || qobject_cast<QPlainTextEdit*>(object))
        && !editsText(*static_cast<QKeyEvent*>(event))) {
        event->ignore();
        return true;
    }
    // What was opened on the page since it came to the front has letters, too.
    if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Alt)
        makeMnemonicsDistinct(m_pages->current(), *this);
    if (event->type() == QEvent::MouseButtonPress) {
        const auto button = static_cast<QMouseEvent*>(event)->button();
        const auto* widget = qobject_cast<QWidget*>(object);
        if (widget && widget->window() == this && (button == Qt::BackButton || button == Qt::ForwardButton)) {
            step(button == Qt::BackButton ? -1 : +1);
            return true;
        }
    }
    return QMainWindow::eventFilter(object, event);
}

void MainWindow::showEdited(int command)
{
    const auto* edit = dynamic_cast<const Edit*>(m_stack.command(command));
    if (!edit)
        return;
    if (const Destination seen = edit->seenAt(); !seen.page.isEmpty() || !std::holds_alternative<std::monostate>(seen.record))
        navigate(seen);
}

/// What was done to a swing before it was signed stays: its edits are taken off the list, the page in front stays, and it is said.
bool MainWindow::undoesWhatIsSigned(int command)
{
    const auto swingOf = [this](int of) {
        const auto* edit = dynamic_cast<const Edit*>(m_stack.command(of));
        return edit ? edit->swing() : SwingId();
    };
    const SwingId swing = swingOf(command);
    if (!swing.valid())
        return false;
    const auto stored = m_stores.swings.swing(swing, db::ReadingParts::Headings);
    if (!stored || stored->state != SwingState::Signed)
        return false;
    m_takingOff = true;
    while (m_stack.index() > 0 && swingOf(m_stack.index() - 1) == swing)
        m_stack.undo(); // is refused, and takes itself off
    m_takingOff = false;
    m_messages->add(MessagePanel::Kind::Information,
        tr("The swing of %1 is signed and frozen: what was done to it before is not undone. Amend it in a new revision to change it.")
            .arg(stored->date.empty() ? tr("no stated date") : toText(stored->date)));
    return true;
}

void MainWindow::undo()
{
    leaveField();
    const int command = m_stack.index() - 1;
    if (undoesWhatIsSigned(command))
        return;
    showEdited(command); // what changes is seen to change
    m_stack.undo();
    if (m_stack.index() == command)
        showEdited(command);
}

void MainWindow::redo()
{
    leaveField();
    const int command = m_stack.index();
    showEdited(command);
    m_stack.redo();
    if (m_stack.index() == command + 1)
        showEdited(command);
}

} // namespace lubberline::ui
