#include "core/deviation/SerialCorrelation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Cholesky>

#include "core/base/Contract.h"

namespace lubberline {

namespace {

/// Twice the restricted log-likelihood, but for a constant, and the variance that goes with it.
struct Likelihood {
    double twiceLog = 0;
    double variance = 0;
};

/// Five coefficients and what is observed: of a size that is known beforehand, as some eighty likelihoods are asked for of 20,000 rows.
constexpr int kMostColumns = 6;
using FilterRow = Eigen::Matrix<double, kMostColumns, 1>;
using FilterRows = std::vector<FilterRow, Eigen::aligned_allocator<FilterRow>>;

/// The design's columns, then the observations; zeros beyond.
FilterRows filterRowsOf(const Eigen::MatrixXd& design, const Eigen::VectorXd& observed)
{
    LUBBERLINE_EXPECT(design.cols() < kMostColumns, "five coefficients at most");
    FilterRows rows(static_cast<std::size_t>(design.rows()), FilterRow::Zero());
    for (Eigen::Index i = 0; i < design.rows(); ++i) {
        rows[static_cast<std::size_t>(i)].head(design.cols()) = design.row(i).transpose();
        rows[static_cast<std::size_t>(i)](design.cols()) = observed(i);
    }
    return rows;
}

Likelihood likelihoodOf(const FilterRows& rows, Eigen::Index p, double rho, double white)
{
    // One filter over the observations and each column of the design; the gain is the same for all.
    FilterRow state = FilterRow::Zero();
    Eigen::Matrix<double, kMostColumns, kMostColumns> normal = Eigen::Matrix<double, kMostColumns, kMostColumns>::Zero();
    double variance = 1.0 - white, logDeterminant = 0, total = 0, logTotal = 0;
    for (const FilterRow& each : rows) {
        const FilterRow row = each - state;
        if (variance + white != total) { // soon it stays
            total = variance + white;
            logTotal = std::log(total);
        }
        normal.noalias() += row * (row / total).transpose();
        logDeterminant += logTotal;
        const double gain = variance / total;
        state = rho * (state + gain * row);
        variance = rho * rho * variance * (1.0 - gain) + (1.0 - rho * rho) * (1.0 - white);
    }
    const Eigen::MatrixXd whole = normal;
    const Eigen::LLT<Eigen::MatrixXd> solver(whole.topLeftCorner(p, p));
    const Eigen::VectorXd side = whole.col(p).head(p);
    const double squares = std::max(whole(p, p) - side.dot(solver.solve(side)), 1e-30);
    const double freedom = static_cast<double>(static_cast<Eigen::Index>(rows.size()) - p);
    const double normalDeterminant = 2.0 * solver.matrixLLT().diagonal().array().log().sum();
    return {-(freedom * std::log(squares) + logDeterminant + normalDeterminant), squares / freedom};
}

} // namespace

std::optional<SerialCorrelation> serialCorrelation(const Eigen::MatrixXd& design, const Eigen::VectorXd& observed)
{
    if (design.rows() < kLeastForSerialCorrelation)
        return std::nullopt;
    constexpr double kTwiceLogRatio = 10.6; // 0.5 % point of χ² with two degrees of freedom
    // The slow part's memory in readings, −1/ln ρ, in steps of a factor; then halved steps about the best.
    const auto rhoOf = [](double step) { return std::exp(-std::exp(-step)); };
    const FilterRows rows = filterRowsOf(design, observed);
    const auto at = [&](double step, double white) { return likelihoodOf(rows, design.cols(), rhoOf(step), white); };
    const Likelihood independent = likelihoodOf(rows, design.cols(), 0.0, 1.0);
    Likelihood best{-1e300, 0};
    double bestStep = 0, bestWhite = 0;
    const auto consider = [&](double step, double white) {
        const Likelihood here = at(step, white);
        if (here.twiceLog > best.twiceLog) {
            best = here;
            bestStep = step;
            bestWhite = white;
        }
    };
    const double longest = std::log(static_cast<double>(design.rows()) / 6.0); // a longer memory is a drift, and cannot be told from A
    for (double step = -0.5; step <= longest; step += 0.75)
        for (const double white : {0.0, 0.2, 0.5, 0.8})
            consider(step, white);
    double byStep = 0.375, byWhite = 0.1;
    for (int halving = 0; halving < 3; ++halving, byStep /= 2, byWhite /= 2) {
        const double step = bestStep, white = bestWhite;
        for (const double s : {step - byStep, step, step + byStep})
            for (const double w : {white - byWhite, white, white + byWhite})
                consider(std::min(s, longest), std::clamp(w, 0.0, 0.99));
    }
    if (best.twiceLog - independent.twiceLog < kTwiceLogRatio)
        return std::nullopt;
    return SerialCorrelation{rhoOf(bestStep), bestWhite, best.variance};
}

Eigen::MatrixXd covarianceUnder(const SerialCorrelation& errors, const Eigen::MatrixXd& design, const Eigen::MatrixXd& inverseNormal)
{
    // ΓX by running sums from both ends: Σ ρ^|i−j| x_j.
    Eigen::MatrixXd smeared = design;
    Eigen::RowVectorXd running = Eigen::RowVectorXd::Zero(design.cols());
    for (Eigen::Index i = 1; i < design.rows(); ++i) {
        running = errors.rho * (running + design.row(i - 1));
        smeared.row(i) += running;
    }
    running.setZero();
    for (Eigen::Index i = design.rows() - 2; i >= 0; --i) {
        running = errors.rho * (running + design.row(i + 1));
        smeared.row(i) += running;
    }
    const Eigen::MatrixXd middle
        = design.transpose() * ((1.0 - errors.whiteShare) * smeared + errors.whiteShare * design) * errors.variance;
    return inverseNormal * middle * inverseNormal;
}

double independentReadings(const SerialCorrelation& errors, int readings)
{
    const double squared = errors.lagOne() * errors.lagOne();
    return readings * (1.0 - squared) / (1.0 + squared);
}

} // namespace lubberline
