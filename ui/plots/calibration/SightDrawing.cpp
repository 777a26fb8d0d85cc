#include "ui/plots/calibration/SightDrawing.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <memory>

#include "ui/plots/drawn/DrawnAxes.h"
#include "ui/text/NumberText.h"

namespace lubberline::ui {

namespace {

struct SightWords {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::SightWords)
};

using Sweep = std::vector<SightBudget>;

/// The elevations of a sweep, each once, in its order.
std::vector<double> elevationsOf(const Sweep& sweep)
{
    std::vector<double> elevations;
    for (const SightBudget& one : sweep)
        if (std::find(elevations.begin(), elevations.end(), one.look.elevation_deg) == elevations.end())
            elevations.push_back(one.look.elevation_deg);
    return elevations;
}

DrawnAxes sightAxes(const Sweep& sweep, const QRectF& rect, const QFont& font)
{
    double most = 0;
    for (const SightBudget& one : sweep)
        most = std::max({most, one.whole.turret.azimuth_deg, one.whole.turret.elevation_deg});
    return {rect, font,
        {sweep.front().look.azimuth_deg, sweep.back().look.azimuth_deg, SightWords::tr("looking, azimuth in the aircraft (°)")},
        scaleFrom0(most, 0.01, SightWords::tr("error of the line, turret's axes (°)"))};
}

QColor colourOfElevation(std::size_t place, const PlotColours& colours)
{
    return place == 0 ? colours.coefficient[4] : place == 1 ? colours.approximate : colours.exact;
}

void paintSight(QPainter& painter, const QRectF& rect, const Sweep& sweep, const DrawnLook& look)
{
    const DrawnAxes axes = sightAxes(sweep, rect, painter.font());
    axes.paint(painter, look.colours);
    painter.save();
    painter.setClipRect(axes.inside());
    const auto elevations = elevationsOf(sweep);
    for (std::size_t place = 0; place < elevations.size(); ++place) {
        QPolygonF azimuths, heights;
        for (const SightBudget& one : sweep)
            if (one.look.elevation_deg == elevations[place]) {
                azimuths << axes.at(one.look.azimuth_deg, one.whole.turret.azimuth_deg);
                heights << axes.at(one.look.azimuth_deg, one.whole.turret.elevation_deg);
            }
        const QColor colour = colourOfElevation(place, look.colours);
        if (look.isShown(2 * place)) {
            painter.setPen(curvePen(colour, painter.font()));
            painter.drawPolyline(azimuths);
        }
        if (look.isShown(2 * place + 1)) {
            painter.setPen(curvePen(colour, painter.font(), 1.5, Qt::DashLine));
            painter.drawPolyline(heights);
        }
    }
    painter.restore();
}

QString sightReadOut(const Sweep& sweep, const QRectF& rect, const QFont& font, const QPointF& at)
{
    const DrawnAxes axes = sightAxes(sweep, rect, font);
    if (!axes.contains(at))
        return {};
    const double azimuth = axes.valueAt(at).x();
    QString text;
    for (const double elevation : elevationsOf(sweep)) {
        const SightBudget* nearest = nullptr;
        for (const SightBudget& one : sweep)
            if (one.look.elevation_deg == elevation
                && (!nearest || std::abs(one.look.azimuth_deg - azimuth) < std::abs(nearest->look.azimuth_deg - azimuth)))
                nearest = &one;
        text += text.isEmpty() ? SightWords::tr("looking %1°: ").arg(signedNumber(nearest->look.azimuth_deg, 0)) : QStringLiteral("; ");
        text += SightWords::tr("at %1° azimuth %2°, elevation %3°")
                    .arg(signedNumber(elevation, 0), plainNumber(nearest->whole.turret.azimuth_deg, 2),
                        plainNumber(nearest->whole.turret.elevation_deg, 2));
    }
    return text;
}

} // namespace

DrawnPicture sightDrawing(std::vector<SightBudget> sweep)
{
    DrawnPicture picture;
    if (sweep.empty()) {
        picture.notice = SightWords::tr("Enter the Earth's field and its dip.");
        return picture;
    }
    const auto shown = std::make_shared<const Sweep>(std::move(sweep));
    picture.paint = [shown](QPainter& painter, const QRectF& rect, const DrawnLook& look) { paintSight(painter, rect, *shown, look); };
    picture.readOut = [shown](const QRectF& rect, const QFont& font, const QPointF& at) { return sightReadOut(*shown, rect, font, at); };
    picture.legend = [shown](const PlotColours& colours) {
        std::vector<LegendEntry> entries;
        const auto elevations = elevationsOf(*shown);
        for (std::size_t place = 0; place < elevations.size(); ++place) {
            const QColor colour = colourOfElevation(place, colours);
            const QString height = signedNumber(elevations[place], 0);
            entries.push_back({SightWords::tr("azimuth, looking %1° up").arg(height), LegendEntry::Key::Line, QPen(colour, 2)});
            entries.push_back(
                {SightWords::tr("elevation, looking %1° up").arg(height), LegendEntry::Key::Line, QPen(colour, 2, Qt::DashLine)});
        }
        return entries;
    };
    return picture;
}

} // namespace lubberline::ui
