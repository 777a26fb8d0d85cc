#include "core/deviation/Harmonics.h"

#include <Eigen/Core>
#include <boost/math/distributions/fisher_f.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <map>
#include <mutex>

#include "core/algebra/LeastSquares.h"
#include "core/algebra/Solve.h"
#include "core/algebra/Spectra.h"
#include "core/deviation/FourierPlan.h"
#include "core/deviation/SmithFit.h"
#include "core/deviation/ToldCoefficients.h"

namespace lubberline {

namespace {

constexpr double kEqualSpacing_rad = 1e-6 * kRadiansPerDegree;

std::vector<HarmonicSample> sorted(std::span<const HarmonicSample> samples)
{
    std::vector<HarmonicSample> result(samples.begin(), samples.end());
    for (auto& sample : result) {
        sample.heading_rad = std::fmod(sample.heading_rad, 2 * kPi);
        if (sample.heading_rad < 0)
            sample.heading_rad += 2 * kPi;
    }
    std::sort(result.begin(), result.end(), [](const HarmonicSample& a, const HarmonicSample& b) {
        return std::pair(a.heading_rad, a.deviation_rad) < std::pair(b.heading_rad, b.deviation_rad);
    });
    return result;
}

bool equallySpaced(const std::vector<HarmonicSample>& samples)
{
    const double step_rad = 2 * kPi / static_cast<double>(samples.size());
    for (std::size_t i = 1; i < samples.size(); ++i)
        if (std::abs(samples[i].heading_rad - samples[0].heading_rad - step_rad * static_cast<double>(i)) > kEqualSpacing_rad)
            return false;
    return true;
}

/// By FFT. Headings that begin at ψ0 instead of north turn order n by n·ψ0. At N even the order N/2 is seen at alternate signs
/// only: ± its value at ψ0 in every reading, so one number, named the cosine, is all there is (not doubled).
std::vector<HarmonicOrder> byFft(const std::vector<HarmonicSample>& samples)
{
    std::vector<double> deviation_rad;
    for (const auto& sample : samples)
        deviation_rad.push_back(sample.deviation_rad);
    const auto transformed = realTransform(deviation_rad);
    const std::size_t n = samples.size();
    std::vector<HarmonicOrder> orders;
    for (std::size_t k = 0; k < transformed.size(); ++k) {
        HarmonicOrder order;
        order.order = static_cast<int>(k);
        order.nyquist = n % 2 == 0 && k == n / 2 && k > 0;
        const double scale = (k == 0 || order.nyquist ? 1.0 : 2.0) / static_cast<double>(n);
        const auto turned
            = order.nyquist ? transformed[k] : transformed[k] * std::polar(1.0, -static_cast<double>(k) * samples[0].heading_rad);
        order.cos_rad = scale * turned.real();
        order.sin_rad = k == 0 || order.nyquist ? 0.0 : -scale * turned.imag();
        orders.push_back(order);
    }
    return orders;
}

Eigen::MatrixXd designFor(const std::vector<HarmonicSample>& samples, int highest)
{
    Eigen::MatrixXd design(static_cast<Eigen::Index>(samples.size()), 2 * highest + 1);
    for (Eigen::Index i = 0; i < design.rows(); ++i) {
        const double heading_rad = samples[static_cast<std::size_t>(i)].heading_rad;
        design(i, 0) = 1;
        for (int k = 1; k <= highest; ++k) {
            design(i, 2 * k - 1) = std::sin(k * heading_rad);
            design(i, 2 * k) = std::cos(k * heading_rad);
        }
    }
    return design;
}

/// An order whose half wave fits into the largest gap is not held by any reading there.
int highestForGap(const std::vector<HarmonicSample>& samples)
{
    double gap_rad = samples.front().heading_rad + 2 * kPi - samples.back().heading_rad;
    for (std::size_t i = 1; i < samples.size(); ++i)
        gap_rad = std::max(gap_rad, samples[i].heading_rad - samples[i - 1].heading_rad);
    return static_cast<int>(std::floor(2 * kPi / gap_rad + 1e-9));
}

/// More than this many orders say nothing of a compass, and would make a design matrix as large as the readings squared.
constexpr int kMostOrdersBySquares = 60;

struct Squares {
    int highest = 0;
    double condition = 1;
    Eigen::VectorXd solution; ///< mean, sine 1, cosine 1, sine 2, …
};

int highestFor(const std::vector<HarmonicSample>& samples)
{
    const int byCount = (static_cast<int>(std::min<std::size_t>(samples.size(), 100'000)) - 1) / 2;
    return std::min({byCount, highestForGap(samples), kMostOrdersBySquares});
}

/// The highest order whose least squares are well conditioned; order 0 (a mean) always is.
Squares squaresByRows(const std::vector<HarmonicSample>& samples)
{
    Eigen::VectorXd observed(static_cast<Eigen::Index>(samples.size()));
    for (std::size_t i = 0; i < samples.size(); ++i)
        observed(static_cast<Eigen::Index>(i)) = samples[i].deviation_rad;
    for (int highest = highestFor(samples); highest > 0; --highest) {
        const Eigen::MatrixXd design = designFor(samples, highest);
        const double condition = conditionNumber(singularValues(design));
        if (condition <= kConditionLimit)
            return {highest, condition, solveLeastSquares(design, observed).solution};
    }
    return {0, 1, solveLeastSquares(designFor(samples, 0), observed).solution};
}

/// The normal equations of the orders up to `highest`, from sums over the samples: products of sines and cosines are sines and cosines of
/// sums and differences, so that N samples cost N, not N times the square of the orders. Of a log this is what makes it bearable; the
/// condition, at most kConditionLimit, enters squared and costs three of sixteen digits.
struct NormalEquations {
    Eigen::MatrixXd matrix;
    Eigen::VectorXd side;
};

NormalEquations normalEquationsOf(const std::vector<HarmonicSample>& samples, int highest)
{
    const auto orders = static_cast<std::size_t>(2 * highest + 1);
    std::vector<std::complex<double>> turns(orders), observed(orders); // Σ e^{ikψ}, Σ δ e^{ikψ}
    for (const auto& sample : samples) {
        const auto step = std::polar(1.0, sample.heading_rad);
        std::complex<double> turn = 1.0;
        for (std::size_t k = 0; k < orders; ++k, turn *= step) {
            turns[k] += turn;
            observed[k] += sample.deviation_rad * turn;
        }
    }
    const auto turnOf = [&](int k) { return k < 0 ? std::conj(turns[static_cast<std::size_t>(-k)]) : turns[static_cast<std::size_t>(k)]; };
    NormalEquations normal{Eigen::MatrixXd(orders, orders), Eigen::VectorXd(orders)};
    for (Eigen::Index i = 0; i < normal.side.size(); ++i) {
        const int k = static_cast<int>(i + 1) / 2;
        const bool sine = i % 2 == 1;
        const auto& side = observed[static_cast<std::size_t>(k)];
        normal.side(i) = sine ? side.imag() : side.real();
        for (Eigen::Index j = 0; j <= i; ++j) {
            const int l = static_cast<int>(j + 1) / 2;
            const auto sum = turnOf(k + l), difference = turnOf(k - l);
            double product = 0; // of i with j, twice
            if (sine && j % 2 == 1)
                product = difference.real() - sum.real();
            else if (sine)
                product = sum.imag() + difference.imag();
            else if (j % 2 == 1)
                product = sum.imag() - difference.imag();
            else
                product = difference.real() + sum.real();
            normal.matrix(i, j) = normal.matrix(j, i) = product / 2;
        }
    }
    return normal;
}

Squares squaresBySums(const std::vector<HarmonicSample>& samples)
{
    const NormalEquations all = normalEquationsOf(samples, highestFor(samples));
    for (Eigen::Index columns = all.side.size(); columns > 1; columns -= 2) {
        const Eigen::MatrixXd normal = all.matrix.topLeftCorner(columns, columns);
        const Eigen::VectorXd squared = symmetricValues(normal);
        const double condition = std::sqrt(squared(columns - 1) / std::max(squared(0), std::numeric_limits<double>::min()));
        if (condition <= kConditionLimit)
            return {static_cast<int>(columns / 2), condition, solvePositive(normal, all.side.head(columns))};
    }
    return {0, 1, Eigen::VectorXd::Constant(1, all.side(0) / all.matrix(0, 0))};
}

constexpr std::size_t kLog = 1000; ///< samples: nobody reads so many by hand

std::vector<HarmonicOrder> ordersOf(const Squares& squares)
{
    std::vector<HarmonicOrder> orders;
    for (int k = 0; k <= squares.highest; ++k) {
        HarmonicOrder order;
        order.order = k;
        order.cos_rad = squares.solution(k == 0 ? 0 : 2 * k);
        order.sin_rad = k == 0 ? 0.0 : squares.solution(2 * k - 1);
        orders.push_back(order);
    }
    return orders;
}

double fisherQuantile(int degreesOfFreedom)
{
    static std::mutex mutex;
    static std::map<int, double> known;
    const std::lock_guard lock(mutex);
    const auto [place, isNew] = known.try_emplace(degreesOfFreedom, 0.0);
    if (isNew)
        place->second = boost::math::quantile(boost::math::fisher_f(2, degreesOfFreedom), 0.95);
    return place->second;
}

/// Noise: what the orders 0…2 leave of the readings. A harmonic of pure noise has sine and cosine of variance 2σ²/N each, so
/// amplitude² / (4σ²/N) is F-distributed with 2 and N − 5 degrees of freedom.
void addNoise(Harmonics& result, const std::vector<HarmonicSample>& samples)
{
    const int freedom = static_cast<int>(samples.size()) - 5;
    if (freedom < 1 || result.orders.size() < 3)
        return;
    double sumOfSquares = 0;
    for (const auto& sample : samples) {
        double fitted = 0;
        for (std::size_t k = 0; k < 3; ++k)
            fitted += result.orders[k].sin_rad * std::sin(static_cast<double>(k) * sample.heading_rad)
                + result.orders[k].cos_rad * std::cos(static_cast<double>(k) * sample.heading_rad);
        sumOfSquares += (sample.deviation_rad - fitted) * (sample.deviation_rad - fitted);
    }
    const double variance = sumOfSquares / freedom, n = static_cast<double>(samples.size());
    for (auto& order : result.orders)
        order.standardError_rad = std::sqrt(variance * (order.order == 0 || order.nyquist ? 1.0 : 2.0) / n);
    result.noiseFloor_rad = std::sqrt(4.0 * variance / n * fisherQuantile(freedom));
}

} // namespace

double HarmonicOrder::amplitude_rad() const { return std::hypot(sin_rad, cos_rad); }

double HarmonicOrder::phase_rad() const { return order == 0 ? 0.0 : std::atan2(cos_rad, sin_rad); }

Result<Harmonics> harmonics(std::span<const HarmonicSample> samples, int maxOrder)
{
    if (samples.empty())
        return Error{ErrorCode::InvalidInput, MARKED("core", "no readings; expected at least one for a mean")};
    for (const auto& sample : samples)
        if (!std::isfinite(sample.heading_rad) || !std::isfinite(sample.deviation_rad))
            return Error{ErrorCode::InvalidInput, MARKED("core", "a heading or deviation is not a finite number")};
    const auto ordered = sorted(samples);
    Harmonics result;
    if (equallySpaced(ordered)) {
        result.method = HarmonicsMethod::Fft;
        result.orders = byFft(ordered);
        result.conditionNumber = ordered.size() < 3 ? 1.0 : std::sqrt(2.0); // columns of length √N and √(N/2), orthogonal
    } else {
        const Squares squares = ordered.size() > kLog ? squaresBySums(ordered) : squaresByRows(ordered);
        result.method = HarmonicsMethod::LeastSquares;
        result.conditionNumber = squares.condition;
        result.orders = ordersOf(squares);
    }
    result.highestResolvable = result.orders.back().order;
    addNoise(result, ordered);
    if (maxOrder >= 0 && maxOrder < result.highestResolvable)
        result.orders.resize(static_cast<std::size_t>(maxOrder) + 1);
    return result;
}

} // namespace lubberline
