#include "core/deviation/SmithFit.h"

#include <Eigen/LU>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <limits>
#include <map>
#include <mutex>
#include <numeric>
#include <string>

#include "core/deviation/LeastSquares.h"

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

/// What distinguishes the two fits: a row of the design matrix and its right-hand side.
struct Row {
    std::array<double, kCoefficientCount> x;
    double y;
};

Row approximateRow(const Observation& reading)
{
    const double s1 = std::sin(reading.compass.radians()), c1 = std::cos(reading.compass.radians());
    return {{1, s1, c1, 2 * s1 * c1, c1 * c1 - s1 * s1}, deviationOf(reading.magnetic, reading.compass).radians()};
}

Row exactRow(const Observation& reading)
{
    const double z = reading.compass.radians(), sum = reading.magnetic.radians() + z;
    const double deviation = deviationOf(reading.magnetic, reading.compass).radians();
    return {{std::cos(deviation), std::sin(z), std::cos(z), std::sin(sum), std::cos(sum)}, std::sin(deviation)};
}

/// Five, three or no parameters: the most that the headings can tell.
/// A condition number of 20 means that a reading error can be blown up some five to ten times in a coefficient: half a circle
/// of readings (15) is just accepted for all five, a quarter (16) for A, B and C.
int parametersFor(const Design& design, int distinct, SmithFitReport& report)
{
    const auto n = design.rows();
    const Eigen::VectorXd sigma = singularValues(n >= 5 ? design : Design(design.transpose()));
    const double tolerance = sigma(0) * std::numeric_limits<double>::epsilon() * static_cast<double>(std::max<Eigen::Index>(n, 5));
    report.rank = static_cast<int>((sigma.array() > tolerance).count());
    report.conditionNumber = n >= 5 ? conditionNumber(sigma) : std::numeric_limits<double>::max();
    if (distinct >= 5 && report.conditionNumber <= kConditionLimit)
        return 5;
    const double three = conditionNumber(singularValues(design.leftCols(3)));
    if (three <= kConditionLimit) {
        report.conditionNumber = three;
        return 3;
    }
    // What is reported must be a number.
    report.conditionNumber = std::min(report.conditionNumber, std::numeric_limits<double>::max());
    return 0;
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

void fillUncertainty(SmithFitReport& report, const Eigen::MatrixXd& inverseNormal)
{
    if (!report.sigma_rad)
        return;
    const auto p = report.parameters;
    const double scatter_rad = std::max(*report.sigma_rad, kLeastScatter_rad);
    report.covariance.topLeftCorner(p, p) = inverseNormal * (scatter_rad * scatter_rad);
    for (int i = 0; i < p; ++i)
        report.standardError[static_cast<std::size_t>(i)] = std::sqrt(report.covariance(i, i));
}

template <class Fit, class MakeRow, class Predict>
Result<Fit> fit(std::span<const Observation> readings, MakeRow makeRow, Predict predict)
{
    const auto order = canonicalOrder(readings);
    const auto distinct = enoughHeadings(readings, order);
    if (!distinct)
        return distinct.error();
    const auto n = static_cast<Eigen::Index>(readings.size());
    Design design(n, 5);
    Eigen::VectorXd observed(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const Row row = makeRow(readings[order[static_cast<std::size_t>(i)]]);
        design.row(i) = Eigen::Map<const Eigen::Matrix<double, 1, 5>>(row.x.data());
        observed(i) = row.y;
    }
    Fit report;
    report.parameters = parametersFor(design, *distinct, report);
    if (!report.fitted())
        return report;

    const LeastSquares solved = solveLeastSquares(design.leftCols(report.parameters), observed);
    for (int i = 0; i < report.parameters; ++i)
        report.value[static_cast<std::size_t>(i)] = solved.solution(i);
    report.residual_rad.resize(readings.size());
    report.leverage.resize(readings.size());
    const auto smith = report.smith();
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto& reading = readings[order[i]];
        const Deviation fitted = predict(smith, reading);
        report.residual_rad[order[i]]
            = Deviation::fromDegrees(deviationOf(reading.magnetic, reading.compass).degrees() - fitted.degrees()).radians();
        report.leverage[order[i]] = solved.leverage(static_cast<Eigen::Index>(i));
    }
    fillStatistics(report);
    fillUncertainty(report, solved.inverseNormal);
    return report;
}

/// Student quantiles are slow to compute and asked for again and again with the same few degrees of freedom.
double studentQuantile(double probability, int degreesOfFreedom)
{
    static std::mutex mutex;
    static std::map<std::pair<double, int>, double> known;
    const std::lock_guard lock(mutex);
    const auto [place, isNew] = known.try_emplace({probability, degreesOfFreedom}, 0.0);
    if (isNew)
        place->second = boost::math::quantile(boost::math::students_t(degreesOfFreedom), probability);
    return place->second;
}

} // namespace

ApproximateSmith ApproximateFit::smith() const
{
    return {value[0].value_or(0), value[1].value_or(0), value[2].value_or(0), value[3].value_or(0), value[4].value_or(0)};
}

ExactSmith ExactFit::smith() const
{
    return {value[0].value_or(0), value[1].value_or(0), value[2].value_or(0), value[3].value_or(0), value[4].value_or(0)};
}

Result<ApproximateFit> fitApproximate(std::span<const Observation> readings)
{
    return fit<ApproximateFit>(readings, approximateRow,
        [](const ApproximateSmith& smith, const Observation& reading) { return deviationAt(smith, reading.compass); });
}

Result<ExactFit> fitExact(std::span<const Observation> readings)
{
    return fit<ExactFit>(
        readings, exactRow, [](const ExactSmith& smith, const Observation& reading) { return deviationAt(smith, reading.magnetic); });
}

std::optional<double> bandHalfWidth_rad(const ApproximateFit& fit, CompassHeading compass)
{
    if (!fit.sigma_rad)
        return std::nullopt;
    const Row row = approximateRow({MagneticHeading{}, compass});
    const auto x = Eigen::Map<const Eigen::Matrix<double, 5, 1>>(row.x.data());
    const double variance = x.dot(fit.covariance * x); // rows without a value are zero
    return studentQuantile(0.975, fit.degreesOfFreedom) * std::sqrt(std::max(0.0, variance));
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

double suspectThreshold(int readings, int degreesOfFreedom)
{
    constexpr double kFalseAlarmsPerSwing = 0.10;
    if (degreesOfFreedom < 2)
        return std::numeric_limits<double>::max();
    return studentQuantile(1.0 - kFalseAlarmsPerSwing / (2.0 * readings), degreesOfFreedom - 1);
}

} // namespace lubberline
