#pragma once
/// A map of deviation as files (the contract of the command line): JSON, and CSV with one row a point.

#include <optional>
#include <string>
#include <vector>

#include "core/sensor/map/DeviationMap.h"

namespace lubberline {

/// "heading", "pitch", "roll".
[[nodiscard]] const char* nameOf(AttitudeAxis axis);

/// What a map was computed from.
struct MapSource {
    std::string file; ///< of the model; may be empty
    MeridianField field;
    std::vector<std::string> circuitsOn;
    std::vector<double> sigma_rad = {}; ///< standard deviation at each point of the map, NaN where there is none; empty: not known
};

/// kind ("modelled"), x_deg, y_deg, deviation_deg (rows follow y, null where the field vanishes), extremes, vanishing, model;
/// standard_deviation_deg (as deviation_deg) where the model knows its own;
/// `minus`: the model whose deviation was taken away, null when there is none.
[[nodiscard]] std::string toJson(const DeviationMap& map, const MapSource& model, const std::optional<MapSource>& minus);
/// heading_deg, pitch_deg, roll_deg, deviation_deg (empty where the field vanishes).
[[nodiscard]] std::string toCsv(const DeviationMap& map);

} // namespace lubberline
