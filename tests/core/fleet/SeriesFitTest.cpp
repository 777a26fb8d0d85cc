// What is filtered figure by figure against the same by the whole covariance, inverted.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <vector>

#include "core/fleet/FleetRandom.h"
#include "core/fleet/FleetSwings.h"
#include "core/fleet/SeriesFit.h"

using namespace lubberline;

namespace {

/// Generalised least squares of columns: restricted likelihood, last coefficient and its variance.
struct Solved {
    double logLikelihood, last, variance;
};
Solved solved(const Eigen::MatrixXd& covariance, const Eigen::MatrixXd& columns, const Eigen::VectorXd& values)
{
    const Eigen::MatrixXd weight = covariance.inverse(), information = columns.transpose() * weight * columns;
    const Eigen::VectorXd found = information.ldlt().solve(columns.transpose() * weight * values), left = values - columns * found;
    return {-0.5 * (std::log(covariance.determinant()) + std::log(information.determinant()) + left.dot(weight * left)),
        found[found.size() - 1], information.inverse()(found.size() - 1, found.size() - 1)};
}

struct Case {
    std::vector<DatedValue> series;
    ScatterSize size;
    std::vector<std::size_t> at;
};

Case drawn(FleetRandom& random)
{
    Case one;
    const int n = 4 + static_cast<int>(random.unit() * 9);
    int day = 12000;
    for (int i = 0; i < n; ++i) {
        one.series.push_back({day, 3 * random.normal(), 0.02 + random.unit(), i > 0 && random.unit() < 0.1, 0.5 + random.unit()});
        day += random.unit() < 0.1 ? 0 : 30 + static_cast<int>(random.unit() * 900);
    }
    one.size = {random.unit() < 0.3 ? 0.0 : random.unit(), random.unit() < 0.3 ? 0.0 : random.unit()};
    if (random.unit() < 0.3)
        one.at.push_back(1 + static_cast<std::size_t>(random.unit() * (n - 1)));
    return one;
}

} // namespace

TEST(SeriesFit, isWhatTheWholeCovarianceGives)
{
    FleetRandom random(11);
    int places = 0, trends = 0;
    for (int round = 0; round < 300; ++round) {
        const auto [series, size, at] = drawn(random);
        const auto n = static_cast<Eigen::Index>(series.size());
        Eigen::MatrixXd covariance(n, n), columns = Eigen::MatrixXd::Ones(n, 1);
        Eigen::VectorXd values(n), years(n);
        const auto add = [&](const Eigen::VectorXd& column) {
            columns.conservativeResize(Eigen::NoChange, columns.cols() + 1);
            columns.rightCols(1) = column;
        };
        const auto stepAt = [n](std::size_t place) {
            Eigen::VectorXd step = Eigen::VectorXd::Ones(n);
            step.head(static_cast<Eigen::Index>(place)).setZero();
            return step;
        };
        for (std::size_t i = 0; i < series.size(); ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            values[row] = series[i].value;
            years[row] = (series[i].day - series.front().day) / kDaysPerYear;
            for (std::size_t j = 0; j < series.size(); ++j) {
                const double since = (std::min(series[i].day, series[j].day) - series.front().day) / kDaysPerYear;
                covariance(row, static_cast<Eigen::Index>(j))
                    = size.wander_deg2_year * since + (i == j ? series[i].variance + series[i].swingShare * size.swing_deg2 : 0.0);
            }
            if (series[i].corrected || std::ranges::find(at, i) != at.end())
                add(stepAt(i));
        }
        const bool trend = round % 2 == 0;
        const SeriesFit fit = fitSeries(series, size, trend, at);
        if (trend && fit.perYear) {
            add(years);
            const Solved known = solved(covariance, columns, values);
            EXPECT_NEAR(*fit.perYear, known.last, 1e-8 * (1 + std::abs(known.last)));
            EXPECT_NEAR(fit.perYearError, std::sqrt(known.variance), 1e-8 * std::sqrt(known.variance));
            ++trends;
        }
        EXPECT_EQ(fit.freedom, n - columns.cols());
        EXPECT_NEAR(fit.logLikelihood, solved(covariance, columns, values).logLikelihood, 1e-8);
        const Eigen::MatrixXd null = columns;
        for (const auto& place : fit.places) {
            columns = null;
            add(stepAt(place.place));
            const Solved known = solved(covariance, columns, values);
            EXPECT_NEAR(place.length2 * known.variance, 1.0, 1e-6);
            EXPECT_NEAR(place.statistic, known.last / std::sqrt(known.variance), 1e-6 * (1 + std::abs(place.statistic)));
            ++places;
        }
    }
    EXPECT_GT(places, 1500);
    EXPECT_GT(trends, 100);
}

/// A step where nothing is left for it: one difference beside a trend, one that is known, figures of one day.
TEST(SeriesFit, asksNoPlaceThatCannotBeTold)
{
    const std::vector<DatedValue> two{{0, 1, 1}, {365, 2, 1}};
    EXPECT_TRUE(fitSeries(two, {}, true, {}).places.empty());
    EXPECT_EQ(fitSeries(two, {}, false, {}).places.size(), 1u);
    const std::vector<DatedValue> three{{0, 1, 1}, {365, 2, 1}, {365, 2, 1}};
    const std::vector<std::size_t> known{1};
    EXPECT_TRUE(fitSeries(three, {}, false, known).places.empty());
    EXPECT_FALSE(fitSeries(three, {}, true, known).perYear);
    EXPECT_EQ(fitSeries(three, {}, false, known).freedom, 1);
    EXPECT_TRUE(fitSeries({}, {}, true, {}).places.empty());
    // Figures without any error are held against one another all the same.
    const std::vector<DatedValue> exact{{0, 1, 0}, {365, 1, 0}, {730, 1, 0}, {1095, 3, 0}};
    const auto fit = fitSeries(exact, {}, false, {});
    ASSERT_EQ(fit.places.size(), 3u);
    EXPECT_GT(std::abs(fit.places[2].statistic), 1e6);
    EXPECT_TRUE(std::isfinite(fit.logLikelihood));
}
