#pragma once
/// One element of the Earth's field over the world, for a map of isolines.

#include <vector>

#include "core/base/Progress.h"
#include "core/earth/FieldModel.h"

namespace lubberline {

enum class FieldElement { Declination, Inclination, Horizontal, Down, Total };

/// Nodes from 90° S to 90° N (rows) and from 180° W to 180° E (columns), both ends included.
struct FieldGrid {
    FieldElement element = FieldElement::Declination;
    std::string model;
    double year = 0;
    int columns = 0, rows = 0;
    std::vector<double> values; ///< degrees (declination, inclination) or nT; rows follow latitude
    [[nodiscard]] double latitudeAt_deg(int row) const { return -90.0 + 180.0 * row / (rows - 1); }
    [[nodiscard]] double longitudeAt_deg(int column) const { return -180.0 + 360.0 * column / (columns - 1); }
};

/// @param step_deg between nodes; 180 must be a whole number of them. Errors: those of FieldModel::evaluate(); Cancelled.
Result<FieldGrid> fieldGrid(
    const FieldModel& model, double year, FieldElement element, double step_deg = 2.0, const Progress& progress = {});

} // namespace lubberline
