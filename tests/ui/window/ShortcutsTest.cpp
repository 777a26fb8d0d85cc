// No key leads to two places, on any page and in either language: Qt would then do neither.

#include <QAbstractButton>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QShortcut>

#include "tests/ui/window/Fixture.h"
#include "ui/guided/GuidedPage.h"
#include "ui/text/Language.h"
#include "ui/window/PageStack.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

/// Who listens to each key now: what is shown and can be done, wherever it was given its key.
QMultiMap<QString, QString> listeners(const QWidget& window)
{
    QMultiMap<QString, QString> heard;
    const auto take = [&](const QKeySequence& keys, const QObject& who, const QString& name) {
        if (!keys.isEmpty())
            heard.insert(keys.toString(QKeySequence::PortableText), who.objectName().isEmpty() ? name : who.objectName());
    };
    for (const QAction* action : window.findChildren<QAction*>()) {
        const auto where = action->associatedObjects();
        const bool shown = std::any_of(where.begin(), where.end(), [](const QObject* place) {
            const auto* widget = qobject_cast<const QWidget*>(place);
            return widget && (widget->isVisible() || qobject_cast<const QMenu*>(widget));
        });
        if (shown && action->isEnabled() && action->isVisible())
            for (const QKeySequence& keys : action->shortcuts())
                take(keys, *action, action->text());
    }
    for (const QAbstractButton* button : window.findChildren<QAbstractButton*>())
        if (button->isVisible() && button->isEnabled())
            take(button->shortcut(), *button, button->text());
    for (const QShortcut* shortcut : window.findChildren<QShortcut*>())
        if (const auto* place = qobject_cast<const QWidget*>(shortcut->parent()); place && place->isVisible() && shortcut->isEnabled())
            take(shortcut->key(), *shortcut, place->metaObject()->className());
    return heard;
}

QStringList givenTwice(const QWidget& window)
{
    const auto heard = listeners(window);
    QStringList twice;
    for (const QString& keys : heard.uniqueKeys())
        if (heard.count(keys) > 1)
            twice += keys + ": " + heard.values(keys).join(" and ");
    return twice;
}

} // namespace

class ShortcutsTest : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { speak({"en"}); }
    void everyShortcutIsGivenOnce();
    void everyPageGivesItsKeysOnce_data();
    void everyPageGivesItsKeysOnce();
    void theRampGivesItsKeysOnce();
    void aFieldErasesNothingByTheWindowsKeys();
    void aKeyThatIsGivenTwiceIsSeen();
};

/// Also of what cannot be done just now.
void ShortcutsTest::everyShortcutIsGivenOnce()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    QMap<QString, QString> given;
    for (const QAction* action : open.window.findChildren<QAction*>())
        for (const QKeySequence& keys : action->shortcuts()) {
            const QString text = keys.toString(QKeySequence::PortableText);
            if (text.isEmpty())
                continue;
            QVERIFY2(!given.contains(text), qPrintable(text + ": " + given.value(text) + " and " + action->objectName()));
            given.insert(text, action->objectName());
        }
    QVERIFY(given.size() > 20);
}

void ShortcutsTest::everyPageGivesItsKeysOnce_data()
{
    QTest::addColumn<QString>("language");
    QTest::newRow("English") << "en";
    QTest::newRow("Polish") << "pl";
}

void ShortcutsTest::everyPageGivesItsKeysOnce()
{
    QFETCH(QString, language);
    QCOMPARE(speak({language}), language);
    SmallFleet fleet;
    const SwingId swing = fleet.addSwing("2026-11-20", eightPoints());
    OpenWindow open(fleet.stores, true);
    auto* stack = open.window.findChild<PageStack*>();
    for (const PageDescription& page : stack->descriptions()) {
        if (!stack->show(Destination{page.id, fleet.compass}))
            QVERIFY2(static_cast<bool>(stack->show(Destination{page.id, swing})), qPrintable(page.id));
        QApplication::processEvents();
        QVERIFY2(givenTwice(open.window).isEmpty(), qPrintable(page.id + ": " + givenTwice(open.window).join("; ")));
        QVERIFY(listeners(open.window).size() > 20);
    }
}

void ShortcutsTest::theRampGivesItsKeysOnce()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.compass);
    open.trigger("guidedSwing");
    const auto twice = [&] { return givenTwice(open.window).join("; "); };
    QVERIFY(listeners(open.window).contains("Ctrl+Return"));
    QCOMPARE(twice(), QString());
    open.find<QPlainTextEdit>("guidedChecklist").clear();
    open.find<QPushButton>("beginGuided").click();
    QCOMPARE(twice(), QString());
    open.find<QPushButton>("prepared").click();
    QVERIFY(listeners(open.window).contains("F2") && listeners(open.window).contains("F11"));
    QCOMPARE(twice(), QString());
    open.window.findChild<GuidedPage*>()->showLive(true);
    QCOMPARE(twice(), QString());
}

/// Ctrl+U goes to the aircraft; in a field of X11 it would erase what is typed to the left.
void ShortcutsTest::aFieldErasesNothingByTheWindowsKeys()
{
    SmallFleet fleet;
    const SwingId swing = fleet.addSwing("2026-11-21", eightPoints());
    OpenWindow open(fleet.stores);
    open.window.go(swing);
    open.trigger("signSwing");
    auto& name = open.find<QLineEdit>("signName");
    name.setFocus();
    QTest::keyClicks(&name, "Jan Kowalski");
    for (const int key : {Qt::Key_U, Qt::Key_K, Qt::Key_E, Qt::Key_D, Qt::Key_H}) {
        QKeyEvent asks(QEvent::ShortcutOverride, key, Qt::ControlModifier);
        asks.ignore();
        QApplication::sendEvent(&name, &asks);
        QVERIFY2(!asks.isAccepted(), qPrintable(QKeySequence(int(Qt::CTRL) | key).toString()));
    }
    QKeyEvent copies(QEvent::ShortcutOverride, Qt::Key_C, Qt::ControlModifier);
    copies.ignore();
    QApplication::sendEvent(&name, &copies);
    QVERIFY(copies.isAccepted());
    QCOMPARE(name.text(), QStringLiteral("Jan Kowalski"));
}

void ShortcutsTest::aKeyThatIsGivenTwiceIsSeen()
{
    SmallFleet fleet;
    const SwingId swing = fleet.addSwing("2026-11-20", eightPoints());
    OpenWindow open(fleet.stores);
    open.window.go(swing);
    QCOMPARE(givenTwice(open.window), QStringList());
    QWidget& page = open.window.findChild<PageStack*>()->current();
    auto* doubled = new QShortcut(QKeySequence("Ctrl+M"), &page);
    QCOMPARE(givenTwice(open.window), QStringList{"Ctrl+M: " + QString(page.metaObject()->className()) + " and minutes"});
    open.find<QAction>("minutes").setEnabled(false);
    QCOMPARE(givenTwice(open.window), QStringList());
    doubled->setKey(QKeySequence("F9"));
    QCOMPARE(givenTwice(open.window).size(), 1);
}

QTEST_MAIN(ShortcutsTest)
#include "ShortcutsTest.moc"
