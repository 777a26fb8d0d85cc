#include <QImage>
#include <QPainter>
#include <QtTest>

#include <set>

#include "ui/plots/calibration/ErrorMapDrawing.h"

using namespace lubberline;
using namespace lubberline::ui;

/// Three cells of the map: one of no deviation, one of some, and all the others without samples.
class ErrorMapDrawingTest : public QObject {
    Q_OBJECT

private:
    const QRectF m_rect{0, 0, 300, 160};
    const DrawnPicture m_picture = errorMapDrawing({{30, 0, 12, 0.0, std::nullopt, std::nullopt},
        {60, 0, 8, -2.0, std::nullopt, std::nullopt}, {60, 10, 5, 1.0, std::nullopt, std::nullopt}});

    QString readOut(int x, int y) const { return m_picture.readOut(m_rect, QFont(), QPointF(x, y)); }

    /// The colours of all pixels where the read-out begins so.
    std::set<QRgb> coloursWhere(const QString& beginning) const
    {
        QImage image(m_rect.size().toSize(), QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        m_picture.paint(painter, m_rect, {paperColours(), {}});
        painter.end();
        std::set<QRgb> colours;
        for (int y = 1; y + 1 < image.height(); y += 3)
            for (int x = 1; x + 1 < image.width(); ++x)
                // With its neighbours: an edge belongs to two cells.
                if (readOut(x, y).startsWith(beginning) && readOut(x - 1, y - 1).startsWith(beginning)
                    && readOut(x + 1, y + 1).startsWith(beginning))
                    colours.insert(image.pixel(x, y));
        return colours;
    }

private slots:
    void noSamplesAreNoDeviationOfZero()
    {
        QCOMPARE(coloursWhere(QStringLiteral("heading 30°, pitch 0°: deviation 0.00°")).size(), std::size_t(1));
        QVERIFY(coloursWhere(QStringLiteral("heading 90°, pitch +10°: no samples")).size() > 1); // hatched
    }
    void theReadOutNamesTheCell()
    {
        std::set<QString> seen;
        for (int y = 0; y < 160; y += 3)
            for (int x = 0; x < 300; x += 3)
                seen.insert(readOut(x, y));
        QVERIFY(seen.contains(QString())); // beside the axes
        QVERIFY(seen.contains(QStringLiteral("heading 0°, pitch 0°: no samples")));
        QVERIFY(seen.contains(QStringLiteral("heading 345°, pitch +10°: no samples")));
        QVERIFY(seen.contains(QStringLiteral("heading 60°, pitch 0°: deviation −2.00° before; 8 samples")));
        for (const QString& text : seen)
            QVERIFY2(!text.contains(QStringLiteral("360")), qPrintable(text));
    }
};

QTEST_MAIN(ErrorMapDrawingTest)
#include "ErrorMapDrawingTest.moc"
