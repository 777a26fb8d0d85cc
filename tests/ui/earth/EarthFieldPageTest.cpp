// The page of the Earth's field: places picked and typed, refusals in words, models from files, the map on its worker.

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

#include "tests/db/TestStores.h"
#include "tests/ui/window/Typing.h"
#include "ui/earth/EarthFieldPage.h"
#include "ui/kit/PlaceText.h"
#include "ui/plots/world/WorldFieldChart.h"
#include "ui/plots/world/WorldFieldItem.h"
#include "ui/plots/world/WorldFieldPlot.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

struct OpenPage {
    test::TestStores stores;
    QString answer; ///< to the question for a file
    EarthFieldPage page{stores, [this](const QString&, const QString&) { return answer; }};

    void addSite(const std::string& name, std::optional<double> latitude_deg, std::optional<double> longitude_deg)
    {
        Site site;
        site.name = name;
        site.latitude_deg = latitude_deg;
        site.longitude_deg = longitude_deg;
        QVERIFY(stores.save(site));
    }
    void show()
    {
        page.resize(1000, 650);
        page.show();
        QApplication::processEvents();
    }
    template <class Widget>
    Widget& find(const char* name)
    {
        return in<Widget>(page, name);
    }
    void type(const char* name, const QString& text)
    {
        auto& edit = find<QLineEdit>(name);
        edit.selectAll();
        QTest::keyClicks(&edit, text);
        QTest::keyClick(&edit, Qt::Key_Return);
    }
    void choose(const char* name, int index)
    {
        auto& box = find<QComboBox>(name);
        box.setCurrentIndex(index);
        emit box.activated(index);
    }
    QString text(const char* name) { return find<QLineEdit>(name).text(); }
    QString label(const char* name) { return find<QLabel>(name).text(); }
    QString cell(int row, int column) { return find<QTableWidget>("fieldTable").item(row, column)->text(); }
    const WorldFieldItem& item() { return static_cast<WorldFieldPlot&>(find<QWidget>("fieldMap")).chart()->item(); }
};

} // namespace

class EarthFieldPageTest : public QObject {
    Q_OBJECT

private slots:
    void anEmptyDatabaseAsksForAPlace();
    void theReportsPointIsShownToItsDigits();
    void aSiteIsPickedAndTypingLeavesIt();
    void aPlaceIsShown();
    void damageIsNamed_data();
    void damageIsNamed();
    void nearThePoleTheCompassIsRefused();
    void cautionIsSaid();
    void yearsChooseTheModel();
    void aFileIsLoadedOrRefused();
    void theMapFollowsElementAndYear();
    void placesAreReadAndWritten();
};

void EarthFieldPageTest::anEmptyDatabaseAsksForAPlace()
{
    OpenPage open;
    open.addSite("Nowhere", {}, {});
    open.show();
    QVERIFY2(open.label("fieldMessage").contains("Pick a site"), qPrintable(open.label("fieldMessage")));
    QCOMPARE(open.find<QComboBox>("fieldSite").count(), 1); // a site without a place is none
    QCOMPARE(open.cell(0, 0), QString("–"));
    QTRY_VERIFY(!open.item().isolines().empty()); // the world needs no place
}

/// WMM2025 technical report, table of test values: 2025.0, 0 km, 80° N 0° E.
void EarthFieldPageTest::theReportsPointIsShownToItsDigits()
{
    OpenPage open;
    open.show();
    open.type("fieldDate", "2025.0");
    open.type("fieldLatitude", "80 N");
    open.type("fieldLongitude", "0 E");
    const QStringList expected{"+6521.6", "+145.9", "+54791.5", "6523.2", "55178.5", "+1.28", "+83.21"};
    for (int row = 0; row < expected.size(); ++row)
        QCOMPARE(open.cell(row, 0), expected[row]);
    QCOMPARE(open.cell(0, 2), QString("137"));
    QVERIFY(open.label("fieldUsed").startsWith("WMM2025, 2025 to 2030"));
    QVERIFY(open.label("fieldMessage").isEmpty());
}

void EarthFieldPageTest::aSiteIsPickedAndTypingLeavesIt()
{
    OpenPage open;
    open.addSite("Deblin", 51.55, 21.89);
    open.addSite("Punta Arenas", -53.0, -70.85);
    open.show();
    QCOMPARE(open.find<QComboBox>("fieldSite").currentText(), QString("Deblin")); // the first one, when nothing is typed
    QCOMPARE(open.text("fieldLatitude"), QString("51.55 N"));
    const QString north = open.cell(2, 0);
    open.choose("fieldSite", 2);
    QCOMPARE(open.text("fieldLongitude"), QString("70.85 W"));
    QVERIFY(north.startsWith("+") && open.cell(2, 0).startsWith(QChar(0x2212))); // Z points up in the south
    open.type("fieldLatitude", "33 54 S");
    QCOMPARE(open.find<QComboBox>("fieldSite").currentIndex(), 0);
    open.page.hide();
    open.show();
    QCOMPARE(open.text("fieldLatitude"), QString("33 54 S")); // what was typed stays
}

void EarthFieldPageTest::aPlaceIsShown()
{
    OpenPage open;
    open.addSite("Deblin", 51.55, 21.89);
    open.addSite("Tromso", 69.68, 18.92);
    open.page.showPlace("Tromso", {69.68, 18.92, 10}, "2005-06-01");
    open.show();
    QCOMPARE(open.find<QComboBox>("fieldSite").currentText(), QString("Tromso"));
    QCOMPARE(open.text("fieldDate"), QString("2005-06-01"));
    QVERIFY(open.label("fieldUsed").startsWith("IGRF-14, 1900 to 2030"));
    open.page.showPlace("Somewhere", {0, 120, 0}, {});
    QCOMPARE(open.find<QComboBox>("fieldSite").currentIndex(), 0);
    QCOMPARE(open.text("fieldDate").size(), 10); // today
}

void EarthFieldPageTest::damageIsNamed_data()
{
    QTest::addColumn<QString>("field");
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("said");
    QTest::newRow("latitude 91") << "fieldLatitude"
                                 << "91"
                                 << "91";
    QTest::newRow("latitude east") << "fieldLatitude"
                                   << "51 E"
                                   << "no latitude";
    QTest::newRow("latitude word") << "fieldLatitude"
                                   << "north"
                                   << "no latitude";
    QTest::newRow("longitude north") << "fieldLongitude"
                                     << "21 N"
                                     << "no longitude";
    QTest::newRow("height word") << "fieldHeight"
                                 << "high"
                                 << "no height";
    QTest::newRow("height too large") << "fieldHeight"
                                      << "1e9"
                                      << "600 000 m";
    QTest::newRow("no such day") << "fieldDate"
                                 << "2026-02-30"
                                 << "2026-02-30";
    QTest::newRow("no date") << "fieldDate"
                             << "soon"
                             << "soon";
    QTest::newRow("outside all models") << "fieldDate"
                                        << "1899-12-31"
                                        << "1900";
    QTest::newRow("after all models") << "fieldDate"
                                      << "2031.0"
                                      << "2030";
}

void EarthFieldPageTest::damageIsNamed()
{
    QFETCH(QString, field);
    QFETCH(QString, typed);
    QFETCH(QString, said);
    OpenPage open;
    open.addSite("Deblin", 51.55, 21.89);
    open.show();
    QVERIFY(open.cell(0, 0) != "–");
    open.type(field.toLatin1(), typed);
    QVERIFY2(open.label("fieldMessage").contains(said), qPrintable(open.label("fieldMessage")));
    for (int row = 0; row < 7; ++row)
        QCOMPARE(open.cell(row, 0), QString("–")); // old figures do not stand beside a new question
}

void EarthFieldPageTest::nearThePoleTheCompassIsRefused()
{
    OpenPage open;
    open.show();
    open.type("fieldDate", "2025.0");
    open.type("fieldLatitude", "85.8");
    open.type("fieldLongitude", "138 E"); // the north magnetic pole of 2025 by WMM2025's report: 85.76° N 139.30° E
    QVERIFY2(open.label("fieldMessage").contains("blackout"), qPrintable(open.label("fieldMessage")));
    QVERIFY(open.cell(3, 0).toDouble() < 2000.0);
    QVERIFY(open.cell(4, 0).toDouble() > 50'000.0); // the field itself is known
}

void EarthFieldPageTest::cautionIsSaid()
{
    OpenPage open;
    open.show();
    open.type("fieldDate", "2025.0");
    open.type("fieldLatitude", "82 N");
    open.type("fieldLongitude", "0");
    QVERIFY(open.cell(3, 0).toDouble() < 6000.0 && open.cell(3, 0).toDouble() > 2000.0);
    QVERIFY2(open.label("fieldMessage").contains("caution"), qPrintable(open.label("fieldMessage")));
}

void EarthFieldPageTest::yearsChooseTheModel()
{
    OpenPage open;
    open.addSite("Deblin", 51.55, 21.89);
    open.show();
    open.type("fieldDate", "2026-11-23");
    QVERIFY(open.label("fieldUsed").startsWith("WMM2025"));
    open.type("fieldDate", "2005-05-05");
    QVERIFY(open.label("fieldUsed").startsWith("IGRF-14"));
    QCOMPARE(open.cell(0, 2), QString("–")); // IGRF states no uncertainty
    open.choose("fieldModel", 1);
    QVERIFY2(
        open.label("fieldMessage").contains("2025") && open.label("fieldMessage").contains("2030"), qPrintable(open.label("fieldMessage")));
    open.choose("fieldModel", 2);
    QVERIFY(open.label("fieldMessage").isEmpty());
}

/// A dipole of degree 1 along the axis: at the equator X is −g10 but for the ellipsoid, Y and D are 0.
void EarthFieldPageTest::aFileIsLoadedOrRefused()
{
    OpenPage open;
    open.addSite("Equator", 0.0, 0.0);
    open.show();
    open.type("fieldDate", "2026.0");
    QSignalSpy failed(&open.page, &EarthFieldPage::failed);
    open.choose("fieldModel", 3); // cancelled
    QCOMPARE(open.find<QComboBox>("fieldModel").currentIndex(), 0);
    QCOMPARE(failed.count(), 0);

    QTemporaryDir folder;
    open.answer = folder.filePath("dipole.cof");
    QFile file(open.answer);
    QVERIFY(file.open(QFile::WriteOnly));
    file.write("    2026.0            DIPOLE        01/01/2026\n  1  0  -30000.0       0.0       10.0        0.0\n");
    file.close();
    open.choose("fieldModel", 3);
    QCOMPARE(failed.count(), 1);
    QVERIFY2(failed.at(0).at(0).toString().contains("dipole.cof"), qPrintable(failed.at(0).at(0).toString()));
    QCOMPARE(open.find<QComboBox>("fieldModel").currentIndex(), 0);

    QVERIFY(file.open(QFile::WriteOnly));
    file.write(
        "    2026.0            DIPOLE        01/01/2026\n  1  0  -30000.0       0.0       10.0        0.0\n  1  1       0.0       0.0        0.0        0.0\n"
        "999999999999999999999999999999999999999999999999\n999999999999999999999999999999999999999999999999\n");
    file.close();
    open.choose("fieldModel", 3);
    QCOMPARE(failed.count(), 1);
    QCOMPARE(open.find<QComboBox>("fieldModel").currentText(), QString("DIPOLE, 2026 to 2031"));
    QCOMPARE(open.cell(5, 0), QString("0.00"));
    const double shrink = std::pow(6371.2 / 6378.137, 3); // from the reference sphere to the ellipsoid's equator
    QVERIFY(std::abs(open.cell(3, 0).toDouble() - 30000.0 * shrink) < 0.06);
    QCOMPARE(open.find<QComboBox>("fieldModel").count(), 5);
}

void EarthFieldPageTest::theMapFollowsElementAndYear()
{
    OpenPage open;
    open.addSite("Deblin", 51.55, 21.89);
    open.show();
    QTRY_VERIFY(!open.item().isolines().empty());
    const auto lowest = [&open] {
        double level = 1e9;
        for (const auto& line : open.item().isolines())
            level = std::min(level, line.level);
        return level;
    };
    QVERIFY(lowest() < 0.0); // declination: west too
    open.choose("fieldElement", 2);
    open.choose("fieldElement", 4);
    QTRY_VERIFY(!open.item().isolines().empty() && lowest() > 15'000.0); // the newest wish: F, whose least is 22,000 nT
    open.type("fieldDate", "1900.0");
    QTRY_VERIFY(open.label("fieldUsed").startsWith("IGRF-14"));
    {
        OpenPage brief; // closed while the worker computes
        brief.show();
    }
}

void EarthFieldPageTest::placesAreReadAndWritten()
{
    QCOMPARE(*parseLatitude_deg(QString("51°33'N")), 51.55);
    QCOMPARE(*parseLatitude_deg(QString("33,5 s")), -33.5);
    QCOMPARE(*parseLatitude_deg(QString("-90")), -90.0);
    QCOMPARE(*parseLongitude_deg(QString("540")), 540.0);
    QCOMPARE(*parseLongitude_deg(QString("70 30 W")), -70.5);
    QVERIFY(!parseLatitude_deg(QString("90.01 S")));
    QVERIFY(!parseLatitude_deg(QString("")));
    QVERIFY(!parseLongitude_deg(QString("nan")));
    QVERIFY(!parseLongitude_deg(QString("")));
    QCOMPARE(*parseHeight_m(""), 0.0);
    QCOMPARE(*parseHeight_m("118,5"), 118.5);
    for (const double degrees : {0.0, -51.5534, 89.9999, -0.25}) {
        QCOMPARE(*parseLatitude_deg(latitudeToType(degrees)), degrees);
        QCOMPARE(*parseLongitude_deg(longitudeToType(degrees)), degrees);
    }
}

QTEST_MAIN(EarthFieldPageTest)
#include "EarthFieldPageTest.moc"
