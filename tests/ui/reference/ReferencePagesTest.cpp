// The pages of heading references, of the two-minute check and of two compasses compared, with real widgets.

#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
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
#include "tests/ui/window/Typing.h"
#include "ui/plots/drawn/DrawnPlot.h"
#include "ui/reference/CheckPage.h"
#include "ui/reference/ComparePage.h"
#include "ui/reference/DatumPage.h"
#include "ui/reference/ManoeuvreLine.h"
#include "ui/reference/ReferencePage.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

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
        auto& slider = in<QSlider>(page, "referenceTau1");
        const double before = page.scenario().vertical->tau1_s;
        slider.setValue(slider.value() + 200);
        QVERIFY(page.scenario().vertical->tau1_s > before * 2);
        auto& loop = in<QComboBox>(page, "referenceLoop");
        loop.setCurrentIndex(4);
        emit loop.activated(4);
        in<QSlider>(page, "referenceTau3").setValue(0);
        QTRY_VERIFY2(page.message().contains("tau3 > tau2"), qPrintable(page.message()));
        auto& table = in<QTableWidget>(page, "referenceTable");
        table.item(0, 0)->setText("x");
        QVERIFY(page.message().contains("no number"));
        table.item(0, 0)->setText("20");
        QCOMPARE(page.scenario().manoeuvres[0].from_s, 20.0);
        QVERIFY(!page.grab().isNull());
    }

    void theAircraftsOwnDeviationIsFlownWith()
    {
        ReferencePage page(files(), [](const FleetItem& record) {
            return std::holds_alternative<CompassId>(record) ? std::optional(OwnIron{"SP-ABC · standby", {0.01, 0.05, -0.02, 0.01, 0}})
                                                             : std::nullopt;
        });
        QVERIFY(page.open(FleetItem()));
        auto& iron = in<QCheckBox>(page, "referenceIron");
        QVERIFY(iron.isHidden());
        QVERIFY(page.open(FleetItem(CompassId{})));
        QVERIFY(!iron.isHidden() && iron.text().contains("SP-ABC"));
        QVERIFY(!page.scenario().compass.model);
        iron.setChecked(true);
        QVERIFY(page.scenario().compass.model);
        QCOMPARE(page.scenario().compass.model->hardIron_nT.x(), 0.05 * page.scenario().compass.horizontal_nT);
        in<QSlider>(page, "referenceTau1").setValue(100); // what else is changed leaves it
        QVERIFY(page.scenario().compass.model && iron.isChecked());
        QVERIFY(page.open(FleetItem())); // from a page of no compass it is still the last one's
        QVERIFY(iron.isChecked());
        iron.setChecked(false);
        QVERIFY(!page.scenario().compass.model);
    }

    void slidersGoFineAndCoarseAndReset()
    {
        ReferencePage page(files());
        page.resize(1000, 650);
        page.show();
        auto& slider = in<QSlider>(page, "referenceDip");
        const int before = slider.value();
        const double dip_deg = page.scenario().dip_deg;
        slider.setFocus();
        QTest::keyClick(&slider, Qt::Key_Right);
        QCOMPARE(slider.value(), before + 1);
        QVERIFY(std::abs(page.scenario().dip_deg - dip_deg) < 0.3);
        QTest::keyClick(&slider, Qt::Key_PageDown);
        QCOMPARE(slider.value(), before + 1 - 50);
        QTest::mouseDClick(&slider, Qt::LeftButton);
        QCOMPARE(slider.value(), before);
    }

    void manoeuvresAreDrawnByHandAndByKeys()
    {
        ReferencePage page(files());
        page.resize(1024, 700);
        page.show();
        Scenario empty = page.scenario();
        empty.manoeuvres.clear();
        empty.duration_s = 600;
        page.showScenario(empty);
        auto& line = in<ManoeuvreLine>(page, "manoeuvreLine");
        const QRectF turns = line.laneRect(ManoeuvreLine::Turn);
        const auto at = [&](double time_s, double part) {
            return QPoint(qRound(line.xOf(time_s)), qRound(turns.center().y() - part * turns.height() / 2));
        };
        QTest::mousePress(&line, Qt::LeftButton, {}, at(100, 0.5));
        const auto dragTo = [&line](const QPoint& to) {
            QMouseEvent move(QEvent::MouseMove, to, line.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
            QCoreApplication::sendEvent(&line, &move);
        };
        dragTo(at(150, 0.5));
        dragTo(at(200, 0.5));
        QTest::mouseRelease(&line, Qt::LeftButton, {}, at(200, 0.5));
        QCOMPARE(page.scenario().manoeuvres.size(), std::size_t(1));
        const Manoeuvre drawn = page.scenario().manoeuvres[0];
        QVERIFY(std::abs(drawn.from_s - 100) <= 3 && std::abs(drawn.to_s - 200) <= 3);
        QCOMPARE(drawn.turnRate_deg_s, 3.0); // half of the lane's 6°/s
        QCOMPARE(in<QTableWidget>(page, "referenceTable").rowCount(), 2);
        // Its end is stretched, the block is moved.
        QTest::mousePress(&line, Qt::LeftButton, {}, at(drawn.to_s, 0.2));
        dragTo(at(250, 0.2));
        QTest::mouseRelease(&line, Qt::LeftButton, {}, at(250, 0.2));
        QVERIFY(std::abs(page.scenario().manoeuvres[0].to_s - 250) <= 3);
        const double length = page.scenario().manoeuvres[0].to_s - page.scenario().manoeuvres[0].from_s;
        QTest::keyClick(&line, Qt::Key_Right);
        QCOMPARE(page.scenario().manoeuvres[0].from_s, drawn.from_s + 5);
        QCOMPARE(page.scenario().manoeuvres[0].to_s - page.scenario().manoeuvres[0].from_s, length);
        QTest::keyClick(&line, Qt::Key_Up);
        QCOMPARE(page.scenario().manoeuvres[0].turnRate_deg_s, 3.5);
        QTest::keyClick(&line, Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(page.scenario().manoeuvres[0].to_s - page.scenario().manoeuvres[0].from_s, length + 5);
        QTest::keyClick(&line, Qt::Key_Insert);
        QCOMPARE(page.scenario().manoeuvres.size(), std::size_t(2));
        QTest::keyClick(&line, Qt::Key_Delete);
        QCOMPARE(page.scenario().manoeuvres.size(), std::size_t(1));
        QTest::keyClick(&line, Qt::Key_PageDown);
        for (int i = 0; i < 12; ++i) // through nothing to the other side, and no further than the lane
            QTest::keyClick(&line, Qt::Key_Down);
        QVERIFY(page.scenario().manoeuvres[0].turnRate_deg_s < 0);
        QTest::keyClick(&line, Qt::Key_Delete);
        QVERIFY(page.scenario().manoeuvres.empty());
        QTest::keyClick(&line, Qt::Key_Delete); // nothing to delete
        QTRY_VERIFY(!page.message().isEmpty());
    }

    void thePlotsAreReadAndExported()
    {
        ReferencePage page(files());
        page.resize(1024, 700);
        page.show();
        QTRY_VERIFY(page.message().contains("Levelling"));
        auto& time = in<DrawnPlot>(page, "referenceTime");
        const QPointF middle = QRectF(time.canvas()->rect()).center();
        QVERIFY2(time.textAt(middle).contains("error"), qPrintable(time.textAt(middle)));
        auto& gain = in<DrawnPlot>(page, "referenceGain");
        QVERIFY2(gain.textAt(QRectF(gain.canvas()->rect()).center()).contains("levelling"), "gain");
        QCOMPARE(page.plot(), static_cast<Plot*>(&time));
        for (const char* ending : {"png", "svg", "pdf"}) {
            const QString path = m_folder.filePath(QStringLiteral("reference.") + ending);
            QVERIFY(time.exportTo(path));
            QVERIFY(QFile(path).size() > 1000);
        }
    }

    void aDatumIsFoundAnywhere()
    {
        DatumPage page(files(), [] { return std::string("2026-06-21T11:30:00Z"); });
        page.resize(1024, 700);
        page.show();
        const auto type = [&](const char* name, const QString& text) {
            auto& edit = in<QLineEdit>(page, name);
            edit.setText(text);
            edit.setModified(true);
            emit edit.editingFinished();
        };
        type("sunLatitude", "52 N");
        type("sunLongitude", "21 E");
        type("sunVariation", "6 E");
        auto& headline = in<QLabel>(page, "datumHeadline");
        QVERIFY2(headline.text().contains("bearing of the shadow"), qPrintable(headline.text()));
        type("sunBearing", "0");
        const double heading = sunAt({52, 21, 0}, *readUtcTime("2026-06-21T11:30:00Z")).azimuth_deg + 180 - 6;
        QVERIFY2(headline.text().contains(QString::number(wrap360(heading), 'f', 1).rightJustified(5, '0')), qPrintable(headline.text()));
        QCOMPARE(in<QTableWidget>(page, "datumBudget").rowCount(), 6);
        QVERIFY(in<QLabel>(page, "datumLines").text().contains("daylight saving"));
        auto& day = in<DrawnPlot>(page, "datumDay");
        QVERIFY(day.textAt(QRectF(day.canvas()->rect()).center()).contains("elevation"));
        type("sunTime", "2026-06-21T23:30:00Z"); // night
        QVERIFY(headline.text().contains("no heading"));
        QVERIFY(page.message().contains("below the horizon"));
        type("sunTime", "noon"); // refused, and changes nothing
        QVERIFY(headline.text().contains("no heading"));
        auto& method = in<QComboBox>(page, "datumMethod");
        method.setCurrentIndex(1);
        type("runwayWheelbase", "10");
        QVERIFY(headline.text().contains("± 0.42"));
        method.setCurrentIndex(2);
        QVERIFY2(headline.text().contains("± 0.11"), qPrintable(headline.text()));
        method.setCurrentIndex(4);
        type("gridLatitude", "85 N");
        type("gridLongitude", "40 W");
        type("gridHeading", "90");
        QVERIFY2(headline.text().contains("130.00"), qPrintable(headline.text()));
        m_path = m_folder.filePath("datum.pdf");
        page.writeReport();
        QVERIFY(QFile::exists(m_path));
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
        auto& table = in<QTableWidget>(page, "checkTable");
        QCOMPARE(table.rowCount(), 3);
        QVERIFY(!in<QPushButton>(page, "checkStore").isEnabled());
        for (int row = 0; row < 3; ++row) {
            const double compass = table.item(row, 0)->text().chopped(1).toDouble();
            table.item(row, 1)->setText(
                QString::number(std::fmod(compass + 2 + 3 * std::sin(compass * 3.14159265 / 180) + 360, 360), 'f', 1));
            table.item(row, 2)->setText(QString::number(compass));
        }
        QVERIFY(page.verdict().has_value());
        QVERIFY2(page.verdict()->holds, qPrintable(in<QLabel>(page, "checkAnswer").text()));
        QSignalSpy made(&page, &CheckPage::makeSwing);
        in<QPushButton>(page, "checkStore").click();
        QCOMPARE(made.count(), 1);
        const auto swing = made[0][0].value<Swing>();
        QCOMPARE(swing.readings.size(), std::size_t(3));
        QCOMPARE(swing.procedure, std::string(kCheckProcedure));
        QVERIFY(missingIn(swing, swing.date).empty());
        QVERIFY(swing.note.find("holds") != std::string::npos);
        table.item(0, 1)->setText("2°30'"); // on paper as it is understood, and not as "230'"
        table.item(0, 2)->setText("0");
        QCOMPARE(page.printedRow(0).mid(1, 2), QStringList({"002.5", "000.0"}));
        QVERIFY(!page.printedRow(0).value(3).isEmpty());
        table.item(0, 2)->setText({});
        QCOMPARE(page.printedRow(0).mid(1), QStringList({"002.5", QString(), QString()}));
        table.item(0, 2)->setText("0");
        table.item(0, 1)->setText("123 456");
        QVERIFY(!page.message().isEmpty());
        m_path = m_folder.filePath("check.pdf");
        page.writeReport();
        QVERIFY(QFile::exists(m_path));
        // Another compass, without a swing: said.
        QVERIFY(page.open(FleetItem(fleet.second)).ok());
        QVERIFY(in<QLabel>(page, "checkHistory").text().contains("No swing on record"));
        QVERIFY(!page.isOf(FleetItem(fleet.first)));
    }

    void twoCompassesAreComparedFromAFile()
    {
        Fleet2 fleet;
        ComparePage page(fleet.stores, files());
        QVERIFY(page.open(FleetItem(fleet.first)).ok());
        QCOMPARE(in<QComboBox>(page, "compareSecond").count(), 2);
        m_path = m_folder.filePath("pairs.csv");
        QFile file(m_path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("first_compass_deg,second_compass_deg,magnetic_heading_deg\n0,4,\n90,94,95\n180,184,\n270,274,269\n");
        file.close();
        page.load();
        QVERIFY(page.verdict().has_value());
        QCOMPARE(page.verdict()->readings, std::size_t(4));
        QVERIFY(!in<QLabel>(page, "compareFigures").text().isEmpty());
        m_path = m_folder.filePath("compare.pdf");
        page.writeReport();
        QVERIFY(QFile::exists(m_path));
        // The second reads ten degrees off beside the datum: noted, and the due list names it.
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("first_compass_deg,second_compass_deg,magnetic_heading_deg\n0,20,2\n90,110,95\n180,200,182\n270,290,269\n");
        file.close();
        m_path = m_folder.filePath("pairs.csv");
        page.load();
        auto& due = in<QPushButton>(page, "compareDue");
        QVERIFY(due.isEnabled());
        due.click();
        QVERIFY(!due.isEnabled());
        const auto events = fleet.stores.fleet.eventsOf(fleet.stores.fleet.compass(fleet.first)->aircraft);
        QCOMPARE(events->size(), std::size_t(1));
        QVERIFY(events->front().cause == DueCause::AccuracySuspected);
        QVERIFY2(events->front().kind.find("slaved no longer holds") != std::string::npos, events->front().kind.c_str());
        in<QTableWidget>(page, "compareTable").item(0, 0)->setText("north-ish");
        QVERIFY(!page.verdict().has_value());
        QVERIFY(!page.message().isEmpty());
    }
};

QTEST_MAIN(ReferencePagesTest)
#include "ReferencePagesTest.moc"
