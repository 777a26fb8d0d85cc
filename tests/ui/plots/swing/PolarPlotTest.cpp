#include "tests/ui/plots/swing/SamplePictures.h"

#include <QFile>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <qwt_polar_canvas.h>
#include <qwt_polar_curve.h>
#include <qwt_polar_plot.h>
#include <qwt_scale_div.h>

#include "ui/plots/base/Chart.h"
#include "ui/plots/swing/ChartPlot.h"
#include "ui/plots/swing/PolarItems.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

template <class Item>
Item* itemOf(QwtPolarPlot& plot)
{
    for (QwtPolarItem* item : plot.itemList()) {
        if (auto* found = dynamic_cast<Item*>(item))
            return found;
    }
    return nullptr;
}

QwtPolarCurve* curveOf(QwtPolarPlot& plot, const QString& title)
{
    for (QwtPolarItem* item : plot.itemList()) {
        if (item->rtti() == QwtPolarItem::Rtti_PolarCurve && item->title().text() == title)
            return static_cast<QwtPolarCurve*>(item);
    }
    return nullptr;
}

/// Readings on four headings at known deviations.
SwingPicture cardinals(double deviation_deg)
{
    SwingPicture picture;
    for (int row = 0; row < 4; ++row) {
        PlottedReading reading;
        reading.row = row;
        reading.magnetic = MagneticHeading::fromDegrees(90.0 * row);
        reading.deviation = Deviation::fromDegrees(deviation_deg);
        reading.compass = toCompass(reading.magnetic, reading.deviation);
        picture.readings.push_back(reading);
    }
    picture.whyNoAnalysis = "a fifth heading is needed";
    return picture;
}

} // namespace

class PolarPlotTest : public QObject {
    Q_OBJECT

private slots:
    void captionsRunIntoNothing();
    void init()
    {
        m_plot.reset(makePolarPlot());
        m_plot->resize(500, 500);
        m_plot->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_plot.get()));
        m_polar = m_plot->findChild<QwtPolarPlot*>();
        QVERIFY(m_polar);
        m_canvas = m_polar->canvas();
    }

    void scaleIsSymmetricalAndNorthIsUp()
    {
        m_plot->setPicture(samplePicture(24));
        const QwtScaleDiv* radius = m_polar->scaleDiv(QwtPolar::Radius);
        QCOMPARE(radius->lowerBound(), -radius->upperBound());
        QCOMPARE(radius->upperBound(), 6.0); // ±4.3° and half a degree of bar, in steps of 2°
        m_plot->setPicture(cardinals(2));
        const auto places = chart().rowsOn(m_canvas);
        const QPointF pole = m_polar->plotRect().center();
        QVERIFY(places[0].at.y() < pole.y() && std::abs(places[0].at.x() - pole.x()) < 1e-6); // north: above
        QVERIFY(places[1].at.x() > pole.x() && std::abs(places[1].at.y() - pole.y()) < 1e-6); // east: right
        QVERIFY(places[2].at.y() > pole.y());
        QVERIFY(places[3].at.x() < pole.x());
    }

    void eastIsOutwardAndZeroHalfWayOut()
    {
        const auto partOfRim = [this](double deviation_deg) {
            SwingPicture picture = cardinals(deviation_deg);
            picture.readings[1].deviation = Deviation::fromDegrees(3.4); // the same scale each time
            m_plot->setPicture(picture);
            const QRectF rim = m_polar->plotRect();
            return (rim.center().y() - chart().rowsOn(m_canvas)[0].at.y()) / (rim.width() / 2);
        };
        QVERIFY(std::abs(partOfRim(0) - 0.5) < 1e-6);
        QVERIFY(std::abs(partOfRim(2) - 0.75) < 1e-6); // the scale is ±4
        QVERIFY(std::abs(partOfRim(-2) - 0.25) < 1e-6);
    }

    void curvesAreThoseOfTheAnalysis()
    {
        const SwingPicture picture = samplePicture(24);
        m_plot->setPicture(picture);
        QwtPolarCurve* approximate = curveOf(*m_polar, "approximate fit");
        QwtPolarCurve* exact = curveOf(*m_polar, "exact fit");
        QCOMPARE(static_cast<int>(approximate->dataSize()), 361);
        QCOMPARE(static_cast<int>(exact->dataSize()), 361);
        QCOMPARE(static_cast<int>(curveOf(*m_polar, "previous swing")->dataSize()), 0);
        const QwtPointPolar east = exact->sample(90);
        QCOMPARE(east.azimuth(), 90.0);
        const auto expected = deviationAt(picture.analysis->exact.smith(), MagneticHeading::fromDegrees(90));
        QVERIFY(std::abs(east.radius() - expected.degrees()) < 1e-9);
        for (std::size_t i = 0; i < approximate->dataSize(); ++i)
            QVERIFY(std::isfinite(approximate->sample(static_cast<int>(i)).radius()));
    }

    void withoutAnalysisTheReadingsAndTheReasonAreShown()
    {
        m_plot->setPicture(cardinals(2));
        QCOMPARE(itemOf<PolarReadings>(*m_polar)->points().size(), std::size_t(4));
        QCOMPARE(itemOf<PolarNotice>(*m_polar)->text(), QString("a fifth heading is needed"));
        QCOMPARE(static_cast<int>(curveOf(*m_polar, "exact fit")->dataSize()), 0);
        m_plot->setPicture({});
        QVERIFY(itemOf<PolarNotice>(*m_polar)->text().contains("Enter readings"));
        m_plot->setPicture(samplePicture(8));
        QVERIFY(itemOf<PolarNotice>(*m_polar)->text().isEmpty());
    }

    void limitBandIsThatOfTheProfile()
    {
        SwingPicture picture = samplePicture(8);
        QVERIFY(!itemOf<PolarGround>(*m_polar)->limit_deg());
        picture.limit_deg = 4;
        m_plot->setPicture(picture);
        QCOMPARE(*itemOf<PolarGround>(*m_polar)->limit_deg(), 4.0);
    }

    void clickOnAPointSelectsItsRow()
    {
        m_plot->setPicture(cardinals(2));
        QSignalSpy selected(m_plot.get(), &SwingPlot::rowSelected);
        const QPoint at = chart().rowsOn(m_canvas)[2].at.toPoint() + QPoint(4, -3);
        QTest::mouseClick(m_canvas, Qt::LeftButton, {}, at);
        QCOMPARE(selected.count(), 1);
        QCOMPARE(selected.first().first().toInt(), 2);
        QCOMPARE(itemOf<PolarReadings>(*m_polar)->selectedRow(), 2);
        QTest::mouseClick(m_canvas, Qt::LeftButton, {}, at + QPoint(0, -60)); // nothing is there
        QCOMPARE(selected.count(), 1);
        m_plot->setSelectedRow(-1);
        QCOMPARE(itemOf<PolarReadings>(*m_polar)->selectedRow(), -1);
    }

    void arrowsMoveRoundTheCompass()
    {
        m_plot->setPicture(cardinals(2));
        QSignalSpy selected(m_plot.get(), &SwingPlot::rowSelected);
        for (const auto key : {Qt::Key_Right, Qt::Key_Right, Qt::Key_Left, Qt::Key_Left})
            QTest::keyClick(m_plot.get(), key);
        QList<int> rows;
        for (const auto& call : selected)
            rows += call.first().toInt();
        QCOMPARE(rows, QList<int>({0, 1, 0, 3}));
    }

    void pointerIsReadOut()
    {
        m_plot->setPicture(cardinals(2));
        QSignalSpy read(m_plot.get(), &SwingPlot::readOut);
        const QPointF north = chart().rowsOn(m_canvas)[0].at;
        QTest::mouseMove(m_canvas, north.toPoint());
        QVERIFY(!read.isEmpty());
        QVERIFY2(read.last().first().toString().contains("compass 358"), qPrintable(read.last().first().toString()));
        const QPointF pole = m_polar->plotRect().center();
        QTest::mouseMove(m_canvas, (pole + QPointF(m_polar->plotRect().width() / 4, 0)).toPoint()); // east, at zero
        const QString place = read.last().first().toString();
        QVERIFY2(place.contains("magnetic 090") || place.contains("magnetic 089"), qPrintable(place));
        QTest::mouseMove(m_canvas, QPoint(1, 1)); // outside the rim
        QVERIFY(read.last().first().toString().isEmpty());
    }

    void wheelKeepsThePlaceUnderThePointer()
    {
        m_plot->setPicture(cardinals(2));
        const QPointF at = chart().rowsOn(m_canvas)[1].at;
        chart().zoomAt({m_canvas, at}, 0.5);
        QVERIFY(std::abs(m_polar->zoomFactor() - 0.5) < 1e-12);
        const QPointF after = chart().rowsOn(m_canvas)[1].at;
        QVERIFY2(std::hypot(after.x() - at.x(), after.y() - at.y()) < 1.0, "the reading stays");
    }

    void frameZoomsAndDoubleClickResets()
    {
        m_plot->setPicture(cardinals(2));
        const QPoint east = chart().rowsOn(m_canvas)[1].at.toPoint();
        QTest::mousePress(m_canvas, Qt::LeftButton, {}, east - QPoint(40, 40));
        QTest::mouseMove(m_canvas, east);
        QTest::mouseRelease(m_canvas, Qt::LeftButton, {}, east + QPoint(40, 40));
        QVERIFY(m_polar->zoomFactor() < 0.3);
        const QPointF seen = chart().rowsOn(m_canvas)[1].at;
        QVERIFY(std::hypot(seen.x() - m_canvas->width() / 2.0, seen.y() - m_canvas->height() / 2.0) < 4);
        QTest::mouseDClick(m_canvas, Qt::LeftButton);
        QCOMPARE(m_polar->zoomFactor(), 1.0);
        QTest::keyClick(m_plot.get(), Qt::Key_Plus);
        QVERIFY(m_polar->zoomFactor() < 1.0);
        QTest::keyClick(m_plot.get(), Qt::Key_Home);
        QCOMPARE(m_polar->zoomFactor(), 1.0);
    }

    void middleButtonPans()
    {
        m_plot->setPicture(cardinals(2));
        chart().zoomAt({m_canvas, QRectF(m_canvas->rect()).center()}, 0.5);
        const QPointF before = chart().rowsOn(m_canvas)[1].at;
        QTest::mousePress(m_canvas, Qt::MiddleButton, {}, QPoint(200, 200));
        QTest::mouseMove(m_canvas, QPoint(170, 215));
        QTest::mouseRelease(m_canvas, Qt::MiddleButton, {}, QPoint(170, 215));
        const QPointF moved = chart().rowsOn(m_canvas)[1].at - before;
        QVERIFY(std::abs(moved.x() + 30) < 1.5);
        QVERIFY(std::abs(moved.y() - 15) < 1.5);
    }

    void legendSwitchesCurvesOff()
    {
        m_plot->setPicture(samplePicture(8));
        const auto& legend = chart().legend();
        for (std::size_t i = 0; i < legend.size(); ++i) {
            if (legend[i].title == "exact fit")
                chart().setShown(static_cast<int>(i), false);
        }
        QVERIFY(!curveOf(*m_polar, "exact fit")->isVisible());
        m_plot->setPicture(samplePicture(12)); // a keystroke does not bring it back
        QVERIFY(!curveOf(*m_polar, "exact fit")->isVisible());
        QVERIFY(curveOf(*m_polar, "approximate fit")->isVisible());
    }

    void coloursFollowThePalette()
    {
        m_plot->setPicture(samplePicture(8));
        const QImage light = m_plot->grab().toImage();
        m_plot->setPalette(darkPalette());
        const QImage dark = m_plot->grab().toImage();
        QVERIFY(QColor(light.pixel(2, 2)).lightnessF() > 0.9);
        QVERIFY(QColor(dark.pixel(2, 2)).lightnessF() < 0.3);
        QVERIFY(inkOf(light) > 3000);
        QVERIFY(inkOf(dark) > 3000);
    }

private:
    Chart& chart() { return *static_cast<ChartPlot*>(m_plot.get())->chart(); }

    std::unique_ptr<SwingPlot> m_plot;
    QwtPolarPlot* m_polar = nullptr;
    QWidget* m_canvas = nullptr;
};

void PolarPlotTest::captionsRunIntoNothing()
{
    const std::unique_ptr<SwingPlot> plot(makePolarPlot(nullptr));
    plot->setPicture(cardinals(2));
    static const QRegularExpression text(QStringLiteral("<text [^>]*x=\"([\\d.]+)\" y=\"([\\d.]+)\"[^>]*>([^<]*)</text>"));
    static const QRegularExpression ofRim(QStringLiteral("^([NESW]|\\d{3}°)$"));
    const QFontMetricsF metrics(paperFont());
    const QTemporaryDir folder;
    static const QRegularExpression ofScale(QStringLiteral("^([+−]\\d+(\\.\\d+)?|0)°$"));
    for (const QSize size :
        {QSize(190, 230), QSize(220, 260), QSize(260, 300), QSize(330, 420), QSize(420, 330), QSize(500, 520), QSize(900, 650)}) {
        const QString path = folder.filePath(QStringLiteral("p.svg"));
        QVERIFY(plot->exportTo(path, size));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QList<QRectF> rim, captions, scale;
        const QString svg = QString::fromUtf8(file.readAll());
        for (auto all = text.globalMatch(svg); all.hasNext();) {
            const auto one = all.next();
            const QString words = one.captured(3);
            const QRectF box(one.captured(1).toDouble(), one.captured(2).toDouble() - metrics.ascent(), metrics.horizontalAdvance(words),
                metrics.ascent());
            if (ofRim.match(words).hasMatch())
                rim += box;
            else if (ofScale.match(words).hasMatch())
                scale += box;
            else if (words.contains("deviation (") || words.contains("outward") || words == "magnetic" || words.contains("heading ("))
                captions += box;
        }
        QCOMPARE(rim.size(), 12);
        QVERIFY(scale.size() >= 3);
        for (const QRectF& label : scale) // as the outermost would into 030°
            for (const QRectF& name : rim)
                QVERIFY2(!name.intersects(label), qPrintable(QStringLiteral("the scale at %1 px").arg(size.width())));
        if (size.width() >= 500)
            QCOMPARE(captions.size(), 4); // two lines each
        for (int i = 0; i < captions.size(); ++i) {
            for (const QRectF& name : rim)
                QVERIFY2(!name.intersects(captions[i]), qPrintable(QStringLiteral("at %1 px").arg(size.width())));
            for (int j = 0; j < i; ++j)
                QVERIFY2(!captions[j].intersects(captions[i]), qPrintable(QStringLiteral("at %1 px").arg(size.width())));
        }
    }
}

QTEST_MAIN(PolarPlotTest)
#include "PolarPlotTest.moc"
