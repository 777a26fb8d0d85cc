#pragma once
/// Residuals of a log that follow each other are no independent witnesses: by how much the variance of what is fitted to them grows.

#include <span>

namespace lubberline {

/// Variance of the mean of whole stretches of residuals over what independent ones would have, 1 and more; 1 where chance explains it, or
/// where there are fewer than 100. @param residuals in the order of the log
[[nodiscard]] double slowResidualFactor(std::span<const double> residuals);

} // namespace lubberline
