// Angles are written in the style that was chosen, by one hand.

#include <QTest>

#include "ui/text/AngleWords.h"

using namespace lubberline;
using namespace lubberline::ui;

class AngleWordsTest : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { showAnglesIn(AngleStyle::DecimalDegrees); }
    void decimalsStayAsTheyAre();
    void figuresInMinutes();
    void ticksInMinutes();
    void sentencesInMinutes();
    void columnsInMinutes();
};

void AngleWordsTest::decimalsStayAsTheyAre()
{
    QCOMPARE(shownAngle(-1.25, 2), QString("−1.25°"));
    QCOMPARE(shownSize(1.25, 2), QString("1.25°"));
    QCOMPARE(shownHeading(7.5), QString("007.5°"));
    QCOMPARE(angleTick(0.5, 0.5), QString("+0.5"));
    QCOMPARE(degreeTick(-2, 1), QString("−2°"));
    QCOMPARE(inAngleStyle("up to 2.5°"), QString("up to 2.5°"));
}

void AngleWordsTest::figuresInMinutes()
{
    showAnglesIn(AngleStyle::DegreesMinutes);
    QCOMPARE(shownAngle(-1.25, 2), QString("1°15'W"));
    QCOMPARE(shownSize(-1.25, 2), QString("1°15'"));
    QCOMPARE(shownSize(0.005, 3), QString("0°00.3'"));
    QCOMPARE(shownHeading(359.999), QString("000°00'"));
    QCOMPARE(shownFigure(3.2), QString("3°12'E"));
}

void AngleWordsTest::ticksInMinutes()
{
    showAnglesIn(AngleStyle::DegreesMinutes);
    QCOMPARE(angleTick(0, 0.5), QString("0"));
    QCOMPARE(angleTick(2, 1), QString("+2"));
    QCOMPARE(angleTick(-1.5, 0.5), QString("−1°30'"));
    QCOMPARE(degreeTick(-2, 1), QString("−2°"));
    QCOMPARE(degreeTick(0.2, 0.2), QString("+0°12'"));
}

void AngleWordsTest::sentencesInMinutes()
{
    showAnglesIn(AngleStyle::DegreesMinutes);
    QCOMPARE(inAngleStyle("magnetic 047.5° · deviation −0.25° ± 0.1°"), QString("magnetic 047°30' · deviation −0°15' ± 0°06'"));
    QCOMPARE(inAngleStyle("059.996° and 10°"), QString("059°59.8' and 10°"));
    QCOMPARE(inAngleStyle("turns at 1.5°/s, H 18000.5 nT"), QString("turns at 1.5°/s, H 18000.5 nT"));
    QCOMPARE(inAngleStyle("0.99°, 0.995°"), QString("0°59', 0°59.7'"));
}

void AngleWordsTest::columnsInMinutes()
{
    QCOMPARE(inAngleColumn("+2.50"), QString("+2.50"));
    QCOMPARE(angleUnit(), QString("°"));
    showAnglesIn(AngleStyle::DegreesMinutes);
    QCOMPARE(angleUnit(), QString("° ′"));
    QCOMPARE(inAngleColumn("−2.50"), QString("−2°30'"));
    QCOMPARE(inAngleColumn("047.5"), QString("047°30'"));
    QCOMPARE(inAngleColumn("0.25 – 1.75"), QString("0°15' – 1°45'"));
    QCOMPARE(inAngleColumn("1°15'W"), QString("1°15'W")); // said already
    QCOMPARE(inAngleColumn("—"), QString("—"));
    QCOMPARE(inAngleColumn("090"), QString("090"));
    QCOMPARE(inAngleStyle("52.1234° N"), QString("52°07.40' N")); // a place stays where it is
}

QTEST_APPLESS_MAIN(AngleWordsTest)
#include "AngleWordsTest.moc"
