// A guided swing that was interrupted, or of which something was left out: it is offered wherever people look for it, goes on with what was
// half typed, and every heading that was skipped can still be read. In the real window.

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QTreeView>

#include "db/transfer/Maintenance.h"
#include "tests/ui/window/Fixture.h"
#include "ui/fleet/AircraftPage.h"
#include "ui/guided/CrewDisplay.h"
#include "ui/guided/GuidedPage.h"
#include "ui/guided/GuidedStation.h"
#include "ui/guided/StationStrip.h"
#include "ui/kit/OpenSwings.h"
#include "ui/window/PageStack.h"

namespace lubberline::ui {

namespace {

struct Crew {
    SmallFleet fleet;
    std::unique_ptr<OpenWindow> open = std::make_unique<OpenWindow>(fleet.stores);

    GuidedPage& page() { return dynamic_cast<GuidedPage&>(open->window.findChild<PageStack*>()->current()); }
    const JobState& state() { return page().job().state(); }
    QString text(const char* label) { return page().findChild<QLabel*>(QString::fromLatin1(label))->text(); }
    template <class Widget>
    Widget& find(const char* name)
    {
        return *page().findChild<Widget*>(QString::fromLatin1(name));
    }

    void addSight(SightingDirection ahead, const std::string& name)
    {
        DatumInstrument sight;
        sight.name = name;
        sight.kind = DatumKind::SightingCompass;
        sight.ahead = ahead;
        QVERIFY(fleet.stores.save(sight));
    }
    void begin(ProcedureKind kind)
    {
        open->window.go(fleet.compass);
        open->trigger("guidedSwing");
        find<QComboBox>("guidedProcedure").setCurrentIndex(static_cast<int>(kind));
        find<QPlainTextEdit>("guidedChecklist").clear();
        find<QPushButton>("beginGuided").click();
        find<QPushButton>("prepared").click();
        QCOMPARE(state().phase, JobPhase::Stations);
    }
    void read(double datum_deg, double compass_deg)
    {
        const auto before = page().job().job().events.size();
        find<QLineEdit>("guidedDatum").setText(QString::number(datum_deg));
        find<QLineEdit>("guidedCompass").setText(QString::number(compass_deg));
        page().station().next();
        if (page().job().job().events.size() == before)
            page().station().next(); // looked at again: it is so
        QCOMPARE(page().job().job().events.size(), before + 1);
    }
    void readHere() { read(nominal(), wrap360(nominal() - 2)); }
    double nominal() { return page().job().station()->station.nominal_deg; }
    void skip(const QString& why)
    {
        page().station().skip();
        find<QLineEdit>("guidedReason").setText(why);
        page().station().next();
    }
    /// The window is gone in the middle of whatever was done, and another one opens on the same database, with settings of its own.
    void kill()
    {
        QApplication::processEvents();
        open->window.disconnect();
        const auto before = std::move(open);
        open = std::make_unique<OpenWindow>(fleet.stores);
    }
    void click(StationStrip& strip, int station)
    {
        const int each = strip.width() / static_cast<int>(state().stations.size());
        QTest::mouseClick(&strip, Qt::LeftButton, {}, {each * station + each / 2, strip.height() / 2});
    }
};

} // namespace

class GuidedOnwardsTest : public QObject {
    Q_OBJECT

private slots:
    void aFigureIsKeptAsItIsTyped()
    {
        Crew crew;
        crew.begin(ProcedureKind::CheckOnly);
        crew.readHere();
        auto& datum = crew.find<QLineEdit>("guidedDatum");
        datum.setFocus();
        QTest::keyClicks(&datum, "44.5");
        QTest::keyClick(&datum, Qt::Key_Return);
        QTest::keyClicks(&crew.find<QLineEdit>("guidedCompass"), "4");
        const SwingId swing = crew.page().swing();
        for (int killed = 0; killed < 2; ++killed) {
            crew.kill();
            crew.open->window.go(swing);
            QCOMPARE(crew.state().current, 1);
            QCOMPARE(crew.find<QLineEdit>("guidedDatum").text(), "44.5");
            QCOMPARE(crew.find<QLineEdit>("guidedCompass").text(), "4");
        }
        crew.readHere();
        crew.kill();
        crew.open->window.go(swing);
        QVERIFY(crew.find<QLineEdit>("guidedDatum").text().isEmpty());         // that step is done
        QCOMPARE(crew.fleet.stores.jobs.typed(swing)->size(), std::size_t{1}); // the name of the load, which has its usual words
    }

    /// It goes where its record goes, and no other swing has it: not that of the same compass, nor the one that stands at the same step.
    void aFigureThatIsHalfTypedBelongsToItsRecord()
    {
        Crew crew;
        crew.begin(ProcedureKind::CheckOnly);
        crew.readHere();
        QTest::keyClicks(&crew.find<QLineEdit>("guidedDatum"), "46.2");
        const SwingId swing = crew.page().swing();
        crew.open->window.go(crew.fleet.aircraft); // at once, before anything else happens
        crew.begin(ProcedureKind::CheckOnly);
        QVERIFY(crew.page().swing() != swing);
        crew.readHere();
        QVERIFY(crew.find<QLineEdit>("guidedDatum").text().isEmpty());
        crew.open->window.go(swing);
        QCOMPARE(crew.find<QLineEdit>("guidedDatum").text(), "46.2");

        const QString copy = crew.open->folder.filePath("copy.lubberline");
        QVERIFY(db::backup(crew.fleet.stores.database(), copy));
        auto stores = db::openStores(copy, db::OpenMode::ReadWriteCreate);
        QVERIFY(stores);
        OpenWindow elsewhere(**stores);
        elsewhere.window.go(swing);
        QCOMPARE(elsewhere.find<QLineEdit>("guidedDatum").text(), "46.2");
        elsewhere.find<QLineEdit>("guidedCompass").setText("44");
        QApplication::processEvents();
        const auto typed = (*stores)->jobs.typed(swing);
        QVERIFY(typed && std::find(typed->begin(), typed->end(), TypedText{"guidedCompass", "44"}) != typed->end());
    }

    void itIsOfferedWherePeopleLook()
    {
        Crew crew;
        crew.begin(ProcedureKind::CheckOnly);
        for (int i = 0; i < 3; ++i)
            crew.readHere();
        const SwingId swing = crew.page().swing();
        const QString words = QStringLiteral("3713 standby compass stands at step 4 of 8: go on");
        QCOMPARE(openSwings(crew.fleet.stores)->front().words, words);
        const auto isTakenUp = [&] { return crew.page().swing() == swing && crew.state().current == 3; };
        // What opens first.
        crew.kill();
        auto& today = crew.open->find<QTableWidget>("overviewToday");
        QVERIFY(today.isVisible());
        QCOMPARE(today.item(0, 2)->text(), words);
        today.setCurrentCell(0, 0);
        QTest::mouseClick(today.viewport(), Qt::LeftButton, {}, today.visualItemRect(today.item(0, 0)).center());
        QVERIFY(isTakenUp());
        // The tree.
        crew.open->window.go({});
        auto& tree = crew.open->find<QTreeView>("fleetTree");
        crew.open->window.go(crew.fleet.swing);
        QStringList names;
        const QModelIndex compass = tree.currentIndex().parent();
        for (int row = 0; row < tree.model()->rowCount(compass); ++row)
            names += tree.model()->index(row, 0, compass).data().toString();
        QVERIFY2(names.filter("guided, at step 4 of 8").size() == 1, qPrintable(names.join("; ")));
        // The page of its compass.
        crew.open->window.go(crew.fleet.compass);
        auto* button = crew.open->window.findChild<PageStack*>()->current().findChild<QPushButton*>("goOnGuided");
        QVERIFY(button);
        QCOMPARE(button->text(), words);
        button->click();
        QVERIFY(isTakenUp());
        // Ctrl+Shift+G on the compass, and where no compass is chosen.
        crew.open->window.go(crew.fleet.compass);
        crew.open->trigger("guidedSwing");
        button = crew.page().findChild<QPushButton*>("goOnGuided");
        QVERIFY(button);
        QCOMPARE(button->text(), words);
        button->click();
        QVERIFY(isTakenUp());
        crew.open->trigger("guidedSwing"); // it is in front already
        QVERIFY(isTakenUp());
        crew.open->trigger("showDue");
        crew.open->trigger("guidedSwing");
        QCOMPARE(crew.open->window.findChild<PageStack*>()->description()->id, "overview");
    }

    void anAbandonedOneSaysWhyAndItsCompassIsChosen()
    {
        Crew crew;
        crew.begin(ProcedureKind::CheckOnly);
        crew.readHere();
        const SwingId swing = crew.page().swing();
        crew.find<QPushButton>("reportFault").click();
        crew.find<QLineEdit>("faultLine").setText("thunderstorm");
        crew.find<QPushButton>("abandonSwing").click();
        auto& shown = dynamic_cast<AircraftPage&>(crew.open->window.findChild<PageStack*>()->current());
        QCOMPARE(shown.compass(), crew.fleet.compass);
        QCOMPARE(crew.open->find<QTreeView>("fleetTree").currentIndex().data().toString(), "standby compass");
        QVERIFY(crew.open->find<QAction>("guidedSwing").isEnabled());
        crew.open->window.go(swing);
        QVERIFY2(crew.open->label("readOnlyReason").contains("Guided swing abandoned: thunderstorm"),
            qPrintable(crew.open->label("readOnlyReason")));
        // Removed with its swing it comes back with it: its figures are on record.
        const auto events = crew.fleet.stores.jobs.jobOf(swing)->value().job.events;
        crew.open->trigger("removeSwing");
        QVERIFY(!crew.fleet.stores.swings.swing(swing));
        crew.open->trigger("undo");
        const SwingId again = crew.open->window.findChild<SwingPage*>()->editor().id();
        const auto job = crew.fleet.stores.jobs.jobOf(again);
        QVERIFY(job && *job);
        QCOMPARE((*job)->job.events.size(), events.size());
        QVERIFY((*job)->job.events == events);
        QVERIFY(crew.fleet.stores.jobs.open()->empty());
        QVERIFY2(crew.open->label("readOnlyReason").contains("Guided swing abandoned: thunderstorm"),
            qPrintable(crew.open->label("readOnlyReason")));
    }

    void theInstrumentIsNamedWithWhatItShouldShowAndCanBeChanged()
    {
        Crew crew;
        crew.addSight(SightingDirection::Reciprocal, "sight compass 12");
        crew.addSight(SightingDirection::Direct, "theodolite");
        crew.open->window.go(crew.fleet.compass);
        crew.begin(ProcedureKind::CheckOnly);
        QCOMPARE(crew.text("guidedInstrument"), "sight compass 12: the sight reads the reciprocal: about 180");
        crew.read(180, 358);
        QCOMPARE(crew.state().stations[0].reading->magnetic.degrees(), 0.0);
        crew.find<QPushButton>("changeInstrument").click();
        auto* menu = crew.page().findChild<QMenu*>();
        QVERIFY(menu && menu->isVisible());
        for (QAction* action : menu->actions())
            if (action->text() == "theodolite")
                action->trigger();
        menu->close();
        QCOMPARE(crew.text("guidedInstrument"), "theodolite: the sight reads the heading: about 045");
        crew.read(45, 43);
        QCOMPARE(crew.state().stations[1].reading->magnetic.degrees(), 45.0);
        for (int i = 2; i < 8; ++i)
            crew.readHere();
        QCOMPARE(crew.state().phase, JobPhase::Review);
        QVERIFY(crew.text("guidedInstrument").contains("theodolite"));
        const Swing made = asLeftSwing(crew.page().job().job(), crew.state());
        QVERIFY2(made.datum.instrument.starts_with("sight compass 12 (0°); theodolite (45°, 90°"), made.datum.instrument.c_str());
    }

    void whatWasSkippedIsReadLater_data()
    {
        QTest::addColumn<QString>("way");
        for (const char* way : {"F2", "click", "arrows", "review"})
            QTest::newRow(way) << QString::fromLatin1(way);
    }
    void whatWasSkippedIsReadLater()
    {
        QFETCH(QString, way);
        Crew crew;
        crew.begin(ProcedureKind::CheckOnly);
        crew.readHere();
        crew.page().station().skip();
        QVERIFY2(crew.text("guidedMessage").contains("instead of"), qPrintable(crew.text("guidedMessage"))); // its cost, at once
        QCOMPARE(crew.state().current, 1);
        crew.skip("the tug is in the way");
        QCOMPARE(crew.state().current, 2);
        auto& strip = crew.find<StationStrip>("stationStrip");
        if (way != "F2")
            crew.readHere();
        if (way == "F2") {
            crew.page().station().readAgain();
        } else if (way == "click") {
            crew.click(strip, 1);
        } else if (way == "arrows") {
            strip.setFocus();
            QTest::keyClick(&strip, Qt::Key_Left);
            QTest::keyClick(&strip, Qt::Key_Left);
            QTest::keyClick(&strip, Qt::Key_Return);
        } else {
            while (crew.state().phase == JobPhase::Stations)
                crew.readHere();
            auto& table = crew.find<QTableWidget>("residuals");
            QVERIFY2(table.item(0, 1)->text().contains("skipped: the tug is in the way"), qPrintable(table.item(0, 1)->text()));
            table.setCurrentCell(0, 0);
            crew.find<QPushButton>("reviewAgain").click();
        }
        QCOMPARE(crew.state().phase, JobPhase::Stations);
        QCOMPARE(crew.state().current, 1);
        crew.readHere();
        QVERIFY(crew.state().stations[1].reading && crew.state().stations[1].skipped.empty());
        while (crew.state().phase == JobPhase::Stations)
            crew.readHere();
        for (const Reading& reading : asLeftSwing(crew.page().job().job(), crew.state()).readings)
            QVERIFY(reading.complete());
    }

    /// The first that was left out stays left out where a control was turned since: as it was found nobody can read it any more.
    void whatWasFoundCannotBeReadAfterAControlWasTurned()
    {
        Crew crew;
        crew.begin(ProcedureKind::Coefficient);
        crew.read(0, 2);
        crew.skip("fence"); // E
        crew.read(180, 174);
        crew.find<QLineEdit>("guidedAfter").setText(crew.text("turnTarget").chopped(1));
        crew.page().station().next();
        crew.click(crew.find<StationStrip>("stationStrip"), 1);
        QCOMPARE(crew.state().stations[1].skipped, "fence");
        QVERIFY2(crew.text("guidedMessage").contains("a control was turned since"), qPrintable(crew.text("guidedMessage")));
    }

    void theCrewsDisplayLeavesTheKeysAndF11ClosesIt()
    {
        Crew crew;
        crew.begin(ProcedureKind::CheckOnly);
        auto& datum = crew.find<QLineEdit>("guidedDatum");
        datum.setFocus();
        QTest::keyClick(&datum, Qt::Key_F11);
        CrewDisplay* display = nullptr;
        for (QWidget* top : QApplication::topLevelWidgets())
            if (auto* found = qobject_cast<CrewDisplay*>(top))
                display = found;
        QVERIFY(display && display->isVisible());
        QVERIFY(display->windowFlags() & Qt::WindowDoesNotAcceptFocus);
        QVERIFY(display->testAttribute(Qt::WA_ShowWithoutActivating));
        QCOMPARE(QApplication::focusWidget(), &datum);
        QTest::keyClicks(&datum, "1");
        QCOMPARE(datum.text(), "1");
        QTest::keyClick(&datum, Qt::Key_F11);
        QVERIFY(!display->isVisible());
    }
};

} // namespace lubberline::ui

QTEST_MAIN(lubberline::ui::GuidedOnwardsTest)
#include "GuidedOnwardsTest.moc"
