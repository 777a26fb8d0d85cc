// A guided swing by keyboard, as a crew does it: published worksheets figure by figure, and taken up again after each of them.
// "Worksheet n": Compass Compensation Worksheet, examples Q1–Q3 (to CAP 562).

#include <QTableWidget>

#include <array>

#include "tests/ui/guided/GuidedKeyboard.h"
#include "ui/guided/GuidedStation.h"
#include "ui/guided/GuidedWords.h"

namespace lubberline::ui {

namespace {

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

} // namespace

class GuidedWorksheetsTest : public QObject {
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
};

} // namespace lubberline::ui

QTEST_MAIN(lubberline::ui::GuidedWorksheetsTest)
#include "GuidedWorksheetsTest.moc"
