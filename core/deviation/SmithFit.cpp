#include "core/deviation/SmithFit.h"

#include <Eigen/LU>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <limits>
#include <map>
#include <mutex>
#include <numeric>
#include <string>

#include "core/algebra/LeastSquares.h"
#include "core/angle/Circle.h"
#include "core/base/Normal.h"
#include "core/deviation/SerialCorrelation.h"
#include "core/deviation/SmithRows.h"
#include "core/deviation/ToldCoefficients.h"

namespace lubberline {

namespace {

using Design = Eigen::MatrixXd;

constexpr double kSameHeading_deg = 1e-6; // far below any reading, far above rounding
/// Below this a residual is rounding, not reading: simulated swings must not divide noise by noise.
constexpr double kRounding_rad = 1e-9;

/// A fixed order, so that the same readings in any order give the same result to the last bit.
std::vector<std::size_t> canonicalOrder(std::span<const Observation> readings)
{
    std::vector<std::size_t> order(readings.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const auto& p = readings[a];
        const auto& q = readings[b];
        return std::pair(p.compass.degrees(), p.magnetic.degrees()) < std::pair(q.compass.degrees(), q.magnetic.degrees());
    });
    return order;
}

int distinctHeadings(std::span<const Observation> readings, const std::vector<std::size_t>& order)
{
    int distinct = 0;
    double last_deg = -1;
    const double first_deg = readings[order.front()].compass.degrees();
    for (const auto i : order) {
        const double heading_deg = readings[i].compass.degrees();
        const bool wrapped = distinct > 0 && first_deg + 360.0 - heading_deg < kSameHeading_deg;
        if (!wrapped && heading_deg - last_deg > kSameHeading_deg) {
            ++distinct;
            last_deg = heading_deg;
        }
    }
    return distinct;
}

Result<int> enoughHeadings(std::span<const Observation> readings, const std::vector<std::size_t>& order)
{
    if (readings.size() < 3)
        return Error{ErrorCode::InvalidInput,
            {MARKED_N("core", "%n reading(s) with both headings; expected at least 3 on different headings"), readings.size()}};
    const int distinct = distinctHeadings(readings, order);
    if (distinct < 3)
        return Error{ErrorCode::InvalidInput,
            {MARKED_N("core", "all %1 readings are on %n heading(s); expected at least 3 different headings"), distinct, readings.size()}};
    return distinct;
}

void fillStatistics(SmithFitReport& report)
{
    double sumOfSquares = 0;
    for (const double residual : report.residual_rad) {
        sumOfSquares += residual * residual;
        report.maxAbsResidual_rad = std::max(report.maxAbsResidual_rad, std::abs(residual));
    }
    report.rms_rad = std::sqrt(sumOfSquares / static_cast<double>(report.residual_rad.size()));
    report.degreesOfFreedom = static_cast<int>(report.residual_rad.size()) - report.parameters;
    if (report.degreesOfFreedom > 0)
        report.sigma_rad = std::sqrt(sumOfSquares / report.degreesOfFreedom);
}

/// Student quantiles are slow to compute and asked for again and again with the same few degrees of freedom.
double studentQuantile(double probability, double degreesOfFreedom)
{
    static std::mutex mutex;
    static std::map<std::pair<double, double>, double> known;
    const std::lock_guard lock(mutex);
    const auto [place, isNew] = known.try_emplace({probability, degreesOfFreedom}, 0.0);
    if (isNew)
        place->second = boost::math::quantile(boost::math::students_t(degreesOfFreedom), probability);
    return place->second;
}

/// A small matrix over the coefficients that were fitted, as one over all five.
Eigen::Matrix<double, 5, 5> overAllFive(const Eigen::MatrixXd& small, const std::vector<int>& columns)
{
    Eigen::Matrix<double, 5, 5> whole = Eigen::Matrix<double, 5, 5>::Zero();
    for (std::size_t i = 0; i < columns.size(); ++i)
        for (std::size_t j = 0; j < columns.size(); ++j)
            whole(columns[i], columns[j]) = small(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    return whole;
}

void fillUncertainty(SmithFitReport& report, const Eigen::MatrixXd& covariance, const std::vector<int>& columns, double freedom)
{
    report.covariance = overAllFive(covariance, columns);
    for (const int i : columns)
        report.standardError[static_cast<std::size_t>(i)] = std::sqrt(report.covariance(i, i));
    report.intervalFactor = studentQuantile(0.975, freedom);
}

/// Of a variance and its part that all readings share: Student's factor is for what was estimated from the scatter, not for what was stated.
double half95(const SmithFitReport& fit, double variance, double sharedVariance)
{
    const double byScatter = *fit.intervalFactor * *fit.intervalFactor * std::max(0.0, variance - sharedVariance);
    return std::sqrt(byScatter + kNormal95 * kNormal95 * sharedVariance);
}

struct SerialErrors {
    SerialCorrelation errors;
    Design design; ///< in the order of reading
};

std::optional<SerialErrors> serialErrorsOf(
    const Design& columns, const Eigen::VectorXd& observed, const std::vector<std::size_t>& order, const Progress& progress)
{
    if (columns.rows() < kLeastForSerialCorrelation)
        return std::nullopt;
    Design inOrder(columns.rows(), columns.cols());
    Eigen::VectorXd observedInOrder(observed.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        inOrder.row(static_cast<Eigen::Index>(order[i])) = columns.row(static_cast<Eigen::Index>(i));
        observedInOrder(static_cast<Eigen::Index>(order[i])) = observed(static_cast<Eigen::Index>(i));
    }
    const auto errors = serialCorrelation(inOrder, observedInOrder, progress);
    if (!errors)
        return std::nullopt;
    return SerialErrors{*errors, std::move(inOrder)};
}

template <class Fit, class MakeRow, class Predict>
Result<Fit> fit(std::span<const Observation> readings, const FitWishes& wishes, MakeRow makeRow, Predict predict)
{
    const auto order = canonicalOrder(readings);
    const auto distinct = enoughHeadings(readings, order);
    if (!distinct)
        return distinct.error();
    Fit report;
    report.index_rad = toRadians(largeIndex_deg(readings));
    const auto n = static_cast<Eigen::Index>(readings.size());
    Design design(n, 5);
    Eigen::VectorXd observed(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const SmithRow row = makeRow(readings[order[static_cast<std::size_t>(i)]], toDegrees(report.index_rad));
        design.row(i) = Eigen::Map<const Eigen::Matrix<double, 1, 5>>(row.x.data());
        observed(i) = row.y;
    }
    const ToldCoefficients told = toldBy(design, *distinct);
    report.parameters = static_cast<int>(told.columns.size());
    report.rank = told.rank;
    report.conditionNumber = told.conditionNumber;
    if (!report.fitted())
        return report;

    const Design columns = design(Eigen::all, told.columns);
    const LeastSquares solved = solveLeastSquares(columns, observed);
    for (std::size_t i = 0; i < told.columns.size(); ++i)
        report.value[static_cast<std::size_t>(told.columns[i])] = solved.solution(static_cast<Eigen::Index>(i));
    report.residual_rad.resize(readings.size());
    report.leverage.resize(readings.size());
    // The memory of errors is looked for in rows without them: readings that are close together differ by their errors alone, and what stands on
    // both sides of the equation would pass for something that drifts.
    Design smooth(n, columns.cols());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto& reading = readings[order[i]];
        const Deviation fitted = predict(report, reading);
        report.residual_rad[order[i]]
            = Deviation::fromDegrees(deviationOf(reading.magnetic, reading.compass).degrees() - fitted.degrees()).radians();
        report.leverage[order[i]] = solved.leverage(static_cast<Eigen::Index>(i));
        const auto fittedCompass = CompassHeading::fromDegrees(wrap360(reading.magnetic.degrees() - fitted.degrees()));
        const SmithRow row = makeRow({reading.magnetic, fittedCompass}, toDegrees(report.index_rad));
        smooth.row(static_cast<Eigen::Index>(i)) = Eigen::Map<const Eigen::Matrix<double, 1, 5>>(row.x.data())(told.columns);
    }
    fillStatistics(report);
    report.unitCovariance = overAllFive(solved.inverseNormal, told.columns);
    if (!report.sigma_rad || !wishes.uncertainty)
        return report;
    const Eigen::VectorXd leftOver = observed - columns * solved.solution;
    if (const auto serial = serialErrorsOf(smooth, leftOver, order, wishes.progress)) {
        report.lagOneCorrelation = serial->errors.lagOne();
        const double freedom = independentReadings(serial->errors, static_cast<int>(n)) - report.parameters;
        fillUncertainty(
            report, covarianceUnder(serial->errors, serial->design, solved.inverseNormal), told.columns, std::max(1.0, freedom));
    } else {
        const double scatter_rad = std::max(*report.sigma_rad, kLeastScatter_rad);
        fillUncertainty(report, solved.inverseNormal * (scatter_rad * scatter_rad), told.columns, report.degreesOfFreedom);
    }
    return report;
}

} // namespace

ApproximateSmith ApproximateFit::smith() const
{
    return {value[0].value_or(0), value[1].value_or(0), value[2].value_or(0), value[3].value_or(0), value[4].value_or(0), index_rad};
}

ExactSmith ExactFit::smith() const
{
    return {value[0].value_or(0), value[1].value_or(0), value[2].value_or(0), value[3].value_or(0), value[4].value_or(0)};
}

std::optional<double> SmithFitReport::interval95(Coefficient c) const
{
    const auto& error = standardError[indexOf(c)];
    if (!error || !intervalFactor)
        return std::nullopt;
    return half95(*this, *error * *error, shared[indexOf(c)] * shared[indexOf(c)]);
}

Deviation deviationAt(const ExactFit& fit, MagneticHeading magnetic)
{
    return Deviation::fromDegrees(deviationAt(fit.smith(), magnetic).degrees() + toDegrees(fit.index_rad));
}

double largeIndex_deg(std::span<const Observation> readings)
{
    std::vector<double> deviations_deg;
    for (const auto& reading : readings)
        deviations_deg.push_back(deviationOf(reading.magnetic, reading.compass).degrees());
    const CircularMean mean = circularMean(deviations_deg);
    // Deviations all round the circle have no middle.
    return mean.togetherness > 0.5 && std::abs(mean.mean_deg) > kLargeIndex_deg ? std::round(mean.mean_deg) : 0.0;
}

void widenTo(SmithFitReport& fit, double error_rad)
{
    if (!fit.fitted() || error_rad <= 0.0 || (fit.sigma_rad && *fit.sigma_rad >= error_rad))
        return;
    if (!fit.sigma_rad) { // as many coefficients as readings: the reading error is all that is known
        fit.covariance = fit.unitCovariance * (error_rad * error_rad);
    } else {
        const double factor = error_rad / std::max(*fit.sigma_rad, kLeastScatter_rad);
        fit.covariance *= factor * factor;
        fit.intervalFactor = std::max(*fit.intervalFactor / factor, kNormal95); // a reading error is known, not estimated
    }
    for (std::size_t i = 0; i < kCoefficientCount; ++i)
        if (fit.value[i])
            fit.standardError[i] = std::sqrt(fit.covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)));
}

void addShared(SmithFitReport& fit, const std::array<double, kCoefficientCount>& errors_rad)
{
    for (std::size_t i = 0; i < kCoefficientCount; ++i) {
        if (!fit.standardError[i])
            continue;
        const auto place = static_cast<Eigen::Index>(i);
        fit.covariance(place, place) += errors_rad[i] * errors_rad[i];
        fit.shared[i] = std::hypot(fit.shared[i], errors_rad[i]);
        fit.standardError[i] = std::sqrt(fit.covariance(place, place));
    }
}

Result<ApproximateFit> fitApproximate(std::span<const Observation> readings, const FitWishes& wishes)
{
    return fit<ApproximateFit>(readings, wishes, approximateRow,
        [](const ApproximateFit& found, const Observation& reading) { return deviationAt(found.smith(), reading.compass); });
}

Result<ExactFit> fitExact(std::span<const Observation> readings, const FitWishes& wishes)
{
    return fit<ExactFit>(
        readings, wishes, exactRow, [](const ExactFit& found, const Observation& reading) { return deviationAt(found, reading.magnetic); });
}

std::optional<double> bandHalfWidth_rad(const ApproximateFit& fit, CompassHeading compass)
{
    if (!fit.intervalFactor)
        return std::nullopt;
    const SmithRow row = approximateRow({MagneticHeading{}, compass}, toDegrees(fit.index_rad));
    const auto x = Eigen::Map<const Eigen::Matrix<double, 5, 1>>(row.x.data());
    const double variance = x.dot(fit.covariance * x); // rows without a value are zero
    const double shared = (x.array() * Eigen::Map<const Eigen::Array<double, 5, 1>>(fit.shared.data())).square().sum();
    const double width_rad = half95(fit, std::max(0.0, variance), shared);
    return width_rad < kPi ? std::optional(width_rad) : std::nullopt; // half a turn either way is every heading
}

std::vector<std::optional<double>> studentisedResiduals(const SmithFitReport& fit)
{
    std::vector<std::optional<double>> studentised(fit.residual_rad.size());
    const int others = fit.degreesOfFreedom - 1;
    if (!fit.sigma_rad || others < 1)
        return studentised;
    const double sumOfSquares = *fit.sigma_rad * *fit.sigma_rad * fit.degreesOfFreedom;
    for (std::size_t i = 0; i < studentised.size(); ++i) {
        const double residual = fit.residual_rad[i], free = 1.0 - fit.leverage[i];
        if (free < 1e-9) // the fit goes through this reading whatever it says
            continue;
        const double variance = std::max((sumOfSquares - residual * residual / free) / others, kRounding_rad * kRounding_rad);
        studentised[i] = residual / std::sqrt(variance * free);
    }
    return studentised;
}

double deletedResidual_rad(const SmithFitReport& fit, std::size_t reading)
{
    LUBBERLINE_EXPECT(reading < fit.residual_rad.size() && fit.leverage[reading] < 1.0, "the others fit a curve without this reading");
    return fit.residual_rad[reading] / (1.0 - fit.leverage[reading]);
}

} // namespace lubberline
