#include "core/reference/VariationTable.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lubberline {

namespace {

double variationAt(const FieldModel& model, double latitude_deg, double longitude_deg, double height_m, double year)
{
    const auto place = makePlace(std::clamp(latitude_deg, -90.0, 90.0), longitude_deg, height_m);
    const auto answer = model.evaluate(*place, year); // the year was asked for before
    return answer->field.variation().degrees();
}

/// The four entries round a place.
struct Cell {
    double south_deg = 0, west_deg = 0, step_deg = 1;
    std::array<double, 4> entry_deg{}; ///< SW, SE, NW, NE

    /// @param up, right  0 … 1 inside the cell.
    [[nodiscard]] double read(double up, double right, TableReading reading) const
    {
        if (reading == TableReading::Nearest)
            return entry_deg[(up >= 0.5 ? 2u : 0u) + (right >= 0.5 ? 1u : 0u)];
        const double base = entry_deg[0];
        const auto off = [&](std::size_t i) { return wrap180(entry_deg[i] - base); };
        return wrap180(base + (1 - up) * right * off(1) + up * (1 - right) * off(2) + up * right * off(3));
    }
};

} // namespace

Result<TableError> variationTableError(const FieldModel& model, const Place& place, double year, double step_deg, TableReading reading)
{
    if (!(step_deg >= 0.1 && step_deg <= 30))
        return Error{ErrorCode::InvalidInput, MARKED("core", "a table of variation has steps of 0.1° to 30°")};
    const auto here = model.evaluate(place, year);
    if (!here)
        return here.error();
    Cell cell{std::min(std::floor(place.latitude_deg / step_deg) * step_deg, 90 - step_deg),
        std::floor(place.longitude_deg / step_deg) * step_deg, step_deg, {}};
    const auto at = [&](double up, double right) {
        return variationAt(model, cell.south_deg + up * step_deg, cell.west_deg + right * step_deg, place.height_m, year);
    };
    cell.entry_deg = {at(0, 0), at(0, 1), at(1, 0), at(1, 1)};
    TableError error;
    error.tabled_deg
        = cell.read((place.latitude_deg - cell.south_deg) / step_deg, (place.longitude_deg - cell.west_deg) / step_deg, reading);
    error.error_deg = wrap180(error.tabled_deg - here->field.variation().degrees());
    error.largest_deg = std::abs(error.error_deg);
    constexpr int kPoints = 12;
    for (int i = 0; i <= kPoints; ++i)
        for (int j = 0; j <= kPoints; ++j) {
            const double up = i / double(kPoints), right = j / double(kPoints);
            error.largest_deg = std::max(error.largest_deg, std::abs(wrap180(cell.read(up, right, reading) - at(up, right))));
        }
    return error;
}

} // namespace lubberline
