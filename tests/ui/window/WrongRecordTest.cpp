// Whatever is typed on any page and in any panel of one record is gone, or was stored with that record, when the window shows another one;
// tried on every page that owns a record, by every route to another record. And what another window or another program changes is shown.

#include <QComboBox>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPlainTextEdit>
#include <QPointer>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTreeView>

#include "tests/ui/window/EveryPage.h"
#include "tests/ui/window/TwoAircraft.h"
#include "ui/fleet/FleetModel.h"
#include "ui/intake/NmeaImportPage.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

const QString kTyped = QStringLiteral("typed for the first");

/// Everything that can be typed into is, on the page and in each panel and tab of it.
void typeEverywhere(Page& page)
{
    every::partsOf(page, {}, [&page](const QString&) {
        for (auto* line : page.findChildren<QLineEdit*>())
            if (line->isVisible() && line->isEnabled() && !line->isReadOnly() && line->objectName() != "qt_spinbox_lineedit")
                line->setText(kTyped);
        for (auto* text : page.findChildren<QPlainTextEdit*>())
            if (text->isVisible() && !text->isReadOnly())
                text->setPlainText(kTyped);
    });
    for (auto* button : page.findChildren<QAbstractButton*>()) // and the panels stand open
        if (button->isCheckable() && button->isVisible() && button->objectName().startsWith("show"))
            button->setChecked(true);
}

QStringList typedOn(const QWidget& page)
{
    QStringList found;
    for (const auto* line : page.findChildren<QLineEdit*>())
        if (line->text() == kTyped)
            found += line->objectName();
    for (const auto* text : page.findChildren<QPlainTextEdit*>())
        if (text->toPlainText() == kTyped)
            found += text->objectName();
    return found;
}

/// Its title, and whose it is beside it.
QString headOf(const Page& page)
{
    const auto* whose = page.findChild<QLabel*>("guidedWhose");
    return page.title() + (whose && whose->isVisible() ? whose->text() : QString());
}

using Route = void (*)(OpenWindow&, TwoAircraft&);

const std::pair<const char*, Route> kRoutes[] = {
    {"tree, swing", [](OpenWindow& open, TwoAircraft& two) { open.window.go(two.otherDraft); }},
    {"tree, compass", [](OpenWindow& open, TwoAircraft& two) { open.window.go(two.otherCompass); }},
    {"tree, aircraft", [](OpenWindow& open, TwoAircraft& two) { open.window.go(two.other); }},
    {"new swing",
        [](OpenWindow& open, TwoAircraft& two) {
            open.window.go(two.otherCompass);
            open.trigger("newSwing");
            open.find<QLineEdit>("newDate").setText("2026-11-25");
            open.find<QPushButton>("createSwing").click();
        }},
    {"import",
        [](OpenWindow& open, TwoAircraft&) {
            QFile file(open.folder.filePath("swing.csv"));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write("# aircraft: 3802\n# type: Su-22\n# compass: standby compass\n# date: 2026-11-24\n"
                       "magnetic_heading_deg,compass_heading_deg\n0,358.5\n90,88\n180,181\n270,271\n");
            file.close();
            QSignalSpy finished(&open.window, &MainWindow::importFinished);
            open.window.importFile(file.fileName());
            QVERIFY(finished.wait());
        }},
    {"a log made a swing",
        [](OpenWindow& open, TwoAircraft& two) {
            open.window.go(two.otherCompass);
            open.trigger("nmeaImport");
            Swing swing = *two.fleet.stores.swings.swing(two.otherDraft);
            swing.id = {};
            swing.record.clear();
            auto* page = open.window.findChild<NmeaImportPage*>();
            QVERIFY(page);
            emit page->makeSwing(swing);
        }},
    {"guided",
        [](OpenWindow& open, TwoAircraft& two) {
            open.window.go(two.otherCompass);
            open.trigger("guidedSwing");
            QVERIFY(!typedOn(open.window.findChild<PageStack*>()->current()).size());
            open.find<QPushButton>("beginGuided").click();
        }},
    {"undo and redo",
        [](OpenWindow& open, TwoAircraft& two) {
            open.window.go(two.otherDraft);
            auto& editor = open.window.findChild<SwingPage*>()->editor();
            Reading read = editor.readings()[0];
            read.compass = CompassHeading::fromDegrees(1);
            QVERIFY(editor.changeReading(0, read, "compass"));
            open.window.go(two.draft);
            open.trigger("undo");
            open.trigger("redo");
        }},
};

} // namespace

class WrongRecordTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsTypedStaysWithItsRecord_data();
    void whatIsTypedStaysWithItsRecord();
    void aPageOfACompassNamesItAndTakesNothingToAnother();
    void aHalfTypedCellIsStoredWithItsSwing_data();
    void aHalfTypedCellIsStoredWithItsSwing();
    void whatAnotherProgramChangesIsShown();
    void whatAnotherProgramRemovesIsGone();
    void backAndForwardGoAlongWhatWasShown();
    void aClickOnTheChosenItemShowsItsPageAgain();
    void aSwingWhoseCreationIsUndoneTakesItsPanels();
};

void WrongRecordTest::whatIsTypedStaysWithItsRecord_data()
{
    QTest::addColumn<int>("route");
    for (int i = 0; i < static_cast<int>(std::size(kRoutes)); ++i)
        QTest::newRow(kRoutes[i].first) << i;
}

void WrongRecordTest::whatIsTypedStaysWithItsRecord()
{
    QFETCH(int, route);
    // Pages of a record; the others are calculators and lists, which own none.
    for (const char* from : {"swing", "swing, complete", "aircraft", "guided", "newSwing", "nmeaImport", "electrical", "sensor",
             "prediction", "check", "compare"}) {
        TwoAircraft two;
        OpenWindow open(two.fleet.stores);
        auto* stack = open.window.findChild<PageStack*>();
        if (QByteArrayView(from) == "swing, complete") {
            open.window.go(two.complete);
        } else {
            const QString id = QString::fromLatin1(from);
            const auto& known = stack->descriptions();
            if (std::none_of(known.begin(), known.end(), [&](const PageDescription& page) { return page.id == id; }))
                qFatal("there is no page %s", from);
            if (!stack->show(Destination{id, two.fleet.compass}) && !stack->show(Destination{id, two.draft}))
                qFatal("%s opens neither", from);
        }
        typeEverywhere(stack->current());
        kRoutes[route].second(open, two);
        every::settle();
        const QStringList left = typedOn(stack->current());
        QVERIFY2(left.isEmpty(), qPrintable(QStringLiteral("from %1: %2").arg(QString::fromLatin1(from), left.join(", "))));
        for (const char* name : {"signSwing", "showCard"})
            if (auto* action = open.window.findChild<QAction*>(QString::fromLatin1(name)); action->isEnabled() && action->isVisible())
                action->trigger();
        for (const char* name : {"changeState", "signButton", "addEvent", "amendButton"}) // with whatever stands in their fields
            if (auto* button = stack->current().findChild<QPushButton*>(QString::fromLatin1(name)); button && button->isVisible())
                button->click();
        QVERIFY2(!two.all(two.other).contains(kTyped), from);
        QVERIFY2(two.fleet.stores.swings.swing(two.complete)->signatures.empty(), from);
        QVERIFY2(two.fleet.stores.swings.swing(two.otherComplete)->signatures.empty(), from);
    }
}

/// Also where what was opened on it is a file: a log, a bench.
void WrongRecordTest::aPageOfACompassNamesItAndTakesNothingToAnother()
{
    TwoAircraft two;
    OpenWindow open(two.fleet.stores);
    auto* stack = open.window.findChild<PageStack*>();
    QStringList ofACompass;
    for (const PageDescription& description : stack->descriptions()) {
        if (!stack->show(Destination{description.id, two.fleet.compass}) || stack->current().shown().compass != two.fleet.compass)
            continue;
        ofACompass += description.id;
        const QPointer<Page> before = &stack->current();
        QVERIFY2(headOf(*before).contains("3713"), qPrintable(description.id));
        QVERIFY2(stack->show(Destination{description.id, two.otherCompass}), qPrintable(description.id));
        QVERIFY2(&stack->current() != before, qPrintable(description.id));
        QVERIFY2(headOf(stack->current()).contains("3802"), qPrintable(headOf(stack->current())));
    }
    for (const char* one : {"calibration", "sensorTests", "sensor", "check", "compare"})
        QVERIFY2(ofACompass.contains(one), one);
}

void WrongRecordTest::aHalfTypedCellIsStoredWithItsSwing_data()
{
    QTest::addColumn<QString>("action");
    for (const char* action : {"back", "forward", "overview", "showDue", "newSwing", "openDatabase", "print", "backup"})
        QTest::newRow(action) << QString::fromLatin1(action);
}

/// A figure without Enter, left by a command of the window: it is where it was typed, or it was refused and is nowhere.
void WrongRecordTest::aHalfTypedCellIsStoredWithItsSwing()
{
    QFETCH(QString, action);
    for (const bool figure : {true, false}) {
        TwoAircraft two;
        OpenWindow open(two.fleet.stores, true);
        open.dialogs.answer = open.folder.filePath("other.lubberline");
        open.window.go(two.otherDraft);
        open.window.go(two.draft);
        open.window.go(two.otherDraft);
        open.trigger("back");
        const QString others = two.all(two.other);
        const auto before = two.fleet.stores.swings.swing(two.draft)->readings;
        open.table().setFocus();
        open.table().goTo(2, ReadingColumn::Compass);
        open.type(figure ? "88.5" : "8x");
        open.trigger(action.toLatin1().constData());
        every::settle();
        const auto after = two.fleet.stores.swings.swing(two.draft)->readings;
        QCOMPARE(after[2].compass->degrees(), figure ? 88.5 : before[2].compass->degrees());
        QCOMPARE(two.all(two.other), others);
        if (!figure)
            QVERIFY2(open.window.messages().shown().contains("8x") || open.cell(2, ReadingColumn::Compass) == "8x", qPrintable(action));
    }
}

void WrongRecordTest::whatAnotherProgramChangesIsShown()
{
    TwoAircraft two;
    OpenWindow open(two.fleet.stores);
    open.window.go(two.draft);
    open.trigger("signSwing");
    const auto program = two.fleet.stores.another();
    QVERIFY(program->signing.complete(two.draft));
    QTRY_COMPARE(open.window.findChild<SwingPage*>()->editor().record().swing.state, SwingState::Complete);
    QVERIFY(open.find<QWidget>("signButton").isVisible());
}

void WrongRecordTest::whatAnotherProgramRemovesIsGone()
{
    TwoAircraft two;
    OpenWindow open(two.fleet.stores);
    open.window.go(two.draft);
    open.trigger("signSwing");
    QVERIFY(two.fleet.stores.another()->swings.remove(two.draft));
    QTRY_VERIFY(open.window.findChild<PageStack*>()->description()->id != "swing");
    QVERIFY(!open.find<QWidget>("signButton").isVisible());
}

void WrongRecordTest::backAndForwardGoAlongWhatWasShown()
{
    TwoAircraft two;
    OpenWindow open(two.fleet.stores);
    const auto title = [&] { return open.window.windowTitle(); };
    open.window.go(two.draft);
    QVERIFY2(title().contains("3713") && title().contains("2026-11-19"), qPrintable(title()));
    open.window.go(two.otherCompass);
    open.window.go(two.otherDraft);
    open.trigger("back");
    QVERIFY2(title().contains("3802") && title().contains("standby compass"), qPrintable(title()));
    open.trigger("back");
    QVERIFY(title().contains("2026-11-19"));
    open.trigger("forward");
    open.trigger("forward");
    QVERIFY(title().contains("2026-11-21"));
    QVERIFY(!open.find<QAction>("forward").isEnabled());
    // A record that is no more is passed over.
    open.trigger("back");
    QVERIFY(two.fleet.stores.swings.remove(two.draft));
    open.trigger("back");
    QVERIFY2(!title().contains("2026-11-19"), qPrintable(title()));
    // The mouse's own buttons, wherever it points.
    auto* table = open.window.findChild<QTreeView*>("fleetTree")->viewport();
    const QString here = title();
    QMouseEvent press(QEvent::MouseButtonPress, {5, 5}, table->mapToGlobal(QPoint(5, 5)), Qt::ForwardButton, Qt::ForwardButton, {});
    QApplication::sendEvent(table, &press);
    QVERIFY(title() != here);
}

void WrongRecordTest::aClickOnTheChosenItemShowsItsPageAgain()
{
    TwoAircraft two;
    OpenWindow open(two.fleet.stores);
    open.window.go(two.draft);
    auto* stack = open.window.findChild<PageStack*>();
    auto& tree = open.find<QTreeView>("fleetTree");
    QVERIFY(std::get<SwingId>(static_cast<FleetModel*>(tree.model())->item(tree.currentIndex())) == two.draft);
    for (const bool byKey : {false, true}) {
        open.trigger("showDue");
        QCOMPARE(stack->description()->id, QStringLiteral("due"));
        tree.scrollTo(tree.currentIndex());
        if (byKey) {
            tree.setFocus();
            QTest::keyClick(&tree, Qt::Key_Return);
        } else {
            QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, tree.visualRect(tree.currentIndex()).center());
        }
        QCOMPARE(stack->description()->id, QStringLiteral("swing"));
    }
}

void WrongRecordTest::aSwingWhoseCreationIsUndoneTakesItsPanels()
{
    TwoAircraft two;
    OpenWindow open(two.fleet.stores);
    auto* stack = open.window.findChild<PageStack*>();
    open.window.go(two.otherCompass);
    open.trigger("newSwing");
    open.find<QLineEdit>("newDate").setText("2026-11-25");
    open.find<QPushButton>("createSwing").click();
    open.trigger("signSwing");
    typeEverywhere(stack->current());
    open.trigger("undo");
    every::settle();
    QVERIFY(typedOn(stack->current()).isEmpty());
    open.trigger("redo");
    every::settle();
    QVERIFY2(typedOn(stack->current()).isEmpty(), qPrintable(typedOn(stack->current()).join(", ")));
    open.trigger("undo");
    open.trigger("back");
    open.trigger("forward");
    every::settle();
    QVERIFY(typedOn(stack->current()).isEmpty());
    QVERIFY(!two.all(two.other).contains(kTyped) && !two.all(two.fleet.aircraft).contains(kTyped));
}

QTEST_MAIN(WrongRecordTest)
#include "WrongRecordTest.moc"
