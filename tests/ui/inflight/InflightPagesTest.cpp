// Deviation in flight in the window: wind reports fill a table, a curve, tables to upload and a report; a log becomes a swing in flight.

#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

#include "core/inflight/FlownModel.h"
#include "core/inflight/WindVector.h"
#include "core/sensor/SensorReading.h"
#include "core/swing/Observations.h"
#include "tests/ui/window/Fixture.h"
#include "tests/ui/window/Typing.h"
#include "ui/inflight/FlightLogPage.h"
#include "ui/inflight/WindsPage.h"
#include "ui/window/PageStack.h"

namespace lubberline::ui {

namespace {

QString written(const QTemporaryDir& folder, const QString& name, const QString& content)
{
    QFile file(folder.filePath(name));
    if (!file.open(QFile::WriteOnly))
        qFatal("the test cannot write");
    file.write(content.toUtf8());
    return file.fileName();
}

/// Headings read 0.5 + 2 sin too much.
QString reports()
{
    QString csv
        = QStringLiteral("aircraft,flight,ground_speed_kt,track_deg,wind_speed_kt,wind_from_deg,ref_wind_speed_kt,ref_wind_from_deg\n");
    for (int flight = 0; flight < 5; ++flight)
        for (int i = 0; i < 24; ++i) {
            const double read_deg = 15.0 * i, e_deg = 0.5 + 2 * std::sin(toRadians(read_deg)) + 0.02 * ((3 * i + flight) % 5 - 2);
            const Eigen::Vector2d wind(10, 20), ground = velocityOf(read_deg - e_deg, 400) + wind, own = ground - velocityOf(read_deg, 400);
            csv += QStringLiteral("SP-LRA,F%1").arg(flight);
            for (const double value :
                {ground.norm(), directionOf_deg(ground), own.norm(), directionOf_deg(-own), wind.norm(), directionOf_deg(-wind)})
                csv += ',' + QString::number(value, 'f', 6);
            csv += '\n';
        }
    return csv;
}

/// Turns with banks and climbs of an aircraft with some iron, the figures with their last digits.
QString wholeLog(int first, int count)
{
    SensorModel iron;
    iron.softIron << 0.012, -0.004, 0.010, 0.006, -0.009, 0.003, 0.005, -0.008, 0;
    iron.hardIron_nT = {700, -400, 300};
    const MeridianField field = MeridianField::fromDip(18700, toRadians(67));
    QString csv = QStringLiteral("time_s,compass_heading_deg,deviation_deg,pitch_deg,roll_deg,horizontal_nT,dip_deg\n");
    for (int i = first; i < first + count; ++i) {
        const double pitch = 15 * std::sin(0.71 * i), roll = 22 * std::sin(0.43 * i + 1);
        const auto reading = readSensor(iron, field, {MagneticHeading::fromDegrees(wrap360(137.5 * i)), toRadians(pitch), toRadians(roll)});
        csv += QString::number(10 * i);
        for (const double value :
            {reading.compass->degrees(), reading.deviation->degrees() + 0.3 * std::sin(2.4 * i * i), pitch, roll, 18700.0, 67.0})
            csv += ',' + QString::number(value, 'g', 17);
        csv += '\n';
    }
    return csv;
}

} // namespace

class InflightPagesTest : public QObject {
    Q_OBJECT

private slots:
    void reportsFillTheTableAndTheDocuments()
    {
        const QTemporaryDir folder;
        QString answer;
        WindsPage page({[&](const QString&, const QString&) { return answer; },
                           [&](const QString&, const QString&, const QString&) { return answer; }},
            [] { return QStringLiteral("2026-11-26T20:00:00Z"); });
        page.show();
        page.writeTables(); // nothing is read yet
        QVERIFY(page.message().contains("open wind reports"));
        answer = written(folder, "obs.csv", reports());
        in<QPushButton>(page, "windsOpen").click();
        auto& table = in<QTableWidget>(page, "windsTable");
        QTRY_COMPARE(table.rowCount(), 1);
        QCOMPARE(table.item(0, 0)->text(), "SP-LRA");
        QCOMPARE(table.item(0, 3)->text(), "+2.00");
        QCOMPARE(table.item(0, 5)->text(), "+0.50");
        QVERIFY2(page.message().contains("too few aircraft"), qPrintable(page.message()));
        answer = folder.filePath("tables.csv");
        page.writeTables();
        QFile csv(answer);
        QVERIFY(csv.open(QFile::ReadOnly));
        QVERIFY(csv.readAll().contains("SP-LRA,90,-2.6"));
        answer = folder.filePath("report.pdf");
        page.writeReport();
        QFile pdf(answer);
        QVERIFY(pdf.open(QFile::ReadOnly));
        QVERIFY(pdf.readAll().startsWith("%PDF-"));
        page.readReports(folder.filePath("missing.csv"));
        QTRY_VERIFY(page.message().contains("missing.csv"));
    }

    void aLogBecomesASwingInFlight()
    {
        const QTemporaryDir folder;
        SmallFleet fleet;
        FlightLogPage page(fleet.stores, {});
        page.show();
        QVERIFY(page.open(fleet.compass));
        QVERIFY(!page.open(fleet.aircraft));
        QSignalSpy made(&page, &FlightLogPage::makeSwing);
        QString legs = QStringLiteral("track_deg,ground_speed_kt,compass_heading_deg\n");
        for (int i = 0; i < 8; ++i) {
            const Eigen::Vector2d ground = velocityOf(45.0 * i, 90) + Eigen::Vector2d(8, -5);
            legs += QStringLiteral("%1,%2,%3\n")
                        .arg(directionOf_deg(ground), 0, 'f', 8)
                        .arg(ground.norm(), 0, 'f', 8)
                        .arg(std::fmod(45.0 * i + 352, 360));
        }
        in<QLineEdit>(page, "flightVariation").setText("6 E");
        page.readLog(written(folder, "legs.csv", legs));
        QTRY_VERIFY(in<QPushButton>(page, "flightMake").isEnabled());
        QVERIFY2(page.message().contains("Wind from 302"), qPrintable(page.message()));
        in<QPushButton>(page, "flightMake").click();
        QCOMPARE(made.count(), 1);
        const Swing swing = made.front().front().value<Swing>();
        QCOMPARE(swing.compass, fleet.compass);
        QCOMPARE(swing.kind, SwingKind::Air);
        const auto analysis = analyse(observationsOf(swing));
        QVERIFY(std::abs(toDegrees(*analysis->approximate.of(Coefficient::A)) - 2) < 1e-3);

        QString log = QStringLiteral("time_s,compass_heading_deg,deviation_deg\n");
        for (int i = 0; i < 200; ++i)
            log += QStringLiteral("%1,%2,%3\n").arg(i).arg(i * 77 % 360).arg(1.5 * std::cos(toRadians(i * 77 % 360)), 0, 'f', 6);
        page.readLog(written(folder, "log.csv", log));
        QTRY_VERIFY2(page.message().contains("200 updates"), qPrintable(page.message()));
        QVERIFY2(page.message().contains("C +1.50"), qPrintable(page.message()));
        page.readLog(written(folder, "bad.csv", "time_s,compass_heading_deg,deviation_deg\n1,2,x\n"));
        QTRY_VERIFY2(page.message().contains("is no figure"), qPrintable(page.message()));
    }

    void theWholeModelGoesFromFlightToFlight()
    {
        const QTemporaryDir folder;
        SmallFleet fleet;
        OpenWindow open(fleet.stores);
        const auto shown = [&]() -> FlightLogPage& {
            open.window.go(fleet.compass);
            open.trigger("flightLog");
            auto& page = dynamic_cast<FlightLogPage&>(open.window.findChild<PageStack*>()->current());
            in<QCheckBox>(page, "flightWhole").setChecked(true);
            return page;
        };
        const auto kept = [&] { return *fleet.stores.sensors.of(fleet.compass); };
        FlightLogPage& first = shown();
        QVERIFY(in<QComboBox>(first, "flightFrom").isHidden()); // there is none to go on from
        first.readLog(written(folder, "one.csv", wholeLog(0, 600)));
        auto& keep = in<QPushButton>(first, "flightKeep");
        QTRY_VERIFY2(keep.isEnabled(), qPrintable(first.message()));
        QVERIFY(!first.message().contains("goes on"));
        keep.click();
        QVERIFY2(first.message().contains("in flight, one"), qPrintable(first.message()));
        QVERIFY(!keep.isEnabled());
        QCOMPARE(kept().size(), 1U);
        const auto one = kept().front();
        QCOMPARE(one.note, "from the log one.csv");
        // The same log once more would count twice: said.
        first.readLog(folder.filePath("one.csv"));
        QTRY_VERIFY2(first.message().contains("counts twice"), qPrintable(first.message()));
        first.readLog(written(folder, "two.csv", wholeLog(600, 400)));
        QTRY_VERIFY2(first.message().contains("goes on from the sensor model in flight, one"), qPrintable(first.message()));
        QTRY_VERIFY(keep.isEnabled());
        keep.click();
        QCOMPARE(kept().size(), 2U);
        const auto both = kept().front();
        QVERIFY(both.uncertainty->covariance(9, 9) < 0.7 * one.uncertainty->covariance(9, 9)); // 1000 updates after 600
        QVERIFY(std::abs(both.model.hardIron_nT.x() - 700) < 20);

        // Begun anew the second flight tells as much as it tells alone.
        auto& from = in<QComboBox>(first, "flightFrom");
        QCOMPARE(from.count(), 3);
        QCOMPARE(from.currentIndex(), 1);
        from.setCurrentIndex(0);
        emit from.activated(0);
        QTRY_VERIFY(!first.message().contains("goes on"));
        QTRY_VERIFY(keep.isEnabled());
        keep.click();
        QVERIFY(kept().front().uncertainty->covariance(9, 9) > both.uncertainty->covariance(9, 9));
        QCOMPARE(kept().front().name, "in flight, two 2");
        open.trigger("undo");
        QCOMPARE(kept().size(), 2U);

        FlightLogPage& again = shown();
        QCOMPARE(in<QComboBox>(again, "flightFrom").currentText(), "goes on from in flight, two");
        // A compass that was swung on the ground since may have been corrected.
        fleet.addSwing("2099-01-01", eightPoints());
        FlightLogPage& later = shown();
        QCOMPARE(in<QComboBox>(later, "flightFrom").currentText(), "begins anew");
    }
};

} // namespace lubberline::ui

QTEST_MAIN(lubberline::ui::InflightPagesTest)
#include "InflightPagesTest.moc"
