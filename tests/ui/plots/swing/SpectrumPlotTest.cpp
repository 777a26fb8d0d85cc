#include "tests/ui/plots/swing/SamplePictures.h"

#include <QSignalSpy>

#include <qwt_plot_curve.h>
#include <qwt_scale_draw.h>
#include <qwt_text.h>

#include "ui/plots/base/CartesianPlot.h"
#include "ui/plots/swing/ChartPlot.h"
#include "ui/plots/swing/SpectrumBars.h"

using namespace lubberline;
using namespace lubberline::ui;

class SpectrumPlotTest : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_plot.reset(makeSpectrumPlot());
        m_plot->resize(600, 480);
        m_plot->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_plot.get()));
        m_spectrum = m_plot->findChild<CartesianPlot*>("spectrumPlot");
        QVERIFY(m_spectrum);
        for (QwtPlotItem* item : m_spectrum->itemList()) {
            if (auto* bars = dynamic_cast<SpectrumBars*>(item))
                m_bars = bars;
            if (auto* noise = dynamic_cast<QwtPlotCurve*>(item))
                m_noise = noise;
        }
        QVERIFY(m_bars && m_noise);
    }

    void barsAreTheAmplitudes()
    {
        const SwingPicture picture = samplePicture(16);
        m_plot->setPicture(picture);
        const Harmonics& harmonics = picture.analysis->harmonics;
        QCOMPARE(m_bars->bars().size(), harmonics.orders.size());
        for (std::size_t i = 0; i < harmonics.orders.size(); ++i) {
            QCOMPARE(m_bars->bars()[i].order, harmonics.orders[i].order);
            QVERIFY(std::abs(m_bars->bars()[i].amplitude_deg - toDegrees(harmonics.orders[i].amplitude_rad())) < 1e-12);
            QVERIFY(m_bars->bars()[i].amplitude_deg <= m_spectrum->view().bottom());
        }
    }

    void ordersThatHeadingsCannotResolveAreHatched()
    {
        m_plot->setPicture(samplePicture(8));
        QCOMPARE(m_bars->highestResolvable(), 4);
        QCOMPARE(m_bars->last(), 12);
        m_plot->setPicture(samplePicture(32));
        QCOMPARE(m_bars->highestResolvable(), 16);
        QCOMPARE(m_bars->last(), 16); // nothing to hatch
    }

    void ordersCutShortOnRequestAreNotCalledUnresolved()
    {
        SwingPicture picture = samplePicture(24);
        Analysis cut = *picture.analysis;
        cut.harmonics.orders.resize(5);
        picture.analysis = std::make_shared<Analysis>(cut);
        m_plot->setPicture(picture);
        QCOMPARE(m_bars->last(), 4);
    }

    void noiseFloorIsALine()
    {
        SwingPicture picture = samplePicture(24);
        m_plot->setPicture(picture);
        QVERIFY(picture.analysis->harmonics.noiseFloor_rad);
        QCOMPARE(static_cast<int>(m_noise->dataSize()), 2);
        const double expected = toDegrees(*picture.analysis->harmonics.noiseFloor_rad);
        QCOMPARE(m_noise->sample(0).y(), expected);
        QCOMPARE(m_noise->sample(1).y(), expected);
        Analysis none = *picture.analysis;
        none.harmonics.noiseFloor_rad.reset();
        picture.analysis = std::make_shared<Analysis>(none);
        m_plot->setPicture(picture);
        QCOMPARE(static_cast<int>(m_noise->dataSize()), 0);
    }

    void ordersAreNamed()
    {
        m_plot->setPicture(samplePicture(8));
        const auto label = [this](double order) { return m_spectrum->axisScaleDraw(QwtAxis::XBottom)->label(order).text(); };
        QCOMPARE(label(0), QString("0\nA"));
        QCOMPARE(label(1), QString("1\nB/C"));
        QCOMPARE(label(2), QString("2\nD/E"));
        QCOMPARE(label(3), QString("3"));
    }

    void orderUnderThePointerIsReadOut()
    {
        m_plot->setPicture(samplePicture(8));
        QSignalSpy read(m_plot.get(), &SwingPlot::readOut);
        QTest::mouseMove(m_spectrum->canvas(), m_spectrum->pixelOf({1.2, 1}).toPoint());
        QVERIFY2(read.last().first().toString().contains("B/C"), qPrintable(read.last().first().toString()));
        QTest::mouseMove(m_spectrum->canvas(), m_spectrum->pixelOf({7, 1}).toPoint());
        QVERIFY2(read.last().first().toString().contains("not resolved"), qPrintable(read.last().first().toString()));
    }

    void emptyPlotSaysWhatToDo()
    {
        m_plot->setPicture({});
        QVERIFY(m_spectrum->notice().contains("Enter readings"));
        QVERIFY(m_bars->bars().empty());
        QVERIFY(inkOf(m_plot->grab().toImage()) > 500);
    }

private:
    std::unique_ptr<SwingPlot> m_plot;
    CartesianPlot* m_spectrum = nullptr;
    SpectrumBars* m_bars = nullptr;
    QwtPlotCurve* m_noise = nullptr;
};

QTEST_MAIN(SpectrumPlotTest)
#include "SpectrumPlotTest.moc"
