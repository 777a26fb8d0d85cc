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

/// The slow part's memory in readings, −1/ln ρ, as its logarithm.
double rhoOf(double step) { return std::exp(-std::exp(-step)); }

/// A point of the grid.
struct SerialPlace {
    int memory = 0; ///< steps of the slow part's memory
    int white = 0;  ///< steps of the white share
};

/// Looks for the likeliest memory and white share: over a grid, then in halved steps about the best.
class SerialSearch {
public:
    SerialSearch(const FilterRows& rows, Eigen::Index columns, const Progress& progress)
        : m_rows(rows)
        , m_columns(columns)
        , m_progress(progress)
        , m_longest(std::log(static_cast<double>(rows.size()) / 6.0)) // a longer memory is a drift, and cannot be told from A
        , m_memories(static_cast<int>((m_longest - kFirst) / kByStep) + 1)
        , m_grid(static_cast<std::size_t>(m_memories) * kWhite.size())
    {
    }

    [[nodiscard]] bool stopped() const { return m_stopped; }

    [[nodiscard]] SerialPlace likeliestOfAll()
    {
        SerialPlace best;
        for (SerialPlace at; at.memory < m_memories; ++at.memory)
            for (at.white = 0; at.white < static_cast<int>(kWhite.size()); ++at.white)
                if (on(at).twiceLog > on(best).twiceLog)
                    best = at;
        return best;
    }

    /// @return twice the logarithm of the likelihood there, and the errors.
    [[nodiscard]] std::pair<double, SerialCorrelation> refined(SerialPlace place)
    {
        Likelihood best = on(place);
        double bestStep = stepOf(place.memory), bestWhite = kWhite[static_cast<std::size_t>(place.white)];
        double byStep = kByStep / 2, byWhite = 0.1;
        for (int halving = 0; halving < 3; ++halving, byStep /= 2, byWhite /= 2) {
            const double step = bestStep, white = bestWhite;
            for (const double s : {step - byStep, step, step + byStep})
                for (const double w : {white - byWhite, white, white + byWhite}) {
                    if (s == step && w == white)
                        continue;
                    const double memory = std::min(s, m_longest), share = std::clamp(w, 0.0, 0.99);
                    const Likelihood here = likelihoodAt(memory, share);
                    if (here.twiceLog > best.twiceLog) {
                        best = here;
                        bestStep = memory;
                        bestWhite = share;
                    }
                }
        }
        return {best.twiceLog, SerialCorrelation{rhoOf(bestStep), bestWhite, best.variance}};
    }

private:
    static constexpr double kFirst = -0.5, kByStep = 0.75;
    static constexpr std::array kWhite{0.0, 0.2, 0.5, 0.8};
    static double stepOf(int memory) { return kFirst + kByStep * memory; }

    const Likelihood& on(SerialPlace place)
    {
        auto& known = m_grid[static_cast<std::size_t>(place.memory) * kWhite.size() + static_cast<std::size_t>(place.white)];
        if (!known)
            known = likelihoodAt(stepOf(place.memory), kWhite[static_cast<std::size_t>(place.white)]);
        return *known;
    }

    /// Each takes its time of a log: progress is told, and asked, here.
    Likelihood likelihoodAt(double step, double white)
    {
        const double most = static_cast<double>(m_grid.size()) + 3 * 8;
        m_stopped = m_stopped || (m_progress && !m_progress(std::min(1.0, ++m_asked / most)));
        return m_stopped ? Likelihood{} : likelihoodOf(m_rows, m_columns, rhoOf(step), white);
    }

    const FilterRows& m_rows;
    Eigen::Index m_columns;
    const Progress& m_progress;
    int m_asked = 0;
    bool m_stopped = false;
    double m_longest;
    int m_memories;
    std::vector<std::optional<Likelihood>> m_grid;
};

} // namespace

std::optional<SerialCorrelation> serialCorrelation(const Eigen::MatrixXd& design, const Eigen::VectorXd& observed, const Progress& progress)
{
    if (design.rows() < kLeastForSerialCorrelation)
        return std::nullopt;
    constexpr double kTwiceLogRatio = 10.6; // 0.5 % point of χ² with two degrees of freedom
    const FilterRows rows = filterRowsOf(design, observed);
    const Likelihood independent = likelihoodOf(rows, design.cols(), 0.0, 1.0);
    SerialSearch search(rows, design.cols(), progress);
    const auto [twiceLog, errors] = search.refined(search.likeliestOfAll());
    return search.stopped() || twiceLog - independent.twiceLog < kTwiceLogRatio ? std::nullopt : std::optional(errors);
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
