#include "core/calibration/SlowResidual.h"

#include <algorithm>
#include <cmath>

namespace lubberline {

double slowResidualFactor(std::span<const double> residuals)
{
    if (residuals.size() < 100)
        return 1.0;
    const auto stretch = static_cast<std::size_t>(std::sqrt(static_cast<double>(residuals.size())));
    const std::size_t stretches = residuals.size() / stretch;
    double mean = 0, variance = 0, between = 0;
    for (const double residual : residuals)
        mean += residual / static_cast<double>(residuals.size());
    for (const double residual : residuals)
        variance += (residual - mean) * (residual - mean) / static_cast<double>(residuals.size() - 1);
    for (std::size_t i = 0; i < stretches; ++i) {
        double sum = 0;
        for (std::size_t k = 0; k < stretch; ++k)
            sum += residuals[i * stretch + k] - mean;
        between += sum * sum / static_cast<double>(stretch) / static_cast<double>(stretches - 1);
    }
    const double factor = variance > 0 ? between / variance : 1.0;
    const double chance = 1.0 + 3.5 * std::sqrt(2.0 / static_cast<double>(stretches));
    return factor > chance ? factor : 1.0;
}

} // namespace lubberline
