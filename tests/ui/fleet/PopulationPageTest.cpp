// The page of years as a population: a first look, the whole, a click, a history, what is saved.

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTabWidget>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

#include "core/demo/DemoFleet.h"
#include "core/demo/DemoPopulation.h"
#include "tests/db/TestStores.h"
#include "ui/fleet/PaintedPlot.h"
#include "ui/fleet/PopulationPage.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

struct OpenPopulation {
    test::TestStores stores;
    QString path;
    std::unique_ptr<PopulationPage> page;

    OpenPopulation()
    {
        if (!db::importFleet(stores.database(), demoFleet(), {}))
            qFatal("the demonstration is stored");
        FileQuestions questions;
        questions.save = [this](const QString&, const QString&, const QString&) { return path; };
        page = std::make_unique<PopulationPage>(stores, questions);
        page->resize(1000, 620);
        page->show();
    }
    [[nodiscard]] bool computeType(const std::string& name)
    {
        for (const auto& type : *stores.fleet.types())
            if (type.name == name) {
                QSignalSpy computed(page.get(), &PopulationPage::computed);
                if (!page->open(type.id))
                    return false;
                while (computed.isEmpty() || !computed.last().first().toBool())
                    if (!computed.wait(20000))
                        return false;
                return true;
            }
        return false;
    }
    template <class T>
    [[nodiscard]] T* find(const char* name) const
    {
        return page->findChild<T*>(QString::fromLatin1(name));
    }
};

} // namespace

class PopulationPageTest : public QObject {
    Q_OBJECT

private slots:
    void showsThePopulationAndWhoIsNext()
    {
        OpenPopulation open;
        QVERIFY(open.computeType(kDemoPopulationType));
        QVERIFY(open.page->message().contains(QStringLiteral("highest at 135°, 315°")));
        QCOMPARE(open.page->news()->report.counts.aircraft, 20);
        auto* ranking = open.find<QTableWidget>("populationRanking");
        QCOMPARE(ranking->rowCount(), 20);
        QCOMPARE(ranking->item(0, 0)->text(), QStringLiteral("3218"));
        QCOMPARE(open.find<QTabWidget>("populationTables")->count(), 11);
        const QImage grab = open.find<QWidget>("populationCurve")->grab().toImage();
        QVERIFY(grab.pixelColor(grab.width() / 2, grab.height() / 2) != QColor() && !grab.isNull());
    }

    /// What is stored after the swings were read and before they are shown is not in the figures, and that is said.
    void aFleetThatChangesWhileItIsComputedIsTold()
    {
        OpenPopulation open;
        QSignalSpy computed(open.page.get(), &PopulationPage::computed);
        QVERIFY(open.page->open({}));
        QVERIFY(computed.wait(20000)); // the first look; the whole has begun
        open.page->fleetChanged();
        while (!computed.last().first().toBool())
            QVERIFY(computed.wait(20000));
        QVERIFY(open.find<QLabel>("populationState")->text().contains(QStringLiteral("changed since")));
        QVERIFY(open.computeType(kDemoPopulationType)); // read again, as it is now
        QVERIFY(!open.find<QLabel>("populationState")->text().contains(QStringLiteral("changed since")));
    }

    void aClickTellsTheSwingsBehindAHeading()
    {
        OpenPopulation open;
        QVERIFY(open.computeType(kDemoPopulationType));
        auto* curve = open.find<PaintedPlot>("populationCurve");
        QTest::mouseClick(curve, Qt::LeftButton, {}, QPoint(curve->width() / 2, curve->height() / 2));
        auto* swings = open.find<QTableWidget>("populationSwings");
        QVERIFY(swings->rowCount() > 100);
        QSignalSpy opened(open.page.get(), &PopulationPage::openSwing);
        emit swings->itemActivated(swings->item(0, 0));
        QCOMPARE(opened.count(), 1);
        QVERIFY(opened.first().first().value<SwingId>().valid());
    }

    void theHistoryOfTheOneThatDriftsIsAFilm()
    {
        OpenPopulation open;
        QVERIFY(open.computeType(kDemoPopulationType));
        QVERIFY(open.find<QLabel>("historyWords")->text().contains(QStringLiteral("B drifts by +0.")));
        auto* film = open.find<QSlider>("historyFilm");
        QCOMPARE(film->maximum(), kDemoPopulationYears);
        film->setValue(3);
        auto* choice = open.find<QComboBox>("populationHistory");
        choice->setCurrentIndex(choice->findText(QStringLiteral("3204"), Qt::MatchStartsWith));
        emit choice->activated(choice->currentIndex());
        QVERIFY(open.find<QLabel>("historyWords")->text().contains(QStringLiteral("lightning")));
        QCOMPARE(film->value(), film->maximum());
    }

    void theFieldsChooseWhatIsComputed()
    {
        OpenPopulation open;
        QVERIFY(open.computeType(kDemoPopulationType));
        const auto whole = open.page->news()->report.counts.used;
        open.find<QLineEdit>("populationFrom")->setText("2024-02-30");
        open.find<QPushButton>("populationCompute")->click();
        QVERIFY(open.page->message().contains("'2024-02-30' is no day"));
        QVERIFY(!open.find<QPushButton>("populationCancel")->isEnabled()); // nothing was begun
        open.find<QLineEdit>("populationFrom")->setText("2022-01-01");
        open.find<QLineEdit>("populationTo")->setText("2023-12-31");
        open.find<QLineEdit>("populationTraining")->setText("2023-01-01");
        QSignalSpy computed(open.page.get(), &PopulationPage::computed);
        open.find<QPushButton>("populationCompute")->click();
        QTRY_VERIFY_WITH_TIMEOUT(!computed.isEmpty() && computed.last().first().toBool(), 20000);
        const auto& report = open.page->news()->report;
        QVERIFY(report.counts.used > 0 && report.counts.used < whole);
        QVERIFY(report.plants.training && report.plants.training->given);
        for (const auto& swing : open.page->news()->fleet.swings)
            QVERIFY(dateOfDay(swing.day).starts_with("2022") || dateOfDay(swing.day).starts_with("2023"));
        open.find<QComboBox>("populationRadio")->setCurrentIndex(1);
        computed.clear();
        open.find<QPushButton>("populationCompute")->click();
        auto* state = open.find<QLabel>("populationState");
        QVERIFY(state->text().contains("Computing"));
        QTRY_VERIFY_WITH_TIMEOUT(state->text().contains("no swing is in the selection"), 20000);
    }

    void whenTheLimitIsReachedIsADistribution()
    {
        OpenPopulation open;
        QVERIFY(open.computeType(kDemoPopulationType));
        const auto& ranked = open.page->news()->report.ranking.compasses.front();
        QVERIFY(!ranked.reachedShare.empty());
        QVERIFY(ranked.reached50_day.has_value());
        const QImage grab = open.find<QWidget>("historyDates")->grab().toImage();
        QVERIFY(!grab.isNull());
    }

    void savesWhatItShows()
    {
        OpenPopulation open;
        QVERIFY(open.computeType(kDemoPopulationType));
        const QTemporaryDir folder;
        for (const char* name : {"a.csv", "a.html", "a.pdf", "a.json"}) {
            open.path = folder.filePath(QString::fromLatin1(name));
            open.find<QPushButton>("populationSave")->click();
            QVERIFY(QFile(open.path).size() > 1000);
        }
    }

    void aFleetThatChangesIsTold()
    {
        OpenPopulation open;
        QVERIFY(open.computeType(kDemoPopulationType));
        open.page->fleetChanged();
        QVERIFY(open.find<QLabel>("populationState")->text().contains(QStringLiteral("has changed")));
    }

    void cancellingKeepsWhatWasThere()
    {
        OpenPopulation open;
        QVERIFY(open.computeType(kDemoPopulationType));
        const auto before = open.page->news();
        open.find<QPushButton>("populationCompute")->click();
        open.find<QPushButton>("populationCancel")->click();
        QTRY_VERIFY_WITH_TIMEOUT(!open.find<QPushButton>("populationCancel")->isEnabled(), 20000);
        QVERIFY(open.page->news() != nullptr);
        QCOMPARE(open.page->news()->report.counts.aircraft, before->report.counts.aircraft);
    }
};

QTEST_MAIN(PopulationPageTest)
#include "PopulationPageTest.moc"
