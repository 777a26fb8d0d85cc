#include "core/swing/HigherShape.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Core>
#include <boost/math/distributions/fisher_f.hpp>

#include "core/algebra/LeastSquares.h"
#include "core/deviation/ToldCoefficients.h"

namespace lubberline {

namespace {

constexpr Eigen::Index kFewest = 10;
constexpr std::size_t kLog = 200;
constexpr double kChance = 0.01;
constexpr double kRounding = 1e-18; ///< computed curves: rounding is no scatter to test against

/// The highest harmonic that so many readings hold against what is left.
int highestOrder(Eigen::Index readings) { return readings < 12 ? 3 : readings < 18 ? 4 : readings < 24 ? 5 : readings < 36 ? 6 : 8; }

/// Harmonics that are held against chance.
struct Orders {
    int first = 3, last = 3;
    [[nodiscard]] Eigen::Index columns() const { return 2 * (last - first + 1); }
};

std::vector<Orders> triedUpTo(int highest)
{
    std::vector<Orders> tried{{3, highest}};
    for (int order = 3; order <= highest && highest > 3; ++order)
        tried.push_back({order, order});
    return tried;
}

/// Five coefficients and these harmonics.
Eigen::MatrixXd designOf(std::span<const Observation> readings, Orders orders)
{
    Eigen::MatrixXd design(static_cast<Eigen::Index>(readings.size()), 5 + orders.columns());
    for (Eigen::Index i = 0; i < design.rows(); ++i) {
        const double z = readings[static_cast<std::size_t>(i)].compass.radians();
        design.row(i).head<5>() << 1.0, std::sin(z), std::cos(z), std::sin(2 * z), std::cos(2 * z);
        for (int k = orders.first; k <= orders.last; ++k) {
            const Eigen::Index column = 5 + 2 * (k - orders.first);
            design(i, column) = std::sin(k * z);
            design(i, column + 1) = std::cos(k * z);
        }
    }
    return design;
}

struct Kept {
    std::vector<Observation> readings;
    Eigen::VectorXd residual_rad;
};

Kept without(std::span<const Observation> readings, const std::vector<double>& residual_rad, const std::vector<std::size_t>& leftOut)
{
    Kept kept;
    std::vector<double> residuals;
    for (std::size_t i = 0; i < readings.size(); ++i)
        if (!std::binary_search(leftOut.begin(), leftOut.end(), i)) {
            kept.readings.push_back(readings[i]);
            residuals.push_back(residual_rad[i]);
        }
    kept.residual_rad = Eigen::Map<const Eigen::VectorXd>(residuals.data(), static_cast<Eigen::Index>(residuals.size()));
    return kept;
}

/// How likely chance alone takes so much away; and what was taken.
struct Tested {
    double chance = 1.0;
    Orders orders;
    Eigen::VectorXd solution; ///< of the five, then of the harmonics
};

Tested tested(const Kept& kept, Orders orders, double squaresOfFive)
{
    const Eigen::MatrixXd design = designOf(kept.readings, orders);
    const Eigen::Index freedom = design.rows() - design.cols();
    if (freedom < 1 || conditionNumber(singularValues(design)) > kConditionLimit)
        return {};
    const Eigen::VectorXd solution = solveLeastSquares(design, kept.residual_rad).solution;
    const double left = std::max((kept.residual_rad - design * solution).squaredNorm(), kRounding);
    const double more = static_cast<double>(orders.columns()), rest = static_cast<double>(freedom);
    const double ratio = std::max(0.0, squaresOfFive - left) / more / (left / rest);
    return {boost::math::cdf(boost::math::complement(boost::math::fisher_f(more, rest), ratio)), orders, solution};
}

/// Which readings stand beside each other on the round.
std::vector<std::size_t> byHeading(const std::vector<Observation>& readings)
{
    std::vector<std::size_t> order(readings.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(
        order.begin(), order.end(), [&](auto a, auto b) { return readings[a].compass.degrees() < readings[b].compass.degrees(); });
    return order;
}

/// What the neighbours of each reading leave on average [rad]: a narrow bump is more than these harmonics, and still no slip of one reading.
std::vector<double> ofNeighbours(std::span<const Observation> readings, const Kept& kept, const Eigen::VectorXd& left_rad)
{
    const auto order = byHeading(kept.readings);
    const auto n = static_cast<std::ptrdiff_t>(order.size());
    const auto at = [&](std::ptrdiff_t place) { return order[static_cast<std::size_t>((place + n) % n)]; };
    std::vector<double> mean_rad;
    for (const auto& reading : readings) {
        const double heading_deg = reading.compass.degrees();
        const auto place = std::partition_point(order.begin(), order.end(), [&](auto one) {
            return kept.readings[one].compass.degrees() < heading_deg;
        }) - order.begin();
        const bool itself = kept.readings[at(place)].compass.degrees() == heading_deg;
        const auto before = static_cast<Eigen::Index>(at(place - 1)), after = static_cast<Eigen::Index>(at(itself ? place + 1 : place));
        mean_rad.push_back(0.5 * (left_rad(before) + left_rad(after)));
    }
    return mean_rad;
}

double amplitudeOf(const Tested& best, int order)
{
    const Eigen::Index column = 5 + 2 * (order - best.orders.first);
    return std::hypot(best.solution(column), best.solution(column + 1));
}

} // namespace

std::optional<HigherShape> higherShape(
    std::span<const Observation> readings, const std::vector<double>& residual_rad, const std::vector<std::size_t>& leftOut)
{
    const Kept kept = without(readings, residual_rad, leftOut);
    if (kept.residual_rad.size() < kFewest || readings.size() >= kLog)
        return std::nullopt;
    const Eigen::MatrixXd five = designOf(kept.readings, {3, 2});
    if (conditionNumber(singularValues(five)) > kConditionLimit)
        return std::nullopt;
    const double squares = (kept.residual_rad - five * solveLeastSquares(five, kept.residual_rad).solution).squaredNorm();
    if (!(squares > 2.0 * kRounding))
        return std::nullopt;
    const auto orders = triedUpTo(highestOrder(kept.residual_rad.size()));
    Tested best;
    for (const Orders& each : orders)
        if (Tested found = tested(kept, each, squares); found.chance < best.chance)
            best = std::move(found);
    if (best.chance * static_cast<double>(orders.size()) > kChance)
        return std::nullopt;
    HigherShape shape;
    shape.at_rad = ofNeighbours(readings, kept, kept.residual_rad - designOf(kept.readings, best.orders) * best.solution);
    const Eigen::VectorXd harmonics
        = designOf(readings, best.orders).rightCols(best.orders.columns()) * best.solution.tail(best.orders.columns());
    for (std::size_t i = 0; i < readings.size(); ++i)
        shape.at_rad[i] += harmonics(static_cast<Eigen::Index>(i));
    double sum = 0, ofThird = 0;
    for (int order = best.orders.first; order <= best.orders.last; ++order) {
        const double amplitude = amplitudeOf(best, order);
        sum += amplitude * amplitude;
        if (order == 3)
            ofThird = amplitude * amplitude;
    }
    shape.size_rad = std::sqrt(sum);
    if (ofThird > 0.5 * sum)
        shape.onlyThird_rad = std::sqrt(ofThird);
    return shape;
}

} // namespace lubberline
