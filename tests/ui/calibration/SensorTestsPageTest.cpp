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

#include "ui/calibration/SensorTestsPage.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

struct OpenTests {
    QTemporaryDir folder;
    QSettings settings{folder.filePath("settings.ini"), QSettings::IniFormat};
    QString answer;
    Clock::Time time{std::chrono::milliseconds(1'800'000'000'000)};
    Clock clock{[this] { return time; }};
    std::unique_ptr<SensorTestsPage> page = opened();

    [[nodiscard]] std::unique_ptr<SensorTestsPage> opened()
    {
        return std::make_unique<SensorTestsPage>(settings,
            FileQuestions{[this](const QString&, const QString&) { return answer; },
                [this](const QString&, const QString&, const QString&) { return answer; }},
            clock);
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
