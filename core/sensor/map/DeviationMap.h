#pragma once
/// Deviation over two of heading, pitch and roll, the third held: many points at once. The same figures as readSensor() gives
/// point by point, to 1e-12 rad.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/sensor/SensorReading.h"

namespace lubberline {

enum class AttitudeAxis { Heading, Pitch, Roll };

/// The full range of the paper: heading 0…360°, pitch ±90°, roll ±180°.
struct AxisRange {
    double from_deg = 0, to_deg = 360;
};
[[nodiscard]] AxisRange fullRange(AttitudeAxis axis);

/// Nodes from one end of the range to the other, both included.
struct MapAxis {
    AttitudeAxis axis = AttitudeAxis::Heading;
    AxisRange range;
    int nodes = 361;
    [[nodiscard]] double at_deg(int node) const { return range.from_deg + (range.to_deg - range.from_deg) * node / (nodes - 1); }
};

struct MapRequest {
    MapAxis x, y;        ///< two different axes
    double held_deg = 0; ///< of the axis that is neither
};
/// The axis that is neither x nor y.
[[nodiscard]] AttitudeAxis heldAxis(const MapRequest& request);

struct DeviationMap {
    MapRequest request;
    /// Rows follow y. [rad, east positive]; 0 where `defined` is 0.
    std::vector<double> deviation_rad;
    std::vector<std::uint8_t> defined; ///< 0: the horizontal field at the sensor vanishes here
    [[nodiscard]] std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * request.x.nodes + x; }
};

/// Checks a request before any memory is taken. Errors: InvalidInput (same axis twice, fewer than 2 nodes, more than
/// 16 million points: names the size in points and MiB).
Result<void> checkMapRequest(const MapRequest& request);

/// The request must be valid (checkMapRequest). `map` is reused: no memory is taken for a map of the same size.
void computeMap(const SensorResponse& sensor, const MeridianField& field, const MapRequest& request, DeviationMap& map);
/// The same by readSensor() for each point: what the fast one is held against.
void computeMapPlainly(const SensorResponse& sensor, const MeridianField& field, const MapRequest& request, DeviationMap& map);

/// b − a [rad], wrapped to (−π, π]; the requests are equal. Undefined where either is.
[[nodiscard]] DeviationMap differenceOf(const DeviationMap& a, const DeviationMap& b);

struct MapExtreme {
    bool maximum = true;
    double x_deg = 0, y_deg = 0;
    double deviation_rad = 0;
};
/// The largest and the smallest value of the map (each once, the first in reading order), then further local extremes by size,
/// `most` in all at most. Periodic axes (heading over a whole turn, roll over ±180°) have no edge. Extremes of a kind nearer
/// than a fortieth of both axes are one.
[[nodiscard]] std::vector<MapExtreme> extremesOf(const DeviationMap& map, std::size_t most = 8);

/// A place round which the compass card turns once: inside this cell of nodes the horizontal field vanishes.
struct VanishingPlace {
    double x_deg = 0, y_deg = 0; ///< middle of the cell
};
[[nodiscard]] std::vector<VanishingPlace> vanishingPlaces(const DeviationMap& map);

} // namespace lubberline
