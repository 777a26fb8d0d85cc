#include <QtTest>

#include <cmath>
#include <limits>

#include "ui/plots/base/NiceScale.h"

using namespace lubberline::ui;

class NiceScaleTest : public QObject {
    Q_OBJECT

private slots:
    void stepIsTheNextOneTwoFive_data()
    {
        QTest::addColumn<double>("least");
        QTest::addColumn<double>("step");
        QTest::newRow("exact 1") << 1.0 << 1.0;
        QTest::newRow("above 1") << 1.01 << 2.0;
        QTest::newRow("exact 2") << 2.0 << 2.0;
        QTest::newRow("above 2") << 2.5 << 5.0;
        QTest::newRow("above 5") << 5.1 << 10.0;
        QTest::newRow("tenths") << 0.13 << 0.2;
        QTest::newRow("rounding of the last bit") << 3 * (0.2 / 3) * (1 + 1e-15) << 0.2;
        QTest::newRow("hundreds") << 180.0 << 200.0;
    }
    void stepIsTheNextOneTwoFive()
    {
        QFETCH(double, least);
        QFETCH(double, step);
        QCOMPARE(niceStep(least), step);
    }

    void scaleHoldsTheValueInFewSteps()
    {
        for (double value = 0.01; value < 200; value *= 1.13) {
            const NiceScale scale = niceScale(value);
            QVERIFY(scale.end >= value);
            QVERIFY(scale.end <= 4 * scale.step + 1e-9);
            const double steps = scale.end / scale.step;
            QVERIFY(std::abs(steps - std::round(steps)) < 1e-9);
        }
    }

    void noiseIsNotBlownUp()
    {
        QCOMPARE(niceScale(0).end, 1.0);
        QCOMPARE(niceScale(1e-9).end, 1.0);
        QCOMPARE(niceScale(0.01, 2, 0.2).end, 0.2);
    }

    void notFiniteCountsAsNothing()
    {
        QCOMPARE(niceScale(std::numeric_limits<double>::quiet_NaN()).end, 1.0);
        QCOMPARE(niceScale(std::numeric_limits<double>::infinity()).end, 1.0);
    }

    void ticksHaveASignAndAsManyDecimalsAsTheStep_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("step");
        QTest::addColumn<QString>("text");
        QTest::newRow("plus") << 2.0 << 1.0 << "+2";
        QTest::newRow("minus") << -2.0 << 1.0 << "−2";
        QTest::newRow("zero") << 0.0 << 0.5 << "0";
        QTest::newRow("minus zero") << -1e-17 << 0.5 << "0";
        QTest::newRow("half") << -0.5 << 0.5 << "−0.5";
        QTest::newRow("whole of halves") << 1.0 << 0.5 << "+1.0";
        QTest::newRow("hundredths") << 0.02 << 0.02 << "+0.02";
        QTest::newRow("tens") << 20.0 << 10.0 << "+20";
    }
    void ticksHaveASignAndAsManyDecimalsAsTheStep()
    {
        QFETCH(double, value);
        QFETCH(double, step);
        QFETCH(QString, text);
        QCOMPARE(signedTick(value, step), text);
    }
};

QTEST_MAIN(NiceScaleTest)
#include "NiceScaleTest.moc"
