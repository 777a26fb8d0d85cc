// Tests of a sensor by hand: actions noted while a log runs, and the distances of an installation.

#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QTabWidget>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>

#include "tests/db/TestStores.h"
#include "ui/calibration/SensorTestsPage.h"
#include "ui/kit/Words.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

struct OpenTests {
    QTemporaryDir folder;
    QSettings settings{folder.filePath("settings.ini"), QSettings::IniFormat};
    QString answer;
    Clock::Time time{std::chrono::milliseconds(1'800'000'000'000)};
    test::TestStores stores;
    QStringList errors;
    EditContext context{stores, [this](const Error& error) { errors += messageOf(error); }};
    QUndoStack undo;
    std::unique_ptr<SensorTestsPage> page = opened();

    /// A bench of a sensor on axis after axis, ±65 000 nT, with this bias.
    [[nodiscard]] QString bench(const QString& name, double bias_nT)
    {
        QFile file(folder.filePath(name));
        if (!file.open(QIODevice::WriteOnly))
            qFatal("no file");
        file.write("time_s,bx_nT,by_nT,bz_nT,ax_nT,ay_nT,az_nT\n");
        for (int i = 0; i < 360; ++i) {
            const int step = i % 40;
            double applied[3] = {0, 0, 0};
            applied[i / 40 % 3] = 3250.0 * (step < 20 ? -20 + 2 * step : 20 - 2 * (step - 20));
            const double noise = i % 2 ? 10 : -10;
            file.write(QStringLiteral("%1,%2,%3,%4,%5,%6,%7\n")
                           .arg(0.1 * i)
                           .arg(applied[0] + bias_nT + noise)
                           .arg(applied[1] - noise)
                           .arg(applied[2] + noise)
                           .arg(applied[0])
                           .arg(applied[1])
                           .arg(applied[2])
                           .toUtf8());
        }
        return file.fileName();
    }

    [[nodiscard]] std::unique_ptr<SensorTestsPage> opened()
    {
        stores.setClock({[this] { return time; }});
        return std::make_unique<SensorTestsPage>(context, undo, settings,
            FileQuestions{[this](const QString&, const QString&) { return answer; },
                [this](const QString&, const QString&, const QString&) { return answer; }});
    }
    template <class T>
    [[nodiscard]] T& find(const char* name) const
    {
        auto* found = page->findChild<T*>(QString::fromLatin1(name));
        if (!found)
            qFatal("no %s", name);
        return *found;
    }
    void note(const QString& what, int after_ms)
    {
        time += std::chrono::milliseconds(after_ms);
        find<QLineEdit>("liveAction").setText(what);
        QTest::keyClick(&find<QLineEdit>("liveAction"), Qt::Key_Return);
    }
    [[nodiscard]] QString verdict(int row) const { return find<QTableWidget>("installationTable").item(row, 3)->text(); }
};

} // namespace

class SensorTestsPageTest : public QObject {
    Q_OBJECT

private slots:
    void actionsAreNotedWhileTheLogRuns()
    {
        OpenTests open;
        QVERIFY(!open.find<QLineEdit>("liveAction").isEnabled());
        open.find<QPushButton>("liveStart").click();
        open.note("landing light on", 12'400);
        open.note("", 1'000); // nothing was switched
        open.note("pump, \"left\"", 9'000);
        auto& table = open.find<QTableWidget>("liveActions");
        QCOMPARE(table.rowCount(), 2);
        QCOMPARE(table.item(0, 0)->text(), QStringLiteral("12.4"));
        QCOMPARE(table.item(1, 0)->text(), QStringLiteral("22.4"));
        // The program dies and is started again: what was noted is there, and the clock goes on.
        open.page = open.opened();
        open.note("radio", 1'000);
        open.answer = open.folder.filePath("actions.csv");
        open.find<QPushButton>("liveSave").click();
        QFile file(open.answer);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), QByteArray("time_s,action\n12.4,landing light on\n22.4,\"pump, \"\"left\"\"\"\n23.4,radio\n"));
        open.find<QPushButton>("liveClear").click();
        QCOMPARE(open.find<QTableWidget>("liveActions").rowCount(), 0);
        QVERIFY(open.find<QPushButton>("liveStart").isEnabled());
    }

    void benchesAreKeptComparedAndRemoved()
    {
        OpenTests open;
        QVERIFY(open.find<QPushButton>("coilKeep").isHidden());
        AircraftType type;
        type.name = "Su-22";
        Aircraft aircraft;
        aircraft.type = *open.stores.save(type);
        aircraft.registration = "3713";
        CompassSystem remote;
        remote.name = "remote compass";
        remote.serialNumber = "S 12";
        remote.aircraft = *open.stores.save(aircraft);
        const CompassId compass = *open.stores.save(remote);
        QVERIFY(open.page->open(compass));
        auto& kept = open.find<QTableWidget>("coilKept");
        for (const auto& [name, bias_nT, date] : {std::tuple("first.csv", 100.0, "2024-01-10"), {"second.csv", 148.0, "2026-01-10"}}) {
            open.page->openLog(open.bench(name, bias_nT));
            QTRY_VERIFY(open.find<QPushButton>("coilKeep").isEnabled());
            QCOMPARE(open.find<QTableWidget>("testsCoil").item(0, 0)->text(), QStringLiteral("scale, measured per applied"));
            open.find<QLineEdit>("coilDate").setText(date);
            open.find<QPushButton>("coilKeep").click();
            QVERIFY(!open.find<QPushButton>("coilKeep").isEnabled());
        }
        QCOMPARE(kept.rowCount(), 2);
        QCOMPARE(kept.item(0, 0)->text(), QStringLiteral("2026-01-10"));
        QCOMPARE(kept.item(0, 1)->text(), QStringLiteral("S 12"));
        QCOMPARE(kept.item(0, 2)->text(), QStringLiteral("65000"));
        kept.selectRow(0);
        const QString words = open.find<QLabel>("coilDrift").text();
        QVERIFY2(words.contains("From 2024-01-10 to 2026-01-10"), qPrintable(words));
        QVERIFY2(words.contains("bias +24.0"), qPrintable(words));
        open.page->findChild<QTabWidget*>()->setCurrentIndex(1);
        open.answer = open.folder.filePath("coil.pdf");
        open.page->writeReport();
        QVERIFY(QFile(open.answer).size() > 3000);
        open.find<QPushButton>("coilRemove").click();
        QCOMPARE(kept.rowCount(), 1);
        open.undo.undo();
        QCOMPARE(kept.rowCount(), 2);
        open.undo.undo(); // the second was never kept
        QCOMPARE(kept.rowCount(), 1);
        open.find<QLineEdit>("coilDate").setText("January");
        open.page->openLog(open.bench("third.csv", 0));
        QTRY_VERIFY(open.find<QPushButton>("coilKeep").isEnabled());
        open.find<QPushButton>("coilKeep").click();
        QCOMPARE(kept.rowCount(), 1);
        QVERIFY2(open.errors.isEmpty(), qPrintable(open.errors.join(u'\n')));
    }

    void distancesAreAChecklist()
    {
        OpenTests open;
        auto& table = open.find<QTableWidget>("installationTable");
        QCOMPARE(table.rowCount(), 6);
        QCOMPARE(open.verdict(0), QStringLiteral("not looked at"));
        table.item(0, 2)->setText("3,2"); // motors: 3.0 m
        table.item(1, 2)->setText("2.1"); // iron of more than 1 kg: 2.5 m
        table.item(2, 2)->setText("near");
        QCOMPARE(open.verdict(0), QStringLiteral("kept"));
        QCOMPARE(open.verdict(1), QStringLiteral("TOO NEAR by 0.40 m"));
        QVERIFY2(open.verdict(2).contains("no distance"), qPrintable(open.verdict(2)));
        QVERIFY(open.find<QLabel>("installationWords").text().contains("1 of 6 distances are too small; 2 were looked at"));
        open.page = open.opened();
        QCOMPARE(open.verdict(1), QStringLiteral("TOO NEAR by 0.40 m"));
        open.page->findChild<QTabWidget*>()->setCurrentIndex(3);
        open.answer = open.folder.filePath("installation.pdf");
        open.page->writeReport();
        QVERIFY(QFile(open.answer).size() > 3000);
        open.find<QPushButton>("installationClear").click();
        QCOMPARE(open.verdict(1), QStringLiteral("not looked at"));
    }
};

QTEST_MAIN(SensorTestsPageTest)
#include "SensorTestsPageTest.moc"
