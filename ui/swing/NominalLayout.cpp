#include "ui/swing/NominalLayout.h"

#include <algorithm>

#include "core/base/Contract.h"

namespace lubberline::ui {

std::vector<PlacedReading> nominalRows(const std::vector<Reading>& readings, int points)
{
    LUBBERLINE_EXPECT(points > 0 && points <= 360, "a layout has between 1 and 360 points");
    std::vector<std::optional<double>> nominals_deg;
    for (const Reading& reading : readings)
        nominals_deg.push_back(reading.nominal_deg);
    std::vector<PlacedReading> rows;
    for (int point = 0; point < points; ++point) {
        const double heading_deg = 360.0 * point / points;
        if (std::find(nominals_deg.begin(), nominals_deg.end(), heading_deg) != nominals_deg.end())
            continue;
        // After the last row with a smaller nominal, so that rows already typed keep their places among themselves.
        const auto smaller = std::find_if(nominals_deg.rbegin(), nominals_deg.rend(),
            [heading_deg](const auto& nominal_deg) { return nominal_deg && *nominal_deg < heading_deg; });
        const auto position = std::distance(smaller, nominals_deg.rend());
        const auto firstWithout = smaller == nominals_deg.rend()
            ? std::find_if(nominals_deg.begin(), nominals_deg.end(), [](const auto& nominal_deg) { return nominal_deg.has_value(); })
                - nominals_deg.begin()
            : position;
        nominals_deg.insert(nominals_deg.begin() + firstWithout, heading_deg);
        PlacedReading row;
        row.position = static_cast<int>(firstWithout);
        row.reading.nominal_deg = heading_deg;
        rows.push_back(std::move(row));
    }
    return rows;
}

} // namespace lubberline::ui
