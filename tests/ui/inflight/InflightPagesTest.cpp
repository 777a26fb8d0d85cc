// Deviation in flight in the window: wind reports fill a table, a curve, tables to upload and a report; a log becomes a swing in flight.

#include <QFile>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

#include "core/inflight/WindVector.h"
#include "core/swing/Observations.h"
#include "tests/ui/window/Fixture.h"
#include "ui/inflight/FlightLogPage.h"
#include "ui/inflight/WindsPage.h"

namespace lubberline::ui {

namespace {

template <class Widget>
Widget& named(QWidget& page, const char* name)
{
    auto* widget = page.findChild<Widget*>(QString::fromLatin1(name));
    if (!widget)
        qFatal("there is no widget named %s", name);
    return *widget;
}

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
        named<QPushButton>(page, "windsOpen").click();
        auto& table = named<QTableWidget>(page, "windsTable");
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
        named<QLineEdit>(page, "flightVariation").setText("6 E");
        page.readLog(written(folder, "legs.csv", legs));
        QTRY_VERIFY(named<QPushButton>(page, "flightMake").isEnabled());
        QVERIFY2(page.message().contains("Wind from 302"), qPrintable(page.message()));
        named<QPushButton>(page, "flightMake").click();
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
};

} // namespace lubberline::ui

QTEST_MAIN(lubberline::ui::InflightPagesTest)
#include "InflightPagesTest.moc"
