// The menu Edit, and what people choose once for all.

#include <QApplication>
#include <QMenu>

#include "ui/fleet/FleetPanel.h"
#include "ui/kit/Theme.h"
#include "ui/kit/keys/FocusEdit.h"
#include "ui/window/MainWindow.h"
#include "ui/window/PageStack.h"

namespace lubberline::ui {

void MainWindow::buildEditMenu(QMenu& menu)
{
    m_undo = addCommand(menu, {MenuId::Edit, 100, tr("&Undo"), QKeySequence::Undo, "undo", [this](Page&) { undo(); }});
    m_redo = addCommand(menu, {MenuId::Edit, 110, tr("&Redo"), {}, "redo", [this](Page&) { redo(); }});
    m_redo->setShortcuts({QKeySequence(tr("Ctrl+Shift+Z")), QKeySequence(tr("Ctrl+Y"))});
    m_undo->setEnabled(false);
    m_redo->setEnabled(false);
    connect(&m_stack, &QUndoStack::canUndoChanged, m_undo, &QAction::setEnabled);
    connect(&m_stack, &QUndoStack::canRedoChanged, m_redo, &QAction::setEnabled);
    connect(&m_stack, &QUndoStack::undoTextChanged, m_undo, [this](const QString& text) { m_undo->setText(tr("&Undo %1").arg(text)); });
    connect(&m_stack, &QUndoStack::redoTextChanged, m_redo, [this](const QString& text) { m_redo->setText(tr("&Redo %1").arg(text)); });
    menu.addSeparator();
    const auto verb = [this, &menu](const QString& text, const QKeySequence& keys, const QString& name, EditVerb what) {
        addCommand(menu, {MenuId::Edit, 200, text, keys, name, [what](Page&) { editIn(QApplication::focusWidget(), what); }});
    };
    verb(tr("Cu&t"), QKeySequence::Cut, QStringLiteral("cut"), EditVerb::Cut);
    verb(tr("&Copy"), QKeySequence::Copy, QStringLiteral("copy"), EditVerb::Copy);
    verb(tr("&Paste"), QKeySequence::Paste, QStringLiteral("paste"), EditVerb::Paste);
    verb(tr("Select &all"), QKeySequence::SelectAll, QStringLiteral("selectAll"), EditVerb::SelectAll);
    menu.addSeparator();
    addCommand(
        menu, {MenuId::Edit, 300, tr("&Find…"), QKeySequence::Find, QStringLiteral("search"), [this](Page&) { m_fleet->focusSearch(); }});
    menu.addSeparator();
}

void MainWindow::applyPreferences()
{
    applyTheme(m_preferences.dark());
    applyTextSize(m_preferences.textSize_percent());
    m_pages->setAngleStyle(m_preferences.angleStyle());
    m_minutes->setChecked(m_preferences.angleStyle() == AngleStyle::DegreesMinutes);
    m_dark->setChecked(m_preferences.dark());
}

void MainWindow::setTextSize(int change_percent)
{
    m_preferences.setTextSize_percent(change_percent == 0 ? 100 : m_preferences.textSize_percent() + change_percent);
}

void MainWindow::setFullScreen(bool full)
{
    setWindowState(full ? windowState() | Qt::WindowFullScreen : windowState() & ~Qt::WindowFullScreen);
}

} // namespace lubberline::ui
