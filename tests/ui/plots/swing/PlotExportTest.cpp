#include "tests/ui/plots/swing/SamplePictures.h"

#include <QDir>
#include <QFile>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgRenderer>
#include <QTemporaryDir>

#include "ui/plots/swing/ChartPlot.h"
#include "ui/plots/swing/PlotRendering.h"
#include "ui/plots/swing/SwingPlot.h"

using namespace lubberline;
using namespace lubberline::ui;

using MakePlot = SwingPlot* (*)(QWidget*);
using Render = void (*)(QPainter&, const QRectF&, const SwingPicture&);
Q_DECLARE_METATYPE(MakePlot)
Q_DECLARE_METATYPE(Render)

namespace {

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

SwingPicture fullPicture()
{
    SwingPicture picture = samplePicture(24);
    picture.previous = samplePicture(8).analysis;
    picture.previousLabel = "2025-11-20";
    picture.limit_deg = 5;
    picture.limitDocument = "14 CFR 25.1327";
    picture.readings[5].excluded = true;
    picture.readings[9].suspect = true;
    picture.readings[9].studentised = 15;
    return picture;
}

QImage rendered(Render render, const SwingPicture& picture, double scale)
{
    QImage image((QSizeF(500, 400) * scale).toSize(), QImage::Format_RGB32);
    image.setDotsPerMeterX(3780);
    image.setDotsPerMeterY(3780);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.scale(scale, scale);
    render(painter, QRectF(50, 40, 400, 320), picture);
    return image;
}

} // namespace

class PlotExportTest : public QObject {
    Q_OBJECT

    static void addPlots()
    {
        QTest::addColumn<MakePlot>("make");
        QTest::addColumn<Render>("render");
        QTest::newRow("polar") << MakePlot(makePolarPlot) << Render(renderPolar);
        QTest::newRow("curve") << MakePlot(makeCurvePlot) << Render(renderCurve);
        QTest::newRow("spectrum") << MakePlot(makeSpectrumPlot) << Render(renderSpectrum);
        QTest::newRow("components") << MakePlot(makeComponentsPlot) << Render(renderComponents);
    }

private slots:
    void init() { QVERIFY(m_folder.isValid()); }

    void pngHasTheSizeAskedForAndAWhiteGround_data() { addPlots(); }
    void pngHasTheSizeAskedForAndAWhiteGround()
    {
        QFETCH(MakePlot, make);
        const std::unique_ptr<SwingPlot> plot(make(nullptr));
        plot->setPalette(darkPalette());
        plot->setPicture(fullPicture());
        const QString path = m_folder.filePath("plot.png");
        QVERIFY(plot->exportTo(path, {700, 500}));
        const QImage image(path);
        QCOMPARE(image.size(), QSize(700, 500));
        QCOMPARE(image.pixelColor(0, 0), QColor(Qt::white));
        QVERIFY(inkOf(image) > 5000);
    }

    void svgIsReadableAndHoldsNoImage_data() { addPlots(); }
    void svgIsReadableAndHoldsNoImage()
    {
        QFETCH(MakePlot, make);
        const std::unique_ptr<SwingPlot> plot(make(nullptr));
        plot->setPicture(fullPicture());
        const QString path = m_folder.filePath("plot.svg");
        QVERIFY(plot->exportTo(path));
        QVERIFY(!contentOf(path).contains("<image"));
        QVERIFY(!contentOf(path).toLower().contains("nan"));
        QSvgRenderer drawing(path);
        QVERIFY(drawing.isValid());
        QImage image(900, 650, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        drawing.render(&painter);
        QVERIFY(inkOf(image) > 5000);
    }

    void pdfIsOnePageWithoutRasterImage_data() { addPlots(); }
    void pdfIsOnePageWithoutRasterImage()
    {
        QFETCH(MakePlot, make);
        const std::unique_ptr<SwingPlot> plot(make(nullptr));
        plot->setPicture(fullPicture());
        const QString path = m_folder.filePath("plot.pdf");
        QVERIFY(plot->exportTo(path));
        const QByteArray pdf = contentOf(path);
        QVERIFY(pdf.startsWith("%PDF-"));
        QVERIFY(pdf.size() > 5000 && pdf.size() < 200'000);
        QVERIFY(!pdf.contains("/Subtype /Image"));
        QCOMPARE(pdf.count("/Type /Page\n"), 1);
        QVERIFY(pdf.contains("/FontFile2")); // the text is text
        QVERIFY(!pdf.contains("/ca 0"));     // no transparency: archive files know none
    }

    void pageOfAReportHoldsNoRasterImage()
    {
        const QString path = m_folder.filePath("page.pdf");
        {
            QPdfWriter page(path);
            page.setPdfVersion(QPagedPaintDevice::PdfVersion_A1b);
            page.setResolution(300);
            QPainter painter(&page);
            painter.scale(300 / 96.0, 300 / 96.0);
            const SwingPicture picture = fullPicture();
            renderPolar(painter, QRectF(0, 0, 340, 340), picture);
            renderCurve(painter, QRectF(0, 350, 640, 320), picture);
            renderSpectrum(painter, QRectF(0, 680, 320, 240), picture);
            renderComponents(painter, QRectF(330, 680, 320, 240), picture);
        }
        const QByteArray pdf = contentOf(path);
        QVERIFY(!pdf.contains("/Subtype /Image"));
        QVERIFY(!pdf.contains("/Subtype/Image"));
    }

    void scaledPaintersGetTheSameDrawing_data() { addPlots(); }
    void scaledPaintersGetTheSameDrawing()
    {
        QFETCH(Render, render);
        const SwingPicture picture = fullPicture();
        for (const double scale : {1.0, 2.0}) {
            const QImage image = rendered(render, picture, scale);
            const QRectF target(50 * scale, 40 * scale, 400 * scale, 320 * scale);
            QRect inked;
            for (int y = 0; y < image.height(); ++y) {
                for (int x = 0; x < image.width(); ++x) {
                    if (image.pixelColor(x, y) != QColor(Qt::white))
                        inked |= QRect(x, y, 1, 1);
                }
            }
            QVERIFY(target.adjusted(-2, -2, 2, 2).contains(inked)); // nothing beside the target
            QVERIFY(inked.height() > 0.9 * target.height());
        }
    }

    void painterIsLeftAsItWas()
    {
        QImage image(300, 300, QImage::Format_RGB32);
        QPainter painter(&image);
        painter.translate(20, 30);
        const QTransform before = painter.transform();
        renderPolar(painter, QRectF(0, 0, 200, 200), fullPicture());
        QCOMPARE(painter.transform(), before);
    }

    void emptyAndUnfinishedSwingsAreDrawnToo_data() { addPlots(); }
    void emptyAndUnfinishedSwingsAreDrawnToo()
    {
        QFETCH(Render, render);
        for (const int readings : {0, 1, 2, 3, 4, 5})
            QVERIFY(inkOf(rendered(render, samplePicture(readings), 1)) > 500);
    }

    void whatIsSwitchedOffIsNotExported()
    {
        const std::unique_ptr<SwingPlot> plot(makeCurvePlot());
        plot->setPicture(fullPicture());
        const QString path = m_folder.filePath("curve.svg");
        QVERIFY(plot->exportTo(path));
        QVERIFY(contentOf(path).contains("2025-11-20"));
        plot->show();
        Chart& chart = *static_cast<ChartPlot*>(plot.get())->chart();
        for (std::size_t i = 0; i < chart.legend().size(); ++i) {
            if (chart.legend()[i].title.contains("2025-11-20"))
                chart.setShown(static_cast<int>(i), false);
        }
        QVERIFY(plot->exportTo(path));
        QVERIFY(!contentOf(path).contains("2025-11-20"));
        QVERIFY(contentOf(path).contains("exact fit"));
    }

    void badPathsAreErrorsAndLeaveNothing()
    {
        const std::unique_ptr<SwingPlot> plot(makePolarPlot());
        plot->setPicture(fullPicture());
        const auto bad = plot->exportTo(m_folder.filePath("plot.bmp"));
        QVERIFY(!bad);
        QVERIFY(bad.error().code == ErrorCode::InvalidInput);
        QVERIFY(QString::fromStdString(bad.error().message.english()).contains("plot.bmp"));
        QVERIFY(plot->exportTo(m_folder.filePath("plot")).error().code == ErrorCode::InvalidInput);
        const auto missing = plot->exportTo(m_folder.filePath("no/such/plot.pdf"));
        QVERIFY(missing.error().code == ErrorCode::Io);
        QVERIFY(QString::fromStdString(missing.error().message.english()).contains("no/such"));
        QVERIFY(plot->exportTo(m_folder.filePath("plot.png"), {0, 10}).error().code == ErrorCode::InvalidInput);
        QDir(m_folder.path()).mkdir("taken.png"); // a folder of this name: the file cannot be put in its place
        QVERIFY(plot->exportTo(m_folder.filePath("taken.png")).error().code == ErrorCode::Io);
        for (const QString& left : QDir(m_folder.path()).entryList(QDir::Files))
            QVERIFY2(left == "plot.png" || left == "plot.svg" || left == "plot.pdf" || left == "page.pdf" || left == "curve.svg",
                qPrintable(left));
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(PlotExportTest)
#include "PlotExportTest.moc"
