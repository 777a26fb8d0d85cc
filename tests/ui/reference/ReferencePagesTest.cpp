// The pages of heading references, of the two-minute check and of two compasses compared, with real widgets.

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

#include "core/format/reference/ScenarioJson.h"
#include "core/record/Completeness.h"
#include "tests/db/TestStores.h"
#include "ui/reference/CheckPage.h"
#include "ui/reference/ComparePage.h"
#include "ui/reference/ReferencePage.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

template <class Widget>
Widget& find(QWidget& page, const char* name)
{
    auto* widget = page.findChild<Widget*>(QString::fromLatin1(name));
    if (!widget)
        qFatal("there is no widget named %s", name);
    return *widget;
}

/// An aircraft with two compasses and six yearly swings of the first.
struct Fleet2 {
    test::TestStores stores;
    CompassId first, second;
    Fleet2()
    {
        AircraftType type;
        type.name = "Glider";
        Aircraft aircraft;
        aircraft.type = *stores.fleet.add(type);
        aircraft.registration = "SP-ABC";
        const AircraftId id = *stores.fleet.add(aircraft);
        for (const char* name : {"standby", "slaved"}) {
            CompassSystem compass;
            compass.aircraft = id;
            compass.name = name;
            (std::string(name) == "standby" ? first : second) = *stores.fleet.add(compass);
        }
        for (int year = 2020; year < 2026; ++year) {
            Swing swing;
            swing.compass = first;
            swing.date = *Date::read(std::to_string(year) + "-06-01");
            for (int heading = 0; heading < 360; heading += 45) {
                Reading reading;
                reading.compass = CompassHeading::fromDegrees(heading);
                reading.magnetic = MagneticHeading::fromDegrees(heading + 2 + 3 * std::sin(heading * 3.14159265 / 180));
                swing.readings.push_back(reading);
            }
            if (!stores.swings.add(swing))
                qFatal("a swing was not stored");
        }
    }
};

} // namespace

class ReferencePagesTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    QString m_path;
    FileQuestions files()
    {
        return {[this](const QString&, const QString&) { return m_path; },
            [this](const QString&, const QString&, const QString&) { return m_path; }};
    }

private slots:
    void aScenarioRunsAndTheSlidersTurnIt()
    {
        ReferencePage page(files());
        page.resize(1000, 650);
        page.show();
        QTRY_VERIFY(page.message().contains("Levelling"));
        auto& slider = find<QSlider>(page, "referenceTau1");
        const double before = page.scenario().vertical->tau1_s;
        slider.setValue(slider.value() + 200);
        QVERIFY(page.scenario().vertical->tau1_s > before * 2);
        auto& loop = find<QComboBox>(page, "referenceLoop");
        loop.setCurrentIndex(4);
        emit loop.activated(4);
        find<QSlider>(page, "referenceTau3").setValue(0);
        QTRY_VERIFY2(page.message().contains("tau3 > tau2"), qPrintable(page.message()));
        auto& table = find<QTableWidget>(page, "referenceTable");
        table.item(0, 0)->setText("x");
        QVERIFY(page.message().contains("no number"));
        table.item(0, 0)->setText("20");
        QCOMPARE(page.scenario().manoeuvres[0].from_s, 20.0);
        QVERIFY(!page.grab().isNull());
    }

    void scenariosAreReadAndWritten()
    {
        ReferencePage page(files());
        QSignalSpy failed(&page, &Page::failed);
        QTRY_VERIFY(page.message().contains("Levelling"));
        m_path = m_folder.filePath("s.json");
        page.save();
        QVERIFY(readScenarioFile(m_path.toStdString()).ok());
        Scenario other;
        other.duration_s = 50;
        QFile file(m_path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray::fromStdString(writeScenarioJson(other)));
        file.close();
        page.load();
        QCOMPARE(page.scenario().duration_s, 50.0);
        QTRY_VERIFY(!page.message().contains("Levelling"));
        m_path = m_folder.filePath("report.pdf");
        page.writeReport();
        QCOMPARE(failed.count(), 0);
        QFile report(m_path);
        QVERIFY(report.open(QIODevice::ReadOnly));
        QVERIFY(report.readAll().startsWith("%PDF"));
        m_path = m_folder.filePath("none.json");
        page.load();
        QCOMPARE(failed.count(), 1);
    }

    void theCheckChoosesHeadingsJudgesAndMakesASwing()
    {
        Fleet2 fleet;
        CheckPage page(fleet.stores, files());
        QVERIFY(page.open(FleetItem(fleet.first)).ok());
        QVERIFY(page.title().contains("SP-ABC"));
        auto& table = find<QTableWidget>(page, "checkTable");
        QCOMPARE(table.rowCount(), 3);
        QVERIFY(!find<QPushButton>(page, "checkStore").isEnabled());
        for (int row = 0; row < 3; ++row) {
            const double compass = table.item(row, 0)->text().chopped(1).toDouble();
            table.item(row, 1)->setText(
                QString::number(std::fmod(compass + 2 + 3 * std::sin(compass * 3.14159265 / 180) + 360, 360), 'f', 1));
            table.item(row, 2)->setText(QString::number(compass));
        }
        QVERIFY(page.verdict().has_value());
        QVERIFY2(page.verdict()->holds, qPrintable(find<QLabel>(page, "checkAnswer").text()));
        QSignalSpy made(&page, &CheckPage::makeSwing);
        find<QPushButton>(page, "checkStore").click();
        QCOMPARE(made.count(), 1);
        const auto swing = made[0][0].value<Swing>();
        QCOMPARE(swing.readings.size(), std::size_t(3));
        QCOMPARE(swing.procedure, std::string(kCheckProcedure));
        QVERIFY(missingIn(swing, swing.date).empty());
        QVERIFY(swing.note.find("holds") != std::string::npos);
        table.item(0, 1)->setText("123 456");
        QVERIFY(!page.message().isEmpty());
        m_path = m_folder.filePath("check.pdf");
        page.writeReport();
        QVERIFY(QFile::exists(m_path));
        // Another compass, without a swing: said.
        QVERIFY(page.open(FleetItem(fleet.second)).ok());
        QVERIFY(find<QLabel>(page, "checkHistory").text().contains("No swing on record"));
        QVERIFY(!page.isOf(FleetItem(fleet.first)));
    }

    void twoCompassesAreComparedFromAFile()
    {
        Fleet2 fleet;
        ComparePage page(fleet.stores, files());
        QVERIFY(page.open(FleetItem(fleet.first)).ok());
        QCOMPARE(find<QComboBox>(page, "compareSecond").count(), 2);
        m_path = m_folder.filePath("pairs.csv");
        QFile file(m_path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("first_compass_deg,second_compass_deg,magnetic_heading_deg\n0,4,\n90,94,95\n180,184,\n270,274,269\n");
        file.close();
        page.load();
        QVERIFY(page.verdict().has_value());
        QCOMPARE(page.verdict()->readings, std::size_t(4));
        QVERIFY(!find<QLabel>(page, "compareFigures").text().isEmpty());
        m_path = m_folder.filePath("compare.pdf");
        page.writeReport();
        QVERIFY(QFile::exists(m_path));
        find<QTableWidget>(page, "compareTable").item(0, 0)->setText("north-ish");
        QVERIFY(!page.verdict().has_value());
        QVERIFY(!page.message().isEmpty());
    }
};

QTEST_MAIN(ReferencePagesTest)
#include "ReferencePagesTest.moc"
