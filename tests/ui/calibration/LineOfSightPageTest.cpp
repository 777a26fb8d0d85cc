// What a person sees who types a line of sight: causes, the whole, and a line that does not stand.

#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

#include "ui/calibration/LineOfSightPage.h"

using namespace lubberline::ui;

namespace {

struct OpenSight {
    QTemporaryDir folder;
    QString answer;
    LineOfSightPage page{{[this](const QString&, const QString&) { return answer; },
                             [this](const QString&, const QString&, const QString&) { return answer; }},
        [] { return QStringLiteral("2026-11-23T06:00:00Z"); }};

    void type(const char* name, const QString& text) const
    {
        auto* line = page.findChild<QLineEdit*>(name);
        QVERIFY2(line, name);
        line->setText(text);
    }
    /// The figure of a cause in a column: 2 and 3 azimuth and elevation in the aircraft, 4 and 5 in the turret.
    [[nodiscard]] QString cell(const QString& cause, int column) const
    {
        auto* table = page.findChild<QTableWidget*>("sightCauses");
        for (int row = 0; row < table->rowCount(); ++row)
            if (table->item(row, 0)->text() == cause)
                return table->item(row, column)->text();
        return QStringLiteral("no such cause");
    }
};

} // namespace

class LineOfSightPageTest : public QObject {
    Q_OBJECT

private slots:
    /// H 20 000 nT, dip 60°: a pitch of the helmet that is sure to 0.1° moves an azimuth abeam by 0.1° tan 60°.
    void followsWhatIsTyped()
    {
        OpenSight open;
        open.type("sightField", "40000, 60");
        open.type("sightLook", "90, 0, 0");
        open.type("sightNoise", "0, 0");
        open.type("sightTilt", "0, 0.1");
        open.type("sightTurretError", "0");
        QCOMPARE(open.cell("pitch of the helmet", 2), QStringLiteral("0.173"));
        QCOMPARE(open.cell("pitch of the helmet", 3), QStringLiteral("0.100"));
        QCOMPARE(open.cell("together", 4), QStringLiteral("0.173"));
        open.type("sightTurret", "0; 0; 90,0"); // a comma in the numbers
        QVERIFY(open.page.findChild<QLabel*>("sightWords")->text().contains("heading 90.0"));
        open.type("sightCockpit", "0, 1000, 0"); // east of an aircraft that heads north: atan(1/20)
        QCOMPARE(open.cell("field of the cockpit", 4), QStringLiteral("−2.862"));
    }

    void whatDoesNotStandIsSaidAndChangesNothing()
    {
        OpenSight open;
        const QString before = open.page.findChild<QLabel*>("sightWords")->text();
        open.type("sightLook", "90, 0");
        QVERIFY2(open.page.message().contains("90, 0"), qPrintable(open.page.message()));
        QCOMPARE(open.page.findChild<QLabel*>("sightWords")->text(), before);
        open.type("sightLook", "90, 0, 0");
        QVERIFY(open.page.findChild<QLabel*>("sightWords")->text() != before);
        QVERIFY(open.page.message().contains("not modelled"));
    }

    void ironOfAModelAndTheReport()
    {
        OpenSight open;
        open.type("sightField", "40000, 60");
        open.type("sightAircraft", "90, 0, 0");
        QFile model(open.folder.filePath("iron.json"));
        QVERIFY(model.open(QIODevice::WriteOnly));
        model.write(R"({"field": {"H_nT": 20000, "dip_deg": 60}, "hard_iron_nT": [1000, 0, 0]})");
        model.close();
        open.answer = model.fileName();
        open.page.findChild<QPushButton*>("sightAircraftIron")->click();
        QCOMPARE(open.cell("iron at the aircraft's sensor", 2), QStringLiteral("+2.862"));
        open.answer = open.folder.filePath("sight.pdf");
        open.page.writeReport();
        QVERIFY(QFile(open.answer).size() > 5000);
        open.answer.clear(); // cancelled: the iron is taken away
        open.page.findChild<QPushButton*>("sightAircraftIron")->click();
        QCOMPARE(open.cell("iron at the aircraft's sensor", 2), QStringLiteral("0.000"));
    }
};

QTEST_MAIN(LineOfSightPageTest)
#include "LineOfSightPageTest.moc"
