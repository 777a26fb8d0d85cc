#include "core/deviation/SerialCorrelation.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "core/algebra/Cholesky.h"
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
    const Eigen::MatrixXd factor = choleskyFactor(whole.topLeftCorner(p, p));
    const Eigen::VectorXd half = whitened(factor, whole.col(p).head(p));
    const double squares = std::max(whole(p, p) - half.squaredNorm(), 1e-30);
    const double freedom = static_cast<double>(static_cast<Eigen::Index>(rows.size()) - p);
    const double normalDeterminant = 2.0 * factor.diagonal().array().log().sum();
    return {-(freedom * std::log(squares) + logDeterminant + normalDeterminant), squares / freedom};
}

/// The errors that may be: memories of the slow part, and how much is white.
class PossibleErrors {
public:
    explicit PossibleErrors(Eigen::Index readings)
        : m_memories(static_cast<int>((std::log(kLongest * static_cast<double>(readings)) - kFirst) / kByStep) + 1)
    {
    }
    [[nodiscard]] int count() const { return m_memories * kWhites; }
    [[nodiscard]] double logMemory(int place) const { return kFirst + kByStep * (place / kWhites); } ///< of −1/ln ρ, in readings
    [[nodiscard]] double white(int place) const { return kWhite[static_cast<std::size_t>(place % kWhites)]; }

private:
    static constexpr double kFirst = -0.5, kByStep = 0.6;
    static constexpr double kLongest = 0.5; ///< of the log; a longer memory is a drift, and cannot be told from A
    static constexpr std::array kWhite{0.0, 0.005, 0.015, 0.04, 0.1, 0.3, 0.6, 0.85, 0.95, 0.985};
    static constexpr int kWhites = static_cast<int>(kWhite.size());
    int m_memories;
};

double rhoOf(double logMemory) { return std::exp(-std::exp(-logMemory)); }

} // namespace

std::optional<SerialCorrelation> serialCorrelation(const Eigen::MatrixXd& design, const Eigen::VectorXd& observed, const Progress& progress)
{
    if (design.rows() < kLeastForSerialCorrelation)
        return std::nullopt;
    constexpr double kTwiceLogRatio = 10.6; // 0.5 % point of χ² with two degrees of freedom
    const FilterRows rows = filterRowsOf(design, observed);
    const Likelihood independent = likelihoodOf(rows, design.cols(), 0.0, 1.0);
    const PossibleErrors possible(design.rows());
    std::vector<Likelihood> likelihoods;
    double highest = independent.twiceLog;
    for (int place = 0; place < possible.count(); ++place) {
        if (progress && !progress(static_cast<double>(place) / possible.count()))
            return std::nullopt;
        likelihoods.push_back(likelihoodOf(rows, design.cols(), rhoOf(possible.logMemory(place)), possible.white(place)));
        highest = std::max(highest, likelihoods.back().twiceLog);
    }
    if (highest - independent.twiceLog < kTwiceLogRatio)
        return std::nullopt;
    // Found by simulation: memories are a little less likely beforehand the longer they are.
    constexpr double kSlower = 0.4;
    // The likeliest memory of a log of a few memories' length is too short, most of the time, and so would be its errors: the middle of
    // those that may be is not.
    double weights = 0, logMemory = 0, white = 0, logVariance = 0;
    for (int place = 0; place < possible.count(); ++place) {
        const Likelihood& one = likelihoods[static_cast<std::size_t>(place)];
        const double weight = std::exp(0.5 * (one.twiceLog - highest) - kSlower * possible.logMemory(place));
        weights += weight;
        logMemory += weight * possible.logMemory(place);
        white += weight * possible.white(place);
        logVariance += weight * std::log(one.variance);
    }
    return SerialCorrelation{rhoOf(logMemory / weights), white / weights, std::exp(logVariance / weights)};
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
