// The window around the pages: the empty database, import, what stores refuses, documents, new swings, the aircraft page.

#include <QComboBox>
#include <QCommandLinkButton>
#include <QDropEvent>
#include <QFile>
#include <QLineEdit>
#include <QMimeData>
#include <QPrinter>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QToolButton>

#include "tests/ui/window/Fixture.h"
#include "ui/plots/swing/SwingPlot.h"
#include "ui/swing/PlotTabs.h"

using namespace lubberline;
using namespace lubberline::ui;

class MainWindowTest : public QObject {
    Q_OBJECT

private slots:
    void emptyDatabaseOffersThreeChoices();
    void newSwingFromNothing();
    void newSwingOfAKnownCompassStartsWithEnter();
    void droppedCsvIsImported();
    void badFileIsOneMessageThatStays();
    void unnamedCsvIsNamed();
    void importIsCancelled();
    void readOnlyStorageRefusesQuietly();
    void rowsAndPointsSelectEachOther();
    void fewReadingsSayWhatIsMissing();
    void documentsAreWritten();
    void nothingIsWrittenOverTheDatabase();
    void aircraftIsEditedInPlace();
    void limitsChangeTheVerdict();
    void eventsAreAdded();
    void settingsAreKept();

private:
    static QString writeFile(const QTemporaryDir& folder, const QString& name, const QByteArray& content)
    {
        QFile file(folder.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
            qFatal("the test's file cannot be written");
        return file.fileName();
    }
    static void drop(QWidget& window, const QString& path)
    {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path)});
        QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&window, &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent event({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&window, &event);
    }
    static QByteArray csv(bool named)
    {
        QByteArray text = named ? "# aircraft: SP-ABC\n# type: Mi-17\n# compass: standby\n# date: 2026-11-20\n" : "# date: 2026-11-20\n";
        return text + "magnetic_heading_deg,compass_heading_deg\n0,358.5\n90,88\n180,181\n270,271\n";
    }
};

void MainWindowTest::emptyDatabaseOffersThreeChoices()
{
    test::TestStores stores;
    OpenWindow open(stores);
    QTRY_VERIFY(open.window.findChild<QCommandLinkButton*>("demonstrationChoice"));
    QTest::mouseClick(&open.find<QCommandLinkButton>("demonstrationChoice"), Qt::LeftButton);
    QCOMPARE(open.demonstrations, 1);
    QVERIFY(open.find<QCommandLinkButton>("importChoice").isVisible());
    QTest::mouseClick(&open.find<QCommandLinkButton>("newSwingChoice"), Qt::LeftButton);
    QVERIFY(open.find<QComboBox>("newType").isVisible());
}

void MainWindowTest::newSwingFromNothing()
{
    test::TestStores stores;
    OpenWindow open(stores);
    open.trigger("newSwing");
    auto& create = open.find<QPushButton>("createSwing");
    QTest::mouseClick(&create, Qt::LeftButton);
    QVERIFY(open.label("newComplaint").contains("type"));
    QVERIFY(stores.whole().types.empty());
    open.find<QComboBox>("newType").setEditText("PZL-130");
    open.find<QComboBox>("newAircraft").setEditText("032");
    open.find<QComboBox>("newCompass").setEditText("standby");
    open.find<QComboBox>("newSite").setEditText("north pad");
    open.find<QLineEdit>("newDate").setText("2026-02-30");
    QTest::mouseClick(&create, Qt::LeftButton);
    QVERIFY(open.label("newComplaint").contains("2026-02-30"));
    open.find<QLineEdit>("newDate").setText("2026-02-28");
    QTest::mouseClick(&create, Qt::LeftButton);
    QCOMPARE(stores.whole().swings.size(), 1u);
    QCOMPARE(stores.whole().sites.front().name, std::string("north pad"));
    QVERIFY2(open.label("swingTitle").startsWith("PZL-130 · 032 · standby · 2026-02-28"), qPrintable(open.label("swingTitle")));
    // A second swing of the same compass makes no second aircraft.
    open.trigger("newSwing");
    QCOMPARE(open.find<QComboBox>("newCompass").currentText(), QStringLiteral("standby"));
    QTest::mouseClick(&open.find<QPushButton>("createSwing"), Qt::LeftButton);
    QCOMPARE(stores.whole().swings.size(), 2u);
    QCOMPARE(stores.whole().aircraft.size(), 1u);
    open.trigger("undo");
    QCOMPARE(stores.whole().swings.size(), 1u);
}

void MainWindowTest::newSwingOfAKnownCompassStartsWithEnter()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.compass);
    open.trigger("newSwing");
    QCOMPARE(open.find<QComboBox>("newLimits").currentText(), QStringLiteral("25.1327")); // those that it has, which are not chosen here
    QVERIFY(!open.find<QComboBox>("newLimits").isEnabled());
    auto& kind = open.find<QComboBox>("newKind");
    const QWidget* first = QApplication::focusWidget();
    kind.setFocus();
    QTest::keyClick(&kind, Qt::Key_Return);
    QCOMPARE(QApplication::focusWidget()->objectName(), QStringLiteral("newStage"));
    QVERIFY(first);
    QCOMPARE(first->objectName(), QStringLiteral("createSwing"));
    // Who types another registration there means that aircraft, and gets no swing of this one.
    auto& create = open.find<QPushButton>("createSwing");
    create.setFocus();
    QTest::keyClick(&create, Qt::Key_4);
    QCOMPARE(open.find<QComboBox>("newAircraft").currentText(), QStringLiteral("4"));
    QCOMPARE(fleet.stores.whole().swings.size(), std::size_t{1});
    open.find<QComboBox>("newAircraft").setCurrentText("3713");
    open.find<QComboBox>("newCompass").setCurrentText("standby compass");
    QTest::keyClick(&create, Qt::Key_Return);
    QCOMPARE(fleet.stores.whole().swings.size(), std::size_t{2});
    QVERIFY2(open.label("swingTitle").startsWith("Su-22 · 3713 · standby compass"), qPrintable(open.label("swingTitle")));
}

void MainWindowTest::droppedCsvIsImported()
{
    test::TestStores stores;
    OpenWindow open(stores);
    QSignalSpy finished(&open.window, &MainWindow::importFinished);
    drop(open.window, writeFile(open.folder, "swing.csv", csv(true)));
    QTRY_VERIFY(!finished.isEmpty());
    QCOMPARE(stores.whole().swings.size(), 1u);
    QVERIFY2(open.label("swingTitle").startsWith("Mi-17 · SP-ABC · standby"), qPrintable(open.label("swingTitle")));
    QCOMPARE(open.table().model()->rowCount(), 5);
    QVERIFY(open.window.messages().messages().first().contains("swing.csv"));
}

void MainWindowTest::badFileIsOneMessageThatStays()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    const std::pair<const char*, QByteArray> files[] = {{"empty.csv", ""}, {"binary.csv", QByteArray("\0\1\2\xff", 4)},
        {"picture.xyz", "x"}, {"half.lubberline.json", "{\"form"}, {"cell.csv", csv(true) + "letters,1\n"}};
    for (const auto& [name, content] : files) {
        QSignalSpy finished(&open.window, &MainWindow::importFinished);
        drop(open.window, writeFile(open.folder, name, content));
        QTRY_VERIFY(!finished.isEmpty());
        const QStringList messages = open.window.messages().messages();
        QCOMPARE(messages.size(), 1);
        QVERIFY2(messages.first().contains(name), qPrintable(messages.first()));
        QVERIFY(!messages.first().contains('\n'));
        QVERIFY(open.window.messages().isVisible());
        QTest::mouseClick(&open.find<QToolButton>("dismissMessage"), Qt::LeftButton);
        QVERIFY(open.window.messages().messages().isEmpty());
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    QCOMPARE(fleet.stores.whole().swings.size(), 1u);
}

void MainWindowTest::unnamedCsvIsNamed()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.swing);
    QSignalSpy finished(&open.window, &MainWindow::importFinished);
    open.dialogs.answer = writeFile(open.folder, "swing.csv", csv(false));
    open.trigger("import");
    QTRY_VERIFY(!finished.isEmpty());
    QCOMPARE(fleet.stores.whole().swings.size(), 1u);
    QTest::mouseClick(&open.find<QPushButton>("answerMessage"), Qt::LeftButton);
    QCOMPARE(open.find<QLineEdit>("namedAircraft").text(), QStringLiteral("3713")); // proposed: what the window shows
    open.find<QLineEdit>("namedAircraft").setText("3802");
    QTest::mouseClick(&open.find<QPushButton>("importNamed"), Qt::LeftButton);
    QTRY_COMPARE(finished.count(), 2);
    QVERIFY2(open.label("swingTitle").contains("3802"), qPrintable(open.label("swingTitle")));
}

void MainWindowTest::importIsCancelled()
{
    SmallFleet fleet;
    fleet.stores.watch().delay_ms = 50;
    OpenWindow open(fleet.stores);
    QSignalSpy finished(&open.window, &MainWindow::importFinished);
    open.window.importFile(writeFile(open.folder, "swing.csv", csv(true)));
    QTRY_VERIFY(open.find<QWidget>("progressStrip").isVisible());
    QTest::mouseClick(&open.find<QPushButton>("cancelJob"), Qt::LeftButton);
    QTRY_VERIFY(!finished.isEmpty());
    QCOMPARE(fleet.stores.whole().swings.size(), 1u);
    QVERIFY(open.window.messages().messages().first().contains("nothing was changed"));
    QVERIFY(!open.find<QWidget>("progressStrip").isVisible());
}

void MainWindowTest::readOnlyStorageRefusesQuietly()
{
    SmallFleet fleet;
    const SwingId id = fleet.addSwing("2026-11-21", eightPoints());
    fleet.stores.makeReadOnly();
    OpenWindow open(fleet.stores);
    open.window.go(id);
    QCOMPARE(open.table().model()->rowCount(), 8);
    QVERIFY(open.label("savedLabel").contains("read only"));
    for (const char* action : {"newSwing", "import", "layout8", "removeSwing", "exclude"})
        QVERIFY2(!open.find<QAction>(action).isEnabled(), action);
    QVERIFY(open.find<QAction>("report").isEnabled());
    open.table().goTo(0, ReadingColumn::Compass);
    open.type("9");
    open.press(Qt::Key_Return);
    QCOMPARE(open.window.undoStack().count(), 0);
    open.window.go(fleet.aircraft);
    QVERIFY(open.find<QLineEdit>("aircraftRegistration").isReadOnly());
}

void MainWindowTest::rowsAndPointsSelectEachOther()
{
    SmallFleet fleet;
    const SwingId id = fleet.addSwing("2026-11-21", eightPoints());
    OpenWindow open(fleet.stores);
    open.window.go(id);
    auto& tabs = open.find<PlotTabs>("plotTabs");
    for (int tab = 0; tab < 4; ++tab) {
        open.trigger(qPrintable(QStringLiteral("plot%1").arg(tab + 1)));
        QCOMPARE(tabs.currentIndex(), tab);
        QVERIFY(tabs.current());
    }
    emit tabs.current()->rowSelected(5);
    QCOMPARE(open.table().currentIndex().row(), 5);
    emit tabs.current()->readOut("magnetic 045°");
    QCOMPARE(open.label("readOut"), QStringLiteral("magnetic 045°"));
}

void MainWindowTest::fewReadingsSayWhatIsMissing()
{
    SmallFleet fleet;
    const SwingId two = fleet.addSwing("2026-11-21", {{0, 359}, {90, 88}});
    const SwingId four = fleet.addSwing("2026-11-22", {{0, 359}, {90, 88}, {180, 181}, {270, 271}});
    OpenWindow open(fleet.stores);
    open.window.go(two);
    const auto& ofTwo = open.find<QTableWidget>("coefficients");
    QCOMPARE(ofTwo.item(0, 0)->text(), QStringLiteral("—"));
    QVERIFY(!ofTwo.item(0, 0)->toolTip().isEmpty());
    open.window.go(four);
    const auto& coefficients = open.find<QTableWidget>("coefficients");
    QVERIFY(coefficients.item(0, 0)->text() != QStringLiteral("—"));
    QCOMPARE(coefficients.item(3, 0)->text(), QStringLiteral("—")); // D needs the quadrants
    QVERIFY(!coefficients.item(3, 0)->toolTip().isEmpty());
    QCOMPARE(coefficients.item(3, 4)->text(), QStringLiteral("—"));
    for (int row = 0; row < 5; ++row)
        for (int column = 0; column < 5; ++column)
            QVERIFY(!coefficients.item(row, column)->text().contains("nan", Qt::CaseInsensitive));
}

void MainWindowTest::documentsAreWritten()
{
    SmallFleet fleet;
    const SwingId id = fleet.addSwing("2026-11-21", eightPoints());
    OpenWindow open(fleet.stores);
    open.window.go(id);
    const std::pair<const char*, const char*> documents[] = {{"report", "report.pdf"}, {"card30", "card.pdf"}};
    for (const auto& [action, name] : documents) {
        open.dialogs.answer = open.folder.filePath(name);
        open.trigger(action);
        QFile file(open.dialogs.answer);
        QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(open.window.messages().messages().join('\n')));
        QVERIFY(file.read(5) == "%PDF-");
    }
    open.dialogs.answer = open.folder.filePath("missing/report.pdf");
    open.trigger("report");
    QVERIFY(open.window.messages().messages().last().contains("missing"));
    open.dialogs.answer = open.folder.filePath("copy.lubberline");
    open.trigger("backup");
    QCOMPARE(open.backedUpTo, open.dialogs.answer);
    QSignalSpy finished(&open.window, &MainWindow::importFinished);
    open.dialogs.answer = open.folder.filePath("fleet.lubberline.json");
    open.trigger("exportFleet");
    QTRY_VERIFY(!finished.isEmpty());
    QVERIFY(QFile::exists(open.dialogs.answer));
    open.trigger("printReport");
    QCOMPARE(open.dialogs.previews, 1);
}

void MainWindowTest::nothingIsWrittenOverTheDatabase()
{
    SmallFleet fleet;
    const SwingId id = fleet.addSwing("2026-11-21", eightPoints());
    OpenWindow open(fleet.stores);
    open.window.go(id);
    const QString database = fleet.stores.location();
    const QString link = open.folder.filePath("report.pdf");
    QVERIFY(QFile::link(database, link));
    for (const QString& path : {database, link, database + "-wal"}) {
        for (const char* action : {"report", "exportFleet", "backup"}) {
            open.dialogs.answer = path;
            open.trigger(action);
            QVERIFY2(open.window.messages().messages().last().contains("which is read"), action);
        }
    }
    open.dialogs.answer = "/dev/full";
    open.trigger("report");
    QVERIFY(open.window.messages().messages().last().contains("device"));
    QVERIFY(open.backedUpTo.isEmpty());
    QCOMPARE(fleet.stores.whole().swings.size(), std::size_t{2}); // it opens and has what it had
    // A plot asks the same way, without a page that passes the question on.
    open.dialogs.answer = open.folder.filePath("plot.png");
    QVERIFY(QFile::link(database, open.dialogs.answer));
    open.trigger("exportPlot");
    QVERIFY(open.window.messages().messages().last().contains("which is read"));
    open.dialogs.answer = open.folder.filePath("plot.svg");
    open.trigger("exportPlot");
    QVERIFY(QFile::exists(open.dialogs.answer));
}

void MainWindowTest::aircraftIsEditedInPlace()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.aircraft);
    auto& registration = open.find<QLineEdit>("aircraftRegistration");
    registration.selectAll();
    QTest::keyClicks(&registration, "3714");
    QTest::keyClick(&registration, Qt::Key_Return);
    QCOMPARE(fleet.stores.whole().aircraft.front().registration, std::string("3714"));
    auto& built = open.find<QLineEdit>("aircraftBuilt");
    QTest::keyClicks(&built, "old");
    QTest::keyClick(&built, Qt::Key_Return);
    QVERIFY(!fleet.stores.whole().aircraft.front().builtYear);
    QCOMPARE(built.text(), QStringLiteral("old"));
    QVERIFY(built.toolTip().contains("year"));
    open.trigger("undo");
    QCOMPARE(fleet.stores.whole().aircraft.front().registration, std::string("3713"));
}

void MainWindowTest::limitsChangeTheVerdict()
{
    SmallFleet fleet;
    const SwingId id = fleet.addSwing("2026-11-21", eightPoints());
    OpenWindow open(fleet.stores);
    open.window.go(fleet.compass);
    auto& limits = open.find<QComboBox>("compassLimits");
    limits.setCurrentIndex(0);
    emit limits.activated(0);
    QVERIFY(!fleet.stores.whole().compasses.front().limits.valid());
    open.window.go(id);
    QVERIFY2(open.label("meaning").contains("No limits are set"), qPrintable(open.label("meaning")));
    open.trigger("undo");
    open.window.go(id);
    QVERIFY2(open.label("meaning").contains("In limits"), qPrintable(open.label("meaning")));
}

void MainWindowTest::eventsAreAdded()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.window.go(fleet.aircraft);
    open.find<QLineEdit>("eventDate").setText("2026-06-01");
    open.find<QLineEdit>("eventKind").setText("lightning strike");
    open.find<QPushButton>("addEvent").click();
    QCOMPARE(fleet.stores.whole().events.size(), 1u);
    auto& table = open.find<QTableWidget>("events");
    QCOMPARE(table.rowCount(), 1);
    table.item(0, 1)->setText("engine change");
    QTRY_COMPARE(fleet.stores.whole().events.front().kind, std::string("engine change"));
    open.trigger("undo");
    QCOMPARE(fleet.stores.whole().events.front().kind, std::string("lightning strike"));
}

void MainWindowTest::settingsAreKept()
{
    SmallFleet fleet;
    OpenWindow open(fleet.stores);
    open.find<QAction>("dark").setChecked(true);
    QTRY_VERIFY(open.window.palette().color(QPalette::Window).lightnessF() < 0.3);
    QVERIFY(open.settings.value("view/dark").toBool());
    open.find<QAction>("dark").setChecked(false);
    QTRY_VERIFY(open.window.palette().color(QPalette::Window).lightnessF() > 0.7);
    open.window.close();
    QVERIFY(!open.settings.value("window/geometry").toByteArray().isEmpty());
}

QTEST_MAIN(MainWindowTest)
#include "MainWindowTest.moc"
