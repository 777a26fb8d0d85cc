#include "core/earth/FieldGrid.h"

#include <cmath>

#include "core/earth/FieldModelData.h"

namespace lubberline {

namespace {

double valueOf(FieldElement element, const EarthField& field)
{
    switch (element) {
    case FieldElement::Declination: return field.variation().degrees();
    case FieldElement::Inclination: return toDegrees(field.inclination_rad());
    case FieldElement::Horizontal: return field.horizontal_nT();
    case FieldElement::Down: return field.down_nT;
    case FieldElement::Total: return field.total_nT();
    }
    return 0.0;
}

} // namespace

Result<FieldGrid> fieldGrid(const FieldModel& model, double year, FieldElement element, double step_deg, const Progress& progress)
{
    LUBBERLINE_EXPECT(step_deg > 0.0 && std::abs(std::remainder(180.0, step_deg)) < 1e-9, "the nodes of a world grid divide 180 degrees");
    if (const auto valid = model.evaluate({}, year); !valid)
        return valid.error();
    FieldGrid grid{element, model.name(), year, static_cast<int>(std::lround(360.0 / step_deg)) + 1,
        static_cast<int>(std::lround(180.0 / step_deg)) + 1, {}};
    grid.values.reserve(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows));
    for (int row = 0; row < grid.rows; ++row) {
        if (progress && !progress(static_cast<double>(row) / grid.rows))
            return Error{ErrorCode::Cancelled, MARKED("core", "the map of the world was cancelled")};
        const auto circle = model.data().model.circle(year, grid.latitudeAt_deg(row), 0.0);
        for (int column = 0; column < grid.columns; ++column)
            grid.values.push_back(valueOf(element, circle.at(grid.longitudeAt_deg(column))));
    }
    return grid;
}

} // namespace lubberline
