#pragma once
/// Control charts: a process that is watched in the order of time, with the run lengths that its limits promise.
/// Sources: NIST/SEMATECH e-Handbook 6.3.2.3 and 6.3.2.4; Montgomery, Introduction to Statistical Quality Control.

#include <span>
#include <vector>

namespace lubberline {

struct ChartLimits {
    double weight = 0.2;    ///< λ of the EWMA
    double width = 2.962;   ///< L: limits at L standard deviations of the average; 500 to the first false alarm
    double reference = 0.5; ///< k of the CUSUM: half of the shift looked for, in standard deviations
    double decision = 5;    ///< h of the CUSUM; 465 to the first false alarm
};

struct EwmaChart {
    std::vector<double> average; ///< z_i = λ x_i + (1 − λ) z_{i−1}, z_0 = the mean
    double low = 0, high = 0;    ///< the limits that it tends to: mean ± L σ √(λ/(2 − λ))
    std::vector<bool> alarm; ///< by the limits of its place, √(λ/(2 − λ) (1 − (1 − λ)^{2i})): an early shift is not overlooked
};
[[nodiscard]] EwmaChart ewma(std::span<const double> values, double mean, double sigma, double weight, double width);

struct CusumChart {
    std::vector<double> high, low; ///< sums above and below, in standard deviations, both ≥ 0
    std::vector<bool> alarm;       ///< begins again after an alarm
};
[[nodiscard]] CusumChart cusum(std::span<const double> values, double mean, double sigma, double reference, double decision);

/// Mean number of values to the first alarm at a shift of the mean [standard deviations], two-sided, begun in the middle; from a Markov
/// chain (Brook and Evans 1972; Lucas and Saccucci 1990).
[[nodiscard]] double cusumRunLength(double reference, double decision, double shift);
[[nodiscard]] double ewmaRunLength(double weight, double width, double shift);

} // namespace lubberline
