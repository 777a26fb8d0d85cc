#include "tests/ui/plots/swing/SamplePictures.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QSignalSpy>
#include <QWheelEvent>

#include <qwt_plot_curve.h>
#include <qwt_plot_intervalcurve.h>
#include <qwt_plot_zoneitem.h>
#include <qwt_scale_div.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_widget.h>
#include <qwt_text.h>

#include "ui/plots/base/CartesianPlot.h"
#include "ui/plots/swing/CartesianReadings.h"
#include "ui/plots/swing/ChartPlot.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

template <class Item>
Item* itemOf(const QwtPlot& plot, const QString& title = {})
{
    for (QwtPlotItem* item : plot.itemList()) {
        auto* found = dynamic_cast<Item*>(item);
        if (found && (title.isEmpty() || item->title().text() == title))
            return found;
    }
    return nullptr;
}

} // namespace

class CurvePlotTest : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_plot.reset(makeCurvePlot());
        m_plot->resize(640, 520);
        m_plot->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_plot.get()));
        m_main = m_plot->findChild<CartesianPlot*>("deviationPlot");
        m_strip = m_plot->findChild<CartesianPlot*>("residualPlot");
        QVERIFY(m_main && m_strip);
    }

    void axesNameWhatTheyShow()
    {
        m_plot->setPicture(samplePicture(8));
        QCOMPARE(m_main->axisTitle(QwtAxis::YLeft).text(), QString("deviation (°, east +)"));
        QCOMPARE(m_strip->axisTitle(QwtAxis::XBottom).text(), QString("magnetic heading (°)"));
        const QList<double> ticks = m_main->axisScaleDiv(QwtAxis::XBottom).ticks(QwtScaleDiv::MajorTick);
        QCOMPARE(ticks, QList<double>({0, 45, 90, 135, 180, 225, 270, 315, 360}));
        QVERIFY(m_strip->axisScaleDraw(QwtAxis::XBottom)->label(45).text() == "045\nNE");
        QVERIFY(m_strip->axisScaleDraw(QwtAxis::XBottom)->label(360).text() == "360\nN");
        QVERIFY(m_strip->axisScaleDraw(QwtAxis::XBottom)->label(30).text() == "030");
    }

    /// Where there is no room for all, the cardinals are left, apart from each other.
    void headingsOfANarrowPlotDoNotTouch()
    {
        m_plot->setPicture(samplePicture(8));
        const auto labelsAt = [this](int width_px) {
            m_plot->resize(width_px, 520);
            QCoreApplication::processEvents();
            auto& axis = *m_strip->axisWidget(QwtAxis::XBottom);
            const auto* draw = m_strip->axisScaleDraw(QwtAxis::XBottom);
            const QImage image = axis.grab().toImage();
            const int top = axis.margin() + static_cast<int>(std::ceil(draw->maxTickLength() + draw->spacing())) + 1;
            int labels = 0, blank = 4;
            for (int x = 0; x < image.width(); ++x) {
                bool ink = false;
                for (int y = top; y < top + axis.fontMetrics().ascent(); ++y)
                    ink = ink || QColor(image.pixel(x, y)).lightnessF() < 0.5;
                labels += ink && blank >= 4 ? 1 : 0; // letters of a word are closer
                blank = ink ? 0 : blank + 1;
            }
            return labels;
        };
        QCOMPARE(labelsAt(640), 9);
        QCOMPARE(labelsAt(260), 5);
    }

    void uprightTitlesAreNotLongerThanTheirCanvases()
    {
        m_plot->setPicture(samplePicture(8));
        for (const int height_px : {520, 300, 240, 200}) {
            m_plot->resize(640, height_px);
            QCoreApplication::processEvents();
            for (const CartesianPlot* plot : {m_main, m_strip}) {
                const QwtText title = plot->axisTitle(QwtAxis::YLeft);
                QVERIFY2(title.textSize().width() <= plot->axisWidget(QwtAxis::YLeft)->height() + 1,
                    qPrintable(QString("%1 at %2").arg(title.text()).arg(height_px)));
                QVERIFY(!title.text().isEmpty());
            }
        }
        QVERIFY(m_main->axisTitle(QwtAxis::YLeft).text() != QString("deviation (°, east +)"));
    }

    void scaleIsSymmetrical()
    {
        m_plot->setPicture(samplePicture(24));
        const QwtScaleDiv& scale = m_main->axisScaleDiv(QwtAxis::YLeft);
        QCOMPARE(scale.lowerBound(), -scale.upperBound());
        QCOMPARE(scale.upperBound(), 6.0); // ±4.3° and half a degree of bar, in steps of 2°
    }

    void bothCanvasesShowAHeadingInOneLine()
    {
        m_plot->setPicture(samplePicture(24));
        QCoreApplication::processEvents();
        for (const double heading_deg : {0.0, 90.0, 217.0, 360.0}) {
            const QPointF above = m_main->canvas()->mapTo(m_plot.get(), m_main->pixelOf({heading_deg, 0}));
            const QPointF below = m_strip->canvas()->mapTo(m_plot.get(), m_strip->pixelOf({heading_deg, 0}));
            QVERIFY2(std::abs(above.x() - below.x()) < 1.0, qPrintable(QString("%1 %2").arg(above.x()).arg(below.x())));
        }
    }

    void residualsStandBeneathTheirReadings()
    {
        const SwingPicture picture = samplePicture(12);
        m_plot->setPicture(picture);
        const auto& above = itemOf<CartesianReadings>(*m_main)->points();
        const auto& below = itemOf<CartesianReadings>(*m_strip)->points();
        QCOMPARE(above.size(), below.size());
        for (std::size_t i = 0; i < above.size(); ++i) {
            QCOMPARE(above[i].heading_deg, below[i].heading_deg);
            const double expected = toDegrees(*picture.analysis->readings[i].residualApproximate_rad);
            QVERIFY(std::abs(below[i].value_deg - expected) < 1e-9);
            QCOMPARE(above[i].bar_deg, picture.resolution_deg / 2);
        }
    }

    void curvesBandAndPreviousAreThere()
    {
        SwingPicture picture = samplePicture(24);
        picture.previous = samplePicture(8).analysis;
        picture.limit_deg = 5;
        m_plot->setPicture(picture);
        for (const char* title : {"approximate fit", "exact fit", "previous swing"}) {
            const auto* curve = itemOf<QwtPlotCurve>(*m_main, title);
            QVERIFY2(curve->dataSize() >= 361, title);
            QCOMPARE(curve->sample(0).x(), 0.0);
            QCOMPARE(curve->sample(static_cast<int>(curve->dataSize()) - 1).x(), 360.0);
        }
        const auto* band = itemOf<QwtPlotIntervalCurve>(*m_main);
        QVERIFY(band->dataSize() >= 361);
        const auto* limit = itemOf<QwtPlotZoneItem>(*m_main);
        QVERIFY(limit->isVisible());
        QCOMPARE(limit->interval().minValue(), -5.0);
        QCOMPARE(limit->interval().maxValue(), 5.0);
        m_plot->setPicture(samplePicture(24));
        QVERIFY(!limit->isVisible());
    }

    void withoutFitThereIsNoStrip()
    {
        const SwingPicture two = samplePicture(2);
        m_plot->setPicture(two);
        QVERIFY(!two.whyNoAnalysis.isEmpty());
        QCOMPARE(m_main->notice(), two.whyNoAnalysis);
        QVERIFY(!m_strip->isVisible());
        QCOMPARE(itemOf<CartesianReadings>(*m_main)->points().size(), std::size_t(2));
        m_plot->setPicture({});
        QVERIFY(m_main->notice().contains("Enter readings"));
        SwingPicture ofNoSwing; // as on a page of logs: it has no rows to enter anything in
        ofNoSwing.whyNoAnalysis = "Open a log.";
        m_plot->setPicture(ofNoSwing);
        QCOMPARE(m_main->notice(), QString("Open a log."));
        m_plot->setPicture(samplePicture(8));
        QVERIFY(m_strip->isVisible());
        QVERIFY(m_main->notice().isEmpty());
    }

    void aHiddenPlotWaitsUntilItIsShown()
    {
        m_plot->hide();
        m_plot->setPicture(samplePicture(24));
        m_plot->setSelectedRow(5);
        QCOMPARE(static_cast<int>(itemOf<QwtPlotCurve>(*m_main, "exact fit")->dataSize()), 0);
        m_plot->show();
        QCOMPARE(static_cast<int>(itemOf<QwtPlotCurve>(*m_main, "exact fit")->dataSize()), 361);
        QCOMPARE(itemOf<CartesianReadings>(*m_main)->selectedRow(), 5);
    }

    void itemsAreReusedByAKeystroke()
    {
        m_plot->setPicture(samplePicture(24));
        const auto before = m_main->itemList();
        m_plot->setPicture(samplePicture(32));
        QCOMPARE(m_main->itemList(), before);
    }

    void clicksInBothPlotsSelect()
    {
        m_plot->setPicture(samplePicture(8));
        QSignalSpy selected(m_plot.get(), &SwingPlot::rowSelected);
        for (CartesianPlot* plot : {m_main, m_strip}) {
            const QPointF at = chart().rowsOn(plot->canvas())[3].at;
            QTest::mouseClick(plot->canvas(), Qt::LeftButton, {}, at.toPoint());
        }
        QCOMPARE(selected.count(), 2);
        QCOMPARE(selected[0].first().toInt(), 3);
        QCOMPARE(selected[1].first().toInt(), 3);
    }

    void frameZoomsAndTheStripFollows()
    {
        m_plot->setPicture(samplePicture(24));
        QWidget* canvas = m_main->canvas();
        const QPoint from = m_main->pixelOf({90, 2}).toPoint(), to = m_main->pixelOf({180, -2}).toPoint();
        QTest::mousePress(canvas, Qt::LeftButton, {}, from);
        QTest::mouseMove(canvas, (from + to) / 2);
        QTest::mouseRelease(canvas, Qt::LeftButton, {}, to);
        QVERIFY(std::abs(m_main->view().left() - 90) < 1 && std::abs(m_main->view().right() - 180) < 1);
        QVERIFY(std::abs(m_main->view().top() + 2) < 0.1);
        QCOMPARE(m_strip->view().left(), m_main->view().left());
        QCOMPARE(m_strip->view().right(), m_main->view().right());
        m_plot->setPicture(samplePicture(24)); // a keystroke keeps the zoom
        QVERIFY(m_main->zoomed());
        QTest::keyClick(m_plot.get(), Qt::Key_Home);
        QVERIFY(!m_main->zoomed());
        QCOMPARE(m_strip->view().right(), 360.0);
    }

    void wheelKeepsThePlaceAndStaysWithinTheTurn()
    {
        m_plot->setPicture(samplePicture(24));
        const QPointF at = m_main->pixelOf({120, 1});
        QWheelEvent in(at, m_main->canvas()->mapToGlobal(at), {}, {0, 240}, {}, {}, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(m_main->canvas(), &in);
        QVERIFY(std::abs(m_main->view().width() - 360 * 0.64) < 1e-6);
        QVERIFY(std::abs(m_main->pixelOf({120, 1}).x() - at.x()) < 1);
        QWheelEvent out(at, m_main->canvas()->mapToGlobal(at), {}, {0, -2400}, {}, {}, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(m_main->canvas(), &out);
        QVERIFY(!m_main->zoomed());
        m_main->setView(QRectF(300, 1, 100, 2)); // beyond the end: pushed back
        QCOMPARE(m_main->view().right(), 360.0);
    }

    void closeInTheTicksStayWholeDegrees()
    {
        m_plot->setPicture(samplePicture(24));
        m_main->setView(QRectF(100, -1, 20, 2));
        const QList<double> ticks = m_main->axisScaleDiv(QwtAxis::XBottom).ticks(QwtScaleDiv::MajorTick);
        QVERIFY(ticks.size() >= 3 && ticks.size() <= 10);
        for (const double tick : ticks)
            QCOMPARE(tick, std::round(tick));
    }

    void controlCCopiesAPicture()
    {
        m_plot->setPicture(samplePicture(24));
        QTest::keyClick(m_plot.get(), Qt::Key_C, Qt::ControlModifier);
        const QImage copied = QGuiApplication::clipboard()->image();
        QCOMPARE(copied.size(), QSize(1280, 1040));
        QCOMPARE(copied.pixelColor(1, 1), QColor(Qt::white));
        QVERIFY(inkOf(copied) > 10000);
    }

    void coloursFollowThePalette()
    {
        m_plot->setPicture(samplePicture(24));
        m_plot->setPalette(darkPalette());
        const QImage dark = m_plot->grab().toImage();
        QVERIFY(QColor(dark.pixel(2, 2)).lightnessF() < 0.3);
        QVERIFY(inkOf(dark) > 3000);
        m_plot->setPalette(QPalette(Qt::white));
        QVERIFY(QColor(m_plot->grab().toImage().pixel(2, 2)).lightnessF() > 0.9);
    }

    void pointerIsReadOut()
    {
        m_plot->setPicture(samplePicture(4));
        QSignalSpy read(m_plot.get(), &SwingPlot::readOut);
        QTest::mouseMove(m_main->canvas(), m_main->pixelOf({45, 0}).toPoint());
        QVERIFY2(read.last().first().toString().contains("deviation"), qPrintable(read.last().first().toString()));
        QTest::mouseMove(m_strip->canvas(), m_strip->pixelOf({45, 0}).toPoint());
        QVERIFY2(read.last().first().toString().contains("residual"), qPrintable(read.last().first().toString()));
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(m_strip->canvas(), &leave);
        QVERIFY(read.last().first().toString().isEmpty());
    }

private:
    Chart& chart() { return *static_cast<ChartPlot*>(m_plot.get())->chart(); }

    std::unique_ptr<SwingPlot> m_plot;
    CartesianPlot* m_main = nullptr;
    CartesianPlot* m_strip = nullptr;
};

QTEST_MAIN(CurvePlotTest)
#include "CurvePlotTest.moc"
