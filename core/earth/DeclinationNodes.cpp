#include "core/earth/DeclinationNodes.h"

#include <cmath>

namespace lubberline {

namespace {

constexpr double kCruise_m = 8000.0;
constexpr double kNodesUpTo_deg = 75.0;

/// wrap180(), whose remainder is only needed where there is something to wrap.
double turned(double angle_deg) { return angle_deg > -180.0 && angle_deg <= 180.0 ? angle_deg : wrap180(angle_deg); }

} // namespace

std::optional<double> DeclinationNodes::fromModel(double latitude_deg, double longitude_deg, double year)
{
    const auto place = makePlace(latitude_deg, longitude_deg, kCruise_m);
    const auto model = defaultFieldModel(year);
    if (!place || !model)
        return {};
    const auto field = fieldForCompass(*model, *place, year);
    return field ? std::optional(field->field.variation().degrees()) : std::nullopt;
}

const DeclinationNodes::Node& DeclinationNodes::node(int latitude, int longitude, int year)
{
    const int east = (longitude % 360 + 360) % 360;
    const auto key = static_cast<std::uint32_t>(((year - 1800) * 181 + (latitude + 90)) * 360 + east);
    const auto [found, isNew] = m_nodes.try_emplace(key);
    if (isNew) {
        const auto place = makePlace(latitude, longitude, kCruise_m);
        const auto model = defaultFieldModel(year + 0.5);
        if (place && model)
            if (const auto field = fieldForCompass(*model, *place, year + 0.5))
                found->second
                    = {static_cast<float>(field->field.variation().degrees()), static_cast<float>(field->declinationRate_deg), true};
    }
    return found->second;
}

std::optional<double> DeclinationNodes::at(double latitude_deg, double longitude_deg, double year)
{
    if (!(std::abs(latitude_deg) <= 90.0) || !(std::abs(longitude_deg) <= 540.0) || !(year >= 1800.0 && year < 2200.0))
        return {};
    if (std::abs(latitude_deg) > kNodesUpTo_deg)
        return fromModel(latitude_deg, longitude_deg, year);
    const int south = static_cast<int>(std::floor(latitude_deg)), west = static_cast<int>(std::floor(longitude_deg));
    const int whole = static_cast<int>(std::floor(year));
    if (south != m_latitude || west != m_longitude || whole != m_year) {
        for (int corner = 0; corner < 4; ++corner)
            m_corner[corner] = node(south + corner / 2, west + corner % 2, whole);
        m_latitude = south;
        m_longitude = west;
        m_year = whole;
    }
    const double north = latitude_deg - south, east = longitude_deg - west, years = year - whole - 0.5;
    const auto value = [&](int corner) { return m_corner[corner].declination_deg + m_corner[corner].rate_deg * years; };
    double sum = 0;
    for (int corner = 0; corner < 4; ++corner) {
        if (!m_corner[corner].told)
            return fromModel(latitude_deg, longitude_deg, year);
        const double weight = (corner / 2 ? north : 1.0 - north) * (corner % 2 ? east : 1.0 - east);
        sum += weight * turned(value(corner) - value(0)); // on either side of 180°
    }
    return turned(value(0) + sum);
}

} // namespace lubberline
