#include "core/fleet/ControlChart.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "core/base/Contract.h"
#include "core/fleet/Proportion.h"

namespace lubberline {

namespace {

double below(double z) { return normalTail(-z); }

/// Of a chain that goes from state i to j with chance Q(i, j) and else alarms: (I − Q)⁻¹ 1.
Eigen::VectorXd runLengths(const Eigen::MatrixXd& chain)
{
    const Eigen::Index n = chain.rows();
    return (Eigen::MatrixXd::Identity(n, n) - chain).partialPivLu().solve(Eigen::VectorXd::Ones(n));
}

/// One side, begun at zero. The sum is cut into cells; their number is that at which the published digits stand still.
double oneSidedCusum(double reference, double decision, double shift)
{
    constexpr int cells = 400;
    const double width = 2 * decision / (2 * cells - 1);
    Eigen::MatrixXd chain(cells, cells);
    for (int i = 0; i < cells; ++i)
        for (int j = 0; j < cells; ++j) {
            const double step = (j - i) * width + reference - shift;
            chain(i, j) = j == 0 ? below(step + width / 2) : below(step + width / 2) - below(step - width / 2);
        }
    return runLengths(chain)[0];
}

} // namespace

EwmaChart ewma(std::span<const double> values, double mean, double sigma, double weight, double width)
{
    LUBBERLINE_EXPECT(weight > 0 && weight <= 1 && sigma >= 0, "a weight of (0, 1] and a standard deviation");
    EwmaChart chart;
    const double spread = sigma * std::sqrt(weight / (2 - weight));
    chart.low = mean - width * spread;
    chart.high = mean + width * spread;
    double average = mean, left = 1;
    for (const double value : values) {
        average = weight * value + (1 - weight) * average;
        left *= (1 - weight) * (1 - weight);
        chart.average.push_back(average);
        chart.alarm.push_back(std::abs(average - mean) > width * spread * std::sqrt(1 - left));
    }
    return chart;
}

CusumChart cusum(std::span<const double> values, double mean, double sigma, double reference, double decision)
{
    LUBBERLINE_EXPECT(sigma > 0, "a standard deviation");
    CusumChart chart;
    double high = 0, low = 0;
    for (const double value : values) {
        const double z = (value - mean) / sigma;
        high = std::max(0.0, high + z - reference);
        low = std::max(0.0, low - z - reference);
        chart.high.push_back(high);
        chart.low.push_back(low);
        chart.alarm.push_back(high > decision || low > decision);
        if (chart.alarm.back())
            high = low = 0;
    }
    return chart;
}

double cusumRunLength(double reference, double decision, double shift)
{
    // Both sides at once never grow together far enough to alarm together: the rates add (Van Dobben de Bruyn 1968).
    return 1.0 / (1.0 / oneSidedCusum(reference, decision, shift) + 1.0 / oneSidedCusum(reference, decision, -shift));
}

double ewmaRunLength(double weight, double width, double shift)
{
    constexpr int cells = 401; // odd: it begins in the middle of one
    const double limit = width * std::sqrt(weight / (2 - weight)), cell = 2 * limit / cells;
    const auto middle = [&](int i) { return -limit + (i + 0.5) * cell; };
    Eigen::MatrixXd chain(cells, cells);
    for (int i = 0; i < cells; ++i)
        for (int j = 0; j < cells; ++j) {
            const double to = (middle(j) - (1 - weight) * middle(i)) / weight - shift, half = cell / (2 * weight);
            chain(i, j) = below(to + half) - below(to - half);
        }
    return runLengths(chain)[cells / 2];
}

} // namespace lubberline
