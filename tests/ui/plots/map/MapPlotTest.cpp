#include "tests/ui/plots/map/SampleMaps.h"

#include <QClipboard>
#include <QFile>
#include <QPainter>
#include <QPdfWriter>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <qwt_plot_canvas.h>
#include <qwt_scale_div.h>
#include <qwt_scale_draw.h>
#include <qwt_text.h>

#include "ui/plots/base/CartesianPlot.h"
#include "ui/plots/map/DivergingMap.h"
#include "ui/plots/map/MapChart.h"
#include "ui/plots/map/MapItem.h"
#include "ui/plots/map/MapPlot.h"
#include "ui/plots/map/MapPlotRendering.h"
#include "ui/plots/map/MapText.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

struct Lab {
    double l, a, b;
};

/// sRGB (IEC 61966-2-1) to CIE 1976 L*a*b*, white of D65: written down from the definition, not from the code under test.
Lab labOf(const QColor& colour)
{
    const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    const double r = linear(colour.redF()), g = linear(colour.greenF()), b = linear(colour.blueF());
    const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
    const double x = f((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047);
    const double y = f(0.2126729 * r + 0.7151522 * g + 0.0721750 * b);
    const double z = f((0.0193339 * r + 0.1191920 * g + 0.9503041 * b) / 1.08883);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double distance(const Lab& p, const Lab& q) { return std::hypot(p.l - q.l, p.a - q.a, p.b - q.b); }

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class MapPlotTest : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_plot = std::make_unique<MapPlot>();
        m_plot->resize(900, 600);
        m_plot->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_plot.get()));
    }

    void coloursAreEvenInCielab()
    {
        QCOMPARE(divergingColour(0), QColor(Qt::white));
        for (const int side : {-1, 1}) {
            double least = 1e9, most = 0, lightness = labOf(divergingColour(0)).l;
            for (int i = 1; i <= 16; ++i) {
                const Lab here = labOf(divergingColour(side * i / 16.0)), before = labOf(divergingColour(side * (i - 1) / 16.0));
                const double step = distance(here, before);
                least = std::min(least, step);
                most = std::max(most, step);
                QVERIFY(here.l < lightness - 2.5); // darker at every step: also in grey
                lightness = here.l;
            }
            QVERIFY2(most / least < 1.25, qPrintable(QString::number(most / least))); // 8 bits a channel: ±0.5 of a step of 4.7
        }
    }

    void coloursAreSymmetrical()
    {
        for (int i = 0; i <= 64; ++i) {
            const Lab west = labOf(divergingColour(-i / 64.0)), east = labOf(divergingColour(i / 64.0));
            QVERIFY(std::abs(west.l - east.l) < 0.7);
            QVERIFY(std::abs(std::hypot(west.a, west.b) - std::hypot(east.a, east.b)) < 1.0);
        }
        QCOMPARE(divergingColour(-7), divergingColour(-1));              // beyond the range is its end
        QVERIFY(divergingColour(-1).blue() > divergingColour(-1).red()); // west is blue
        QCOMPARE(divergingTable()[0], divergingColour(-1).rgb());
        QCOMPARE(divergingTable()[kDivergingHalf], QColor(Qt::white).rgb());
    }

    void scaleIsSymmetricalAndHoldsTheData()
    {
        m_plot->setPicture(sampleMapPicture());
        const NiceScale& scale = m_plot->chart()->scale();
        QVERIFY(scale.end >= m_plot->chart()->cells()->largest_deg());
        QVERIFY(scale.end - scale.step < m_plot->chart()->cells()->largest_deg());
    }

    void aScaleThatIsGivenStays()
    {
        MapPicture picture = sampleMapPicture();
        picture.scale_deg = 30; // the same for two maps that are compared
        m_plot->setPicture(picture);
        QCOMPARE(m_plot->chart()->scale().end, 30.0);
        QVERIFY(m_plot->chart()->item().levels_deg().back() <= 30);
        picture.scale_deg = 400;
        m_plot->setPicture(picture);
        QCOMPARE(m_plot->chart()->scale().end, 180.0); // no angle is larger
    }

    void contoursLieOnTheirLevels()
    {
        const MapRequest request = sampleRequest(AttitudeAxis::Heading, AttitudeAxis::Pitch, 0, 73, 37);
        m_plot->setPicture(
            mapPictureOf(mapOf(request, [](double heading_deg, double pitch_deg) { return heading_deg / 60 - 3 + pitch_deg / 90; })));
        const MapItem& item = m_plot->chart()->item();
        QVERIFY(item.contours().size() >= 5);
        for (const ContourLine& line : item.contours()) {
            for (const ContourPoint& point : line.points)
                QVERIFY(std::abs(point.x / 60 - 3 + point.y / 90 - line.level) < 1e-9);
        }
        const auto& levels = item.levels_deg();
        QVERIFY(std::any_of(levels.begin(), levels.end(), [](double level) { return std::abs(level) < 1e-12; }));
    }

    void limitIsAContourOfItsOwn()
    {
        MapPicture picture = sampleMapPicture();
        picture.limit_deg = 3;
        m_plot->setPicture(picture);
        QVERIFY(!m_plot->chart()->item().limitLines().empty());
        for (const ContourLine& line : m_plot->chart()->item().limitLines())
            QCOMPARE(std::abs(line.level), 3.0);
        const auto& legend = m_plot->chart()->legend();
        QVERIFY(std::any_of(legend.begin(), legend.end(), [](const LegendEntry& e) { return e.present && e.title == "limit ±3°"; }));
        picture.limit_deg.reset();
        m_plot->setPicture(picture);
        QVERIFY(m_plot->chart()->item().limitLines().empty());
    }

    void contoursAreLabelledAndLabelsKeepClear()
    {
        m_plot->setPicture(sampleMapPicture());
        m_plot->grab();
        const auto& labels = m_plot->chart()->item().labels();
        QVERIFY(labels.size() >= 5);
        const QRectF canvas = m_plot->chart()->plot().canvas()->contentsRect();
        for (std::size_t i = 0; i < labels.size(); ++i) {
            QVERIFY(labels[i].text.endsWith(u'°'));
            QVERIFY(std::abs(labels[i].turned_deg) <= 90);
            QVERIFY(canvas.contains(labels[i].box));
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY(!labels[i].box.intersects(labels[j].box));
        }
    }

    void axesNameTheirUnitsAndSigns()
    {
        m_plot->setPicture(sampleMapPicture());
        CartesianPlot& plot = m_plot->chart()->plot();
        QVERIFY(plot.axisTitle(QwtAxis::XBottom).text().contains("heading (°)"));
        QCOMPARE(plot.axisTitle(QwtAxis::YLeft).text(), QString("pitch (°, nose up +)"));
        QCOMPARE(plot.axisScaleDiv(QwtAxis::XBottom).lowerBound(), 0.0);
        QCOMPARE(plot.axisScaleDiv(QwtAxis::XBottom).upperBound(), 360.0);
        QCOMPARE(plot.axisScaleDiv(QwtAxis::YLeft).lowerBound(), -90.0);
        QCOMPARE(plot.axisScaleDraw(QwtAxis::XBottom)->label(90).text(), QString("090 E"));
        QCOMPARE(plot.axisScaleDraw(QwtAxis::XBottom)->label(45).text(), QString("045"));
        QCOMPARE(plot.axisScaleDraw(QwtAxis::YLeft)->label(30).text(), QString("+30"));
        m_plot->setPicture(mapPictureOf(sampleMap(sampleSensor(), sampleRequest(AttitudeAxis::Pitch, AttitudeAxis::Roll, 47))));
        QCOMPARE(plot.axisTitle(QwtAxis::YLeft).text(), QString("roll (°, starboard down +)"));
        QCOMPARE(plot.axisScaleDiv(QwtAxis::YLeft).upperBound(), 180.0);
        QCOMPARE(mapCaption(m_plot->chart()->picture()), QString("SP-XYZ, standby · heading 047°"));
    }

    void saysWhetherModelledOrMeasured()
    {
        MapPicture picture = sampleMapPicture();
        QCOMPARE(kindWord(picture), QString("MODELLED"));
        m_plot->setPicture(picture);
        const QImage modelled = m_plot->grab().toImage();
        picture.measured = true;
        QCOMPARE(kindWord(picture), QString("MEASURED"));
        m_plot->setPicture(picture);
        QVERIFY(m_plot->grab().toImage() != modelled); // it is on the picture
        QCOMPARE(mapValueTitle(picture), QString("deviation (°, east +)"));
    }

    void readOutTellsThePlaceAndTheValue()
    {
        const MapRequest request = sampleRequest(AttitudeAxis::Heading, AttitudeAxis::Pitch, 0, 361, 181);
        const MapPicture picture = mapPictureOf(
            mapOf(request, [](double heading_deg, double pitch_deg) { return 3.4 + (heading_deg - 47) + (pitch_deg - 12); }));
        QCOMPARE(
            mapReadOut(picture, 47, 12, MapCells(picture.map).valueAt_deg(47, 12)), QString("heading 047°, pitch +12.0°, deviation +3.4°"));
        QCOMPARE(*MapCells(picture.map).valueAt_deg(47.25, 12.5), 3.4 + 0.25 + 0.5); // bilinear
        QVERIFY(!MapCells(picture.map).valueAt_deg(361, 12));

        m_plot->setPicture(sampleMapPicture());
        QSignalSpy read(m_plot.get(), &MapPlot::readOut);
        CartesianPlot& plot = m_plot->chart()->plot();
        const QPoint at = plot.pixelOf({47, 12}).toPoint();
        QTest::mouseMove(plot.canvas(), at);
        QVERIFY(!read.isEmpty());
        const QPointF value = plot.valueAt(at);
        const QString expected = mapValueText(*m_plot->chart()->cells()->valueAt_deg(value.x(), value.y()));
        QVERIFY2(read.last().first().toString().endsWith("deviation " + expected), qPrintable(read.last().first().toString()));
    }

    void aJumpIsNotInterpolated()
    {
        // +170° left of 180, −170° right of it: between them lies 180°, not 0.
        const MapRequest request = sampleRequest(AttitudeAxis::Heading, AttitudeAxis::Pitch, 0, 37, 19);
        const auto map = mapOf(request, [](double heading_deg, double) { return heading_deg <= 180 ? 170.0 : -170.0; });
        const MapCells cells(map);
        QVERIFY(cells.kind(18, 5) == MapCells::Kind::Jump);
        QCOMPARE(*cells.valueAt_deg(184, 0), 170.0);
        QCOMPARE(*cells.valueAt_deg(186, 0), -170.0);
        const QImage image = cells.image(cells.range_deg(), {361, 91}, 180, 0);
        for (int x = 0; x < image.width(); ++x) {
            const QColor colour = image.pixelColor(x, 40);
            QVERIFY(colour == QColor(divergingTable()[kDivergingHalf + 242]) || colour == QColor(divergingTable()[kDivergingHalf - 242]));
        }
        for (const ContourLine& line : cells.contours(std::array{0.0}))
            QVERIFY(line.points.empty());
    }

    void whereTheFieldVanishesThereIsNoNumber()
    {
        const MapRequest request = sampleRequest(AttitudeAxis::Heading, AttitudeAxis::Pitch, 0, 37, 19);
        auto map = mapOf(request, [](double heading_deg, double) { return 5 * std::sin(toRadians(heading_deg)); });
        map->defined[map->index(10, 9)] = 0;
        map->deviation_rad[map->index(10, 9)] = 0;
        const MapPicture picture = mapPictureOf(map);
        m_plot->setPicture(picture);
        const MapCells& cells = *m_plot->chart()->cells();
        for (const auto& [x, y] : {std::pair{95, 5}, {105, 5}, {95, -5}, {105, -5}})
            QVERIFY(!cells.valueAt_deg(x, y));
        QVERIFY(cells.valueAt_deg(115, 5));
        QVERIFY(mapReadOut(picture, 100, 0, {}).endsWith("horizontal field vanishes"));
        const QImage image = cells.image(cells.range_deg(), {360, 180}, 10, qRgb(1, 2, 3));
        QCOMPARE(image.pixel(100, 90), qRgb(1, 2, 3));
        QCOMPARE(image.pixel(120, 90), divergingColour(5 * std::sin(toRadians(120.5)) / 10).rgb());
        QVERIFY(inkOf(m_plot->grab().toImage()) > 1000);
    }

    void vanishingPlacesOfAStrongMagnetAreFound()
    {
        const MapPicture picture = mapPictureOf(sampleMap(sampleSensor(20'000)));
        QVERIFY(!picture.vanishing.empty());
        m_plot->setPicture(picture);
        QVERIFY(inkOf(m_plot->grab().toImage()) > 10'000);
        QCOMPARE(m_plot->chart()->scale().end, 180.0);
    }

    void noIronIsAWhiteMapWithoutContours()
    {
        MapPicture picture = mapPictureOf(sampleMap(SensorModel{}));
        m_plot->setPicture(picture);
        QVERIFY(m_plot->chart()->item().contours().empty());
        const QRect canvas = m_plot->chart()->plot().canvas()->rect();
        const QImage image = m_plot->chart()->plot().canvas()->grab().toImage();
        QCOMPARE(image.pixelColor(canvas.width() / 3, canvas.height() / 3), QColor(Qt::white));
    }

    void aMapWithoutAnyFieldIsHatched()
    {
        auto map = std::make_shared<DeviationMap>();
        computeMap(SensorResponse{Eigen::Matrix3d::Zero(), Eigen::Vector3d::Zero()}, sampleField(), sampleRequest(), *map);
        m_plot->setPicture(mapPictureOf(map));
        QVERIFY(!m_plot->chart()->cells()->valueAt_deg(100, 10));
        QVERIFY(inkOf(m_plot->chart()->plot().canvas()->grab().toImage()) > 10'000);
    }

    void anEmptyPlotSaysSo()
    {
        m_plot->setPicture({});
        QVERIFY(m_plot->chart()->plot().notice().contains("no map"));
        QCOMPARE(m_plot->chart()->readOutAt({m_plot->chart()->plot().canvas(), {50, 50}}), QString());
        QVERIFY(inkOf(m_plot->grab().toImage()) > 200);
    }

    void zoomStaysForTheSameAxesOnly()
    {
        m_plot->setPicture(sampleMapPicture());
        CartesianPlot& plot = m_plot->chart()->plot();
        plot.setView({90, -30, 90, 60});
        m_plot->setPicture(mapPictureOf(sampleMap(sampleSensor(3000))));
        QCOMPARE(plot.view(), QRectF(90, -30, 90, 60));
        m_plot->setPicture(mapPictureOf(sampleMap(sampleSensor(), sampleRequest(AttitudeAxis::Heading, AttitudeAxis::Roll))));
        QCOMPARE(plot.view(), QRectF(0, -180, 360, 360));
        plot.setView({90, -30, 90, 60});
        QTest::mouseDClick(plot.canvas(), Qt::LeftButton);
        QVERIFY(!plot.zoomed());
    }

    void coarseIsTheSameMapNearly()
    {
        MapPicture picture
            = mapPictureOf(sampleMap(sampleSensor(), sampleRequest(AttitudeAxis::Heading, AttitudeAxis::Pitch, 0, 361, 181)));
        m_plot->setPicture(picture);
        const auto fine = m_plot->chart()->item().contours().size();
        picture.coarse = true;
        m_plot->setPicture(picture);
        QCOMPARE(m_plot->chart()->item().contours().size(), fine);
        for (const ContourLine& line : m_plot->chart()->item().contours()) {
            for (const ContourPoint& point : line.points)
                QVERIFY(std::abs(*m_plot->chart()->cells()->valueAt_deg(point.x, point.y) - line.level) < 0.02);
        }
    }

    void followsTheDarkPalette()
    {
        m_plot->setPicture(sampleMapPicture());
        m_plot->setPalette(darkPalette());
        const QImage image = m_plot->grab().toImage();
        QCOMPARE(image.pixelColor(2, image.height() / 2), darkPalette().color(QPalette::Base));
    }

    void paperIsVectorButForTheColours()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("map.pdf");
        {
            QPdfWriter page(path);
            page.setPdfVersion(QPagedPaintDevice::PdfVersion_A1b);
            page.setResolution(300);
            QPainter painter(&page);
            painter.scale(300 / 96.0, 300 / 96.0);
            renderMap(painter, QRectF(0, 0, 620, 420), sampleMapPicture());
        }
        const QByteArray pdf = contentOf(path);
        QCOMPARE(pdf.count("/Subtype /Image"), 1);
        QVERIFY(!pdf.contains("/DCTDecode")); // lossless
        QVERIFY(pdf.contains("/FontFile2"));  // the text is text
        QVERIFY(!pdf.contains("/ca 0"));      // archive files know no transparency
        QVERIFY(pdf.size() < 1'500'000);
    }

    void exportsLookLikeTheScreenOnWhite()
    {
        QTemporaryDir folder;
        m_plot->setPalette(darkPalette());
        m_plot->setPicture(sampleMapPicture());
        for (const char* ending : {"png", "svg", "pdf"}) {
            const QString path = folder.filePath(QString("map.") + ending);
            QVERIFY(m_plot->exportTo(path, {800, 560}));
            QVERIFY(contentOf(path).size() > 10'000);
        }
        const QImage image(folder.filePath("map.png"));
        QCOMPARE(image.size(), QSize(800, 560));
        QCOMPARE(image.pixelColor(0, 0), QColor(Qt::white));
        QVERIFY(contentOf(folder.filePath("map.svg")).contains("MODELLED"));
        QVERIFY(m_plot->exportTo(folder.filePath("map.bmp")).error().code == ErrorCode::InvalidInput);
        m_plot->copyToClipboard();
        QVERIFY(!QGuiApplication::clipboard()->image().isNull());
    }

private:
    std::unique_ptr<MapPlot> m_plot;
};

QTEST_MAIN(MapPlotTest)
#include "MapPlotTest.moc"
