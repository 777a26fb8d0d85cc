// A guided swing by keyboard, as a crew does it: the published worksheets figure by figure, slips, repeats, skips, faults, and
// taking a swing up again. "Worksheet n": Compass Compensation Worksheet, examples Q1–Q3 (to CAP 562).

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>

#include <array>

#include "tests/ui/window/Fixture.h"
#include "ui/guided/CrewDisplay.h"
#include "ui/guided/GuidedPage.h"
#include "ui/guided/GuidedStation.h"
#include "ui/guided/GuidedWords.h"

namespace lubberline::ui {

namespace {

struct Pair {
    double magnetic_deg, compass_deg;
};

struct Worksheet {
    const char* name;
    std::array<Pair, 4> correction; ///< N, E, S, W
    const char *C, *onSouth, *B, *onWest;
    std::array<Pair, 8> check; ///< NW, N, NE, E, SE, S, SW, W
    const char* A;
    std::array<int, 8> steer; ///< for 000, 045 … 315
};

const std::array kWorksheets{
    Worksheet{"Q1", {{{359, 3}, {91, 85}, {178, 170}, {267, 265}}}, "−6.0", "176°", "+2.0", "263°",
        {{{317, 316}, {0, 358}, {47, 42}, {93, 89}, {135, 134}, {179, 177}, {225, 220}, {273, 269}}}, "+3.0",
        {1, 43, 89, 137, 181, 223, 269, 317}},
    Worksheet{"Q2", {{{355, 358}, {92, 92}, {184, 183}, {272, 266}}}, "−2.0", "185°", "−3.0", "269°",
        {{{318, 316}, {1, 0}, {49, 47}, {92, 89}, {137, 135}, {182, 181}, {229, 227}, {276, 273}}}, "+2.0",
        {1, 45, 89, 135, 181, 225, 269, 315}},
    Worksheet{"Q3", {{{2, 355}, {88, 84}, {182, 185}, {268, 272}}}, "+5.0", "180°", "+4.0", "268°",
        {{{317, 316}, {0, 358}, {48, 47}, {89, 89}, {136, 135}, {183, 181}, {224, 223}, {270, 270}}}, "+1.0",
        {359, 45, 91, 135, 179, 225, 271, 315}},
};

/// The page with a crew at its keyboard.
struct Ramp {
    SmallFleet fleet;
    GuidedPage page{fleet.stores, [] { return std::string("2026-11-23T10:00:00Z"); }};
    QSignalSpy finished{&page, &GuidedPage::finished};
    QSignalSpy failed{&page, &GuidedPage::failed};

    Ramp()
    {
        page.resize(1200, 760);
        page.show();
        QApplication::setActiveWindow(&page);
    }
    template <class Widget>
    Widget& find(const char* name)
    {
        auto* widget = page.findChild<Widget*>(QString::fromLatin1(name));
        if (!widget)
            qFatal("there is no widget named %s", name);
        return *widget;
    }
    QString text(const char* label) { return find<QLabel>(label).text(); }
    void begin(ProcedureKind kind = ProcedureKind::Coefficient)
    {
        QVERIFY(page.begin(fleet.compass));
        find<QComboBox>("guidedProcedure").setCurrentIndex(static_cast<int>(kind));
        find<QPlainTextEdit>("guidedChecklist").setPlainText("tools\ndoors");
        find<QPushButton>("beginGuided").click();
        for (const char* box : {"check0", "check1"})
            QTest::keyClick(&find<QCheckBox>(box), Qt::Key_Space);
        find<QPushButton>("prepared").click();
    }
    /// Types where the focus is, then Enter.
    void type(const QString& figures)
    {
        QWidget* at = page.focusWidget();
        QVERIFY(at);
        if (auto* line = qobject_cast<QLineEdit*>(at))
            line->selectAll();
        QTest::keyClicks(at, figures);
        QTest::keyClick(at, Qt::Key_Return);
    }
    void read(Pair pair)
    {
        type(QString::number(pair.magnetic_deg));
        type(QString::number(pair.compass_deg));
    }
    /// Reads, and keeps what the page would look at twice: the worksheets' compasses are far out before they are corrected.
    void readAndKeep(Pair pair)
    {
        const int at = page.job().state().current;
        const auto before = page.job().job().events.size();
        read(pair);
        if (page.job().job().events.size() == before)
            QTest::keyClick(page.focusWidget(), Qt::Key_Return);
        QVERIFY(page.job().state().current != at || page.job().state().turn || page.job().state().phase != JobPhase::Stations);
    }
    void obey() { type(text("turnTarget").chopped(1)); }
    const JobState& state() { return page.job().state(); }
    void key(Qt::Key code) { QTest::keyClick(page.focusWidget(), code); }
};

} // namespace

class GuidedPageTest : public QObject {
    Q_OBJECT

private slots:
    void theWorksheetsByKeyboard_data()
    {
        QTest::addColumn<int>("sheet");
        for (int i = 0; i < 3; ++i)
            QTest::newRow(kWorksheets[static_cast<std::size_t>(i)].name) << i;
    }
    void theWorksheetsByKeyboard()
    {
        QFETCH(int, sheet);
        const Worksheet& worksheet = kWorksheets[static_cast<std::size_t>(sheet)];
        Ramp ramp;
        ramp.begin();
        QCOMPARE(ramp.text("turnTo"), "Turn to 000° N");
        ramp.readAndKeep(worksheet.correction[0]);
        ramp.readAndKeep(worksheet.correction[1]);
        QCOMPARE(ramp.text("turnTo"), "Turn to 180° S");
        ramp.readAndKeep(worksheet.correction[2]);
        QCOMPARE(ramp.text("turnSentence"), QStringLiteral("C = %1°: turn the N–S screw until the compass reads").arg(worksheet.C));
        QCOMPARE(ramp.text("turnTarget"), worksheet.onSouth);
        ramp.obey();
        ramp.readAndKeep(worksheet.correction[3]);
        QCOMPARE(ramp.text("turnSentence"), QStringLiteral("B = %1°: turn the E–W screw until the compass reads").arg(worksheet.B));
        QCOMPARE(ramp.text("turnTarget"), worksheet.onWest);
        ramp.obey();
        for (const Pair pair : worksheet.check)
            ramp.readAndKeep(pair);
        QCOMPARE(
            ramp.text("turnSentence"), QStringLiteral("A = %1°: turn the compass in its mount until the compass reads").arg(worksheet.A));
        ramp.obey();
        auto& table = ramp.find<QTableWidget>("residuals");
        QCOMPARE(table.rowCount(), 8);
        for (int row = 0; row < 8; ++row)
            QCOMPARE(table.item(row, 5)->text().toInt(), worksheet.steer[static_cast<std::size_t>((row + 7) % 8)]); // from NW on
        ramp.type("Dora");
        QCOMPARE(ramp.finished.count(), 1);
        const SwingId made = ramp.finished.front().front().value<SwingId>();
        const auto record = ramp.fleet.stores.swings.record(made);
        QCOMPARE(record->swing.readings.size(), 8u);
        QCOMPARE(record->swing.stage, SwingStage::AsLeft);
        QVERIFY(qAbs(*record->swing.indexRemoved_deg - QString(worksheet.A).replace(QChar(0x2212), '-').toDouble()) < 1e-9);
        // What was found before any control was turned on it is a swing of its own.
        const auto others = ramp.fleet.stores.whole().swings;
        const auto found
            = std::find_if(others.begin(), others.end(), [&](const Swing& one) { return one.job == record->swing.job && one.id != made; });
        QVERIFY(found != others.end());
        QCOMPARE(found->stage, SwingStage::AsFound);
        QCOMPARE(found->readings.size(), 4u);
        QCOMPARE(found->readings[2].compass->degrees(), worksheet.correction[2].compass_deg);
        QCOMPARE(found->readings[2].raw.compass_deg.size(), 1u);
        QVERIFY(ramp.fleet.stores.jobs.open()->empty());
    }

    /// TM 1-1500-204-23-4: N 008, E 086, S 176, W 278 (V6): C is taken out on N from 008 to 002.
    void theArmysExample()
    {
        Ramp ramp;
        ramp.begin(ProcedureKind::IndexFirst);
        for (const Pair pair : {Pair{0, 8}, Pair{90, 86}, Pair{180, 176}, Pair{270, 278}})
            ramp.readAndKeep(pair);
        QCOMPARE(ramp.text("turnTarget"), "276°");
        ramp.key(Qt::Key_F5);
        ramp.type("mount is riveted");
        QCOMPARE(ramp.text("turnTarget"), "272°");
        ramp.obey();
        ramp.readAndKeep({0, 8});
        QCOMPARE(ramp.text("turnTarget"), "002°");
    }

    /// Duncan Aviation's example (V5): index of −1.75° in our sign, then C −5.5° on N and B +3° on E.
    void theFluxValve()
    {
        Ramp ramp;
        ramp.begin(ProcedureKind::FluxValve);
        for (const Pair pair : {Pair{0, 6}, Pair{90, 90}, Pair{180, 175}, Pair{270, 276}})
            ramp.readAndKeep(pair);
        QVERIFY(ramp.text("turnSentence").startsWith("A = −1.8°"));
        ramp.type("274.25");
        ramp.readAndKeep({0, 4.25});
        QVERIFY(ramp.text("turnSentence").startsWith("C = −5.5°"));
        ramp.type("358.75");
        ramp.readAndKeep({90, 88.25});
        QVERIFY(ramp.text("turnSentence").startsWith("B = +3.0°"));
        QCOMPARE(ramp.text("turnTarget"), "091.3°");
    }

    void slipsAreNamedBeforeTheyAreKept_data()
    {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("words");
        QTest::newRow("swapped digits") << "296"
                                        << "swapped digits, 269° meant";
        QTest::newRow("reciprocal") << "089"
                                    << "the reciprocal, 269° meant";
        QTest::newRow("ten degrees") << "279"
                                     << "a 10° slip, 269° meant";
    }
    void slipsAreNamedBeforeTheyAreKept()
    {
        QFETCH(QString, typed);
        QFETCH(QString, words);
        Ramp ramp;
        ramp.fleet.addSwing(
            "2025-11-01", {{0, 359}, {45, 44}, {90, 89}, {135, 134}, {180, 179}, {225, 224}, {270, 269}, {315, 314}}); // last year
        ramp.begin(ProcedureKind::CheckOnly);
        for (const double heading : {0.0, 45.0, 90.0, 135.0, 180.0, 225.0})
            ramp.readAndKeep({heading, wrap360(heading - 1)});
        const auto steps = ramp.page.job().job().events.size();
        ramp.type("270");
        ramp.type(typed);
        QCOMPARE(ramp.page.job().job().events.size(), steps); // not taken yet
        QVERIFY2(ramp.text("guidedMessage").contains(words), qPrintable(ramp.text("guidedMessage")));
        ramp.type("269"); // looked at again
        QCOMPARE(ramp.page.job().job().events.size(), steps + 1);
        QVERIFY(ramp.text("guidedMessage").isEmpty());
        QCOMPARE(ramp.text("turnTo"), "Turn to 315° NW");
    }

    void anAircraftFarFromItsHeadingAndABadFigureAreSaid()
    {
        Ramp ramp;
        ramp.begin(ProcedureKind::CheckOnly);
        ramp.read({12, 11});
        QVERIFY(ramp.text("guidedMessage").contains("12.0° from 000"));
        ramp.key(Qt::Key_Return); // it stands there all the same
        QCOMPARE(ramp.state().current, 1);
        QVERIFY(
            QString::fromStdString(std::get<job::ReadingTaken>(ramp.page.job().job().events.back().what).note).contains("kept as read"));
        ramp.read({45, 44});
        ramp.type("90");
        ramp.type("nonsense");
        QCOMPARE(ramp.state().current, 2);
        QVERIFY(ramp.text("guidedMessage").contains("nonsense"));
        ramp.type("89 89.5 90 91"); // four figures
        QVERIFY(ramp.text("guidedMessage").contains("one to three"));
        ramp.type("89 90 89");
        QCOMPARE(ramp.state().current, 3);
        QVERIFY(qAbs(ramp.state().stations[2].reading->compass.degrees() - 268.0 / 3) < 1e-9);
    }

    void anotherHeadingIsNoReadingHere()
    {
        Ramp ramp;
        ramp.begin(ProcedureKind::CheckOnly);
        ramp.read({45, 44}); // north is asked for
        ramp.key(Qt::Key_Return);
        QCOMPARE(ramp.state().current, 0);
        QVERIFY2(ramp.text("guidedMessage").contains("no reading on 000°"), qPrintable(ramp.text("guidedMessage")));
    }

    void moreThanTheCompensatorCanIsSaid()
    {
        Ramp ramp;
        ramp.begin();
        ramp.readAndKeep({0, 320});
        ramp.readAndKeep({90, 90});
        ramp.readAndKeep({180, 220});
        QCOMPARE(ramp.text("turnSentence").left(9), QStringLiteral("C = +40.0"));
        QVERIFY(ramp.text("guidedMessage").contains("demagnetise"));
    }

    void repeatSkipAndFault()
    {
        Ramp ramp;
        ramp.begin(ProcedureKind::CheckOnly);
        ramp.read({0, 359});
        ramp.read({45, 44});
        ramp.key(Qt::Key_F2); // the last one again
        QCOMPARE(ramp.text("turnTo"), "Turn to 045° NE");
        ramp.read({45, 43.5});
        ramp.key(Qt::Key_F4);
        ramp.type("");
        QCOMPARE(ramp.state().current, 2); // not without a reason
        ramp.type("tug in the way");
        QCOMPARE(ramp.state().current, 3);
        ramp.key(Qt::Key_F8);
        ramp.type("bubble in the bowl");
        QCOMPARE(ramp.state().phase, JobPhase::Fault);
        QVERIFY(ramp.text("faultText").contains("bubble in the bowl"));
        ramp.type("topped up");
        QCOMPARE(ramp.state().phase, JobPhase::Stations);
        for (int heading = 135; heading < 360; heading += 45)
            ramp.readAndKeep({double(heading), double(heading - 1)});
        QCOMPARE(ramp.state().phase, JobPhase::Review);
        QVERIFY2(ramp.text("reviewNotes").contains("090° E (tug in the way)"), qPrintable(ramp.text("reviewNotes")));
        QVERIFY(ramp.text("reviewNotes").contains("instead of"));
    }

    void aControlTurnedAfterTheCheckSwingVoidsIt()
    {
        Ramp ramp;
        ramp.begin(ProcedureKind::CheckOnly);
        for (int heading = 0; heading < 360; heading += 45)
            ramp.readAndKeep({double(heading), wrap360(heading - 2)});
        QCOMPARE(ramp.state().phase, JobPhase::Review);
        ramp.find<QLineEdit>("turnedAfter").setText("359");
        ramp.find<QPushButton>("turnedAgain").click();
        QCOMPARE(ramp.state().phase, JobPhase::Stations);
        QVERIFY(ramp.text("guidedMessage").contains("void"));
        QCOMPARE(ramp.state().current, 0);
    }

    void whatIsWantedAndWhatIsReadAfterTurningMayDiffer()
    {
        Ramp ramp;
        ramp.begin();
        ramp.readAndKeep({359, 3});
        ramp.readAndKeep({91, 85});
        ramp.readAndKeep({178, 170});
        ramp.type("179"); // 176 is wanted
        QVERIFY(ramp.text("guidedMessage").contains("176° is wanted, it reads 179°"));
        QCOMPARE(ramp.state().current, 2);
        ramp.key(Qt::Key_Return); // the screw is at its stop
        QCOMPARE(ramp.state().current, 3);
        QCOMPARE(std::get<job::Adjusted>(ramp.page.job().job().events.back().what).after_deg, 179.0);
    }

    void itGoesOnWhereItStoodOnAnyStep()
    {
        Ramp ramp;
        ramp.begin();
        const auto& worksheet = kWorksheets[0];
        const auto again = [&] { // another run of the program
            GuidedPage other(ramp.fleet.stores, [] { return std::string("2026-11-24T06:00:00Z"); });
            QVERIFY(other.takeUp(ramp.page.swing()));
            QCOMPARE(stepTitle(other.job()), stepTitle(ramp.page.job()));
            QVERIFY(other.job().job() == ramp.page.job().job());
        };
        for (const Pair pair : worksheet.correction) {
            ramp.readAndKeep(pair);
            again();
            if (ramp.state().turn) {
                ramp.obey();
                again();
            }
        }
        for (const Pair pair : worksheet.check) {
            ramp.readAndKeep(pair);
            again();
        }
    }

    void aSecondWindowIsToldAndOverwritesNothing()
    {
        Ramp ramp;
        ramp.begin(ProcedureKind::CheckOnly);
        GuidedPage second(ramp.fleet.stores, [] { return std::string("2026-11-23T10:05:00Z"); });
        QVERIFY(second.takeUp(ramp.page.swing()));
        ramp.read({0, 359});
        QSignalSpy told(&second, &GuidedPage::failed);
        const auto refused = second.job().tell(job::ReadingTaken{0, {}, 0, 350, {}});
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::Conflict);
        QCOMPARE(ramp.fleet.stores.jobs.jobOf(ramp.page.swing())->value().job.events.size(), ramp.page.job().job().events.size());
    }

    void aFullDiskLosesNothingThatWasTyped()
    {
        Ramp ramp;
        ramp.begin(ProcedureKind::CheckOnly);
        QSignalSpy notStored(&ramp.page, &GuidedPage::notStored);
        ramp.fleet.stores.watch().refuseWrites = true;
        ramp.read({0, 359});
        QCOMPARE(ramp.state().current, 0);
        QVERIFY(ramp.text("guidedMessage").contains("full"));
        QCOMPARE(ramp.find<QLineEdit>("guidedCompass").text(), "359");
        QCOMPARE(notStored.count(), 1);
        ramp.fleet.stores.watch().refuseWrites = false;
        ramp.key(Qt::Key_Return);
        QCOMPARE(ramp.state().current, 1);
    }

    void anExpiredSiteOrDatumNeedsAReason()
    {
        Ramp ramp;
        Site base;
        base.name = "Rose 2";
        base.certificateExpiry = "2026-11-22";
        const SiteId site = *ramp.fleet.stores.save(base);
        QVERIFY(ramp.page.begin(ramp.fleet.compass));
        ramp.find<QComboBox>("guidedSite").setCurrentIndex(1);
        ramp.find<QPushButton>("beginGuided").click();
        QVERIFY(ramp.text("guidedComplaint").contains("A reason is expected"));
        QVERIFY(ramp.fleet.stores.jobs.open()->empty());
        ramp.find<QLineEdit>("guidedOverride").setText("only base that is open");
        ramp.find<QPushButton>("beginGuided").click();
        const auto jobs = ramp.fleet.stores.jobs.open();
        QCOMPARE(jobs->size(), 1u);
        const Swing swing = ramp.fleet.stores.swings.record(jobs->front().swing)->swing;
        QCOMPARE(swing.site, site);
        QVERIFY(QString::fromStdString(swing.siteOverride).endsWith("only base that is open"));
    }

    /// Painted for 4.0° E where it is about 6.5° E: a line marked 090 heads 4.0 − 6.5 less, magnetic.
    void aRoseLineIsCorrectedForItsAge()
    {
        Ramp ramp;
        Site base;
        base.name = "Rose 2";
        base.latitude_deg = 53.1;
        base.longitude_deg = 17.98;
        base.paintedVariation_deg = 4.0;
        QVERIFY(ramp.fleet.stores.save(base));
        DatumInstrument lines;
        lines.name = "painted lines";
        lines.kind = DatumKind::RoseLine;
        QVERIFY(ramp.fleet.stores.save(lines));
        QVERIFY(ramp.page.begin(ramp.fleet.compass));
        ramp.find<QComboBox>("guidedProcedure").setCurrentIndex(static_cast<int>(ProcedureKind::CheckOnly));
        ramp.find<QComboBox>("guidedSite").setCurrentIndex(1);
        QVERIFY2(ramp.text("guidedComplaint").contains("out by −2."), qPrintable(ramp.text("guidedComplaint")));
        ramp.find<QPlainTextEdit>("guidedChecklist").clear();
        ramp.find<QPushButton>("beginGuided").click();
        ramp.find<QPushButton>("prepared").click();
        QCOMPARE(ramp.find<QLineEdit>("guidedDatum").text(), "000"); // the aircraft is set on the line
        ramp.type("357");
        const double magnetic = ramp.state().stations[0].reading->magnetic.degrees();
        QVERIFY2(magnetic > 357 && magnetic < 358, qPrintable(QString::number(magnetic))); // 000 − 2.47
    }

    void theSecondScreenShowsTheNextFigure()
    {
        Ramp ramp;
        ramp.begin();
        CrewDisplay crew(ramp.page.job());
        crew.refresh();
        QCOMPARE(crew.findChild<QLabel*>("crewFigure")->text(), "000° N");
        ramp.readAndKeep({359, 3});
        ramp.readAndKeep({91, 85});
        ramp.readAndKeep({178, 170});
        QCOMPARE(crew.findChild<QLabel*>("crewFigure")->text(), "176");
        QVERIFY(crew.findChild<QLabel*>("crewWhat")->text().contains("N–S screw"));
    }

    void figuresAreLargeEnoughForTheSun()
    {
        Ramp ramp;
        ramp.begin();
        for (const char* name : {"guidedDatum", "guidedCompass", "guidedAfter"})
            QVERIFY(ramp.find<QLineEdit>(name).font().pixelSize() >= 48);
        QVERIFY(ramp.find<QLabel>("turnTarget").font().pixelSize() >= 48);
    }
};

} // namespace lubberline::ui

QTEST_MAIN(lubberline::ui::GuidedPageTest)
#include "GuidedPageTest.moc"
