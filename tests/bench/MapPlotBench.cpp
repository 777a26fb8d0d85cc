// A slider's step to the repainted contour map at 900×600 (361×181 points computed, contours, labels, painting) against the
// same grid shown by QwtPlotSpectrogram as it comes (bilinear, contours by conrec, without labels), in turns in one run; and a
// turn of the surface of 181×91 points against as many plain polygons. The milliseconds themselves are printed: wanted are
// medians under 33 for both, which says something only of a machine that is not busy with other work.

#include <QApplication>
#include <QImage>
#include <QPainter>

#include <cmath>
#include <cstdio>
#include <memory>

#include <qwt_color_map.h>
#include <qwt_interval.h>
#include <qwt_matrix_raster_data.h>
#include <qwt_plot.h>
#include <qwt_plot_spectrogram.h>

#include "core/angle/Heading.h"
#include "core/sensor/map/DeviationMap.h"
#include "tests/bench/Ratio.h"
#include "ui/plots/map/MapPlot.h"
#include "ui/plots/map/SurfacePlot.h"

namespace {

using namespace lubberline;

constexpr int kRounds = 41;
constexpr double kWanted_ms = 33;

const MeridianField kField = MeridianField::fromDip(18500, toRadians(67));

SensorResponse sensorAt(int step)
{
    SensorModel sensor;
    sensor.hardIron_nT = {1600.0 + 20 * step, -1200, 400}; // what the slider moves
    sensor.softIron << 0.05, 0.015, -0.025, 0.01, -0.05, 0.02, -0.015, 0.005, 0.025;
    return responseOf(sensor);
}

std::shared_ptr<DeviationMap> mapAt(int step, int columns, int rows)
{
    auto map = std::make_shared<DeviationMap>();
    const MapRequest request{
        {AttitudeAxis::Heading, fullRange(AttitudeAxis::Heading), columns}, {AttitudeAxis::Pitch, fullRange(AttitudeAxis::Pitch), rows}, 0};
    computeMap(sensorAt(step), kField, request, *map);
    return map;
}

ui::MapPicture pictureAt(int step, int columns, int rows)
{
    ui::MapPicture picture;
    picture.map = mapAt(step, columns, rows);
    picture.limit_deg = 5;
    picture.extremes = extremesOf(*picture.map, 2);
    picture.vanishing = vanishingPlaces(*picture.map);
    return picture;
}

/// The naive way: Qwt's own spectrogram with its own contours.
class SpectrogramPlot : public QwtPlot {
public:
    SpectrogramPlot() : m_item(new QwtPlotSpectrogram)
    {
        auto* colours = new QwtLinearColorMap(Qt::blue, Qt::red);
        colours->addColorStop(0.5, Qt::white);
        m_item->setColorMap(colours);
        m_item->setDisplayMode(QwtPlotSpectrogram::ContourMode);
        m_item->setDefaultContourPen(QPen(Qt::black, 1));
        m_item->attach(this);
        setAxisScale(QwtAxis::XBottom, 0, 360, 45);
        setAxisScale(QwtAxis::YLeft, -90, 90, 30);
    }

    void setMap(const DeviationMap& map)
    {
        auto* grid = new QwtMatrixRasterData;
        QVector<double> values;
        double largest = 0;
        for (const double value_rad : map.deviation_rad) {
            values.append(toDegrees(value_rad));
            largest = std::max(largest, std::abs(values.back()));
        }
        grid->setValueMatrix(values, map.request.x.nodes);
        grid->setInterval(Qt::XAxis, QwtInterval(-0.5, 360.5));
        grid->setInterval(Qt::YAxis, QwtInterval(-90.5, 90.5));
        grid->setInterval(Qt::ZAxis, QwtInterval(-largest, largest));
        grid->setResampleMode(QwtMatrixRasterData::BilinearInterpolation);
        m_item->setData(grid);
        QList<double> levels;
        for (double level = -std::floor(largest); level <= largest; level += 1)
            levels.append(level);
        m_item->setContourLevels(levels);
        replot();
    }

private:
    QwtPlotSpectrogram* m_item;
};

bool reportMilliseconds(const char* what, double ms)
{
    bench::row(what, ms, kWanted_ms, "what is wanted; on a busy machine no fault", 1.0);
    return ms < kWanted_ms;
}

bool benchMap(bool coarse)
{
    ui::MapPlot ours;
    SpectrogramPlot naive;
    for (QWidget* plot : {static_cast<QWidget*>(&ours), static_cast<QWidget*>(&naive)}) {
        plot->resize(900, 600);
        plot->show();
    }
    QApplication::processEvents();
    QImage screen(900, 600, QImage::Format_RGB32);
    int step = 0;
    const auto slide = [&] {
        ui::MapPicture picture = pictureAt(++step % 50, 361, 181);
        picture.coarse = coarse;
        ours.setPicture(picture);
        static_cast<QWidget&>(ours).render(&screen);
    };
    const auto slideNaively = [&] {
        naive.setMap(*mapAt(++step % 50, 361, 181));
        static_cast<QWidget&>(naive).render(&screen);
    };
    const bench::Timing timing = bench::compare(slide, slideNaively, kRounds);
    const char* what = coarse ? "slider to contour map 900x600, dragging" : "slider to contour map 900x600, at rest";
    const bool kept = bench::report(what, timing, "QwtPlotSpectrogram", coarse ? 0.5 : 1.0);
    reportMilliseconds(what, timing.ours_s * 1e3);
    return kept;
}

void plainPolygons(QPainter& painter, int columns, int rows)
{
    painter.setPen(Qt::NoPen);
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            painter.setBrush(QColor(x % 256, y % 256, 128));
            const double left = 100 + 600.0 * x / columns, top = 60 + 400.0 * y / rows;
            const QPointF corners[] = {{left, top}, {left + 3.4, top + 0.4}, {left + 3.2, top + 4.5}, {left - 0.2, top + 4.1}};
            painter.drawConvexPolygon(corners, 4);
        }
    }
}

bool benchSurface()
{
    ui::SurfacePlot surface;
    surface.resize(900, 600);
    surface.show();
    ui::MapPicture picture = pictureAt(0, 181, 91);
    picture.coarse = true; // drawn as while the mouse turns it
    surface.setPicture(picture);
    QApplication::processEvents();
    QImage screen(900, 600, QImage::Format_RGB32);
    int turn = 0;
    const auto ours = [&] {
        surface.setView({turn++ * 5.0, 30});
        static_cast<QWidget&>(surface).render(&screen);
    };
    const auto reference = [&] {
        QPainter painter(&screen);
        painter.fillRect(screen.rect(), Qt::white);
        plainPolygons(painter, 180, 90);
    };
    const bench::Timing timing = bench::compare(ours, reference, kRounds);
    const bool kept = bench::report("turning the surface 181x91", timing, "as many plain polygons", 3);
    reportMilliseconds("turning the surface 181x91, a frame", timing.ours_s * 1e3);
    return kept;
}

} // namespace

int main(int argc, char** argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    bool kept = benchMap(true);
    kept = benchMap(false) && kept;
    kept = benchSurface() && kept;
    return kept ? 0 : 1;
}
