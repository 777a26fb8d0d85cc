// The page of a guided swing beside its figures: another window, a full disk, the base it stands on, and what is seen from afar.

#include "tests/ui/guided/GuidedKeyboard.h"
#include "ui/guided/CrewDisplay.h"
#include "ui/guided/GuidedStation.h"
#include "ui/intake/LivePanel.h"

namespace lubberline::ui {

class GuidedPageTest : public QObject {
    Q_OBJECT

private slots:
    void aSecondWindowIsToldAndOverwritesNothing()
    {
        Keyboard keyboard;
        keyboard.begin(ProcedureKind::CheckOnly);
        GuidedPage second(keyboard.fleet.stores, [] { return std::string("2026-11-23T10:05:00Z"); });
        QVERIFY(second.takeUp(keyboard.page.swing()));
        keyboard.read({0, 359});
        QSignalSpy told(&second, &GuidedPage::failed);
        const auto refused = second.job().tell(job::ReadingTaken{0, {}, 0, 350, {}});
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::Conflict);
        QCOMPARE(
            keyboard.fleet.stores.jobs.jobOf(keyboard.page.swing())->value().job.events.size(), keyboard.page.job().job().events.size());
    }

    /// The page scrolls on a small screen: what F12 shows is seen.
    void theLiveStripComesIntoSight()
    {
        Keyboard keyboard;
        keyboard.begin(ProcedureKind::CheckOnly);
        keyboard.page.resize(720, 420);
        auto& strip = keyboard.find<LivePanel>("liveStrip");
        QVERIFY(!strip.isVisible());
        QTest::keyClick(&keyboard.page, Qt::Key_F12);
        QTRY_VERIFY(strip.isVisible());
        QTRY_COMPARE(strip.visibleRegion().boundingRect().size(), strip.size());
    }

    void aFullDiskLosesNothingThatWasTyped()
    {
        Keyboard keyboard;
        keyboard.begin(ProcedureKind::CheckOnly);
        QSignalSpy notStored(&keyboard.page, &GuidedPage::notStored);
        keyboard.fleet.stores.watch().refuseWrites = true;
        keyboard.read({0, 359});
        QCOMPARE(keyboard.state().current, 0);
        QVERIFY(keyboard.text("guidedMessage").contains("full"));
        QCOMPARE(keyboard.find<QLineEdit>("guidedCompass").text(), "359");
        QCOMPARE(notStored.count(), 1);
        keyboard.fleet.stores.watch().refuseWrites = false;
        keyboard.key(Qt::Key_Return);
        QCOMPARE(keyboard.state().current, 1);
    }

    void anExpiredSiteOrDatumNeedsAReason()
    {
        Keyboard keyboard;
        Site base;
        base.name = "Rose 2";
        base.certificateExpiry = "2026-11-22";
        const SiteId site = *keyboard.fleet.stores.save(base);
        QVERIFY(keyboard.page.begin(keyboard.fleet.compass));
        keyboard.find<QComboBox>("guidedSite").setCurrentIndex(1);
        keyboard.find<QPushButton>("beginGuided").click();
        QVERIFY(keyboard.text("guidedComplaint").contains("A reason is expected"));
        QVERIFY(keyboard.fleet.stores.jobs.open()->empty());
        keyboard.find<QLineEdit>("guidedOverride").setText("only base that is open");
        keyboard.find<QPushButton>("beginGuided").click();
        const auto jobs = keyboard.fleet.stores.jobs.open();
        QCOMPARE(jobs->size(), 1u);
        const Swing swing = keyboard.fleet.stores.swings.record(jobs->front().swing)->swing;
        QCOMPARE(swing.site, site);
        QVERIFY(QString::fromStdString(swing.siteOverride).endsWith("only base that is open"));
    }

    /// Painted for 4.0° E where it is about 6.5° E: a line marked 090 heads 4.0 − 6.5 less, magnetic.
    void aRoseLineIsCorrectedForItsAge()
    {
        Keyboard keyboard;
        Site base;
        base.name = "Rose 2";
        base.latitude_deg = 53.1;
        base.longitude_deg = 17.98;
        base.paintedVariation_deg = 4.0;
        QVERIFY(keyboard.fleet.stores.save(base));
        DatumInstrument lines;
        lines.name = "painted lines";
        lines.kind = DatumKind::RoseLine;
        QVERIFY(keyboard.fleet.stores.save(lines));
        QVERIFY(keyboard.page.begin(keyboard.fleet.compass));
        keyboard.find<QComboBox>("guidedProcedure").setCurrentIndex(static_cast<int>(ProcedureKind::CheckOnly));
        keyboard.find<QComboBox>("guidedSite").setCurrentIndex(1);
        QVERIFY2(keyboard.text("guidedComplaint").contains("out by −2."), qPrintable(keyboard.text("guidedComplaint")));
        keyboard.find<QPlainTextEdit>("guidedChecklist").clear();
        keyboard.find<QPushButton>("beginGuided").click();
        keyboard.find<QPushButton>("prepared").click();
        QCOMPARE(keyboard.find<QLineEdit>("guidedDatum").text(), "000"); // the aircraft is set on the line
        keyboard.type("357");
        const double magnetic = keyboard.state().stations[0].reading->magnetic.degrees();
        QVERIFY2(magnetic > 357 && magnetic < 358, qPrintable(QString::number(magnetic))); // 000 − 2.47
    }

    void theSecondScreenShowsTheNextFigure()
    {
        Keyboard keyboard;
        keyboard.begin();
        CrewDisplay crew(keyboard.page.job());
        crew.refresh();
        QCOMPARE(crew.findChild<QLabel*>("crewFigure")->text(), "000° N");
        keyboard.readAndKeep({359, 3});
        keyboard.readAndKeep({91, 85});
        keyboard.readAndKeep({178, 170});
        QCOMPARE(crew.findChild<QLabel*>("crewFigure")->text(), "176");
        QVERIFY(crew.findChild<QLabel*>("crewWhat")->text().contains("N–S screw"));
    }

    void figuresAreLargeEnoughForTheSun()
    {
        Keyboard keyboard;
        keyboard.begin();
        for (const char* name : {"guidedDatum", "guidedCompass", "guidedAfter"})
            QVERIFY(keyboard.find<QLineEdit>(name).font().pixelSize() >= 48);
        QVERIFY(keyboard.find<QLabel>("turnTarget").font().pixelSize() >= 48);
    }
};

} // namespace lubberline::ui

QTEST_MAIN(lubberline::ui::GuidedPageTest)
#include "GuidedPageTest.moc"
