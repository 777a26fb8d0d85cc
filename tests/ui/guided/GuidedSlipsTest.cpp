// What goes wrong while a crew reads and turns: slips, headings far off, controls at their stop, repeats, skips, faults.

#include "tests/ui/guided/GuidedKeyboard.h"
#include "ui/guided/GuidedStation.h"

namespace lubberline::ui {

class GuidedSlipsTest : public QObject {
    Q_OBJECT

private slots:
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
};

} // namespace lubberline::ui

QTEST_MAIN(lubberline::ui::GuidedSlipsTest)
#include "GuidedSlipsTest.moc"
