#include "tests/ui/plots/map/SampleMaps.h"

#include <QFile>
#include <QPainter>
#include <QPdfWriter>
#include <QSignalSpy>
#include <QTemporaryDir>

#include "ui/plots/map/MapPlotRendering.h"
#include "ui/plots/map/SurfaceChart.h"
#include "ui/plots/map/SurfacePainting.h"
#include "ui/plots/map/SurfacePlot.h"

using namespace lubberline;
using namespace lubberline::ui;

namespace {

const QRectF kRoom(0, 0, 800, 500);

/// The screen's y grows downward: above means smaller.
SurfaceProjection projection(double azimuth_deg, double elevation_deg) { return {{azimuth_deg, elevation_deg}, kRoom}; }

} // namespace

class SurfacePlotTest : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_plot = std::make_unique<SurfacePlot>();
        m_plot->resize(900, 600);
        m_plot->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_plot.get()));
        m_plot->setPicture(sampleMapPicture());
        m_canvas = m_plot->chart()->canvases().front();
    }

    void boxFitsItsRoomFromEveryside()
    {
        for (double azimuth_deg = 0; azimuth_deg < 360; azimuth_deg += 7) {
            for (const double elevation_deg : {5.0, 30.0, 75.0}) {
                const SurfaceProjection project = projection(azimuth_deg, elevation_deg);
                QRectF bounds;
                for (const double x : {-1.0, 1.0}) {
                    for (const double y : {-1.0, 1.0}) {
                        for (const double z : {-1.0, 1.0}) {
                            QVERIFY(kRoom.adjusted(-1e-6, -1e-6, 1e-6, 1e-6).contains(project({x, y, z})));
                            bounds |= QRectF(project({x, y, z}), QSizeF(1e-9, 1e-9));
                        }
                    }
                }
                QVERIFY(bounds.width() > 0.99 * kRoom.width() || bounds.height() > 0.99 * kRoom.height());
            }
        }
    }

    void upIsUpAndTheFarCornerIsFar()
    {
        for (double azimuth_deg = 3; azimuth_deg < 360; azimuth_deg += 10) {
            const SurfaceProjection project = projection(azimuth_deg, 40);
            QVERIFY(project({0, 0, 1}).y() < project({0, 0, -1}).y());
            const double far = project({double(project.farX()), double(project.farY()), 0}).y();
            for (const double x : {-1.0, 1.0}) {
                for (const double y : {-1.0, 1.0})
                    QVERIFY(far <= project({x, y, 0}).y() + 1e-9); // of a level plane the far corner is drawn highest
            }
        }
    }

    void azimuthTurnsTheBoxClockwise()
    {
        // Seen from the front y goes away from the eye; turned by 90° clockwise it points to the right.
        QVERIFY(projection(0, 30)({0, 1, 0}).y() < projection(0, 30)({0, -1, 0}).y());
        QVERIFY(projection(90, 30)({0, 1, 0}).x() > projection(90, 30)({0, -1, 0}).x() + 100);
    }

    void elevationIsHeld()
    {
        m_plot->setView({370, 120});
        QCOMPARE(m_plot->view().elevation_deg, 75.0);
        QCOMPARE(m_plot->view().azimuth_deg, 10.0);
        m_plot->setView({-20, -50});
        QCOMPARE(m_plot->view().elevation_deg, 5.0);
        QCOMPARE(m_plot->view().azimuth_deg, 340.0);
    }

    void meshHasTheMapsValuesAndBothEnds()
    {
        const auto map = sampleMap(sampleSensor(), sampleRequest(AttitudeAxis::Heading, AttitudeAxis::Pitch, 0, 361, 181));
        const MapCells cells(map);
        const SurfaceMesh mesh(cells, 10, 181, 91);
        QCOMPARE(mesh.columns(), 181);
        QCOMPARE(mesh.rows(), 91);
        QCOMPARE(mesh.node(0, 0).at.x, -1.0);
        QCOMPARE(mesh.node(180, 90).at.x, 1.0);
        QCOMPARE(mesh.node(180, 90).at.y, 1.0);
        for (const auto& [x, y] : {std::pair{0, 0}, {17, 45}, {180, 90}}) {
            QCOMPARE(mesh.node(x, y).value_deg, cells.node_deg(2 * x, 2 * y));
            QCOMPARE(mesh.node(x, y).at.z, std::clamp(mesh.node(x, y).value_deg / 10, -1.0, 1.0));
        }
        const SurfaceMesh odd(
            MapCells(sampleMap(sampleSensor(), sampleRequest(AttitudeAxis::Heading, AttitudeAxis::Pitch, 0, 360, 7))), 10, 181, 91);
        QCOMPARE(odd.columns(), 181); // 359 cells cannot be thinned evenly
        QCOMPARE(odd.rows(), 7);
        QCOMPARE(odd.node(180, 0).at.x, 1.0);
    }

    void undefinedCellsAndJumpsAreGaps()
    {
        auto map = mapOf(sampleRequest(AttitudeAxis::Heading, AttitudeAxis::Pitch, 0, 37, 19),
            [](double heading_deg, double) { return heading_deg <= 180 ? 170.0 : -170.0; });
        map->defined[map->index(5, 5)] = 0;
        const SurfaceMesh mesh(MapCells(map), 180, 181, 91);
        QVERIFY(!mesh.middle_deg(18, 3));
        QVERIFY(!mesh.middle_deg(4, 4) && !mesh.middle_deg(5, 5));
        QCOMPARE(*mesh.middle_deg(17, 3), 170.0);
        m_plot->setPicture(mapPictureOf(map));
        QVERIFY(inkOf(m_plot->grab().toImage()) > 5000);
    }

    void whatIsNearerHidesWhatIsBehind()
    {
        // High ground falls by a steep (white) wall to low, blue ground: from the high side the wall hides the low ground.
        const auto map = mapOf(sampleRequest(AttitudeAxis::Heading, AttitudeAxis::Pitch, 0, 61, 61),
            [](double, double pitch_deg) { return pitch_deg < 0 ? 8.0 : -8.0; });
        MapPicture picture;
        picture.map = map;
        picture.scale_deg = 10;
        m_plot->setPicture(picture);
        const auto colourOfLowGround = [this](double azimuth_deg) {
            m_plot->setView({azimuth_deg, 20});
            return m_canvas->grab().toImage().pixelColor(m_plot->chart()->pixelOf({0, 0.5, -0.8}).toPoint());
        };
        const QColor fromTheHighSide = colourOfLowGround(0), fromTheLowSide = colourOfLowGround(180);
        QVERIFY2(std::abs(fromTheHighSide.red() - fromTheHighSide.blue()) < 12, qPrintable(fromTheHighSide.name()));
        QVERIFY2(fromTheLowSide.blue() > fromTheLowSide.red() + 60, qPrintable(fromTheLowSide.name()));
    }

    void dragTurnsWheelZoomsDoubleClickResets()
    {
        const SurfaceView before = m_plot->view();
        QTest::mousePress(m_canvas, Qt::LeftButton, {}, QPoint(300, 300));
        QMouseEvent move(QEvent::MouseMove, QPointF(350, 320), m_canvas->mapToGlobal(QPointF(350, 320)), Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(m_canvas, &move);
        QTest::mouseRelease(m_canvas, Qt::LeftButton, {}, QPoint(350, 320));
        QVERIFY(m_plot->view().azimuth_deg != before.azimuth_deg);
        QVERIFY(m_plot->view().elevation_deg > before.elevation_deg); // the near side goes down with the hand
        QWheelEvent wheel(QPointF(300, 300), m_canvas->mapToGlobal(QPointF(300, 300)), {}, {0, 240}, {}, {}, Qt::NoScrollPhase, false);
        QApplication::sendEvent(m_canvas, &wheel);
        QVERIFY(m_plot->chart()->zoom() > 1.5);
        QTest::mouseDClick(m_canvas, Qt::LeftButton);
        QCOMPARE(m_plot->view(), SurfaceView{});
        QCOMPARE(m_plot->chart()->zoom(), 1.0);
        QTest::keyClick(m_plot.get(), Qt::Key_Right);
        QCOMPARE(m_plot->view().azimuth_deg, SurfaceView{}.azimuth_deg + 5);
    }

    void frontFollowsTheHand()
    {
        // A point of the near side moves to the right when it is dragged there.
        const double before = m_plot->chart()->pixelOf({0, -1, 0}).x();
        QTest::mousePress(m_canvas, Qt::LeftButton, {}, QPoint(300, 300));
        QMouseEvent move(QEvent::MouseMove, QPointF(320, 300), m_canvas->mapToGlobal(QPointF(320, 300)), Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(m_canvas, &move);
        QTest::mouseRelease(m_canvas, Qt::LeftButton, {}, QPoint(320, 300));
        QVERIFY(m_plot->chart()->pixelOf({0, -1, 0}).x() > before);
    }

    void readOutIsOfTheSurfaceUnderThePointer()
    {
        QSignalSpy read(m_plot.get(), &SurfacePlot::readOut);
        const SurfaceMesh& mesh = *m_plot->chart()->mesh();
        const auto& node = mesh.node(120, 5); // near, nothing in front
        QTest::mouseMove(m_canvas, m_plot->chart()->pixelOf(node.at).toPoint());
        QVERIFY(!read.isEmpty());
        const QString text = read.last().first().toString();
        QVERIFY2(text.contains("heading") && text.contains("pitch") && text.contains("deviation"), qPrintable(text));
        QTest::mouseMove(m_canvas, QPoint(2, 2));
        QCOMPARE(read.last().first().toString(), QString());
    }

    void isDrawnOnLightAndDark()
    {
        QVERIFY(inkOf(m_plot->grab().toImage()) > 50'000);
        m_plot->setPalette(darkPalette());
        const QImage dark = m_plot->grab().toImage();
        QCOMPARE(dark.pixelColor(4, dark.height() - 4), darkPalette().color(QPalette::Base));
        m_plot->setPicture({});
        QVERIFY(inkOf(m_plot->grab().toImage()) > 200); // says that there is none
    }

    void paperIsVector()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("surface.pdf");
        {
            QPdfWriter page(path);
            page.setPdfVersion(QPagedPaintDevice::PdfVersion_A1b);
            page.setResolution(300);
            QPainter painter(&page);
            painter.scale(300 / 96.0, 300 / 96.0);
            renderSurface(painter, QRectF(0, 0, 620, 420), sampleMapPicture(), {120, 25});
        }
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray pdf = file.readAll();
        QVERIFY(!pdf.contains("/Subtype /Image"));
        QVERIFY(pdf.contains("/FontFile2"));
        QVERIFY(!pdf.contains("/ca 0"));
        QVERIFY2(pdf.size() > 50'000 && pdf.size() < 1'000'000, qPrintable(QString::number(pdf.size())));
        QVERIFY(m_plot->exportTo(folder.filePath("surface.png")));
        QCOMPARE(QImage(folder.filePath("surface.png")).pixelColor(0, 0), QColor(Qt::white));
    }

private:
    std::unique_ptr<SurfacePlot> m_plot;
    QWidget* m_canvas = nullptr;
};

QTEST_MAIN(SurfacePlotTest)
#include "SurfacePlotTest.moc"
