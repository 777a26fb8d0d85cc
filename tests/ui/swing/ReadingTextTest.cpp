// A true heading is typed with its letter.

#include "ui/swing/readings/ReadingText.h"
#include "tests/ui/window/Fixture.h"

namespace lubberline::ui {

class ReadingTextTest : public QObject {
    Q_OBJECT

private slots:
    void aTrueHeadingIsTypedWithItsLetter()
    {
        Reading reading;
        QVERIFY(!applyTyped(reading, ReadingColumn::Magnetic, "274T")); // the swing states no variation
        QVERIFY(applyTyped(reading, ReadingColumn::Magnetic, "4.5T", 6.0));
        QCOMPARE(reading.trueHeading->degrees(), 4.5);
        QCOMPARE(reading.magnetic->degrees(), 358.5); // magnetic = true − variation, east positive
        QVERIFY(applyTyped(reading, ReadingColumn::Magnetic, "359", 6.0));
        QVERIFY(!reading.trueHeading);
        QVERIFY(!applyTyped(reading, ReadingColumn::Magnetic, "T", 6.0));
    }
};

} // namespace lubberline::ui

QTEST_MAIN(lubberline::ui::ReadingTextTest)
#include "ReadingTextTest.moc"
