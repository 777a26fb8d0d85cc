#include <QImage>
#include <QPainter>
#include <QtTest>

#include "ui/plots/drawn/DrawnAxes.h"

using namespace lubberline;
using namespace lubberline::ui;

class DrawnAxesTest : public QObject {
    Q_OBJECT

    /// How dark the strip above the axes is in all: the ink of the upper title.
    static double inkOfTitle(double width)
    {
        QImage image(static_cast<int>(width), 300, QImage::Format_Grayscale8);
        image.fill(Qt::white);
        QPainter painter(&image);
        const DrawnAxes axes(image.rect(), painter.font(), {0, 24, "hour of the day (UTC)"},
            {0, 3, "error of the heading (degrees, one standard deviation)"});
        axes.paint(painter, paperColours());
        painter.end();
        double ink = 0;
        for (int y = 0; y < static_cast<int>(axes.inside().top()) - 2; ++y)
            for (int x = 0; x < image.width(); ++x)
                ink += 255 - qGray(image.pixel(x, y));
        return ink;
    }

private slots:
    void aTitleIsWholeOnANarrowPicture()
    {
        const double whole = inkOfTitle(900);
        QVERIFY(whole > 10000);
        for (const double width : {500.0, 330.0, 260.0, 200.0})
            QVERIFY2(std::abs(inkOfTitle(width) / whole - 1) < 0.05, qPrintable(QString::number(width)));
    }

    void thePictureGivesWayToIt()
    {
        const QFont font;
        const DrawnScale upright{0, 1, "x"}, across{0, 1, "error of the heading (degrees, one standard deviation)"};
        const double wide = DrawnAxes({0, 0, 900, 300}, font, upright, across).inside().top();
        const double narrow = DrawnAxes({0, 0, 260, 300}, font, upright, across).inside().top();
        QVERIFY(narrow >= wide + 0.9 * QFontMetricsF(font).height());
    }
};

QTEST_MAIN(DrawnAxesTest)
#include "DrawnAxesTest.moc"
