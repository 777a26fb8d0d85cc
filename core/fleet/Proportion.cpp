#include "core/fleet/Proportion.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/roots.hpp>

#include "core/base/Contract.h"

namespace lubberline {

namespace {

double rootBetween(const std::function<double(double)>& f, double low, double high)
{
    std::uintmax_t rounds = 200;
    const auto [a, b] = boost::math::tools::toms748_solve(f, low, high, boost::math::tools::eps_tolerance<double>(46), rounds);
    return 0.5 * (a + b);
}

/// r with Φ(x + r) − Φ(x − r) = share.
double halfWidthHolding(double x, double share)
{
    const boost::math::normal normal;
    return rootBetween([&](double r) { return cdf(normal, x + r) - cdf(normal, x - r) - share; }, 0.0, std::abs(x) + 40.0);
}

} // namespace

Interval clopperPearson(std::int64_t successes, std::int64_t trials, double confidence)
{
    LUBBERLINE_EXPECT(trials >= 1 && successes >= 0 && successes <= trials, "a share of at least one trial");
    const double half = 0.5 * (1.0 - confidence);
    const auto x = static_cast<double>(successes), n = static_cast<double>(trials);
    return {successes == 0 ? 0.0 : quantile(boost::math::beta_distribution<>(x, n - x + 1), half),
        successes == trials ? 1.0 : quantile(boost::math::beta_distribution<>(x + 1, n - x), 1.0 - half)};
}

double percentileOf(std::span<const double> sorted, double q)
{
    LUBBERLINE_EXPECT(!sorted.empty(), "a percentile of something");
    const double place = q * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    if (below + 1 >= sorted.size())
        return sorted.back();
    return std::lerp(sorted[below], sorted[below + 1], place - static_cast<double>(below));
}

double medianOf(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return percentileOf(values, 0.5);
}

double nextOutside(int n, double factor)
{
    LUBBERLINE_EXPECT(n >= 2, "two before the next");
    return 2.0 * cdf(complement(boost::math::students_t(n - 1), factor / std::sqrt(1.0 + 1.0 / n)));
}

double nextBeyond(int n, double mean, double s, double limit)
{
    LUBBERLINE_EXPECT(n >= 2, "two before the next");
    if (!(s > 0))
        return std::abs(mean) > limit ? 1.0 : 0.0;
    const boost::math::students_t student(n - 1);
    const double scale = s * std::sqrt(1.0 + 1.0 / n);
    return cdf(complement(student, (limit - mean) / scale)) + cdf(student, (-limit - mean) / scale);
}

double toleranceFactor(int n, double share, double confidence)
{
    LUBBERLINE_EXPECT(n >= 2, "two of a population");
    const boost::math::chi_squared chi(n - 1);
    const auto chance = [&](double k) { // that mean ± k s holds the share, over where the mean fell
        const auto at = [&](double u) {
            const double r = halfWidthHolding(u / std::sqrt(n), share);
            return std::exp(-0.5 * u * u) * cdf(complement(chi, (n - 1) * r * r / (k * k)));
        };
        return 2.0 / std::sqrt(2.0 * 3.14159265358979323846)
            * boost::math::quadrature::gauss_kronrod<double, 61>::integrate(at, 0.0, 9.0, 5, 1e-11);
    };
    return rootBetween([&](double k) { return chance(k) - confidence; }, 0.1, 5000.0);
}

double toleranceFactorOneSided(int n, double share, double confidence)
{
    LUBBERLINE_EXPECT(n >= 2, "two of a population");
    const double root = std::sqrt(static_cast<double>(n));
    return quantile(boost::math::non_central_t(n - 1, quantile(boost::math::normal(), share) * root), confidence) / root;
}

std::vector<bool> discoveries(std::span<const double> p, double rate, std::size_t of)
{
    LUBBERLINE_EXPECT(of >= p.size(), "no fewer were tested than are given");
    std::vector<std::size_t> order(p.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t i) { return std::pair(p[i], i); });
    std::size_t kept = 0;
    for (std::size_t k = 0; k < order.size(); ++k)
        if (p[order[k]] <= rate * static_cast<double>(k + 1) / static_cast<double>(of))
            kept = k + 1;
    std::vector<bool> found(p.size(), false);
    for (std::size_t k = 0; k < kept; ++k)
        found[order[k]] = true;
    return found;
}

double normalTail(double z) { return 0.5 * std::erfc(z / std::sqrt(2.0)); }
double normalTailQuantile(double chance) { return std::sqrt(2.0) * boost::math::erfc_inv(2.0 * chance); }

double studentFactor(double degreesOfFreedom, double confidence)
{
    const double half = 0.5 * (1.0 - confidence);
    return degreesOfFreedom > 0 ? quantile(complement(boost::math::students_t(degreesOfFreedom), half)) : normalTailQuantile(half);
}

} // namespace lubberline
