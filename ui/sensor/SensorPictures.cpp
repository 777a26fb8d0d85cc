#include "ui/sensor/SensorPictures.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/Normal.h"
#include "core/sensor/SensorReading.h"
#include "core/swing/Analysis.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

namespace {

struct SensorPicturesTexts {
    Q_DECLARE_TR_FUNCTIONS(lubberline::ui::SensorPictures)
};

constexpr std::size_t kMarkedExtremes = 6, kMarkedWhileDragging = 2;
constexpr int kLevelStep_deg = 10;

std::shared_ptr<DeviationMap> mapOf(const SensorModel& model, const ModelView& view)
{
    auto map = std::make_shared<DeviationMap>();
    computeMap(responseOf(model), view.field, view.request, *map);
    return map;
}

double largest_deg(const DeviationMap& map)
{
    double largest_rad = 0;
    for (const double deviation_rad : map.deviation_rad)
        largest_rad = std::max(largest_rad, std::abs(deviation_rad));
    return toDegrees(largest_rad);
}

/// Rounded up to a tenth of a power of ten at least, so that a colour keeps its meaning while a slider moves a little.
double rounded_deg(double largest_deg)
{
    const double step = std::pow(10.0, std::floor(std::log10(std::max(largest_deg, 0.1)))) / 2;
    return std::min(std::ceil(largest_deg / step) * step, 180.0);
}

std::function<std::optional<double>(double, double)> bandOf(const NamedModel& named, const ModelView& view)
{
    if (!named.uncertainty)
        return {};
    return [model = named.model, uncertainty = *named.uncertainty, field = view.field, request = view.request](
               double x_deg, double y_deg) -> std::optional<double> {
        std::array<double, 3> angles_deg{};
        angles_deg[static_cast<std::size_t>(heldAxis(request))] = request.held_deg;
        angles_deg[static_cast<std::size_t>(request.x.axis)] = x_deg;
        angles_deg[static_cast<std::size_t>(request.y.axis)] = y_deg;
        const auto sigma_rad = headingSigma_rad(
            model, uncertainty, field, {MagneticHeading::fromDegrees(angles_deg[0]), toRadians(angles_deg[1]), toRadians(angles_deg[2])});
        return sigma_rad ? std::optional(kNormal95 * toDegrees(*sigma_rad)) : std::nullopt;
    };
}

MapPicture withMarks(MapPicture picture, std::shared_ptr<const DeviationMap> map)
{
    picture.extremes = extremesOf(*map, picture.coarse ? kMarkedWhileDragging : kMarkedExtremes);
    if (!picture.difference)
        picture.vanishing = vanishingPlaces(*map);
    picture.map = std::move(map);
    return picture;
}

MapPicture comparedPicture(const ModelView& view, MapPicture picture, std::shared_ptr<const DeviationMap> map)
{
    const std::shared_ptr<const DeviationMap> other = mapOf(view.other->model, view);
    auto difference = std::make_shared<DeviationMap>(differenceOf(*other, *map));
    picture.scale_deg = std::max(0.1, rounded_deg(std::max({largest_deg(*map), largest_deg(*other), largest_deg(*difference)})));
    if (view.compared == Compared::This) {
        picture.band_deg = bandOf(view.model, view);
        return withMarks(std::move(picture), std::move(map));
    }
    if (view.compared == Compared::Other) {
        picture.band_deg = bandOf(*view.other, view);
        picture.title = view.other->name;
        return withMarks(std::move(picture), other);
    }
    picture.difference = true;
    picture.limit_deg.reset(); // a limit is for a deviation
    picture.title = SensorPicturesTexts::tr("%1 − %2").arg(view.model.name, view.other->name);
    return withMarks(std::move(picture), std::move(difference));
}

std::vector<Observation> levelSwing(const SensorModel& model, const MeridianField& field)
{
    std::vector<Observation> readings;
    const SensorResponse response = responseOf(model);
    for (int heading_deg = 0; heading_deg < 360; heading_deg += kLevelStep_deg) {
        const MagneticHeading magnetic = MagneticHeading::fromDegrees(heading_deg);
        if (const SensorReading reading = readSensor(response, field, {magnetic}); reading.compass)
            readings.push_back({magnetic, *reading.compass});
    }
    return readings;
}

std::shared_ptr<const Analysis> analysed(const std::vector<Observation>& readings, QString& why)
{
    auto analysis = analyse(readings, {.findSlips = false}); // computed, not read
    if (!analysis) {
        why = messageOf(analysis.error());
        return nullptr;
    }
    return std::make_shared<const Analysis>(std::move(analysis.value()));
}

} // namespace

MapRequest wholeRequest(AttitudeAxis x, AttitudeAxis y, double held_deg)
{
    const auto whole = [](AttitudeAxis axis) {
        const AxisRange range = fullRange(axis);
        return MapAxis{axis, range, static_cast<int>(std::lround(range.to_deg - range.from_deg)) + 1};
    };
    return {whole(x), whole(y), held_deg};
}

MapPicture mapPictureOf(const ModelView& view)
{
    MapPicture picture;
    picture.title = view.model.name;
    picture.limit_deg = view.limit_deg;
    picture.coarse = view.coarse;
    if (!view.other)
        picture.band_deg = bandOf(view.model, view);
    std::shared_ptr<const DeviationMap> map = mapOf(view.model.model, view);
    return view.other ? comparedPicture(view, std::move(picture), std::move(map)) : withMarks(std::move(picture), std::move(map));
}

SwingPicture levelSwingOf(const ModelView& view)
{
    SwingPicture picture;
    picture.title = SensorPicturesTexts::tr("MODELLED · %1").arg(view.model.name);
    picture.readingsTitle = SensorPicturesTexts::tr("MODELLED: %1, level").arg(view.model.name);
    picture.limit_deg = view.limit_deg;
    picture.limitDocument = view.limitDocument;
    picture.resolution_deg = 0;
    const auto readings = levelSwing(view.model.model, view.field);
    for (const Observation& reading : readings) {
        PlottedReading point;
        point.row = static_cast<int>(picture.readings.size());
        point.magnetic = reading.magnetic;
        point.compass = reading.compass;
        point.deviation = deviationOf(reading.magnetic, reading.compass);
        picture.readings.push_back(point);
    }
    picture.analysis = analysed(readings, picture.whyNoAnalysis);
    if (view.other) {
        QString none;
        picture.previous = analysed(levelSwing(view.other->model, view.field), none);
        picture.previousTitle = view.other->name;
    }
    return picture;
}

} // namespace lubberline::ui
