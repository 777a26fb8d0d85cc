#pragma once
/// Maps of deviation for the tests of their plots, made by the core like any other.

#include <memory>

#include "core/sensor/map/DeviationMap.h"
#include "tests/ui/plots/swing/SamplePictures.h"
#include "ui/plots/map/MapPicture.h"

namespace lubberline::ui {

inline MeridianField sampleField() { return MeridianField::fromDip(18500, toRadians(67)); }

/// Hard iron of `hard_nT` and soft iron of the order of 0.05.
inline SensorModel sampleSensor(double hard_nT = 2000)
{
    SensorModel sensor;
    sensor.hardIron_nT = {0.8 * hard_nT, -0.6 * hard_nT, 0.2 * hard_nT};
    sensor.softIron << 0.05, 0.015, -0.025, 0.01, -0.05, 0.02, -0.015, 0.005, 0.025;
    return sensor;
}

inline MapRequest sampleRequest(
    AttitudeAxis x = AttitudeAxis::Heading, AttitudeAxis y = AttitudeAxis::Pitch, double held_deg = 0, int columns = 181, int rows = 91)
{
    return {{x, fullRange(x), columns}, {y, fullRange(y), rows}, held_deg};
}

inline std::shared_ptr<const DeviationMap> sampleMap(const SensorModel& sensor, const MapRequest& request = sampleRequest())
{
    auto map = std::make_shared<DeviationMap>();
    computeMap(responseOf(sensor), sampleField(), request, *map);
    return map;
}

inline MapPicture mapPictureOf(std::shared_ptr<const DeviationMap> map)
{
    MapPicture picture;
    picture.extremes = extremesOf(*map, 2);
    picture.vanishing = vanishingPlaces(*map);
    picture.map = std::move(map);
    picture.title = "SP-XYZ, standby";
    return picture;
}

inline MapPicture sampleMapPicture() { return mapPictureOf(sampleMap(sampleSensor())); }

/// A map whose values are given by a function of the nodes' angles.
template <typename Deviation_deg>
std::shared_ptr<DeviationMap> mapOf(const MapRequest& request, Deviation_deg deviation_deg)
{
    auto map = std::make_shared<DeviationMap>();
    map->request = request;
    for (int y = 0; y < request.y.nodes; ++y) {
        for (int x = 0; x < request.x.nodes; ++x)
            map->deviation_rad.push_back(toRadians(deviation_deg(request.x.at_deg(x), request.y.at_deg(y))));
    }
    map->defined.assign(map->deviation_rad.size(), 1);
    return map;
}

} // namespace lubberline::ui
