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
struct Keyboard {
    SmallFleet fleet;
    GuidedPage page{fleet.stores, [] { return std::string("2026-11-23T10:00:00Z"); }};
    QSignalSpy finished{&page, &GuidedPage::finished};
    QSignalSpy failed{&page, &GuidedPage::failed};

    Keyboard()
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
        Keyboard keyboard;
        keyboard.begin();
        QCOMPARE(keyboard.text("turnTo"), "Turn to 000° N");
        keyboard.readAndKeep(worksheet.correction[0]);
        keyboard.readAndKeep(worksheet.correction[1]);
        QCOMPARE(keyboard.text("turnTo"), "Turn to 180° S");
        keyboard.readAndKeep(worksheet.correction[2]);
        QCOMPARE(keyboard.text("turnSentence"), QStringLiteral("C = %1°: turn the N–S screw until the compass reads").arg(worksheet.C));
        QCOMPARE(keyboard.text("turnTarget"), worksheet.onSouth);
        keyboard.obey();
        keyboard.readAndKeep(worksheet.correction[3]);
        QCOMPARE(keyboard.text("turnSentence"), QStringLiteral("B = %1°: turn the E–W screw until the compass reads").arg(worksheet.B));
        QCOMPARE(keyboard.text("turnTarget"), worksheet.onWest);
        keyboard.obey();
        for (const Pair pair : worksheet.check)
            keyboard.readAndKeep(pair);
        QCOMPARE(keyboard.text("turnSentence"),
            QStringLiteral("A = %1°: turn the compass in its mount until the compass reads").arg(worksheet.A));
        keyboard.obey();
        auto& table = keyboard.find<QTableWidget>("residuals");
        QCOMPARE(table.rowCount(), 8);
        for (int row = 0; row < 8; ++row)
            QCOMPARE(table.item(row, 5)->text().toInt(), worksheet.steer[static_cast<std::size_t>((row + 7) % 8)]); // from NW on
        keyboard.type("Dora");
        QCOMPARE(keyboard.finished.count(), 1);
        const SwingId made = keyboard.finished.front().front().value<SwingId>();
        const auto record = keyboard.fleet.stores.swings.record(made);
        QCOMPARE(record->swing.readings.size(), 8u);
        QCOMPARE(record->swing.stage, SwingStage::AsLeft);
        QVERIFY(qAbs(*record->swing.indexRemoved_deg - QString(worksheet.A).replace(QChar(0x2212), '-').toDouble()) < 1e-9);
        // What was found before any control was turned on it is a swing of its own.
        const auto others = keyboard.fleet.stores.whole().swings;
        const auto found
            = std::find_if(others.begin(), others.end(), [&](const Swing& one) { return one.job == record->swing.job && one.id != made; });
        QVERIFY(found != others.end());
        QCOMPARE(found->stage, SwingStage::AsFound);
        QCOMPARE(found->readings.size(), 4u);
        QCOMPARE(found->readings[2].compass->degrees(), worksheet.correction[2].compass_deg);
        QCOMPARE(found->readings[2].raw.compass_deg.size(), 1u);
        QVERIFY(keyboard.fleet.stores.jobs.open()->empty());
    }

    /// TM 1-1500-204-23-4: N 008, E 086, S 176, W 278 (V6): C is taken out on N from 008 to 002.
    void theArmysExample()
    {
        Keyboard keyboard;
        keyboard.begin(ProcedureKind::IndexFirst);
        for (const Pair pair : {Pair{0, 8}, Pair{90, 86}, Pair{180, 176}, Pair{270, 278}})
            keyboard.readAndKeep(pair);
        QCOMPARE(keyboard.text("turnTarget"), "276°");
        keyboard.key(Qt::Key_F5);
        keyboard.type("mount is riveted");
        QCOMPARE(keyboard.text("turnTarget"), "272°");
        keyboard.obey();
        keyboard.readAndKeep({0, 8});
        QCOMPARE(keyboard.text("turnTarget"), "002°");
    }

    /// Duncan Aviation's example (V5): index of −1.75° in our sign, then C −5.5° on N and B +3° on E.
    void theFluxValve()
    {
        Keyboard keyboard;
        keyboard.begin(ProcedureKind::FluxValve);
        for (const Pair pair : {Pair{0, 6}, Pair{90, 90}, Pair{180, 175}, Pair{270, 276}})
            keyboard.readAndKeep(pair);
        QVERIFY(keyboard.text("turnSentence").startsWith("A = −1.8°"));
        keyboard.type("274.25");
        keyboard.readAndKeep({0, 4.25});
        QVERIFY(keyboard.text("turnSentence").startsWith("C = −5.5°"));
        keyboard.type("358.75");
        keyboard.readAndKeep({90, 88.25});
        QVERIFY(keyboard.text("turnSentence").startsWith("B = +3.0°"));
        QCOMPARE(keyboard.text("turnTarget"), "091.3°");
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
        Keyboard keyboard;
        keyboard.fleet.addSwing(
            "2025-11-01", {{0, 359}, {45, 44}, {90, 89}, {135, 134}, {180, 179}, {225, 224}, {270, 269}, {315, 314}}); // last year
        keyboard.begin(ProcedureKind::CheckOnly);
        for (const double heading : {0.0, 45.0, 90.0, 135.0, 180.0, 225.0})
            keyboard.readAndKeep({heading, wrap360(heading - 1)});
        const auto steps = keyboard.page.job().job().events.size();
        keyboard.type("270");
        keyboard.type(typed);
        QCOMPARE(keyboard.page.job().job().events.size(), steps); // not taken yet
        QVERIFY2(keyboard.text("guidedMessage").contains(words), qPrintable(keyboard.text("guidedMessage")));
        keyboard.type("269"); // looked at again
        QCOMPARE(keyboard.page.job().job().events.size(), steps + 1);
        QVERIFY(keyboard.text("guidedMessage").isEmpty());
        QCOMPARE(keyboard.text("turnTo"), "Turn to 315° NW");
    }

    void anAircraftFarFromItsHeadingAndABadFigureAreSaid()
    {
        Keyboard keyboard;
        keyboard.begin(ProcedureKind::CheckOnly);
        keyboard.read({12, 11});
        QVERIFY(keyboard.text("guidedMessage").contains("12.0° from 000"));
        keyboard.key(Qt::Key_Return); // it stands there all the same
        QCOMPARE(keyboard.state().current, 1);
        QVERIFY(QString::fromStdString(std::get<job::ReadingTaken>(keyboard.page.job().job().events.back().what).note)
                    .contains("kept as read"));
        keyboard.read({45, 44});
        keyboard.type("90");
        keyboard.type("nonsense");
        QCOMPARE(keyboard.state().current, 2);
        QVERIFY(keyboard.text("guidedMessage").contains("nonsense"));
        keyboard.type("89 89.5 90 91"); // four figures
        QVERIFY(keyboard.text("guidedMessage").contains("one to three"));
        keyboard.type("89 90 89");
        QCOMPARE(keyboard.state().current, 3);
        QVERIFY(qAbs(keyboard.state().stations[2].reading->compass.degrees() - 268.0 / 3) < 1e-9);
    }

    void anotherHeadingIsNoReadingHere()
    {
        Keyboard keyboard;
        keyboard.begin(ProcedureKind::CheckOnly);
        keyboard.read({45, 44}); // north is asked for
        keyboard.key(Qt::Key_Return);
        QCOMPARE(keyboard.state().current, 0);
        QVERIFY2(keyboard.text("guidedMessage").contains("no reading on 000°"), qPrintable(keyboard.text("guidedMessage")));
    }

    void moreThanTheCompensatorCanIsSaid()
    {
        Keyboard keyboard;
        keyboard.begin();
        keyboard.readAndKeep({0, 320});
        keyboard.readAndKeep({90, 90});
        keyboard.readAndKeep({180, 220});
        QCOMPARE(keyboard.text("turnSentence").left(9), QStringLiteral("C = +40.0"));
        QVERIFY(keyboard.text("guidedMessage").contains("demagnetise"));
    }

    void repeatSkipAndFault()
    {
        Keyboard keyboard;
        keyboard.begin(ProcedureKind::CheckOnly);
        keyboard.read({0, 359});
        keyboard.read({45, 44});
        keyboard.key(Qt::Key_F2); // the last one again
        QCOMPARE(keyboard.text("turnTo"), "Turn to 045° NE");
        keyboard.read({45, 43.5});
        keyboard.key(Qt::Key_F4);
        keyboard.type("");
        QCOMPARE(keyboard.state().current, 2); // not without a reason
        keyboard.type("tug in the way");
        QCOMPARE(keyboard.state().current, 3);
        keyboard.key(Qt::Key_F8);
        keyboard.type("bubble in the bowl");
        QCOMPARE(keyboard.state().phase, JobPhase::Fault);
        QVERIFY(keyboard.text("faultText").contains("bubble in the bowl"));
        keyboard.type("topped up");
        QCOMPARE(keyboard.state().phase, JobPhase::Stations);
        for (int heading = 135; heading < 360; heading += 45)
            keyboard.readAndKeep({double(heading), double(heading - 1)});
        QCOMPARE(keyboard.state().phase, JobPhase::Review);
        QVERIFY2(keyboard.text("reviewNotes").contains("090° E (tug in the way)"), qPrintable(keyboard.text("reviewNotes")));
        QVERIFY(keyboard.text("reviewNotes").contains("instead of"));
    }

    void aControlTurnedAfterTheCheckSwingVoidsIt()
    {
        Keyboard keyboard;
        keyboard.begin(ProcedureKind::CheckOnly);
        for (int heading = 0; heading < 360; heading += 45)
            keyboard.readAndKeep({double(heading), wrap360(heading - 2)});
        QCOMPARE(keyboard.state().phase, JobPhase::Review);
        keyboard.find<QLineEdit>("turnedAfter").setText("359");
        keyboard.find<QPushButton>("turnedAgain").click();
        QCOMPARE(keyboard.state().phase, JobPhase::Stations);
        QVERIFY(keyboard.text("guidedMessage").contains("void"));
        QCOMPARE(keyboard.state().current, 0);
    }

    void whatIsWantedAndWhatIsReadAfterTurningMayDiffer()
    {
        Keyboard keyboard;
        keyboard.begin();
        keyboard.readAndKeep({359, 3});
        keyboard.readAndKeep({91, 85});
        keyboard.readAndKeep({178, 170});
        keyboard.type("179"); // 176 is wanted
        QVERIFY(keyboard.text("guidedMessage").contains("176° is wanted, it reads 179°"));
        QCOMPARE(keyboard.state().current, 2);
        keyboard.key(Qt::Key_Return); // the screw is at its stop
        QCOMPARE(keyboard.state().current, 3);
        QCOMPARE(std::get<job::Adjusted>(keyboard.page.job().job().events.back().what).after_deg, 179.0);
    }

    void itGoesOnWhereItStoodOnAnyStep()
    {
        Keyboard keyboard;
        keyboard.begin();
        const auto& worksheet = kWorksheets[0];
        const auto again = [&] { // another run of the program
            GuidedPage other(keyboard.fleet.stores, [] { return std::string("2026-11-24T06:00:00Z"); });
            QVERIFY(other.takeUp(keyboard.page.swing()));
            QCOMPARE(stepTitle(other.job()), stepTitle(keyboard.page.job()));
            QVERIFY(other.job().job() == keyboard.page.job().job());
        };
        for (const Pair pair : worksheet.correction) {
            keyboard.readAndKeep(pair);
            again();
            if (keyboard.state().turn) {
                keyboard.obey();
                again();
            }
        }
        for (const Pair pair : worksheet.check) {
            keyboard.readAndKeep(pair);
            again();
        }
    }

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
