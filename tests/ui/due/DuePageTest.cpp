// What is due, on the page: the list and its filters, waivers, rules, the calendar file; the day that ends while the window is
// open.

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>

#include "tests/db/TestStores.h"
#include "tests/ui/window/Typing.h"
#include "ui/due/DuePage.h"
#include "ui/due/DueWatch.h"
#include "ui/fleet/EventsPanel.h"
#include "ui/kit/Words.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

/// Three aircraft: one swung in 2020, one struck by lightning and landed hard since its swing, one swung lately.
struct OpenDue {
    test::TestStores stores;
    AircraftId old, struck, fresh;
    Date today = "2026-11-23";
    QString path;
    QStringList failures, told;
    EditContext context{stores, [this](const Error& error) { failures += messageOf(error); }};
    QUndoStack stack;
    std::vector<std::pair<AircraftId, CompassId>> opened;
    std::unique_ptr<DuePage> page;

    OpenDue()
    {
        old = add("Su-22", "3713", "2020-01-01");
        struck = add("Su-22", "3802", "2026-05-01");
        fresh = add("Mi-17", "602", "2026-11-01");
        event(struck, "2026-06-10", DueCause::Lightning, "lightning strike");
        event(struck, "2026-06-11", DueCause::HardLanding, "hard landing");
    }
    AircraftId add(const std::string& type, const std::string& registration, Date swung)
    {
        const auto types = *stores.fleet.types();
        const auto known = std::find_if(types.begin(), types.end(), [&](const TypeRow& one) { return one.name == type; });
        AircraftType made;
        made.name = type;
        Aircraft aircraft;
        aircraft.type = known != types.end() ? known->id : *stores.save(made);
        aircraft.registration = registration;
        CompassSystem compass;
        compass.aircraft = *stores.save(aircraft);
        compass.name = "standby compass";
        Swing swing;
        swing.compass = *stores.save(compass);
        swing.date = swung;
        for (int i = 0; i < 8; ++i) {
            Reading reading;
            reading.magnetic = MagneticHeading::fromDegrees(45.0 * i);
            reading.compass = CompassHeading::fromDegrees(45.0 * i);
            swing.readings.push_back(reading);
        }
        const SwingId id = *stores.swings.add(swing);
        if (!stores.signing.complete(id) || !stores.signing.sign(id, {SignatureRole::Performer, "Ada", "PL 12", "", ""})
            || !stores.signing.sign(id, {SignatureRole::Inspector, "Ben", "PL 7", "", ""}))
            qFatal("the swing cannot be signed");
        return compass.aircraft;
    }
    void event(AircraftId aircraft, Date date, DueCause cause, const std::string& words)
    {
        Event made;
        made.aircraft = aircraft;
        made.date = date;
        made.cause = cause;
        made.kind = words;
        static_cast<void>(*stores.save(made));
    }
    void open()
    {
        const auto ask = [this](auto&&...) { return path; };
        page = std::make_unique<DuePage>(
            context, stack, [this] { return today; }, FileQuestions{ask, ask});
        QObject::connect(page.get(), &DuePage::failed, page.get(), [this](const QString& message) { failures += message; });
        QObject::connect(page.get(), &DuePage::done, page.get(), [this](const QString& message) { told += message; });
        QObject::connect(page.get(), &DuePage::openCompass, page.get(),
            [this](AircraftId aircraft, CompassId compass) { opened.emplace_back(aircraft, compass); });
        QObject::connect(&stores.changes(), &db::Changes::dueChanged, page.get(), [this] { look(); });
        page->resize(1000, 600);
        page->show();
        look();
    }
    void look() { page->show(std::make_shared<const DueNews>(*dueNews(stores, today, {}))); }
    template <class Widget>
    Widget& find(const char* name)
    {
        return in<Widget>(*page, name);
    }
    QTableWidget& table() { return find<QTableWidget>("dueTable"); }
    QString text(int row, int column) { return table().item(row, column)->text(); }
    QString flag(int row, int column) { return find<QTableWidget>("dueFlags").item(row, column)->text(); }
    int row(const QString& registration)
    {
        for (int i = 0; i < table().rowCount(); ++i)
            if (text(i, 2).startsWith(registration + " ·"))
                return i;
        return -1;
    }
};

} // namespace

class DuePageTest : public QObject {
    Q_OBJECT

private slots:
    void theMostUrgentIsFirstWithShapeAndWord()
    {
        OpenDue open;
        QVERIFY(open.stores.save(DueRule{{}, "two years", 24, 0, 60, "a document", "1", {}}).ok());
        open.open();
        QCOMPARE(open.table().rowCount(), 2); // the fresh one is neither due nor due soon
        QCOMPARE(open.text(0, 0), QString("overdue"));
        QVERIFY(!open.table().item(0, 0)->icon().isNull());
        QVERIFY(open.text(0, 2).startsWith("3713 · "));
        QCOMPARE(open.text(0, 3), QString("2022-01-01"));
        QCOMPARE(open.text(0, 5), QString("2020-01-01"));
        QCOMPARE(open.text(1, 0), QString("due"));
        QCOMPARE(open.text(1, 4), QString("lightning strike"));
        QCOMPARE(open.text(1, 6), QString("2028-05-01"));
    }

    void filtersNarrowTheList()
    {
        OpenDue open;
        open.open();
        open.find<QComboBox>("dueFilter").setCurrentIndex(2);
        QCOMPARE(open.table().rowCount(), 3);
        auto& types = open.find<QComboBox>("dueType");
        types.setCurrentIndex(types.findText("Mi-17"));
        QCOMPARE(open.table().rowCount(), 1);
        open.look(); // found anew: the filter stays
        QCOMPARE(open.table().rowCount(), 1);
        types.setCurrentIndex(0);
        QTest::keyClicks(&open.find<QLineEdit>("dueWords"), "LIGHTning");
        QCOMPARE(open.table().rowCount(), 1);
        QVERIFY(open.text(0, 2).startsWith("3802 · "));
        QTest::keyClicks(&open.find<QLineEdit>("dueWords"), "x");
        QCOMPARE(open.table().rowCount(), 0);
        QVERIFY(!open.find<QPushButton>("dueOpen").isEnabled());
        QVERIFY(!open.find<QPushButton>("waiveButton").isEnabled());
    }

    void enterOpensTheCompass()
    {
        OpenDue open;
        open.open();
        QApplication::setActiveWindow(open.page.get());
        open.table().setFocus();
        open.table().selectRow(open.row("3802"));
        QTest::keyClick(&open.table(), Qt::Key_Return);
        QCOMPARE(open.opened.size(), std::size_t(1));
        QVERIFY(open.opened[0].first == open.struck);
        QTest::mouseClick(&open.find<QPushButton>("dueOpen"), Qt::LeftButton);
        QCOMPARE(open.opened.size(), std::size_t(2));
        QVERIFY(open.opened[1] == open.opened[0]);
    }

    void aWaiverAnswersTheChosenEventOnly()
    {
        OpenDue open;
        open.open();
        open.table().selectRow(open.row("3802"));
        auto& flags = open.find<QTableWidget>("dueFlags");
        QCOMPARE(flags.rowCount(), 2);
        flags.selectRow(1);
        QCOMPARE(open.flag(1, 2), QString("hard landing"));
        auto& button = open.find<QPushButton>("waiveButton");
        QTest::mouseClick(&button, Qt::LeftButton); // neither reason nor name
        QCOMPARE(open.failures.size(), 1);
        QVERIFY(open.stores.whole().waivers.empty());
        QTest::keyClicks(&open.find<QLineEdit>("waiverReason"), "inspected, no shift on 000 and 090");
        open.event(open.old, "2026-11-01", DueCause::EngineChange,
            "engine change");            // elsewhere in the fleet, and the list is found anew
        QCOMPARE(flags.currentRow(), 1); // the waiver does not slip to the lightning
        QTest::keyClicks(&open.find<QLineEdit>("waiverBy"), "J. Nowak");
        QTest::mouseClick(&button, Qt::LeftButton);
        QCOMPARE(open.stores.whole().waivers.size(), std::size_t(1));
        const Waiver waiver = open.stores.whole().waivers[0];
        QCOMPARE(waiver.event, open.stores.whole().events[1].record);
        QCOMPARE(waiver.reason, std::string("inspected, no shift on 000 and 090"));
        QCOMPARE(waiver.by, std::string("J. Nowak"));
        QCOMPARE(waiver.date, Date("2026-11-23"));
        QCOMPARE(open.text(open.row("3802"), 4), QString("lightning strike"));
        QCOMPARE(flags.rowCount(), 1);
        QVERIFY(open.find<QLineEdit>("waiverReason").text().isEmpty());
    }

    void aReasonIsNotKeptForAnotherEvent()
    {
        OpenDue open;
        open.open();
        open.table().selectRow(open.row("3802"));
        QTest::keyClicks(&open.find<QLineEdit>("waiverReason"), "two headings agree");
        Waiver elsewhere{{}, open.stores.whole().events[0].record, "2026-11-23", "by another window", "A. B."};
        QVERIFY(open.stores.save(elsewhere).ok());
        QVERIFY(open.find<QLineEdit>("waiverReason").text().isEmpty());
    }

    void aCalendarRuleIsNotWaived()
    {
        OpenDue open;
        QVERIFY(open.stores.save(DueRule{{}, "two years", 24, 0, 60, {}, {}, {}}).ok());
        open.open();
        open.table().selectRow(open.row("3713"));
        QCOMPARE(open.find<QTableWidget>("dueFlags").rowCount(), 1);
        QVERIFY(!open.find<QPushButton>("waiveButton").isEnabled());
        open.find<QTableWidget>("dueFlags").selectRow(0);
        QVERIFY(!open.find<QPushButton>("waiveButton").isEnabled());
    }

    void aReadOnlyDatabaseIsOnlyShown()
    {
        OpenDue open;
        open.stores.makeReadOnly();
        open.open();
        open.table().selectRow(open.row("3802"));
        QVERIFY(!open.find<QPushButton>("waiveButton").isEnabled());
        QVERIFY(!open.find<QLineEdit>("waiverReason").isEnabled());
        QVERIFY(!open.find<QLineEdit>("waiverBy").isEnabled());
        open.page->findChild<QTabWidget*>()->setCurrentIndex(1);
        QVERIFY(!open.find<QPushButton>("knownRules").isEnabled());
        QVERIFY(!open.find<QPushButton>("removeRule").isEnabled());
        QCOMPARE(open.find<QTableWidget>("dueRules").rowCount(), 0); // and no row for a new one
    }

    void rulesAreEditedInPlace()
    {
        OpenDue open;
        open.open();
        open.page->findChild<QTabWidget*>()->setCurrentIndex(1);
        auto& rules = open.find<QTableWidget>("dueRules");
        QCOMPARE(rules.rowCount(), 1); // none applies before somebody wants it
        QTest::mouseClick(&open.find<QPushButton>("knownRules"), Qt::LeftButton);
        QCOMPARE(open.stores.whole().dueRules.size(), std::size_t(2));
        QTest::mouseClick(&open.find<QPushButton>("knownRules"), Qt::LeftButton); // twice is once
        QCOMPARE(open.stores.whole().dueRules.size(), std::size_t(2));
        rules.item(2, 0)->setText("ours");
        QTRY_COMPARE(open.stores.whole().dueRules.size(), std::size_t(3));
        rules.item(2, 1)->setText("6");
        QTRY_COMPARE(open.stores.whole().dueRules[2].months, 6);
        rules.item(2, 6)->setText("Mi-17");
        QTRY_COMPARE(open.stores.whole().dueRules[2].type, open.stores.whole().types[1].record);
        for (const auto& [column, text] : {std::pair(1, "0"), std::pair(1, "six"), std::pair(2, "-1"), std::pair(6, "Concorde")}) {
            const auto before = open.failures.size();
            rules.item(2, column)->setText(text);
            QTRY_COMPARE(open.failures.size(), before + 1);
            QVERIFY(rules.item(2, column)->text() != QString(text)); // what is stored is shown
        }
        QCOMPARE(open.stores.whole().dueRules[2].months, 6);
        QCOMPARE(open.stores.whole().dueRules[2].graceDays, 0);
        rules.setCurrentCell(2, 0);
        QTest::mouseClick(&open.find<QPushButton>("removeRule"), Qt::LeftButton);
        QCOMPARE(open.stores.whole().dueRules.size(), std::size_t(2));
        open.stack.undo(); // the removal
        QCOMPARE(open.stores.whole().dueRules.size(), std::size_t(3));
        QCOMPARE(rules.rowCount(), 4); // shown again, with the row for a new one
        while (open.stack.canUndo())
            open.stack.undo();
        QVERIFY(open.stores.whole().dueRules.empty());
    }

    void theCalendarFileHasTheDays()
    {
        OpenDue open;
        QVERIFY(open.stores.save(DueRule{{}, "two years", 24, 0, 60, {}, {}, {}}).ok());
        QTemporaryDir folder;
        open.path = folder.filePath("swings.ics");
        open.open();
        QTest::mouseClick(&open.find<QPushButton>("dueCalendar"), Qt::LeftButton);
        QFile file(open.path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray text = file.readAll();
        QCOMPARE(text.count("BEGIN:VEVENT"), 5); // three compasses by the calendar, two events
        for (const char* day : {"20220101", "20280501", "20281101", "20260610", "20260611"})
            QVERIFY2(text.contains(QByteArray("DTSTART;VALUE=DATE:") + day), day);
        QCOMPARE(open.told.size(), 1);
        open.path = folder.filePath("no such folder/swings.ics");
        QTest::mouseClick(&open.find<QPushButton>("dueCalendar"), Qt::LeftButton);
        QCOMPARE(open.failures.size(), 1);
        open.path.clear(); // cancelled
        QTest::mouseClick(&open.find<QPushButton>("dueCalendar"), Qt::LeftButton);
        QCOMPARE(open.failures.size(), 1);
    }

    void theDayEndsWhileTheWindowIsOpen()
    {
        OpenDue open;
        QVERIFY(open.stores.save(DueRule{{}, "a month", 1, 0, 0, {}, {}, {}}).ok());
        open.today = "2026-12-01";
        DueWatch watch(open.stores, [&open] { return open.today; });
        QSignalSpy ready(&watch, &DueWatch::ready);
        watch.lookAtDay(); // nothing was asked for yet
        QVERIFY(!ready.wait(50));
        watch.start();
        QTRY_COMPARE(ready.count(), 1);
        QCOMPARE(watch.news()->due(), 2);
        watch.lookAtDay(); // the same day
        QVERIFY(!ready.wait(50));
        open.today = "2026-12-02";
        watch.lookAtDay();
        QTRY_COMPARE(ready.count(), 2);
        QCOMPARE(watch.news()->due(), 3);
    }

    void theCrewsWordsSuggestTheCause()
    {
        OpenDue open;
        QStringList errors;
        EditContext context{open.stores, [&errors](const Error& error) { errors += QString::fromStdString(error.message.english()); }};
        QUndoStack stack;
        EventsPanel panel(context, stack);
        panel.showAircraft(open.fresh);
        panel.show();
        auto* cause = panel.findChild<QComboBox*>("eventCause");
        panel.findChild<QLineEdit*>("eventDate")->setText("2026-11-20");
        QTest::keyClicks(panel.findChild<QLineEdit*>("eventKind"), "lightning, port wing");
        QCOMPARE(cause->currentIndex(), static_cast<int>(DueCause::Lightning));
        QTest::mouseClick(panel.findChild<QPushButton*>("addEvent"), Qt::LeftButton);
        QVERIFY(open.stores.whole().events.back().cause == DueCause::Lightning);
        QCOMPARE(cause->currentIndex(), 0);
        QCOMPARE(dueNews(open.stores, open.today, {})->due(), 2);
        open.stores.makeReadOnly();
        panel.showAircraft(open.fresh);
        QVERIFY(!cause->isEnabled());
        QVERIFY(errors.isEmpty());
    }

    void aThousandAircraftAreShown()
    {
        OpenDue open;
        for (int i = 0; i < 1000; ++i)
            open.add("Su-22", std::to_string(10000 + i), addDays("2020-01-01", i));
        QVERIFY(open.stores.save(DueRule{{}, "two years", 24, 0, 60, {}, {}, {}}).ok());
        open.open();
        QCOMPARE(open.table().rowCount(), 1002);
        QCOMPARE(open.text(0, 3), QString("2022-01-01"));
        for (int row = 1; row < 1000; ++row)
            QVERIFY(open.text(row - 1, 3) <= open.text(row, 3) || open.text(row - 1, 0) != open.text(row, 0));
    }
};

QTEST_MAIN(DuePageTest)
#include "DuePageTest.moc"
