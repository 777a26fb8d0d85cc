#include "core/inflight/HeadingNoise.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "core/algebra/Spectra.h"
#include "core/base/Middle.h"

namespace lubberline {

namespace {

constexpr double kSpike = 4.0, kToSigma = 1.4826; ///< 1.4826: the standard deviation of normal errors over their middle size
constexpr double kEnoughFreedom = 20;
constexpr double kNoDirection = 1e-9;    ///< of the largest: a direction that no heading tells
constexpr double kLongest = 400;         ///< innovations that the slow scale looks back on: known to 7 % of variance
constexpr std::size_t kRecent = 40;      ///< that show an air that turns rough
constexpr double kMostTurn = 16;         ///< times the scale: one innovation alone says no more
constexpr double kMiddleSquare = 0.4549; ///< of χ² with 1
constexpr double kRough = 2.2;           ///< the middle of 40 squares is as far off 1 by chance once in 300

struct Fit {
    Eigen::VectorXd left; ///< residuals over their stated deviation
    Eigen::Index rank = 0;
};

Fit fitOf(std::span<const HeadingRow> rows, const std::vector<bool>& used)
{
    const auto states = rows.front().h.size();
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(states, states);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(states);
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (used[i]) {
            information += rows[i].h * rows[i].h.transpose() / rows[i].variance;
            right += rows[i].h * (rows[i].z / rows[i].variance);
        }
    const SymmetricParts parts = symmetricParts(information);
    Eigen::VectorXd solution = Eigen::VectorXd::Zero(states);
    Fit fit{Eigen::VectorXd(static_cast<Eigen::Index>(rows.size())), 0};
    for (Eigen::Index i = 0; i < states; ++i)
        if (parts.values(i) > kNoDirection * parts.values(states - 1)) {
            ++fit.rank;
            solution += parts.vectors.col(i) * (parts.vectors.col(i).dot(right) / parts.values(i));
        }
    for (std::size_t i = 0; i < rows.size(); ++i)
        fit.left(static_cast<Eigen::Index>(i)) = (rows[i].z - rows[i].h.dot(solution)) / std::sqrt(rows[i].variance);
    return fit;
}

} // namespace

bool HeadingScatter::contradicts() const { return freedom >= kEnoughFreedom && ratio > 1.0 + 3.0 * std::sqrt(2.0 / freedom); }

double HeadingScatter::blended() const
{
    const double own = std::min(freedom, kEnoughFreedom) / kEnoughFreedom;
    return own * ratio + (1.0 - own);
}

HeadingScatter scatterOf(std::span<const HeadingRow> rows)
{
    if (rows.empty())
        return {};
    std::vector<bool> used(rows.size(), true);
    HeadingScatter scatter;
    for (int round = 0; round < 3; ++round) {
        const Fit fit = fitOf(rows, used);
        std::vector<double> sizes;
        double squares = 0;
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (used[i]) {
                const double left = fit.left(static_cast<Eigen::Index>(i));
                sizes.push_back(std::abs(left));
                squares += left * left;
            }
        scatter.freedom = std::max(0.0, static_cast<double>(sizes.size()) - static_cast<double>(fit.rank));
        if (scatter.freedom == 0)
            return {};
        scatter.ratio = squares / scatter.freedom;
        const double limit = kSpike * kToSigma * middleOf(std::move(sizes)) + 1e-9;
        for (std::size_t i = 0; i < rows.size(); ++i)
            used[i] = std::abs(fit.left(static_cast<Eigen::Index>(i))) <= limit;
    }
    return scatter;
}

void NoiseScale::take(double square)
{
    m_weight = std::min(m_weight + 1.0, kLongest);
    m_slow += (std::min(square, kMostTurn * m_slow) - m_slow) / m_weight;
    if (m_recent.size() < kRecent) {
        m_recent.push_back(square);
        m_recentSum += square;
        return;
    }
    m_recentSum += square - m_recent[m_place];
    m_recent[m_place] = square;
    m_place = (m_place + 1) % kRecent;
}

/// A change of iron lifts some innovations of the last ones, rough air all of them: their middle.
double NoiseScale::ratio() const
{
    if (m_recent.size() < kRecent || m_recentSum < kRough * m_slow * static_cast<double>(kRecent))
        return m_slow;
    const double middle = middleOf(m_recent) / kMiddleSquare;
    return middle > kRough * m_slow ? middle : m_slow;
}

} // namespace lubberline
