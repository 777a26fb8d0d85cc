#pragma once
/// What a map of deviation shows: one value, made by the page, the command or the report.

#include <QString>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/sensor/map/DeviationMap.h"

namespace lubberline::ui {

struct MapPicture {
    std::shared_ptr<const DeviationMap> map; ///< null: an empty plot that says so
    QString title;
    bool measured = false;           ///< the map says "modelled" or "measured"
    std::optional<double> limit_deg; ///< |deviation| allowed: the heavy contour
    double scale_deg = 0;            ///< colour range ±; 0: from the data, rounded 1-2-5. The same for compared maps.
    bool difference = false;         ///< of two deviations
    std::vector<MapExtreme> extremes;
    std::vector<VanishingPlace> vanishing;
    /// Half of the 95 % band round the value at x and y, where the calibration of the model tells it; empty: not known.
    std::function<std::optional<double>(double x_deg, double y_deg)> band_deg;
    bool coarse = false; ///< while the hand is on a slider: quicker, a little less fine
};

} // namespace lubberline::ui
