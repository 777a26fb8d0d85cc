// The card on the page: its rows by either heading and in every step, what has to be said, and the value between rows.

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>

#include <cmath>

#include "core/swing/SwingResult.h"
#include "tests/ui/window/Fixture.h"
#include "tests/ui/window/Typing.h"
#include "ui/swing/CardPanel.h"

namespace lubberline::ui {

class CardPanelTest : public QObject {
    Q_OBJECT

    static SwingRecord recordOf(const std::vector<std::pair<double, double>>& pairs)
    {
        SwingRecord record;
        for (const auto& [magnetic, compass] : pairs) {
            Reading reading;
            reading.magnetic = MagneticHeading::fromDegrees(magnetic);
            reading.compass = CompassHeading::fromDegrees(compass);
            record.swing.readings.push_back(reading);
        }
        return record;
    }

private slots:
    /// The worksheet's question 1 (QNSC PEWB), by readings and without A.
    void hasTheWorksheetsFigures()
    {
        const SwingRecord record = recordOf({{317, 316}, {0, 358}, {47, 42}, {93, 89}, {135, 134}, {179, 177}, {225, 220}, {273, 269}});
        CardPanel panel;
        panel.show(record, std::make_shared<const Analysis>(resultOf(record).value()), {});
        auto& rows = in<QTableWidget>(panel, "cardRows");
        QCOMPARE(rows.rowCount(), 12);
        in<QComboBox>(panel, "cardStep").setCurrentIndex(3); // 45°
        in<QComboBox>(panel, "cardFrom").setCurrentIndex(1);
        in<QCheckBox>(panel, "cardWithoutA").setChecked(true);
        const char* steer[] = {"001", "043", "089", "137", "181", "223", "269", "317"};
        QCOMPARE(rows.rowCount(), 8);
        for (int row = 0; row < 8; ++row)
            QCOMPARE(rows.item(row, 1)->text(), QString(steer[row]));
        in<QDoubleSpinBox>(panel, "cardAt").setValue(22.5);
        QVERIFY(in<QLabel>(panel, "cardBetween").text().contains("STEER 022.0 between the rows")); // 001 and 043
        QSignalSpy wanted(&panel, &CardPanel::writeCard);
        in<QPushButton>(panel, "writeThisCard").click();
        QCOMPARE(wanted.count(), 1);
        in<QComboBox>(panel, "cardBy").setCurrentIndex(1);
        in<QComboBox>(panel, "cardStep").setCurrentIndex(0);
        QCOMPARE(rows.rowCount(), 36);
        QCOMPARE(rows.horizontalHeaderItem(0)->text(), QString("COMPASS"));
    }

    void marksWhatNobodyReadAndRefusesAFold()
    {
        const SwingRecord record = recordOf({{0, 1}, {30, 32}, {60, 61}, {90, 90}, {120, 121}, {150, 152}, {180, 181}, {210, 210}});
        CardPanel panel;
        panel.show(record, std::make_shared<const Analysis>(resultOf(record).value()), {});
        auto& rows = in<QTableWidget>(panel, "cardRows");
        for (int row = 0; row < 12; ++row)
            QCOMPARE(rows.item(row, 1)->text().contains('*'), row > 7);
        QVERIFY(in<QLabel>(panel, "cardRemarks").text().contains("no reading between 210° and 001°"));
        std::vector<std::pair<double, double>> folded; // hard iron stronger than the field: the needle only swings to and fro
        for (int heading = 0; heading < 360; heading += 15)
            folded.emplace_back(heading, wrap360(toDegrees(std::atan2(std::sin(toRadians(heading)), 1.2 + std::cos(toRadians(heading))))));
        const SwingRecord fold = recordOf(folded);
        panel.show(fold, std::make_shared<const Analysis>(resultOf(fold).value()), {});
        QCOMPARE(rows.rowCount(), 0);
        QVERIFY(!in<QPushButton>(panel, "writeThisCard").isEnabled());
        QVERIFY(in<QLabel>(panel, "cardRemarks").text().startsWith("no card"));
        panel.show({}, nullptr, "too few readings");
        QCOMPARE(in<QLabel>(panel, "cardRemarks").text(), QString("too few readings"));
    }
};

} // namespace lubberline::ui

QTEST_MAIN(lubberline::ui::CardPanelTest)
#include "CardPanelTest.moc"
