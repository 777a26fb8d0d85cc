#include <QImage>
#include <QPainter>
#include <QtTest>

#include "ui/plots/base/PlotLegend.h"

using namespace lubberline;
using namespace lubberline::ui;

class PlotLegendTest : public QObject {
    Q_OBJECT

    static std::vector<LegendEntry> entries()
    {
        return {{"levelling: tilt of gyro over tilt of the apparent vertical"}, {"slaving: gyro over sensor"}, {"short"}};
    }

    /// How dark it is in all: what is cut leaves less.
    static double ink(double width)
    {
        const double height = legendHeight(entries(), width, QFont());
        QImage image(static_cast<int>(width), static_cast<int>(height) + 1, QImage::Format_Grayscale8);
        image.fill(Qt::white);
        QPainter painter(&image);
        painter.setFont(QFont());
        paintLegend(painter, QRectF(0, 0, width, height), entries(), paperColours());
        painter.end();
        double ink = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                ink += 255 - qGray(image.pixel(x, y));
        return ink;
    }

private slots:
    void wordsGoOnBeneathOnANarrowPlot()
    {
        const double whole = ink(1200);
        QVERIFY(whole > 10000);
        for (const double width : {500.0, 300.0, 200.0, 150.0})
            QVERIFY2(std::abs(ink(width) / whole - 1) < 0.05, qPrintable(QString::number(width)));
        QVERIFY(legendHeight(entries(), 150, QFont()) > 2 * legendHeight(entries(), 500, QFont()));
    }

    /// Each row of an entry is a switch for its curve; entries lie beneath each other.
    void anEntryInLinesIsOneSwitch()
    {
        const QFont font;
        const double width = 150, height = legendHeight(entries(), width, font);
        std::vector<int> found;
        for (double y = 0; y < height; y += 2)
            if (const int at = legendEntryAt(entries(), QRectF(0, 0, width, height), font, {width / 2, y}); at >= 0)
                found.push_back(at);
        QVERIFY(std::is_sorted(found.begin(), found.end()));
        QVERIFY(std::count(found.begin(), found.end(), 0) > 2 * std::count(found.begin(), found.end(), 2));
        QCOMPARE(found.back(), 2);
    }
};

QTEST_MAIN(PlotLegendTest)
#include "PlotLegendTest.moc"
