// Menus, toolbar and shortcuts of the main window.

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QMenuBar>
#include <QSettings>
#include <QToolBar>

#include "ui/fleet/FleetPanel.h"
#include "ui/kit/Edit.h"
#include "ui/kit/MessagePanel.h"
#include "ui/kit/Theme.h"
#include "ui/plots/swing/SwingPlot.h"
#include "ui/swing/NominalLayout.h"
#include "ui/swing/PlotTabs.h"
#include "ui/swing/SwingEditor.h"
#include "ui/swing/SwingPage.h"
#include "ui/window/MainWindow.h"

namespace lubberline::ui {

QAction* MainWindow::addCommand(
    QMenu& menu, const QString& text, const QKeySequence& keys, const std::function<void()>& act, const QString& name)
{
    auto* action = menu.addAction(text);
    action->setShortcut(keys);
    action->setObjectName(name);
    connect(action, &QAction::triggered, this, act);
    return action;
}

void MainWindow::buildActions()
{
    buildFileMenu();
    buildEditMenu();
    buildSwingMenu();
    buildFleetMenu();
    buildModelMenu();
    buildViewMenu();
    buildHelpMenu();
    buildToolBar();
    updateActions();
}

void MainWindow::buildFileMenu()
{
    auto& menu = *menuBar()->addMenu(tr("&File"));
    m_writingActions += addCommand(
        menu, tr("&New swing"), QKeySequence::New, [this] { showNewSwing(); }, "newSwing");
    m_writingActions += addCommand(
        menu, tr("&Import…"), tr("Ctrl+I"), [this] { chooseImport(); }, "import");
    auto& exports = *menu.addMenu(tr("&Export exchange file"));
    addCommand(
        exports, tr("This &aircraft…"), {}, [this] { exportExchange(false); }, "exportAircraft");
    addCommand(
        exports, tr("The whole &fleet…"), {}, [this] { exportExchange(true); }, "exportFleet");
    if (m_services.backup)
        addCommand(
            menu, tr("&Back up the database…"), {}, [this] { backUp(); }, "backup");
    menu.addSeparator();
    m_swingActions += addCommand(
        menu, tr("&Report…"), tr("Ctrl+R"), [this] { writeReportFile(); }, "report");
    m_swingActions += addCommand(
        menu, tr("&Print preview of the report…"), QKeySequence::Print, [this] { previewReport(); }, "printReport");
    m_swingActions += addCommand(
        menu, tr("Correction &card, every 30°…"), tr("Ctrl+K"), [this] { writeCardFile(30); }, "card30");
    m_swingActions += addCommand(
        menu, tr("Correction card, every &45°…"), tr("Ctrl+Shift+K"), [this] { writeCardFile(45); }, "card45");
    m_swingActions += addCommand(
        menu, tr("Print preview of the car&d…"), tr("Ctrl+Shift+P"), [this] { previewCard(); }, "printCard");
    m_swingActions += addCommand(
        menu, tr("&Job card to carry out…"), tr("Ctrl+Alt+J"), [this] { writeJobCardFile(); }, "jobCard");
    m_swingActions += addCommand(
        menu, tr("Sheet in DD &1613 style…"), {}, [this] { write1613File(); }, "sheet1613");
    menu.addSeparator();
    addCommand(
        menu, tr("&Quit"), QKeySequence::Quit, [this] { close(); }, "quit");
}

void MainWindow::buildEditMenu()
{
    auto& menu = *menuBar()->addMenu(tr("&Edit"));
    m_undo = addCommand(
        menu, tr("&Undo"), QKeySequence::Undo, [this] { undo(); }, "undo");
    m_redo = addCommand(
        menu, tr("&Redo"), QKeySequence::Redo, [this] { redo(); }, "redo");
    m_undo->setEnabled(false);
    m_redo->setEnabled(false);
    connect(&m_stack, &QUndoStack::canUndoChanged, m_undo, &QAction::setEnabled);
    connect(&m_stack, &QUndoStack::canRedoChanged, m_redo, &QAction::setEnabled);
    connect(&m_stack, &QUndoStack::undoTextChanged, m_undo, [this](const QString& text) { m_undo->setText(tr("&Undo %1").arg(text)); });
    connect(&m_stack, &QUndoStack::redoTextChanged, m_redo, [this](const QString& text) { m_redo->setText(tr("&Redo %1").arg(text)); });
}

void MainWindow::buildSwingMenu()
{
    auto& menu = *menuBar()->addMenu(tr("&Swing"));
    m_writingActions += addCommand(
        menu, tr("&Guided swing on the ramp"), tr("Ctrl+Shift+G"), [this] { showGuided(); }, "guidedSwing");
    menu.addSeparator();
    m_compassActions += addCommand(
        menu, tr("Swing from an &NMEA log…"), tr("Ctrl+Shift+I"), [this] { showNmeaImport(); }, "nmeaImport");
    m_compassActions += addCommand(
        menu, tr("&Electrical swings of this compass"), tr("Ctrl+Shift+L"), [this] { showElectrical(); }, "electricalSwings");
    menu.addSeparator();
    auto& layouts = *menu.addMenu(tr("&Lay out nominal headings"));
    for (const int points : kLayoutPoints)
        m_draftActions += addCommand(
            layouts, tr("%1 points, every %2°").arg(points).arg(360.0 / points), {}, [this, points] { m_swingPage->layOut(points); },
            QStringLiteral("layout%1").arg(points));
    m_draftActions += addCommand(
        menu, tr("&Accept the nominal heading"), tr("Ctrl+D"), [this] { m_swingPage->acceptNominal(); }, "acceptNominal");
    m_draftActions += addCommand(
        menu, tr("&Insert a row above"), tr("Ctrl+Ins"), [this] { m_swingPage->insertRow(); }, "insertRow");
    m_draftActions += addCommand(
        menu, tr("&Delete the selected rows"), tr("Ctrl+Del"), [this] { m_swingPage->deleteRows(); }, "deleteRows");
    m_exclude = addCommand(
        menu, tr("&Exclude the reading…"), tr("Ctrl+E"), [this] { m_swingPage->toggleExcluded(); }, "exclude");
    menu.addSeparator();
    m_swingActions += addCommand(
        menu, tr("Mark &complete, or open again"), tr("Ctrl+Return"), [this] { m_swingPage->toggleComplete(); }, "complete");
    m_swingActions += addCommand(
        menu, tr("&Sign or amend"), tr("Ctrl+Shift+S"), [this] { m_swingPage->openSigning(); }, "signSwing");
    m_draftActions += addCommand(
        menu, tr("&Remove this draft swing"), {}, [this] { removeDraft(); }, "removeSwing");
}

void MainWindow::buildFleetMenu()
{
    auto& menu = *menuBar()->addMenu(tr("F&leet"));
    addCommand(
        menu, tr("&Overview"), tr("Alt+Home"), [this] { showHome(); }, "overview");
    addCommand(
        menu, tr("What is &due"), tr("Ctrl+J"), [this] { showDue(); }, "showDue");
    addCommand(
        menu, tr("Compass &bases"), tr("Ctrl+Alt+B"), [this] { showSites(); }, "showSites");
    addCommand(
        menu, tr("&Datum instruments"), tr("Ctrl+Shift+M"), [this] { showInstruments(); }, "showInstruments");
    addCommand(
        menu, tr("&Search everything"), QKeySequence::Find, [this] { m_fleet->focusSearch(); }, "search");
    addCommand(
        menu, tr("Go to the &tree"), tr("Ctrl+T"), [this] { m_fleet->focusTree(); }, "focusTree");
    m_swingActions += addCommand(
        menu, tr("Go to the &readings"), tr("Ctrl+G"), [this] { m_swingPage->focusReadings(); }, "focusReadings");
    m_swingActions += addCommand(
        menu, tr("Go to the &aircraft of this swing"), tr("Ctrl+U"), [this] { showAircraft(aircraftShown(), compassShown()); },
        "goAircraft");
}

void MainWindow::buildViewMenu()
{
    auto& menu = *menuBar()->addMenu(tr("&View"));
    const QString plots[] = {tr("&Polar plot"), tr("&Curve"), tr("&Spectrum"), tr("C&omponents")};
    for (int tab = 0; tab < 4; ++tab)
        m_swingActions += addCommand(
            menu, plots[tab], QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + tab)),
            [this, tab] { m_swingPage->plots().setCurrentIndex(tab); }, QStringLiteral("plot%1").arg(tab + 1));
    m_swingActions += addCommand(
        menu, tr("&Reset the zoom"), tr("Ctrl+0"), [this] { m_swingPage->plots().current()->resetZoom(); }, "resetZoom");
    m_swingActions += addCommand(
        menu, tr("Cop&y the plot"), tr("Ctrl+Shift+C"), [this] { m_swingPage->plots().current()->copyToClipboard(); }, "copyPlot");
    m_swingActions += addCommand(
        menu, tr("E&xport the plot…"), tr("Ctrl+Shift+E"), [this] { m_swingPage->plots().current()->exportInteractively(); }, "exportPlot");
    menu.addSeparator();
    auto* minutes = menu.addAction(tr("Degrees and &minutes"));
    minutes->setObjectName(QStringLiteral("minutes"));
    minutes->setShortcut(tr("Ctrl+M"));
    minutes->setCheckable(true);
    minutes->setChecked(m_style == AngleStyle::DegreesMinutes);
    connect(minutes, &QAction::toggled, this, &MainWindow::applyAngleStyle);
    auto* dark = menu.addAction(tr("&Dark"));
    dark->setObjectName(QStringLiteral("dark"));
    dark->setShortcut(tr("Ctrl+Shift+D"));
    dark->setCheckable(true);
    dark->setChecked(m_services.settings.value("view/dark", false).toBool());
    connect(dark, &QAction::toggled, this, [this](bool on) {
        m_services.settings.setValue("view/dark", on);
        applyTheme(on);
    });
    menu.addSeparator();
    auto* dock = findChild<QDockWidget*>(QStringLiteral("fleetDock"))->toggleViewAction();
    dock->setShortcut(tr("F9"));
    menu.addAction(dock);
}

void MainWindow::buildHelpMenu()
{
    auto& menu = *menuBar()->addMenu(tr("&Help"));
    addCommand(
        menu, tr("&Entering readings by keyboard"), QKeySequence::HelpContents,
        [this] {
            m_messages->add(MessagePanel::Kind::Information,
                tr("Type the magnetic heading, Enter, the compass reading, Enter: the next row follows. Angles as 3.25, 3.25W, 3°15'W, 3 15 W; decimal point or comma.\n"
                   "In the deviation column, W and E (or a sign) give the compass heading. = or Ctrl+D takes the nominal heading as read. Delete empties a cell.\n"
                   "Ctrl+Z undoes everything, across swings. Ctrl+E leaves a reading out, with a reason that stays on the record."));
        },
        "helpEntering");
    addCommand(
        menu, tr("&About Lubberline"), {},
        [this] {
            m_messages->add(MessagePanel::Kind::Information,
                tr("Lubberline %1: aircraft magnetic deviation. Based in part on the work of the Qwt project (http://qwt.sf.net).")
                    .arg(QApplication::applicationVersion()));
        },
        "about");
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
    const bool writable = !m_stores.readOnly();
    const bool swing = swingShown();
    const bool editable = swing && m_swingPage->editor().editable();
    for (QAction* action : std::as_const(m_writingActions))
        action->setEnabled(writable);
    for (QAction* action : std::as_const(m_swingActions))
        action->setEnabled(swing);
    for (QAction* action : std::as_const(m_compassActions))
        action->setEnabled(compassShown().valid());
    for (QAction* action : std::as_const(m_draftActions))
        action->setEnabled(editable);
    m_exclude->setEnabled(editable && m_swingPage->rowSelected());
    findChild<QAction*>(QStringLiteral("exportAircraft"))->setEnabled(aircraftShown().valid());
}

void MainWindow::showEdited(int command)
{
    const auto* edit = dynamic_cast<const Edit*>(m_stack.command(command));
    if (!edit)
        return;
    if (edit->sensorsOf().valid())
        showSensor(edit->sensorsOf());
    else if (edit->swing().valid())
        showSwing(edit->swing());
    else if (edit->aircraft().valid())
        showAircraft(edit->aircraft(), {});
}

void MainWindow::undo()
{
    leaveField();
    const int command = m_stack.index() - 1;
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
