#include "core/swing/ModelBand.h"

#include <algorithm>
#include <cmath>

#include <boost/math/distributions/chi_squared.hpp>

namespace lubberline {

void addModelBand(Prediction& prediction, const SensorModel& model, const ModelUncertainty& uncertainty)
{
    constexpr double kLevelCoefficients = 5;
    const double widths = std::sqrt(quantile(boost::math::chi_squared(kLevelCoefficients), kBoundProbability));
    for (PredictedPoint& point : prediction.points) {
        const auto sigma_rad = headingSigma_rad(model, uncertainty, prediction.there, {point.magnetic, 0, 0});
        if (!point.deviation || !sigma_rad)
            continue;
        point.lowest_rad = point.deviation->radians() - widths * *sigma_rad;
        point.highest_rad = point.deviation->radians() + widths * *sigma_rad;
        prediction.maxAbsPossible_rad
            = std::max({prediction.maxAbsPossible_rad, std::abs(*point.lowest_rad), std::abs(*point.highest_rad)});
    }
    prediction.basis = MARKED("core", "a sensor model with its calibration's uncertainty");
}

} // namespace lubberline
