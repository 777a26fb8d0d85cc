#include "core/inflight/WindChange.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>

#include "core/algebra/Products.h"
#include "core/algebra/Solve.h"
#include "core/algebra/Spectra.h"
#include "core/base/VectorClones.h"
#include "core/fleet/FleetRandom.h"
#include "core/inflight/Ziggurat.h"

namespace lubberline {

namespace {

using Told = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;
constexpr int kSimulated = 999, kEnough = 20;

/// L with L Lᵀ = A, of A that tells not all directions, too: what it does not tell comes out as a column of zeros.
Eigen::Matrix3d rootOf(const Eigen::Matrix3d& a)
{
    Eigen::Matrix3d root = Eigen::Matrix3d::Zero();
    for (Eigen::Index j = 0; j < 3; ++j) {
        double pivot = a(j, j);
        for (Eigen::Index k = 0; k < j; ++k)
            pivot -= root(j, k) * root(j, k);
        if (!(pivot > 1e-12 * a(j, j)))
            continue;
        root(j, j) = std::sqrt(pivot);
        for (Eigen::Index i = j + 1; i < 3; ++i) {
            double rest = a(i, j);
            for (Eigen::Index k = 0; k < j; ++k)
                rest -= root(i, k) * root(j, k);
            root(i, j) = rest / root(j, j);
        }
    }
    return root;
}

/// Flights in the directions that are told; what others there are is zero: three always, for which products are written out.
struct ChangeSeries {
    int rank = 0;
    std::vector<Eigen::Matrix3d> information;
    std::vector<Eigen::Vector3d> score;
    std::vector<Eigen::Matrix3d> within; ///< of each place: (W)⁻¹, W = M₁ − M₁ M⁻¹ M₁
    std::vector<Eigen::Matrix3d> before; ///< M₁ M⁻¹
    std::vector<bool> possible;

    /// The largest statistic, and its place.
    [[nodiscard]] std::pair<double, std::size_t> largest(const std::vector<Eigen::Vector3d>& scores) const
    {
        Eigen::Vector3d all = Eigen::Vector3d::Zero(), sum = all;
        for (const auto& one : scores)
            all += one;
        std::pair<double, std::size_t> best{-1.0, 0};
        for (std::size_t k = 0; k + 1 < scores.size(); ++k) {
            sum += scores[k];
            if (!possible[k])
                continue;
            const Eigen::Vector3d away = sum - before[k] * all;
            if (const double statistic = away.dot(within[k] * away); statistic > best.first)
                best = {statistic, k};
        }
        return best;
    }
};

Eigen::Matrix3d padded(const Told& told)
{
    Eigen::Matrix3d whole = Eigen::Matrix3d::Zero();
    whole.topLeftCorner(told.rows(), told.cols()) = told;
    return whole;
}

ChangeSeries changeSeriesOf(std::span<const FlightTold> flights, const ClusteredFit& fit)
{
    ChangeSeries series;
    series.rank = fit.rank;
    const Told u = fit.directions.topLeftCorner(3, fit.rank);
    std::vector<Told> information;
    Told all = Told::Zero(fit.rank, fit.rank);
    for (const auto& flight : flights) {
        information.push_back(carried(u.transpose(), flight.information.topLeftCorner<3, 3>()));
        series.information.push_back(padded(information.back()));
        series.score.push_back(Eigen::Vector3d::Zero());
        series.score.back().head(fit.rank) = u.transpose() * flight.score.head<3>();
        all += information.back();
    }
    Told sum = Told::Zero(fit.rank, fit.rank);
    for (std::size_t k = 0; k + 1 < flights.size(); ++k) {
        sum += information[k];
        const Told share = solvePositive(all, sum).transpose(); // M₁ M⁻¹
        const Told w = sum - share * sum;
        const SymmetricParts own = symmetricParts(w);
        // Both sides have to tell all directions, if badly.
        const bool possible = own.values(0) > 1e-6 * own.values(fit.rank - 1);
        series.possible.push_back(possible);
        series.before.push_back(padded(share));
        series.within.push_back(
            possible ? padded(composed(own.vectors, own.values.cwiseInverse())) : Eigen::Matrix3d(Eigen::Matrix3d::Zero()));
    }
    return series;
}

double tailOf(double statistic, int rank, double freedom)
{
    if (freedom > 0)
        return cdf(complement(boost::math::fisher_f(rank, freedom), statistic / rank));
    return cdf(complement(boost::math::chi_squared(rank), statistic));
}

constexpr std::size_t kAbreast = 8;
using Abreast = std::array<double, kAbreast>; ///< a figure of each of some draws
using AbreastScore = std::array<Abreast, 3>;

/// ChangeSeries::largest() of some draws at once.
LUBBERLINE_VECTOR_CLONES void largestAbreast(const ChangeSeries& series, const AbreastScore* scores, std::size_t count, Abreast& best)
{
    AbreastScore all{}, sum{};
    for (std::size_t k = 0; k < count; ++k)
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t d = 0; d < kAbreast; ++d)
                all[i][d] += scores[k][i][d];
    best.fill(-1.0);
    for (std::size_t k = 0; k + 1 < count; ++k) {
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t d = 0; d < kAbreast; ++d)
                sum[i][d] += scores[k][i][d];
        if (!series.possible[k])
            continue;
        const double *const b = series.before[k].data(), *const w = series.within[k].data(); // a column after the other
        for (std::size_t d = 0; d < kAbreast; ++d) {
            const double x = sum[0][d] - (b[0] * all[0][d] + b[3] * all[1][d] + b[6] * all[2][d]);
            const double y = sum[1][d] - (b[1] * all[0][d] + b[4] * all[1][d] + b[7] * all[2][d]);
            const double z = sum[2][d] - (b[2] * all[0][d] + b[5] * all[1][d] + b[8] * all[2][d]);
            const double statistic = w[0] * x * x + w[4] * y * y + w[8] * z * z + 2.0 * (w[1] * x * y + w[2] * x * z + w[5] * y * z);
            best[d] = statistic > best[d] ? statistic : best[d];
        }
    }
}

void drawScores(const std::vector<Eigen::Matrix3d>& roots, int rank, FleetRandom& random, std::vector<AbreastScore>& scores)
{
    static const Ziggurat normal;
    for (std::size_t f = 0; f < roots.size(); ++f) {
        const Eigen::Matrix3d& root = roots[f];
        for (std::size_t d = 0; d < kAbreast; ++d) {
            const double x = normal(random), y = rank > 1 ? normal(random) : 0.0, z = rank > 2 ? normal(random) : 0.0;
            scores[f][0][d] = root(0, 0) * x;
            scores[f][1][d] = root(1, 0) * x + root(1, 1) * y;
            scores[f][2][d] = root(2, 0) * x + root(2, 1) * y + root(2, 2) * z;
        }
    }
}

/// Share of series without a change whose largest statistic is as large. Where that is no rare thing it is told by few of them: drawing
/// ends with the twentieth (Besag and Clifford 1991).
double simulatedChance(const ChangeSeries& series, double statistic, double freedom)
{
    ContentSeed seed;
    for (const auto& information : series.information)
        seed.add(information(0, 0));
    FleetRandom random(seed.value());
    std::vector<AbreastScore> scores(series.score.size());
    std::vector<Eigen::Matrix3d> roots(scores.size());
    std::transform(series.information.begin(), series.information.end(), roots.begin(), rootOf);
    int beyond = 0;
    Abreast largest{};
    for (int draw = 0; draw < kSimulated; ++draw) {
        const auto place = static_cast<std::size_t>(draw) % kAbreast;
        if (place == 0) {
            drawScores(roots, series.rank, random, scores);
            largestAbreast(series, scores.data(), scores.size(), largest);
        }
        const double scale = freedom > 0 ? random.chiSquare(std::max(1, static_cast<int>(freedom))) / freedom : 1.0;
        if (largest[place] >= statistic * scale)
            ++beyond;
        if (beyond == kEnough)
            return static_cast<double>(kEnough) / (draw + 1.0);
    }
    return (beyond + 1.0) / (kSimulated + 1.0);
}

} // namespace

std::optional<WindChange> largestChange(std::span<const FlightTold> flights, const ClusteredFit& fit, double freedom)
{
    if (flights.size() < 3 || fit.rank == 0 || fit.columns != 3)
        return {};
    const ChangeSeries series = changeSeriesOf(flights, fit);
    const auto places = std::count(series.possible.begin(), series.possible.end(), true);
    const auto [statistic, after] = series.largest(series.score);
    if (places == 0 || statistic <= 0)
        return {};
    WindChange change;
    change.after = after;
    change.p = std::min(1.0, static_cast<double>(places) * tailOf(statistic, series.rank, freedom));
    if (places > 1 && change.p < 0.7)
        change.p = std::min(change.p, simulatedChance(series, statistic, freedom));
    Eigen::Vector3d sum = Eigen::Vector3d::Zero(), all = sum;
    for (std::size_t f = 0; f < flights.size(); ++f) {
        all += series.score[f];
        if (f <= after)
            sum += series.score[f];
    }
    // S − M₁M⁻¹S_all = −W Δ
    const Eigen::Vector3d step = -(series.within[after] * (sum - series.before[after] * all));
    change.step_deg.head<3>() = fit.directions.topLeftCorner(3, series.rank) * step.head(series.rank);
    for (int i = 0; i < 3; ++i)
        if (!fit.told[i])
            change.step_deg(i) = 0;
    return change;
}

} // namespace lubberline
