// What people look for in menus is there, by the key that they know, and does what it says.

#include <QClipboard>
#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QPrinter>
#include <QPushButton>
#include <QSpinBox>
#include <QTextBrowser>

#include "tests/ui/window/Fixture.h"
#include "ui/kit/Preferences.h"
#include "ui/text/Language.h"
#include "ui/window/PageStack.h"

using namespace lubberline;
using namespace lubberline::ui;

class MenusTest : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { speak({"en"}); }
    void whatPeopleLookForIsThere();
    void redoHasBothKeys();
    void clipboardGoesWhereTheKeyboardIs();
    void anotherDatabaseIsOpened();
    void aRefusedDatabaseLeavesTheWindow();
    void backupsGoToTheirFolderAndTheOldestGo();
    void preferencesHoldAtOnce();
    void aNewSwingBeginsWithTheUsualBase();
    void typeAircraftAndCompassAreMadeAndUndone();
    void anAircraftIsRemovedAndPutBack();
    void whatWasDoneBeforeSigningIsNotUndone();
    void whatIsCompleteIsNotRemoved();
    void helpHasItsTopics();
    void fullScreenIsNotTheRampsKey();
    void theFrontPageIsPrinted();
};

void MenusTest::whatPeopleLookForIsThere()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores, true);
    const std::pair<const char*, const char*> entries[]
        = {{"File", "newSwing newDatabase openDatabase demonstration saveCopy backup restore import exportFleet print quit"},
            {"Edit", "undo redo cut copy paste selectAll search preferences"},
            {"View", "fullScreen largerText smallerText usualText minutes dark"},
            {"Fleet", "newType newAircraft newCompass newBase removeType removeAircraft removeCompass removeBase"},
            {"Help", "help helpContents helpShortcuts helpGlossary helpDerivation helpLicences helpProblem about"}};
    for (const auto& [menu, names] : entries) {
        QStringList have;
        for (const QAction* action : open.window.menuBar()->actions())
            if (QString(action->text()).remove('&') == menu)
                for (const QAction* entry : action->menu()->actions()) {
                    have += entry->objectName();
                    if (entry->menu())
                        for (const QAction* inner : entry->menu()->actions())
                            have += inner->objectName();
                }
        for (const QString& name : QString(names).split(' '))
            QVERIFY2(have.contains(name), qPrintable(QString(menu) + " has no " + name));
    }
    QVERIFY(open.window.findChild<QMenu*>("recentDatabases"));
    QCOMPARE(open.find<QAction>("openDatabase").shortcut(), QKeySequence(QKeySequence::Open));
    QCOMPARE(open.find<QAction>("print").shortcut(), QKeySequence(QKeySequence::Print));
}

void MenusTest::redoHasBothKeys()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    QVERIFY(open.find<QAction>("redo").shortcuts().contains(QKeySequence("Ctrl+Y")));
    QVERIFY(open.find<QAction>("redo").shortcuts().contains(QKeySequence("Ctrl+Shift+Z")));
}

void MenusTest::clipboardGoesWhereTheKeyboardIs()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.trigger("newAircraft");
    auto& line = open.find<QLineEdit>("newRecordName");
    line.setText("3713");
    line.setFocus();
    open.trigger("selectAll");
    open.trigger("cut");
    QVERIFY(line.text().isEmpty());
    QCOMPARE(QApplication::clipboard()->text(), QString("3713"));
    open.trigger("paste");
    QCOMPARE(line.text(), QString("3713"));
    open.window.go(fleet.addSwing("2026-11-20", eightPoints()));
    open.table().goTo(1, ReadingColumn::Compass);
    open.table().setFocus();
    open.trigger("copy");
    QCOMPARE(QApplication::clipboard()->text().trimmed(), QString("45"));
    QTest::keyClick(&open.table(), Qt::Key_A, Qt::ControlModifier);
    QVERIFY(open.table().selectionModel()->selectedIndexes().size() > 8);
}

void MenusTest::anotherDatabaseIsOpened()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores, true);
    open.dialogs.answer = open.folder.filePath("new.lubberline");
    open.trigger("newDatabase");
    QCOMPARE(open.opened, open.dialogs.answer + " made");
    QFile there(open.folder.filePath("there.lubberline"));
    QVERIFY(there.open(QIODevice::WriteOnly));
    open.dialogs.answer = there.fileName();
    open.trigger("openDatabase");
    QCOMPARE(open.opened, there.fileName());
    open.trigger("newDatabase"); // nothing is made over a file
    QCOMPARE(open.opened, there.fileName());
    QVERIFY(open.window.messages().shown().contains("already"));
    open.settings.setValue("files/recent", QStringList{there.fileName(), "/no/such/file"});
    auto* recent = open.window.findChild<QMenu*>("recentDatabases");
    open.opened.clear();
    emit recent->aboutToShow();
    QCOMPARE(recent->actions().size(), 1);
    recent->actions().first()->trigger();
    QCOMPARE(open.opened, there.fileName());
}

void MenusTest::aRefusedDatabaseLeavesTheWindow()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores, true);
    open.refuse = true;
    open.dialogs.answer = open.folder.filePath("other.lubberline");
    open.trigger("openDatabase");
    QVERIFY(open.window.isVisible());
    QVERIFY(open.window.messages().shown().contains("no database"));
}

void MenusTest::backupsGoToTheirFolderAndTheOldestGo()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    QDir folder(open.folder.path());
    QVERIFY(folder.mkdir("backups") && folder.cd("backups"));
    Preferences preferences(open.settings);
    preferences.setBackupFolder(folder.path());
    preferences.setBackupsKept(2);
    const auto put = [&](const QString& name) {
        QFile file(folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
    };
    put("memory-2020-01-01-000000.lubberline");
    put("memory-2021-01-01-000000.lubberline");
    put("other-2019-01-01-000000.lubberline");
    put("memory-of-mine.lubberline");
    open.writeBackups = true;
    open.trigger("backup");
    QCOMPARE(folder.entryList(QDir::Files).size(), 4);
    QVERIFY(!folder.exists("memory-2020-01-01-000000.lubberline"));
    QVERIFY(folder.exists("memory-2021-01-01-000000.lubberline"));
    QVERIFY2(open.backedUpTo.startsWith(folder.filePath("memory-")), qPrintable(open.backedUpTo));
    QVERIFY(open.window.messages().shown().contains(open.backedUpTo));
    open.find<QPushButton>("answerMessage").click();
    QCOMPARE(open.dialogs.openedOutside, folder.path());
}

void MenusTest::preferencesHoldAtOnce()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.trigger("preferences");
    const auto choose = [&](const char* name, int index) {
        auto& box = open.find<QComboBox>(name);
        box.setCurrentIndex(index);
        emit box.activated(index);
    };
    choose("preferAngles", 1);
    QVERIFY(open.find<QAction>("minutes").isChecked());
    choose("preferTheme", 1);
    QVERIFY(open.find<QAction>("dark").isChecked());
    open.trigger("dark");
    QCOMPARE(open.find<QComboBox>("preferTheme").currentIndex(), 0);
    open.trigger("largerText");
    QCOMPARE(open.find<QSpinBox>("preferTextSize").value(), 110);
    open.trigger("usualText");
    QCOMPARE(open.find<QSpinBox>("preferTextSize").value(), 100);
    choose("preferLanguage", 2);
    QCOMPARE(open.settings.value("view/language").toString(), QString("pl"));
    QCOMPARE(wantedLanguages("pl"), QStringList{"pl"});
}

void MenusTest::aNewSwingBeginsWithTheUsualBase()
{
    SmallFleet fleet;
    Site site;
    site.name = "Deblin";
    site.record = newRecordId();
    QVERIFY(fleet.stores.save(site));
    OpenWindow open(fleet.stores);
    open.trigger("preferences");
    auto& box = open.find<QComboBox>("preferSite");
    box.setCurrentIndex(box.findText("Deblin"));
    emit box.activated(box.currentIndex());
    open.trigger("newSwing");
    QCOMPARE(open.find<QComboBox>("newSite").currentText(), QString("Deblin"));
    open.window.go(fleet.compass);
    open.trigger("guidedSwing");
    QCOMPARE(open.find<QComboBox>("guidedSite").currentText(), QString("Deblin"));
}

void MenusTest::typeAircraftAndCompassAreMadeAndUndone()
{
    test::TestStores stores;
    OpenWindow open(stores);
    auto* stack = open.window.findChild<PageStack*>();
    const auto make = [&](const char* action, const QString& name) {
        open.trigger(action);
        QWidget& page = stack->current(); // those of other kinds are still there
        page.findChild<QLineEdit*>("newRecordName")->setText(name);
        page.findChild<QPushButton*>("makeRecord")->click();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    };
    make("newAircraft", "3713"); // there is no type yet
    QCOMPARE(stores.fleet.totals()->aircraft, 0);
    make("newType", "Su-22");
    make("newAircraft", "3713");
    make("newCompass", "standby compass");
    QCOMPARE(stores.fleet.totals()->compasses, 1);
    make("newCompass", "standby compass"); // a name that is taken
    QCOMPARE(stores.fleet.totals()->compasses, 1);
    QCOMPARE(open.window.undoStack().count(), 3);
    for (int i = 0; i < 3; ++i)
        open.trigger("undo");
    QCOMPARE(stores.fleet.totals()->types, 0);
    for (int i = 0; i < 3; ++i)
        open.trigger("redo");
    QCOMPARE(stores.fleet.totals()->compasses, 1);
}

void MenusTest::anAircraftIsRemovedAndPutBack()
{
    SmallFleet fleet;
    const SwingId swing = fleet.addSwing("2026-11-21", eightPoints());
    OpenWindow open(fleet.stores);
    open.window.go(swing);
    open.table().goTo(1, ReadingColumn::Compass);
    open.type("44");
    open.press(Qt::Key_Return);
    open.window.go(fleet.aircraft);
    const Fleet before = fleet.stores.whole();
    open.trigger("removeAircraft");
    QCOMPARE(fleet.stores.fleet.totals()->aircraft, 0);
    QVERIFY(open.window.messages().shown().contains("3713"));
    open.trigger("undo");
    QVERIFY(fleet.stores.whole() == before);
    open.trigger("undo"); // what was done before it still knows its reading
    QCOMPARE(fleet.stores.swings.swing(swing)->readings[1].compass->degrees(), 45.0);
}

void MenusTest::whatWasDoneBeforeSigningIsNotUndone()
{
    SmallFleet fleet;
    const SwingId swing = fleet.addSwing("2026-11-21", eightPoints());
    OpenWindow open(fleet.stores);
    open.window.go(fleet.aircraft);
    auto& registration = open.find<QLineEdit>("aircraftRegistration");
    registration.selectAll();
    QTest::keyClicks(&registration, "3714");
    QTest::keyClick(&registration, Qt::Key_Return);
    open.window.go(swing);
    for (int row = 0; row < 2; ++row) {
        open.table().goTo(row, ReadingColumn::Compass);
        open.type("44");
        open.press(Qt::Key_Return);
    }
    QVERIFY(fleet.stores.signing.complete(swing));
    QVERIFY(fleet.stores.signing.sign(swing, {SignatureRole::Performer, "Ada", "PL 12", "", ""}));
    QVERIFY(fleet.stores.signing.sign(swing, {SignatureRole::Inspector, "Ben", "PL 7", "", ""}));
    const Swing as = *fleet.stores.swings.swing(swing);
    open.window.go(fleet.aircraft);
    open.find<QLineEdit>("eventKind").setText("half typed");
    open.trigger("undo");
    QVERIFY(*fleet.stores.swings.swing(swing) == as);
    QVERIFY2(open.window.messages().shown().contains("signed and frozen"), qPrintable(open.window.messages().shown()));
    QCOMPARE(open.find<QLineEdit>("eventKind").text(), QStringLiteral("half typed")); // the page in front stays
    QCOMPARE(open.window.undoStack().index(), 1);                                     // what was done to the aircraft
    open.trigger("undo");
    QCOMPARE(fleet.stores.whole().aircraft.front().registration, std::string("3713"));
    QVERIFY(!open.find<QAction>("undo").isEnabled());
}

void MenusTest::whatIsCompleteIsNotRemoved()
{
    SmallFleet fleet;
    const SwingId swing = fleet.addSwing("2026-11-21", eightPoints());
    QVERIFY(fleet.stores.signing.complete(swing));
    OpenWindow open(fleet.stores);
    open.window.go(fleet.compass);
    open.trigger("removeCompass");
    QCOMPARE(fleet.stores.fleet.totals()->compasses, 1);
    QVERIFY2(open.window.messages().shown().contains("2026-11-21"), qPrintable(open.window.messages().shown()));
}

void MenusTest::helpHasItsTopics()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    const std::pair<const char*, const char*> topics[]
        = {{"helpContents", "Ctrl+Z"}, {"helpShortcuts", "Ctrl+Y"}, {"helpGlossary", "variation"}, {"helpDerivation", "least squares"},
            {"helpLicences", "IGRF-14"}, {"about", "memory.lubberline"}, {"helpProblem", "Qt"}};
    for (const auto& [action, word] : topics) {
        open.trigger(action);
        QVERIFY2(open.find<QTextBrowser>("helpText").toPlainText().contains(word), action);
    }
    open.find<QPushButton>("copyHelp").click();
    QVERIFY(QApplication::clipboard()->text().contains("Lubberline"));
    QVERIFY(!QApplication::clipboard()->text().contains("3713")); // nothing of a record
}

void MenusTest::fullScreenIsNotTheRampsKey()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    QCOMPARE(open.find<QAction>("fullScreen").shortcut(), QKeySequence(Qt::Key_F11));
    open.trigger("fullScreen");
    QVERIFY(open.window.isFullScreen());
    open.trigger("fullScreen");
    QVERIFY(!open.window.isFullScreen());
    open.window.go(fleet.compass);
    open.trigger("guidedSwing");
    QVERIFY(open.find<QAction>("fullScreen").shortcut().isEmpty());
    open.window.go(fleet.compass);
    QCOMPARE(open.find<QAction>("fullScreen").shortcut(), QKeySequence(Qt::Key_F11));
}

void MenusTest::theFrontPageIsPrinted()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.compass);
    const QString path = open.folder.filePath("page.pdf");
    open.dialogs.onPreview = [&](const std::function<void(QPrinter&)>& paint) {
        QPrinter printer;
        printer.setOutputFormat(QPrinter::PdfFormat);
        printer.setOutputFileName(path);
        paint(printer);
    };
    open.trigger("print");
    QCOMPARE(open.dialogs.previews, 1);
    QVERIFY(QFileInfo(path).size() > 2000);
    open.window.go(fleet.addSwing("2026-11-21", eightPoints()));
    open.dialogs.onPreview = {};
    open.trigger("print"); // the report
    QCOMPARE(open.dialogs.previews, 2);
}

QTEST_MAIN(MenusTest)
#include "MenusTest.moc"
