#include "core/inflight/ClusteredFit.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include <boost/math/distributions/fisher_f.hpp>

#include "core/algebra/Products.h"
#include "core/algebra/Solve.h"
#include "core/algebra/Spectra.h"
#include "core/base/Alongside.h"

namespace lubberline {

namespace {

using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kWindColumns, kWindColumns>;
using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kWindColumns, 1>;

/// An eigenvalue of the scaled normal matrix below is a direction that the headings do not tell: some 6° of spread about two opposite ones.
constexpr double kLeastTold = 0.01;
constexpr double kSecondOrderShare = 0.1;
constexpr int kToldInARun = 12; ///< four flights of three headings, twelve of one
constexpr std::size_t kFlightsForShared = 1500;

Small full(const WindMatrix& lower, int columns)
{
    Small matrix = lower.topLeftCorner(columns, columns);
    for (int i = 0; i < columns; ++i)
        for (int j = i + 1; j < columns; ++j)
            matrix(i, j) = matrix(j, i);
    return matrix;
}

SmallVector sharedVariance(const SharedError& shared, int columns)
{
    SmallVector variance(columns);
    for (int i = 0; i < columns; ++i)
        variance(i) = std::pow(i == 0 ? shared.offset_deg : (i < 3 ? 1.0 : kSecondOrderShare) * shared.sine_deg, 2);
    return variance;
}

/// Directions that the headings tell, as columns.
Small toldDirections(const Small& normal)
{
    const double weight = std::max(normal(0, 0), 1e-300);
    Small scaled = normal / weight;
    for (int i = 1; i < scaled.rows(); ++i) { // 1 has the mean square 1, a sine ½
        scaled.row(i) *= std::sqrt(2.0);
        scaled.col(i) *= std::sqrt(2.0);
    }
    const SymmetricParts parts = symmetricParts(scaled);
    const int columns = static_cast<int>(normal.rows());
    int left = 0;
    while (left < columns && parts.values(left) < kLeastTold)
        ++left;
    Small directions(columns, columns - left);
    for (int i = left; i < columns; ++i)
        directions.col(i - left) = parts.vectors.col(i);
    for (int i = 1; i < columns; ++i)
        directions.row(i) *= std::sqrt(2.0);
    return directions;
}

SmallVector solveIn(const Small& directions, const Small& information, const SmallVector& score)
{
    const SmallVector along = directions.transpose() * score;
    return directions * SmallVector(solvePositive(carried(directions.transpose(), information), along));
}

/// −2 log of the restricted likelihood of a run of flights with coefficients of their own.
double deviance(std::span<const FlightSums* const> run, double scatter, const SharedError& shared)
{
    constexpr int columns = 3;
    const SmallVector variance = sharedVariance(shared, columns);
    Small sum = Small::Zero(columns, columns);
    SmallVector score = SmallVector::Zero(columns);
    double value = 0;
    for (const FlightSums* flight : run) {
        const Small normal = full(flight->normal, columns) / scatter;
        const SmallVector product = flight->product.head(columns) / scatter;
        Small mixed = normal * variance.asDiagonal();
        mixed.diagonal().array() += 1.0;
        const Eigen::PartialPivLU<Small> lu(mixed);
        const Small information = lu.solve(normal);
        const SmallVector told = lu.solve(product);
        value += std::log(std::max(lu.determinant(), 1e-300)) - product.dot(variance.asDiagonal() * told);
        sum += information;
        score += told;
    }
    // Directions that the run does not tell are in no term.
    const SymmetricParts parts = symmetricParts(sum);
    const double least = 1e-9 * std::max(parts.values(columns - 1), 1e-300);
    for (int i = 0; i < columns; ++i)
        if (const double eigenvalue = parts.values(i); eigenvalue > least)
            value += std::log(eigenvalue) - std::pow(parts.vectors.col(i).dot(score), 2) / eigenvalue;
    return value;
}

} // namespace

double scatterWithin(std::span<const FlightSums* const> flights, int columns)
{
    double squares = 0, freedom = 0;
    for (const FlightSums* flight : flights) {
        const Small normal = full(flight->normal, columns);
        const SymmetricParts parts = symmetricParts(normal);
        const double least = 1e-3 * std::max(normal(0, 0), 1e-300);
        double left = flight->squares, rank = 0;
        for (int i = 0; i < columns; ++i)
            if (const double eigenvalue = parts.values(i); eigenvalue > least) {
                left -= std::pow(parts.vectors.col(i).dot(flight->product.head(columns)), 2) / eigenvalue;
                ++rank;
            }
        if (static_cast<double>(flight->count) <= rank)
            continue;
        squares += std::max(0.0, left);
        freedom += static_cast<double>(flight->count) - rank;
    }
    constexpr double kLeast_deg2 = 1e-8; // simulated without any noise
    return freedom > 0 ? std::max(kLeast_deg2, squares / freedom) : 1.0;
}

FlightTold toldByFlight(const FlightSums& sums, double scatter, const SharedError& shared, int columns)
{
    const Small normal = full(sums.normal, columns) / scatter;
    Small mixed = normal * sharedVariance(shared, columns).asDiagonal();
    mixed.diagonal().array() += 1.0;
    const Eigen::PartialPivLU<Small> lu(mixed);
    FlightTold told;
    const Small information = lu.solve(normal);
    told.information.topLeftCorner(columns, columns) = 0.5 * (information + information.transpose());
    told.score.head(columns) = lu.solve(SmallVector(sums.product.head(columns) / scatter));
    return told;
}

namespace {

struct RunOfFlights {
    std::span<const FlightSums* const> flights;
    double scatter = 0;
    int freedom = 0; ///< what its flights tell less what is common to them
};

/// Runs of flights that tell some coefficients more than a run has: many flights where each flew one heading.
std::vector<RunOfFlights> runsOf(std::span<const AircraftFlights> fleet)
{
    std::vector<RunOfFlights> runs;
    std::size_t flights = 0, turn = 0;
    for (const auto& aircraft : fleet)
        flights += aircraft.flights.size();
    const std::size_t stride = std::max<std::size_t>(1, flights / kFlightsForShared);
    const auto told = [](const WindMatrix& normal) { return static_cast<int>(toldDirections(full(normal, 3)).cols()); };
    for (const auto& aircraft : fleet) {
        const std::span<const FlightSums* const> all(aircraft.flights);
        int left = 0; // that the flights from here on tell
        for (const FlightSums* flight : all)
            left += told(flight->normal);
        for (std::size_t begin = 0; begin < all.size();) {
            std::size_t end = begin;
            int own = 0;
            WindMatrix normal = WindMatrix::Zero();
            // What would be left of too few goes with the run before.
            while (end < all.size() && (own < kToldInARun || left < kToldInARun / 2)) {
                const int one = told(all[end]->normal);
                own += one;
                left -= one;
                normal += all[end++]->normal;
            }
            if (const int freedom = own - told(normal); freedom > 0 && turn++ % stride == 0)
                runs.push_back({all.subspan(begin, end - begin), aircraft.scatter, freedom});
            begin = end;
        }
    }
    return runs;
}

} // namespace

SharedError sharedErrorOf(std::span<const AircraftFlights> fleet)
{
    const std::vector<RunOfFlights> runs = runsOf(fleet);
    SharedError best;
    if (runs.empty())
        return best;
    for (const auto& run : runs)
        best.freedom += run.freedom;
    const auto value = [&](double offset_deg, double sine_deg) {
        std::vector<double> each(runs.size());
        alongside(runs.size(), [&](std::size_t run) {
            each[run] = deviance(runs[run].flights, runs[run].scatter, {offset_deg, sine_deg, 0});
        });
        return std::accumulate(each.begin(), each.end(), 0.0); // in their order
    };
    // On a grid of ratios, finer about the best: the likelihood is smooth and has one maximum.
    constexpr double kLeast_deg = 0.003;
    double step = 4.0, least = value(0, 0);
    for (double offset = 0.01; offset < 20; offset *= step)
        for (double sine = 0.01; sine < 20; sine *= step)
            if (const double one = value(offset, sine); one < least) {
                least = one;
                best.offset_deg = offset;
                best.sine_deg = sine;
            }
    if (best.sine_deg == 0 && best.offset_deg == 0)
        return best;
    for (step = 2.0; step > 1.03; step = std::sqrt(step)) {
        const double offset = best.offset_deg, sine = best.sine_deg;
        for (const double o : {offset / step, offset, offset * step})
            for (const double s : {sine / step, sine, sine * step})
                if (const double one = value(o, s); one < least && o > kLeast_deg && s > kLeast_deg) {
                    least = one;
                    best.offset_deg = o;
                    best.sine_deg = s;
                }
    }
    return best;
}

double ClusteredFit::standardError(int column) const { return std::sqrt(std::max(0.0, covariance(column, column))); }

ClusteredFit fitFlights(std::span<const FlightTold> flights, const FlightSums& sums, int columns, bool sharedKnown)
{
    ClusteredFit fit;
    fit.columns = columns;
    fit.flights = static_cast<int>(flights.size());
    const Small directions = toldDirections(full(sums.normal, columns));
    if (directions.cols() == 0)
        return fit;
    Small information = Small::Zero(columns, columns);
    SmallVector score = SmallVector::Zero(columns);
    for (const auto& flight : flights) {
        information += flight.information.topLeftCorner(columns, columns);
        score += flight.score.head(columns);
    }
    const SmallVector value = solveIn(directions, information, score);
    fit.rank = static_cast<int>(directions.cols());
    fit.information.topLeftCorner(columns, columns) = information;
    fit.score.head(columns) = score;
    fit.directions.topLeftCorner(columns, fit.rank) = directions;
    // A coefficient is told where moving it alone is moving along the directions that are told.
    const Small onto = product(directions, pseudoInverse(directions));
    constexpr double kOwn = 0.99;
    for (int i = 0; i < columns; ++i) {
        fit.told[i] = onto(i, i) > kOwn;
        fit.value(i) = fit.told[i] ? value(i) : 0.0;
    }
    Small covariance = carried(directions, inversePositive(carried(directions.transpose(), information)));
    fit.errorsTold = sharedKnown;
    const auto count = static_cast<double>(flights.size());
    if (flights.size() > 1) {
        fit.errorsTold = true;
        Small spread = Small::Zero(columns, columns);
        for (const auto& flight : flights) {
            const SmallVector away
                = solveIn(directions, information - flight.information.topLeftCorner(columns, columns), score - flight.score.head(columns))
                - value;
            spread += away * away.transpose();
        }
        spread *= (count - 1.0) / count;
        // Of model and jackknife, for each coefficient the larger one.
        SmallVector longer(columns);
        for (int i = 0; i < columns; ++i)
            longer(i) = spread(i, i) > 0 && std::isfinite(spread(i, i)) ? std::sqrt(std::max(1.0, covariance(i, i) / spread(i, i))) : 1.0;
        if (spread.allFinite())
            covariance = longer.asDiagonal() * spread * longer.asDiagonal();
    }
    // What is not told leaks a little into what is: a usual size of it is in the error.
    constexpr double kUsual_deg = 2.0;
    covariance.diagonal() += (1.0 - onto.diagonal().array()).max(0.0).matrix() * (kUsual_deg * kUsual_deg);
    fit.covariance.topLeftCorner(columns, columns) = covariance;
    for (int i = 0; i < columns; ++i)
        if (!fit.told[i]) {
            fit.covariance.row(i).setZero();
            fit.covariance.col(i).setZero();
        }
    return fit;
}

WindRow valueWithout(const ClusteredFit& fit, const FlightTold& left)
{
    WindRow value = WindRow::Zero();
    if (fit.rank == 0)
        return value;
    const int columns = fit.columns;
    value.head(columns) = solveIn(fit.directions.topLeftCorner(columns, fit.rank),
        (fit.information - left.information).topLeftCorner(columns, columns), (fit.score - left.score).head(columns));
    for (int i = 0; i < columns; ++i)
        if (!fit.told[i])
            value(i) = 0;
    return value;
}

double chanceOfNoSecondOrder(const ClusteredFit& fit)
{
    if (fit.columns < kWindColumns || !fit.told[3] || !fit.told[4] || fit.flights < 3)
        return 1.0;
    const Eigen::Matrix2d covariance = fit.covariance.bottomRightCorner<2, 2>();
    const Eigen::Vector2d value = fit.value.tail<2>();
    const double statistic = 0.5 * value.dot(solvePositive(covariance, value).col(0));
    if (!std::isfinite(statistic) || statistic <= 0)
        return 1.0;
    return cdf(complement(boost::math::fisher_f(2, fit.flights - 1), statistic));
}

} // namespace lubberline
