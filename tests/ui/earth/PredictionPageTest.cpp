// What a compass will read elsewhere: figures held against core, and what is said when nothing can be.

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>

#include "core/earth/FieldModel.h"
#include "core/swing/SwingPlaces.h"
#include "tests/ui/sensor/SensorPageFixture.h"
#include "ui/earth/PredictionPage.h"
#include "ui/plots/swing/PredictionPlot.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

struct OpenPrediction {
    OpenPage fleet;
    PredictionPage page{fleet.stores};
    QStringList failures;
    OpenPrediction()
    {
        QObject::connect(&page, &PredictionPage::failed, &page, [this](const QString& message) { failures += message; });
        page.resize(1000, 640);
        page.show();
    }
    QString label(const char* name) { return page.findChild<QLabel*>(QString::fromLatin1(name))->text(); }
    void type(const char* name, const QString& text)
    {
        auto* edit = page.findChild<QLineEdit*>(QString::fromLatin1(name));
        edit->setText(text);
        emit edit->editingFinished();
    }
    void choose(const char* name, int index)
    {
        auto* box = page.findChild<QComboBox*>(QString::fromLatin1(name));
        box->setCurrentIndex(index);
        emit box->activated(index);
    }
};

} // namespace

class PredictionPageTest : public QObject {
    Q_OBJECT

private slots:
    void theCurveThereIsCores()
    {
        OpenPrediction open;
        const SiteId home = open.fleet.addSite("Home", 52.2, 21.0);
        const SwingId id = open.fleet.addSwing(home, "2026-06-10", someIron());
        QVERIFY(open.page.showSwing(id));
        QVERIFY(!open.page.prediction());
        open.type("predictionLatitude", "28 N");
        open.type("predictionLongitude", "15.6 W");
        open.type("predictionDate", "2026-11-23");
        QVERIFY2(open.page.prediction(), qPrintable(open.label("predictionVerdict")));
        const auto swing = swingAtPlace(*open.fleet.stores.swings.record(id));
        const auto expected = predict(*swing, stampField(*makePlace(28, -15.6), "2026-11-23")->field.meridian());
        QCOMPARE(open.page.prediction()->points.size(), expected->points.size());
        for (std::size_t i = 0; i < expected->points.size(); ++i)
            QCOMPARE(open.page.prediction()->points[i].deviation->degrees(), expected->points[i].deviation->degrees());
        QVERIFY(open.label("predictionField").contains("nT"));
        QVERIFY(open.label("predictionVerdict").contains("imits"));
        QVERIFY(open.label("predictionWarnings").contains("with a probability of 95 %, assuming vertical soft iron"));
        QVERIFY2(open.label("predictionAgain").contains("95 %"), qPrintable(open.label("predictionAgain")));
        auto* plot = open.page.findChild<PredictionPlot*>("prediction");
        QVERIFY(plot->picture().there && plot->picture().here);
        QCOMPARE(*plot->picture().limit_deg, 10.0);
        QVERIFY(open.page.findChild<QListWidget*>("predictionKnowledge")->count() >= 10);
        QVERIFY(!plot->grab().toImage().isNull());
    }

    void whatIsAssumedCanBeTyped()
    {
        OpenPrediction open;
        const SwingId id = open.fleet.addSwing(open.fleet.addSite("Home", 52.2, 21.0), "2026-06-10", someIron());
        QVERIFY(open.page.showSwing(id));
        open.type("predictionLatitude", "28 N");
        open.type("predictionLongitude", "15.6 W");
        open.type("predictionDate", "2026-11-23");
        const double bound_rad = open.page.prediction()->change->bound_rad;
        open.type("assumedSoft", "0,01");
        open.type("assumedHard", "300");
        open.type("assumedMagnets", "500");
        QVERIFY2(open.page.prediction(), qPrintable(open.label("predictionVerdict")));
        const auto swing = swingAtPlace(*open.fleet.stores.swings.record(id));
        const auto there = stampField(*makePlace(28, -15.6), "2026-11-23")->field.meridian();
        const auto expected = predict(std::span(&*swing, 1), {swing->field, there}, {0.01, 300, 500});
        QCOMPARE(open.page.prediction()->change->bound_rad, expected->change->bound_rad);
        QVERIFY(expected->change->bound_rad < bound_rad);
        QVERIFY(open.label("predictionWarnings").contains("of about 0.01"));
        open.type("assumedOneCycle", "none");
        QVERIFY(!open.page.prediction());
        QVERIFY2(open.label("predictionVerdict").contains("no size"), qPrintable(open.label("predictionVerdict")));
    }

    void swingsAtTwoPlacesAreSeparated()
    {
        OpenPrediction open;
        const SiteId home = open.fleet.addSite("Home", 52.2, 21.0), far = open.fleet.addSite("Far", 1.3, 103.9);
        const SwingId id = open.fleet.addSwing(home, "2026-06-10", someIron());
        open.fleet.addSwing(far, "2026-07-10", someIron());
        QVERIFY(open.page.showSwing(id));
        open.choose("predictionSite", 2);
        QVERIFY(open.page.prediction());
        open.choose("predictionBasis", 1);
        QVERIFY2(open.failures.isEmpty(), qPrintable(open.failures.join('\n')));
        QVERIFY(open.label("predictionWarnings").contains("several places"));
    }

    void swingsAtOnePlaceCannotBe()
    {
        OpenPrediction open;
        const SiteId home = open.fleet.addSite("Home", 52.2, 21.0);
        const SwingId id = open.fleet.addSwing(home, "2026-06-10", someIron());
        QVERIFY(open.page.showSwing(id));
        open.choose("predictionBasis", 1);
        QCOMPARE(open.failures.size(), 1);
        QCOMPARE(open.page.findChild<QComboBox*>("predictionBasis")->currentIndex(), 0);
    }

    void whatIsMissingIsSaid()
    {
        OpenPrediction open;
        const SwingId id = open.fleet.addSwing(open.fleet.addSite("Home", 52.2, 21.0), "2026-06-10", someIron());
        QVERIFY(open.page.showSwing(id));
        open.type("predictionLongitude", "20");
        open.type("predictionLatitude", "95");
        QVERIFY(!open.page.prediction());
        QVERIFY(!open.label("predictionVerdict").isEmpty());
        open.type("predictionLatitude", "50");
        open.type("predictionDate", "2042-01-01");
        QVERIFY2(open.label("predictionVerdict").contains("2030"), qPrintable(open.label("predictionVerdict")));
        open.type("predictionDate", "2026-01-01");
        QVERIFY(open.page.prediction());
        open.type("predictionLatitude", "86 N");
        open.type("predictionLongitude", "139 E");
        QVERIFY(open.label("predictionVerdict").contains("blackout"));
    }
};

QTEST_MAIN(PredictionPageTest)
#include "PredictionPageTest.moc"
