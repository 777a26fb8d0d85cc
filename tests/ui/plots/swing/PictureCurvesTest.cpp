#include "tests/ui/plots/swing/SamplePictures.h"

#include <algorithm>

#include "ui/plots/swing/PictureCurves.h"
#include "ui/plots/swing/PictureText.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

bool allFinite(const QPolygonF& curve)
{
    return std::all_of(curve.begin(), curve.end(), [](const QPointF& p) { return std::isfinite(p.x()) && std::isfinite(p.y()); });
}

ApproximateSmith rough(double factor)
{
    ApproximateSmith smith = sampleSmith();
    smith.B_rad *= factor;
    smith.C_rad *= factor;
    return smith;
}

} // namespace

class PictureCurvesTest : public QObject {
    Q_OBJECT

private slots:
    void approximateFitStandsAtMagneticHeading()
    {
        const SwingPicture picture = samplePicture(24);
        const ApproximateFit& fit = picture.analysis->approximate;
        const QPolygonF curve = approximateCurve(fit);
        QCOMPARE(curve.size(), 361);
        for (int compass_deg = 0; compass_deg <= 360; ++compass_deg) {
            const QPointF& point = curve[compass_deg];
            QVERIFY(std::abs(point.x() - point.y() - compass_deg) < 1e-9); // magnetic = compass + deviation
            const double expected = deviationAt(fit.smith(), CompassHeading::fromDegrees(compass_deg)).degrees();
            QVERIFY(std::abs(point.y() - expected) < 1e-9);
        }
        QVERIFY(std::abs(curve.last().y() - curve.first().y()) < 1e-9);
    }

    void exactFitStandsAtMagneticHeading()
    {
        const SwingPicture picture = samplePicture(24);
        const QPolygonF curve = exactCurve(picture.analysis->exact);
        QCOMPARE(curve.size(), 361);
        for (int magnetic_deg = 0; magnetic_deg <= 360; ++magnetic_deg) {
            const auto magnetic = MagneticHeading::fromDegrees(magnetic_deg);
            QCOMPARE(curve[magnetic_deg].x(), static_cast<double>(magnetic_deg));
            QVERIFY(std::abs(curve[magnetic_deg].y() - deviationAt(picture.analysis->exact.smith(), magnetic).degrees()) < 1e-9);
        }
    }

    void aTurnIsCutExactlyAtBothEnds_data()
    {
        QTest::addColumn<double>("factor");
        QTest::newRow("small") << 1.0;
        QTest::newRow("other sign") << -1.0;
        QTest::newRow("thirty degrees") << 9.0;
    }
    void aTurnIsCutExactlyAtBothEnds()
    {
        QFETCH(double, factor);
        const SwingPicture picture = samplePicture(24, rough(factor));
        const QPolygonF cut = withinOneTurn(approximateCurve(picture.analysis->approximate));
        QCOMPARE(cut.first().x(), 0.0);
        QCOMPARE(cut.last().x(), 360.0);
        QVERIFY(std::abs(cut.first().y() - cut.last().y()) < 1e-6);
        for (int i = 1; i < cut.size(); ++i)
            QVERIFY(cut[i].x() >= cut[i - 1].x());
        QVERIFY(allFinite(cut));
    }

    void bandSurroundsTheFit()
    {
        const SwingPicture picture = samplePicture(8);
        const auto band = confidenceBand(picture.analysis->approximate);
        const QPolygonF curve = approximateCurve(picture.analysis->approximate);
        QCOMPARE(static_cast<int>(band.size()), 361);
        for (std::size_t i = 0; i < band.size(); ++i) {
            QVERIFY(band[i].low_deg < band[i].high_deg);
            QVERIFY(std::abs((band[i].low_deg + band[i].high_deg) / 2 - curve[static_cast<int>(i)].y()) < 1e-9);
        }
        const auto half = bandHalfWidth_rad(picture.analysis->approximate, CompassHeading::fromDegrees(30));
        QVERIFY(std::abs((band[30].high_deg - band[30].low_deg) / 2 - toDegrees(*half)) < 1e-9);
        QCOMPARE(withinOneTurn(band).front().magnetic_deg, 0.0);
        QCOMPARE(withinOneTurn(band).back().magnetic_deg, 360.0);
    }

    void noBandWithoutDegreesOfFreedom()
    {
        const SwingPicture picture = samplePicture(5);
        QVERIFY(picture.analysis);
        QVERIFY(!approximateCurve(picture.analysis->approximate).isEmpty());
        QVERIFY(confidenceBand(picture.analysis->approximate).empty());
    }

    void componentsAddUpToTheFit()
    {
        const SwingPicture picture = samplePicture(16);
        const ApproximateFit& fit = picture.analysis->approximate;
        const QPolygonF sum = sumOfComponents(fit);
        for (int compass_deg = 0; compass_deg <= 360; ++compass_deg) {
            double added = 0;
            for (const Coefficient which : kCoefficients)
                added += componentCurve(fit, which)[compass_deg].y();
            QVERIFY(std::abs(added - sum[compass_deg].y()) < 1e-9);
            QVERIFY(std::abs(sum[compass_deg].x() - compass_deg) < 1e-9);
        }
    }

    void whatCouldNotBeToldHasNoCurve()
    {
        const SwingPicture picture = samplePicture(4);
        QVERIFY(picture.analysis);
        QVERIFY(componentCurve(picture.analysis->approximate, Coefficient::D).isEmpty());
        QVERIFY(!componentCurve(picture.analysis->approximate, Coefficient::B).isEmpty());
    }

    void residualsAreThoseOfTheAnalysis()
    {
        const SwingPicture picture = samplePicture(12);
        for (std::size_t i = 0; i < picture.readings.size(); ++i) {
            const double expected = toDegrees(*picture.analysis->readings[i].residualApproximate_rad);
            QVERIFY(std::abs(residual_deg(picture.readings[i], picture.analysis->approximate) - expected) < 1e-9);
        }
    }

    void residualsWrap()
    {
        SwingPicture picture = samplePicture(12);
        PlottedReading far = picture.readings[0];
        far.deviation = Deviation::fromDegrees(far.deviation.degrees() + 350);
        const double near_deg = residual_deg(picture.readings[0], picture.analysis->approximate);
        QVERIFY(std::abs(residual_deg(far, picture.analysis->approximate) - (near_deg - 10)) < 1e-9);
    }

    void scaleHoldsEverythingThatIsDrawn()
    {
        SwingPicture picture = samplePicture(24);
        picture.resolution_deg = 2;
        const NiceScale scale = deviationScale(picture);
        for (const PlottedReading& reading : picture.readings)
            QVERIFY(std::abs(reading.deviation.degrees()) + 1 <= scale.end);
        picture.previous = samplePicture(24, rough(4)).analysis;
        QVERIFY(deviationScale(picture).end > 2 * scale.end);
    }

    void aLimitFarOutDoesNotFlattenTheCurve()
    {
        SwingPicture picture = samplePicture(24);
        const double without = deviationScale(picture).end;
        picture.limit_deg = 5;
        QVERIFY(deviationScale(picture).end >= 5);
        picture.limit_deg = 60;
        QCOMPARE(deviationScale(picture).end, without);
        QVERIFY(limitTitle(picture, without).contains("60"));
        QVERIFY(limitTitle(picture, without).contains("beyond"));
    }

    void deviationsPastHalfATurnStayFinite()
    {
        ApproximateSmith wild = sampleSmith();
        wild.A_rad = toRadians(176);
        const SwingPicture picture = samplePicture(16, wild);
        QVERIFY(picture.analysis);
        const QPolygonF exact = exactCurve(picture.analysis->exact);
        for (int i = 1; i < exact.size(); ++i)
            QVERIFY(std::abs(exact[i].y() - exact[i - 1].y()) < 90); // goes on, no jump across the plot
        QVERIFY(allFinite(exact));
        QVERIFY(allFinite(withinOneTurn(approximateCurve(picture.analysis->approximate))));
        QVERIFY(std::isfinite(deviationScale(picture).end));
    }

    void suspectLabelNamesHeadingAndT()
    {
        PlottedReading reading;
        reading.magnetic = MagneticHeading::fromDegrees(45.2);
        reading.studentised = 15.04;
        QCOMPARE(suspectLabel(reading), QString("045° t = 15"));
        reading.studentised = -4.32;
        QCOMPARE(suspectLabel(reading), QString("045° t = −4.3"));
        reading.magnetic = MagneticHeading::fromDegrees(359.7);
        reading.studentised.reset();
        QCOMPARE(suspectLabel(reading), QString("000°"));
    }

    void readOutsNameUnitsAndKinds()
    {
        SwingPicture picture = samplePicture(8);
        picture.readings[2].suspect = true;
        picture.readings[2].studentised = 5.5;
        const QString text = readingReadOut(picture.readings[2], picture);
        for (const char* part : {"magnetic 090", "compass ", "deviation +", "residual ", "t = 5.5", "suspect", "°"})
            QVERIFY2(text.contains(part), qPrintable(text));
        QVERIFY(orderReadOut(1, picture).contains("B/C"));
        QVERIFY(orderReadOut(4, picture).contains("cosine"));
        QVERIFY(orderReadOut(5, picture).contains("not resolved"));
        QVERIFY(componentsReadOut(90, picture).contains("B sin"));
    }
};

QTEST_MAIN(PictureCurvesTest)
#include "PictureCurvesTest.moc"
