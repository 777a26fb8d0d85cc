#include <QtTest>

#include "ui/plots/swing/ReadingMarks.h"

using namespace lubberline;
using namespace lubberline::ui;

class ReadingMarksTest : public QObject {
    Q_OBJECT

    static QPointF project(double heading_deg, double value_deg) { return {2 * heading_deg, 150 - 5 * value_deg}; }
    static std::vector<PlacedLabel> placed(const std::vector<ReadingPoint>& points, const QRectF& within)
    {
        std::vector<const ReadingPoint*> marks;
        for (const ReadingPoint& point : points)
            marks.push_back(&point);
        return placesOfLabels(marks, project, {within, {{0, 0, 300, 40}}}, QFont());
    }

private slots:
    /// As of neighbours that all were misread, on a small plot: no label lies over another, over a ring or over what was there before.
    void labelsOfACrowdKeepApart()
    {
        std::vector<ReadingPoint> points;
        for (int i = 0; i < 12; ++i)
            points.push_back({i, 60.0 + 4 * i, (i % 3) * 1.5, 0.5, false, i % 2 == 0, QStringLiteral("%1° t = 12.3").arg(60 + 4 * i)});
        const QRectF within(0, 0, 400, 300);
        const auto labels = placed(points, within);
        QCOMPARE(labels.size(), 6U);
        for (std::size_t i = 0; i < labels.size(); ++i) {
            QVERIFY(within.contains(labels[i].place));
            QVERIFY(!labels[i].place.intersects(QRectF(0, 0, 300, 40)));
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY(!labels[i].place.intersects(labels[j].place));
            for (const ReadingPoint& point : points)
                QVERIFY(!labels[i].place.contains(project(point.heading_deg, point.value_deg)));
        }
    }

    void oneAloneStandsBesideItsPoint()
    {
        const auto labels = placed({{0, 90, 0, 0.5, false, true, QStringLiteral("090°")}}, {0, 0, 400, 300});
        QCOMPARE(labels.size(), 1U);
        QVERIFY(labels[0].place.left() > 180 && labels[0].place.left() < 200);
    }

    void whereNothingIsFreeTheRingStandsAlone()
    {
        QVERIFY(placed({{0, 10, 5, 0.5, false, true, QStringLiteral("a label wider than the plot")}}, {0, 0, 40, 300}).empty());
    }
};

QTEST_MAIN(ReadingMarksTest)
#include "ReadingMarksTest.moc"
