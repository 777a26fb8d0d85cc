// A key does one thing: all shortcuts of the window, of each page that may be in front, of its parts and plots, and the letters that Alt
// reaches (menus, buttons, labels, tabs) are held against each other as they stand beside each other on the screen.

#include <QAbstractButton>
#include <QAction>
#include <QGroupBox>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QShortcut>
#include <QTabBar>
#include <QToolButton>

#include "tests/ui/window/Fixture.h"
#include "ui/window/PageStack.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

/// Who answers to which keys.
class Given {
public:
    void add(const QKeySequence& keys, const QString& who)
    {
        const QString text = keys.toString(QKeySequence::PortableText);
        if (text.isEmpty())
            return;
        if (m_who.contains(text) && m_who.value(text) != who)
            m_twice += QStringLiteral("%1: %2 and %3").arg(text, m_who.value(text), who);
        m_who.insert(text, who);
    }
    [[nodiscard]] const QStringList& twice() const { return m_twice; }
    [[nodiscard]] qsizetype count() const { return m_who.size(); }

private:
    QMap<QString, QString> m_who;
    QStringList m_twice;
};

QString nameOf(const QObject& object, const QString& text)
{
    return (object.objectName().isEmpty() ? QString::fromLatin1(object.metaObject()->className()) : object.objectName()) + " '" + text
        + '\'';
}

/// Every action and shortcut that there is, seen or not: menus hold the commands of all pages.
void addKeys(Given& given, const QWidget& window)
{
    for (const QAction* action : window.findChildren<QAction*>())
        for (const QKeySequence& keys : action->shortcuts())
            given.add(keys, nameOf(*action, action->text()));
    for (const QShortcut* shortcut : window.findChildren<QShortcut*>())
        given.add(shortcut->key(), nameOf(*shortcut->parent(), "shortcut"));
    for (const QAbstractButton* button : window.findChildren<QAbstractButton*>())
        if (button->shortcut() != QKeySequence::mnemonic(button->text()))
            given.add(button->shortcut(), nameOf(*button, button->text()));
}

/// The letters that Alt reaches, of what is on the screen.
void addLetters(Given& given, const QWidget& window)
{
    for (const QMenuBar* bar : window.findChildren<QMenuBar*>())
        for (const QAction* menu : bar->actions())
            given.add(QKeySequence::mnemonic(menu->text()), nameOf(*menu, menu->text()));
    for (const QAbstractButton* button : window.findChildren<QAbstractButton*>())
        if (button->isVisible())
            given.add(QKeySequence::mnemonic(button->text()), nameOf(*button, button->text()));
    for (const QLabel* label : window.findChildren<QLabel*>())
        if (label->isVisible() && label->buddy())
            given.add(QKeySequence::mnemonic(label->text()), nameOf(*label, label->text()));
    for (const QGroupBox* group : window.findChildren<QGroupBox*>())
        if (group->isVisible())
            given.add(QKeySequence::mnemonic(group->title()), nameOf(*group, group->title()));
    for (const QTabBar* tabs : window.findChildren<QTabBar*>())
        for (int tab = 0; tabs->isVisible() && tab < tabs->count(); ++tab)
            given.add(QKeySequence::mnemonic(tabs->tabText(tab)), nameOf(*tabs, tabs->tabText(tab)));
}

} // namespace

class ShortcutsTest : public QObject {
    Q_OBJECT

private slots:
    void aKeyIsGivenOnceOnEveryPage_data();
    void aKeyIsGivenOnceOnEveryPage();
    void aLetterIsGivenOnceInEveryMenu();
    void whatIsGivenTwiceIsFound();
};

void ShortcutsTest::aKeyIsGivenOnceOnEveryPage_data()
{
    QTest::addColumn<QString>("page");
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    for (const PageDescription& page : open.window.findChild<PageStack*>()->descriptions())
        QTest::newRow(qPrintable(page.id)) << page.id;
}

void ShortcutsTest::aKeyIsGivenOnceOnEveryPage()
{
    QFETCH(const QString, page);
    SmallFleet fleet;
    const SwingId swing
        = fleet.addSwing("2026-11-21", {{0, 1}, {45, 46}, {90, 92}, {135, 136}, {180, 181}, {225, 224}, {270, 269}, {315, 314}});
    OpenWindow open(fleet.stores);
    auto* stack = open.window.findChild<PageStack*>();
    const auto opened = [&](const FleetItem& record) { return static_cast<bool>(stack->show(Destination{page, record})); };
    QVERIFY(opened(fleet.compass) || opened(swing));
    // With all that can be opened on it.
    for (QToolButton* part : stack->current().findChildren<QToolButton*>())
        if (part->isCheckable() && part->isVisible())
            part->setChecked(true);
    Given given;
    addKeys(given, open.window);
    addLetters(given, open.window);
    QVERIFY(given.count() > 20);
    QVERIFY2(given.twice().isEmpty(), qPrintable(given.twice().join('\n')));
}

void ShortcutsTest::aLetterIsGivenOnceInEveryMenu()
{
    SmallFleet fleet;
    const SwingId swing = fleet.addSwing("2026-11-21", {});
    OpenWindow open(fleet.stores);
    auto* stack = open.window.findChild<PageStack*>();
    for (const PageDescription& page : stack->descriptions()) {
        if (!stack->show(Destination{page.id, fleet.compass}))
            static_cast<void>(stack->show(Destination{page.id, swing}));
        for (const QMenu* menu : open.window.findChildren<QMenu*>()) {
            Given given;
            for (const QAction* action : menu->actions())
                if (action->isVisible())
                    given.add(QKeySequence::mnemonic(action->text()), nameOf(*action, action->text()));
            QVERIFY2(given.twice().isEmpty(), qPrintable(page.id + ", " + menu->title() + ": " + given.twice().join('\n')));
        }
    }
}

void ShortcutsTest::whatIsGivenTwiceIsFound()
{
    QWidget page;
    QPushButton one("&Sign", &page), other("Si&x, and &Sign", &page);
    QAction action("act", &page);
    action.setShortcut(QKeySequence("Ctrl+Alt+L"));
    QShortcut shortcut(QKeySequence("Ctrl+Alt+L"), &page);
    page.show();
    Given given;
    addKeys(given, page);
    addLetters(given, page);
    QCOMPARE(given.twice().size(), 1); // Alt+S and Alt+X are two letters; the second '&' of a text is none
    other.setText("No &swing");
    addLetters(given, page);
    QCOMPARE(given.twice().size(), 2);
}

QTEST_MAIN(ShortcutsTest)
#include "ShortcutsTest.moc"
