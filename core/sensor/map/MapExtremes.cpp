// Extremes of a map, and the places where the field vanishes.

#include <algorithm>
#include <cmath>

#include "core/sensor/map/DeviationMap.h"

namespace lubberline {

namespace {

/// Heading over a whole turn and roll over ±180° come back to where they began; pitch does not.
bool periodic(const MapAxis& axis)
{
    return axis.axis != AttitudeAxis::Pitch && std::abs(axis.range.to_deg - axis.range.from_deg) == 360.0;
}

/// a − b of two deviations, the short way round.
double difference(double a, double b)
{
    const double apart = a - b;
    return apart > kPi ? apart - 2.0 * kPi : apart <= -kPi ? apart + 2.0 * kPi : apart;
}

class Neighbourhood {
public:
    explicit Neighbourhood(const DeviationMap& map) : m_map(map), m_wrapX(periodic(map.request.x)), m_wrapY(periodic(map.request.y)) {}

    int columns() const { return m_map.request.x.nodes - (m_wrapX ? 1 : 0); } ///< the last column of a whole turn is the first
    int rows() const { return m_map.request.y.nodes - (m_wrapY ? 1 : 0); }

    /// +1: nothing beside it is larger, −1: nothing is smaller, 0 else. Of equal neighbours, the first in reading order counts.
    int extremeAt(int x, int y) const
    {
        if (!m_map.defined[m_map.index(x, y)])
            return 0;
        const double here = m_map.deviation_rad[m_map.index(x, y)];
        bool largest = true, smallest = true;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                int nx = x + dx, ny = y + dy;
                if ((dx == 0 && dy == 0) || !inside(nx, columns(), m_wrapX) || !inside(ny, rows(), m_wrapY))
                    continue;
                if (!m_map.defined[m_map.index(nx, ny)])
                    return 0; // beside a place where the field vanishes, the deviation takes every value
                const double step = difference(here, m_map.deviation_rad[m_map.index(nx, ny)]);
                const bool earlier = ny < y || (ny == y && nx < x);
                largest = largest && (earlier ? step > 0 : step >= 0);
                smallest = smallest && (earlier ? step < 0 : step <= 0);
            }
        return largest ? 1 : smallest ? -1 : 0;
    }

private:
    static bool inside(int& i, int count, bool wraps)
    {
        if (wraps)
            i = (i + count) % count;
        return i >= 0 && i < count;
    }
    const DeviationMap& m_map;
    bool m_wrapX, m_wrapY;
};

MapExtreme extreme(const DeviationMap& map, int x, int y, bool maximum)
{
    return {maximum, map.request.x.at_deg(x), map.request.y.at_deg(y), map.deviation_rad[map.index(x, y)]};
}

/// Part of an axis within which two extremes of a kind are one: a ridge that slants between nodes shows its top at several.
constexpr double kOneHill = 1.0 / 40;

bool near(const MapAxis& axis, double a_deg, double b_deg)
{
    const double apart_deg = periodic(axis) ? std::remainder(a_deg - b_deg, 360.0) : a_deg - b_deg;
    return std::abs(apart_deg) <= kOneHill * std::abs(axis.range.to_deg - axis.range.from_deg);
}

} // namespace

constexpr double kFlat_rad = 1e-6; ///< no figure of a map is shown so finely

std::vector<MapExtreme> extremesOf(const DeviationMap& map, std::size_t most)
{
    const Neighbourhood around(map);
    std::optional<MapExtreme> largest, smallest;
    std::vector<MapExtreme> local;
    for (int y = 0; y < around.rows(); ++y)
        for (int x = 0; x < around.columns(); ++x) {
            const std::size_t at = map.index(x, y);
            if (!map.defined[at])
                continue;
            if (!largest || map.deviation_rad[at] > largest->deviation_rad)
                largest = extreme(map, x, y, true);
            if (!smallest || map.deviation_rad[at] < smallest->deviation_rad)
                smallest = extreme(map, x, y, false);
            if (const int kind = around.extremeAt(x, y))
                local.push_back(extreme(map, x, y, kind > 0));
        }
    // A map without iron, or of a mount alone, is flat: its highest place is one of rounding.
    if (!largest || difference(largest->deviation_rad, smallest->deviation_rad) < kFlat_rad)
        return {};
    std::vector<MapExtreme> found;
    if (largest && most > 0)
        found.push_back(*largest);
    if (smallest && most > 1)
        found.push_back(*smallest);
    std::stable_sort(
        local.begin(), local.end(), [](const auto& a, const auto& b) { return std::abs(a.deviation_rad) > std::abs(b.deviation_rad); });
    for (const auto& each : local) {
        const bool known = std::any_of(found.begin(), found.end(), [&](const MapExtreme& other) {
            return other.maximum == each.maximum && near(map.request.x, each.x_deg, other.x_deg)
                && near(map.request.y, each.y_deg, other.y_deg);
        });
        if (found.size() < most && !known)
            found.push_back(each);
    }
    return found;
}

std::vector<VanishingPlace> vanishingPlaces(const DeviationMap& map)
{
    std::vector<VanishingPlace> places;
    const auto& request = map.request;
    for (int y = 0; y + 1 < request.y.nodes; ++y)
        for (int x = 0; x + 1 < request.x.nodes; ++x) {
            const std::size_t corners[] = {map.index(x, y), map.index(x + 1, y), map.index(x + 1, y + 1), map.index(x, y + 1)};
            double turned = 0.0;
            bool known = true;
            for (int i = 0; i < 4; ++i) {
                known = known && map.defined[corners[i]];
                turned += difference(map.deviation_rad[corners[(i + 1) % 4]], map.deviation_rad[corners[i]]);
            }
            if (known && std::abs(turned) > kPi) // a whole turn, or none
                places.push_back(
                    {(request.x.at_deg(x) + request.x.at_deg(x + 1)) / 2, (request.y.at_deg(y) + request.y.at_deg(y + 1)) / 2});
        }
    return places;
}

} // namespace lubberline
