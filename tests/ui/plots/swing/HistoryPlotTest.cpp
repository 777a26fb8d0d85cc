#include "tests/ui/plots/swing/SamplePictures.h"

#include <QFileInfo>
#include <QPainter>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <qwt_date.h>
#include <qwt_plot_curve.h>
#include <qwt_text.h>

#include "ui/plots/base/CartesianPlot.h"
#include "ui/plots/swing/HistoryPlot.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

std::vector<HistoryPoint> fiveYears()
{
    std::vector<HistoryPoint> points;
    for (int i = 4; i >= 0; --i) { // the newest first, as pages list them
        HistoryPoint point;
        point.date = QDate(2020 + i, 5, 10 + i);
        point.swing = 40 + i;
        point.coefficient_deg = {0.5, 2.0 + 0.3 * i, -1.0, 0.4, -0.2};
        point.maxAbsDeviation_deg = 3.0 + 0.2 * i;
        points.push_back(point);
    }
    points[1].coefficient_deg[3].reset(); // 4-point swing: D could not be told
    return points;
}

} // namespace

class HistoryPlotTest : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_plot = std::make_unique<HistoryPlot>();
        m_plot->resize(640, 360);
        m_plot->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_plot.get()));
        m_cartesian = m_plot->findChild<CartesianPlot*>("historyPlot");
        QVERIFY(m_cartesian);
    }

    void seriesAreOrderedByDate()
    {
        m_plot->setHistory(fiveYears(), 10.0);
        const QwtPlotCurve* b = curve("B");
        QCOMPARE(static_cast<int>(b->dataSize()), 5);
        for (int i = 1; i < 5; ++i) {
            QVERIFY(b->sample(i).x() > b->sample(i - 1).x());
            QVERIFY(std::abs(b->sample(i).y() - (2.0 + 0.3 * i)) < 1e-12);
        }
        QCOMPARE(QwtDate::toDateTime(b->sample(0).x(), Qt::UTC).date(), QDate(2020, 5, 10));
    }

    void whatCouldNotBeToldIsLeftOut()
    {
        m_plot->setHistory(fiveYears(), {});
        QCOMPARE(static_cast<int>(curve("D")->dataSize()), 4);
    }

    void clickSelectsTheSwing()
    {
        m_plot->setHistory(fiveYears(), 10.0);
        QSignalSpy selected(m_plot.get(), &HistoryPlot::swingSelected);
        QSignalSpy read(m_plot.get(), &HistoryPlot::readOut);
        const QPoint at = m_cartesian->pixelOf(curve("B")->sample(3)).toPoint();
        QTest::mouseMove(m_cartesian->canvas(), at);
        QVERIFY2(read.last().first().toString().contains("2023-05-13"), qPrintable(read.last().first().toString()));
        QTest::mouseClick(m_cartesian->canvas(), Qt::LeftButton, {}, at);
        QCOMPARE(selected.count(), 1);
        QCOMPARE(selected.first().first().toInt(), 43);
    }

    void oneSwingAndNoneAreDrawn()
    {
        m_plot->setHistory({}, {});
        QVERIFY(m_cartesian->notice().contains("No swings"));
        QVERIFY(inkOf(m_plot->grab().toImage()) > 300);
        m_plot->setHistory({fiveYears().front()}, 10.0);
        QVERIFY(m_cartesian->notice().isEmpty());
        QVERIFY(m_cartesian->view().width() > 0);
        QVERIFY(inkOf(m_plot->grab().toImage()) > 300);
    }

    void undatedSwingsAreLeftOut()
    {
        auto points = fiveYears();
        points[2].date = QDate();
        m_plot->setHistory(points, {});
        QCOMPARE(static_cast<int>(curve("A")->dataSize()), 4);
    }

    void isPaintedOnWhite()
    {
        m_plot->setPalette(darkPalette());
        m_plot->setHistory(fiveYears(), 10.0);
        QImage image(600, 300, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        m_plot->render(painter, QRectF(0, 0, 600, 300));
        painter.end();
        QCOMPARE(image.pixelColor(1, 1), QColor(Qt::white));
        QVERIFY(inkOf(image) > 3000);
    }

    void hasTheMannersOfEveryPlot()
    {
        m_plot->setHistory(fiveYears(), 10.0);
        const QTemporaryDir folder;
        QVERIFY(m_plot->exportTo(folder.filePath("history.svg")));
        QVERIFY(QFileInfo(folder.filePath("history.svg")).size() > 1000);
        const QRectF whole = m_cartesian->view();
        QTest::keyClick(m_plot.get(), Qt::Key_Plus);
        QVERIFY(m_cartesian->view().width() < whole.width());
        QTest::keyClick(m_plot.get(), Qt::Key_Home);
        QCOMPARE(m_cartesian->view(), whole);
    }

private:
    QwtPlotCurve* curve(const QString& title)
    {
        for (QwtPlotItem* item : m_cartesian->itemList(QwtPlotItem::Rtti_PlotCurve)) {
            if (item->title().text() == title)
                return static_cast<QwtPlotCurve*>(item);
        }
        return nullptr;
    }

    std::unique_ptr<HistoryPlot> m_plot;
    CartesianPlot* m_cartesian = nullptr;
};

QTEST_MAIN(HistoryPlotTest)
#include "HistoryPlotTest.moc"
