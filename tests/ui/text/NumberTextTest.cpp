#include <QtTest>

#include "ui/text/NumberText.h"

using namespace lubberline::ui;

class NumberTextTest : public QObject {
    Q_OBJECT

private slots:
    void takesWhatPeopleType()
    {
        for (const QString text : {"-3.5", " -3,5 ", "\u22123.5", "\u20133,5", "\u20103.5", "\u20113.5"})
            QCOMPARE(typedNumber(text), std::optional(-3.5));
        QCOMPARE(typedNumber(QStringLiteral("1\u00A0234,5")), std::optional(1234.5));
    }

    void refusesWhatIsNone()
    {
        for (const QString text : {"", " ", "a", "1,234,5", "1.2.3", "nan", "inf", "3 5", "0x10"})
            QVERIFY2(!typedNumber(text), qPrintable(text));
    }

    void showsSigns()
    {
        QCOMPARE(signedNumber(1.25, 2), QStringLiteral("+1.25"));
        QCOMPARE(signedNumber(-1.25, 2), QStringLiteral("\u22121.25"));
        QCOMPARE(plainNumber(1.25, 2), QStringLiteral("1.25"));
        QCOMPARE(plainNumber(-1.25, 2), QStringLiteral("\u22121.25"));
        for (const double nothing : {0.0, -0.0, 0.004, -0.004}) {
            QCOMPARE(signedNumber(nothing, 2), QStringLiteral("0.00"));
            QCOMPARE(plainNumber(nothing, 2), QStringLiteral("0.00"));
        }
    }
};

QTEST_GUILESS_MAIN(NumberTextTest)
#include "NumberTextTest.moc"
