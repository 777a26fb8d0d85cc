#pragma once
/// Small-sample statistics that the fleet's figures stand on, each with its source.

#include <cstdint>
#include <span>
#include <vector>

namespace lubberline {

struct Interval {
    double low = 0, high = 0;
    friend bool operator==(const Interval&, const Interval&) = default;
};

/// Exact interval of a share, from quantiles of the beta distribution (Clopper and Pearson 1934). @param trials ≥ 1
[[nodiscard]] Interval clopperPearson(std::int64_t successes, std::int64_t trials, double confidence = 0.95);

/// Quantile of order statistics, with linear interpolation between them: place q(n − 1). @param values sorted, not empty
[[nodiscard]] double percentileOf(std::span<const double> sorted, double q);
[[nodiscard]] double medianOf(std::vector<double> values); ///< percentileOf(…, 0.5) of what need not be sorted

/// Chance that the next of a normal population is outside mean ± factor·s, both of n before it: Student with n − 1 degrees, scale
/// s√(1 + 1/n). @param n ≥ 2
[[nodiscard]] double nextOutside(int n, double factor);
/// Chance that the next one is outside ±limit, from mean and s of n before it. @param n ≥ 2; s ≥ 0
[[nodiscard]] double nextBeyond(int n, double mean, double s, double limit);

/// Two-sided factors k: mean ± k·s holds a share of a normal population with a confidence (exact integral over the mean).
[[nodiscard]] double toleranceFactor(int n, double share, double confidence);
/// The same on one side: mean + k·s (non-central Student).
[[nodiscard]] double toleranceFactorOneSided(int n, double share, double confidence);

/// Which of the hypotheses fall when the expected share of false ones among them is to be at most `rate` (Benjamini and Hochberg
/// 1995). @param of how many were tested: at least as many as are given (the rest with p = 1)
[[nodiscard]] std::vector<bool> discoveries(std::span<const double> p, double rate, std::size_t of);

/// Φ̄(z), and its inverse: chance that a standard normal is above z.
[[nodiscard]] double normalTail(double z);
[[nodiscard]] double normalTailQuantile(double chance);
/// Half width of a two-sided Student interval in units of the standard error; normal where degrees ≤ 0 stands for "known".
[[nodiscard]] double studentFactor(double degreesOfFreedom, double confidence = 0.95);

} // namespace lubberline
