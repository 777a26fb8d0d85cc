#include "core/deviation/PointRules.h"

#include <algorithm>
#include <cmath>

#include "core/deviation/SmithFit.h"
#include "core/deviation/SmithRows.h"

namespace lubberline {

namespace {

struct OnPoints {
    std::array<std::optional<std::size_t>, 8> reading;
    std::array<double, 8> deviation_rad{};
    double worst_deg = 0; ///< the farthest that a taken reading is from its point
    int points = 0;       ///< 8, 4, or 0 when a cardinal is missing
};

/// @param index_deg  by which the compass is far out as a whole
double headingOf(const Observation& reading, HeadingArgument argument, double index_deg)
{
    return argument == HeadingArgument::Magnetic ? reading.magnetic.degrees() : wrap360(reading.compass.degrees() + index_deg);
}

/// The nearest reading to a point; readings on the very same heading are averaged, because all of them count.
void takeNearest(OnPoints& taken, std::size_t point, std::span<const Observation> readings, HeadingArgument argument, double index_deg)
{
    const double point_deg = 45.0 * static_cast<double>(point);
    double nearest_deg = kPointTolerance_deg, sum_rad = 0;
    int count = 0;
    for (std::size_t i = 0; i < readings.size(); ++i) {
        const double distance_deg = std::abs(wrap180(headingOf(readings[i], argument, index_deg) - point_deg));
        const double deviation_rad = toRadians(aboutIndex_deg(readings[i], index_deg));
        if (distance_deg < nearest_deg || (count == 0 && distance_deg <= nearest_deg)) {
            nearest_deg = distance_deg;
            taken.reading[point] = i;
            sum_rad = deviation_rad;
            count = 1;
        } else if (count > 0 && distance_deg == nearest_deg
            && headingOf(readings[i], argument, index_deg) == headingOf(readings[*taken.reading[point]], argument, index_deg)) {
            sum_rad += deviation_rad;
            ++count;
        }
    }
    if (count > 0) {
        taken.deviation_rad[point] = sum_rad / count;
        taken.worst_deg = std::max(taken.worst_deg, nearest_deg);
    }
}

OnPoints onPoints(std::span<const Observation> readings, HeadingArgument argument, double index_deg)
{
    OnPoints cardinals, all;
    for (std::size_t point = 0; point < 8; point += 2)
        takeNearest(cardinals, point, readings, argument, index_deg);
    all = cardinals;
    for (std::size_t point = 1; point < 8; point += 2)
        takeNearest(all, point, readings, argument, index_deg);
    const auto complete = [](const OnPoints& taken, std::size_t step) {
        for (std::size_t point = 0; point < 8; point += step)
            if (!taken.reading[point])
                return false;
        return true;
    };
    all.points = complete(all, 1) ? 8 : 0;
    if (all.points == 8)
        return all;
    cardinals.points = complete(cardinals, 2) ? 4 : 0;
    return cardinals;
}

} // namespace

std::optional<PointRules> pointRules(std::span<const Observation> readings)
{
    const double index_deg = largeIndex_deg(readings);
    const OnPoints magnetic = onPoints(readings, HeadingArgument::Magnetic, index_deg);
    const OnPoints compass = onPoints(readings, HeadingArgument::Compass, index_deg);
    const bool byCompass
        = compass.points > magnetic.points || (compass.points == magnetic.points && compass.worst_deg < magnetic.worst_deg);
    const OnPoints& taken = byCompass ? compass : magnetic;
    if (taken.points == 0)
        return std::nullopt;

    const auto& d = taken.deviation_rad; // N NE E SE S SW W NW
    PointRules rules;
    rules.points = taken.points;
    rules.argument = byCompass ? HeadingArgument::Compass : HeadingArgument::Magnetic;
    rules.reading = taken.reading;
    rules.B_rad = (d[2] - d[6]) / 2;
    rules.C_rad = (d[0] - d[4]) / 2;
    rules.E_rad = ((d[0] + d[4]) - (d[2] + d[6])) / 4;
    if (taken.points == 8) {
        rules.A_rad = (d[0] + d[1] + d[2] + d[3] + d[4] + d[5] + d[6] + d[7]) / 8;
        rules.D_rad = ((d[1] + d[5]) - (d[3] + d[7])) / 4;
    } else {
        rules.A_rad = (d[0] + d[2] + d[4] + d[6]) / 4;
    }
    return rules;
}

} // namespace lubberline
