#include "core/calibration/Ellipsoid.h"

#include <Eigen/Dense>
#include <algorithm>
#include <random>

#include "core/angle/Angle.h"
#include "core/base/Middle.h"
#include "core/base/Number.h"
#include "core/calibration/LogQuality.h"
#include "core/calibration/QuadricFit.h"
#include "core/calibration/SlowResidual.h"
#include "core/calibration/Spectrum.h"

namespace lubberline {

namespace {

constexpr std::size_t kSubsample = 50000; ///< of a long log: enough for a median and for a covariance
constexpr double kTrim = 4.0 * 1.4826;
constexpr double kFlat = 0.02; ///< thickness of the cloud as a part of its length: below, it is a plane or a line

std::size_t freeOf(EllipsoidShape shape) { return shape == EllipsoidShape::Sphere ? 4 : shape == EllipsoidShape::Axes ? 6 : 9; }

FieldColumns columnsOf(const SensorLog& log) { return {log.field[0], log.field[1], log.field[2]}; }

/// Evenly spread rows that are in use, at most kSubsample.
std::vector<std::size_t> someRows(const std::vector<std::uint8_t>& used, std::size_t most = kSubsample)
{
    const auto count = static_cast<std::size_t>(std::count(used.begin(), used.end(), std::uint8_t{1}));
    const std::size_t step = std::max<std::size_t>(1, (count + most - 1) / most);
    std::vector<std::size_t> rows;
    std::size_t seen = 0;
    for (std::size_t row = 0; row < used.size(); ++row)
        if (used[row] != 0 && seen++ % step == 0)
            rows.push_back(row);
    return rows;
}

/// Distance from the quadric, to first order, in the unit of the points: (|V d| − 1)/|V n|.
double distanceFrom(const Quadric& quadric, const Eigen::Vector3d& m)
{
    const Eigen::Vector3d unit = quadric.toUnit * (m - quadric.centre);
    const double size = unit.norm(), slope = (quadric.toUnit * unit).norm();
    return size > 0 && slope > 0 ? (size - 1.0) * size / slope : 1.0 / quadric.toUnit.norm();
}

struct Spread {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    double scale = 1;
    Eigen::Vector3d axes = Eigen::Vector3d::Zero(); ///< standard deviations along the principal axes, smallest first
    Eigen::Vector3d thinnest = Eigen::Vector3d::Zero();
};

Spread spreadOf(const SensorLog& log, const std::vector<std::size_t>& rows)
{
    Spread spread;
    for (const auto row : rows)
        spread.centre += log.at(row) / static_cast<double>(rows.size());
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const auto row : rows) {
        const Eigen::Vector3d off = log.at(row) - spread.centre;
        covariance += off * off.transpose() / static_cast<double>(rows.size());
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(covariance);
    spread.axes = eigen.eigenvalues().cwiseMax(0).cwiseSqrt();
    spread.thinnest = eigen.eigenvectors().col(0);
    spread.scale = std::max(spread.axes[2], 1e-300);
    return spread;
}

/// Rows far outside of where the log is on an axis: a whole spike of many fields' size would drown all else.
void dropFarRows(const SensorLog& log, std::vector<std::uint8_t>& used)
{
    const auto rows = someRows(used);
    if (rows.size() < 20)
        return;
    for (const auto& values : log.field) {
        std::vector<double> sorted;
        for (const auto row : rows)
            sorted.push_back(values[row]);
        std::sort(sorted.begin(), sorted.end());
        const double low = sorted[sorted.size() / 20], high = sorted[sorted.size() - 1 - sorted.size() / 20];
        const double margin = 1.5 * (high - low);
        for (std::size_t row = 0; row < used.size(); ++row)
            if (used[row] != 0 && (values[row] < low - margin || values[row] > high + margin))
                used[row] = 0;
    }
}

/// A sphere through four drawn points that half of the log lies nearest to: a start that no minority of bad samples can move.
std::optional<Quadric> consensusSphere(const SensorLog& log, const std::vector<std::size_t>& rows)
{
    std::mt19937 draw(12345); // the same log gives the same result
    std::optional<Quadric> best;
    double least = std::numeric_limits<double>::max();
    for (int attempt = 0; attempt < 400; ++attempt) {
        Eigen::Matrix4d system;
        Eigen::Vector4d squares;
        for (int i = 0; i < 4; ++i) {
            const Eigen::Vector3d m = log.at(rows[draw() % rows.size()]) - log.at(rows[0]);
            system.row(i) << 2.0 * m.transpose(), 1.0;
            squares[i] = m.squaredNorm();
        }
        const Eigen::Vector4d solved = system.fullPivLu().solve(squares);
        const double radius2 = solved[3] + solved.head<3>().squaredNorm();
        if (!solved.allFinite() || !(radius2 > 0))
            continue;
        Quadric sphere;
        sphere.centre = solved.head<3>() + log.at(rows[0]);
        sphere.toUnit = Eigen::Matrix3d::Identity() / std::sqrt(radius2);
        std::vector<double> away;
        for (const auto row : rows)
            away.push_back(std::abs(distanceFrom(sphere, log.at(row))));
        if (const double middle = middleOf(std::move(away)); middle < least) {
            least = middle;
            best = sphere;
        }
    }
    return best;
}

struct Trimmed {
    std::optional<Quadric> quadric;
    std::vector<std::uint8_t> used;
    double scatter = std::numeric_limits<double>::max(); ///< 1.4826 MAD of all that were offered
};

double scatterOf(const SensorLog& log, const Quadric& quadric, const std::vector<std::size_t>& rows)
{
    std::vector<double> away;
    away.reserve(rows.size());
    for (const auto row : rows)
        away.push_back(std::abs(distanceFrom(quadric, log.at(row))));
    return 1.4826 * middleOf(std::move(away));
}

/// Rows of `offered` within the trimming limit of a quadric.
std::vector<std::uint8_t> within(const SensorLog& log, const Quadric& quadric, const std::vector<std::uint8_t>& offered, double scatter)
{
    const double limit = std::max(kTrim / 1.4826 * scatter, 1e-9 / quadric.toUnit.norm());
    // (size − 1) size/slope against the limit without a division; the same as distanceFrom().
    std::vector<std::uint8_t> used(offered.size(), 0);
    const Eigen::Matrix3d v = quadric.toUnit;
    const Eigen::Vector3d c = quadric.centre;
    for (std::size_t row = 0; row < offered.size(); ++row) {
        if (offered[row] == 0)
            continue;
        const Eigen::Vector3d unit = v * (log.at(row) - c);
        const double square = unit.squaredNorm();
        used[row] = std::abs(square - std::sqrt(square)) <= limit * (v * unit).norm() ? 1 : 0;
    }
    return used;
}

Trimmed trimmedFit(const SensorLog& log, const std::vector<std::uint8_t>& offered, EllipsoidShape shape, std::optional<Quadric> start)
{
    Trimmed result;
    result.used = offered;
    const auto offeredRows = someRows(offered);
    if (start)
        result.used = within(log, *start, offered, scatterOf(log, *start, offeredRows));
    for (int round = 0; round < 5; ++round) {
        const auto rows = someRows(result.used);
        if (rows.size() <= freeOf(shape))
            return {};
        const Spread spread = spreadOf(log, rows);
        const FieldMoments moments = momentsOf(columnsOf(log), result.used, spread.centre, spread.scale);
        result.quadric = adjustedQuadric(moments, shape);
        if (!result.quadric && round == 0 && shape == EllipsoidShape::General)
            result.quadric = constrainedQuadric(moments);
        if (!result.quadric)
            return {};
        result.scatter = scatterOf(log, *result.quadric, offeredRows);
        auto next = within(log, *result.quadric, offered, result.scatter);
        if (next == result.used)
            break;
        result.used = std::move(next);
    }
    return result;
}

/// Derivatives of (|W d| − F)/|W n| by W (a, b, c, e, f, k of a symmetric matrix) and p.
Eigen::Matrix<double, 1, 9> jacobianRow(const Eigen::Matrix3d& w, const Eigen::Vector3d& d)
{
    const Eigen::Vector3d n = (w * d).normalized(), slope = w * n;
    Eigen::Matrix<double, 1, 9> row;
    row << n[0] * d[0], n[0] * d[1] + n[1] * d[0], n[0] * d[2] + n[2] * d[0], n[1] * d[1], n[1] * d[2] + n[2] * d[1], n[2] * d[2],
        -slope.transpose();
    return row / slope.norm();
}

Eigen::Matrix3d symmetricUnit(int index)
{
    constexpr std::array<std::array<int, 2>, 6> kPlaces{{{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};
    const auto [i, j] = kPlaces[static_cast<std::size_t>(index)];
    Eigen::Matrix3d unit = Eigen::Matrix3d::Zero();
    unit(i, j) = unit(j, i) = 1.0;
    return unit;
}

/// The free parameters of a shape among the six of W and three of p.
Eigen::MatrixXd freeParameters(EllipsoidShape shape)
{
    if (shape == EllipsoidShape::General)
        return Eigen::MatrixXd::Identity(9, 9);
    const bool sphere = shape == EllipsoidShape::Sphere;
    Eigen::MatrixXd free = Eigen::MatrixXd::Zero(9, sphere ? 4 : 6);
    for (int i = 0; i < 3; ++i) {
        free((std::array{0, 3, 5})[static_cast<std::size_t>(i)], sphere ? 0 : i) = 1.0;
        free(6 + i, (sphere ? 1 : 3) + i) = 1.0;
    }
    return free;
}

/// a, b, c, e, f, k of S, P, Q, R and F by the six of W and p: the way of the covariance. S = W⁻¹ − 1; without a known field W is scaled
/// to determinant 1, and F takes what it had.
Eigen::Matrix<double, 10, 9> reportedBy(const Eigen::Matrix3d& w, double field, bool fieldKnown)
{
    const Eigen::Matrix3d gain = w.inverse();
    Eigen::Matrix<double, 10, 9> by = Eigen::Matrix<double, 10, 9>::Zero();
    for (int i = 0; i < 6; ++i) {
        Eigen::Matrix3d change = symmetricUnit(i);
        if (!fieldKnown) {
            const double growth = (gain * change).trace() / 3.0;
            change -= growth * w;
            by(9, i) = -field * growth;
        }
        const Eigen::Matrix3d soft = -gain * change * gain;
        by.col(i).head<6>() << soft(0, 0), soft(0, 1), soft(0, 2), soft(1, 1), soft(1, 2), soft(2, 2);
    }
    by.block<3, 3>(6, 6).setIdentity();
    return by;
}

void describeParameters(EllipsoidFit& fit, const Eigen::Matrix<double, 10, 10>& covariance, bool fieldKnown, std::string_view unit)
{
    constexpr std::array<const char*, 9> kNames{"a", "b", "c", "e", "f", "k", "P", "Q", "R"};
    const auto& s = fit.softIron;
    const std::array<double, 9> values{
        s(0, 0), s(0, 1), s(0, 2), s(1, 1), s(1, 2), s(2, 2), fit.hardIron[0], fit.hardIron[1], fit.hardIron[2]};
    for (std::size_t i = 0; i < 9; ++i) {
        const bool diagonal = i == 0 || i == 3 || i == 5;
        if (i < 6 && !diagonal && fit.shape != EllipsoidShape::General)
            continue;
        if (i < 6 && fit.shape == EllipsoidShape::Sphere && !fieldKnown)
            continue; // a sphere's scale is its radius
        const auto at = static_cast<Eigen::Index>(i);
        fit.parameters.push_back({kNames[i], values[i], std::sqrt(std::max(0.0, covariance(at, at))), i < 6 ? "1" : std::string(unit)});
    }
    if (!fieldKnown)
        fit.parameters.push_back({"F", fit.field, std::sqrt(std::max(0.0, covariance(9, 9))), std::string(unit)});
}

EllipsoidFit fitOf(
    const SensorLog& log, const Quadric& quadric, const std::vector<std::uint8_t>& used, EllipsoidShape shape, std::optional<double> field)
{
    EllipsoidFit fit;
    fit.shape = shape;
    fit.field = field ? *field : 1.0 / std::cbrt(quadric.toUnit.determinant());
    const Eigen::Matrix3d w = fit.field * quadric.toUnit;
    fit.softIron = w.inverse() - Eigen::Matrix3d::Identity();
    fit.hardIron = quadric.centre;

    const auto rows = someRows(used);
    const auto count = static_cast<double>(std::count(used.begin(), used.end(), std::uint8_t{1}));
    const Eigen::MatrixXd free = freeParameters(shape);
    Eigen::Matrix<double, 9, 9> normal = Eigen::Matrix<double, 9, 9>::Zero();
    std::vector<Eigen::Vector3d> directions;
    std::vector<double> residuals;
    double weighted = 0, plain = 0;
    for (const auto row : rows) {
        const Eigen::Vector3d d = log.at(row) - fit.hardIron, field_ = w * d;
        const auto jacobian = jacobianRow(w, d);
        normal += jacobian.transpose() * jacobian;
        directions.push_back(field_.normalized());
        const double residual = field_.norm() - fit.field;
        residuals.push_back(residual);
        plain += residual * residual;
        const double size = residual / (w * directions.back()).norm();
        weighted += size * size;
    }
    const auto some = static_cast<double>(rows.size());
    fit.rms = std::sqrt(plain / some);
    fit.sigma = std::sqrt(weighted / std::max(1.0, some - static_cast<double>(freeOf(shape))));
    fit.coverage = coverageOf(directions);

    const Eigen::MatrixXd reduced = free.transpose() * normal * free;
    const Eigen::VectorXd scale = reduced.diagonal().cwiseSqrt().cwiseMax(1e-300);
    const Eigen::MatrixXd normalised = scale.asDiagonal().inverse() * reduced * scale.asDiagonal().inverse();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(normalised);
    const double largest = eigen.eigenvalues().maxCoeff(), smallest = std::max(eigen.eigenvalues().minCoeff(), 1e-15 * largest);
    fit.condition = std::sqrt(largest / smallest);
    fit.rank = static_cast<int>((eigen.eigenvalues().array() > 1e-12 * largest).count());
    fit.gate = fit.condition * fit.sigma / fit.field;
    const Eigen::MatrixXd inverse = scale.asDiagonal().inverse() * eigen.eigenvectors()
        * eigen.eigenvalues().cwiseMax(smallest).cwiseInverse().asDiagonal() * eigen.eigenvectors().transpose()
        * scale.asDiagonal().inverse();
    const double slow = rows.size() == static_cast<std::size_t>(count) ? slowResidualFactor(residuals) : 1.0;
    const auto by = reportedBy(w, fit.field, field.has_value());
    const Eigen::Matrix<double, 10, 10> covariance
        = fit.sigma * fit.sigma * slow * (some / count) * by * free * inverse * free.transpose() * by.transpose();
    describeParameters(fit, covariance, field.has_value(), log.figureUnit());
    return fit;
}

std::string figure(double value) { return figureText(value, std::abs(value) < 10 ? 2 : 0); }

/// Why nothing can be told of so few or such flat samples; empty where there is no such reason.
Message flatness(const SensorLog& log, const std::vector<std::size_t>& rows, EllipsoidShape shape)
{
    const std::size_t least = 2 * (freeOf(shape) + 1);
    if (rows.size() < least)
        return {MARKED("core", "%1 usable samples; expected %2 or more, in many attitudes"), rows.size(), least};
    const Spread spread = spreadOf(log, rows);
    const std::string unit(log.figureUnit());
    if (spread.axes[2] <= 1e-9 * std::max(1.0, spread.centre.norm()))
        return {MARKED("core", "all samples are equal: the sensor was not turned, or it is stuck")};
    if (spread.axes[1] < kFlat * spread.axes[2])
        return {MARKED("core", "the samples lie on a line: across it they spread by %1 %3 against %2 %3 along it; expected %4 %3 or more"),
            figure(spread.axes[1]), figure(spread.axes[2]), unit, figure(kFlat * spread.axes[2])};
    if (spread.axes[0] < kFlat * spread.axes[2])
        return {MARKED("core", "the samples lie in a plane: off it they spread by %1 %3 against %2 %3 in it; expected %4 %3 or more"),
            figure(spread.axes[0]), figure(spread.axes[2]), unit, figure(kFlat * spread.axes[2])};
    return {};
}

Message turnMore(const Coverage& coverage)
{
    return {MARKED("core", "no samples within %1° of one direction: %2"), figureText(coverage.largestGap_deg, 0), coverage.turnTo};
}

void judge(EllipsoidResult& result, const SensorLog& log, std::optional<double> field_nT)
{
    const EllipsoidFit& fit = *result.fit;
    result.verdict = fit.gate <= kGateGood ? CalibrationVerdict::Good
        : fit.gate <= kGateDetermined      ? CalibrationVerdict::Doubtful
                                           : CalibrationVerdict::NotDetermined;
    if (result.verdict != CalibrationVerdict::Good) {
        result.reasons.push_back(
            {MARKED("core", "the gate (condition × noise/field) is %1; expected %2 or less, and nothing is determined above %3"),
                figureText(fit.gate, 2), figureText(kGateGood, 1), figureText(kGateDetermined, 1)});
        result.nextSteps.push_back(turnMore(fit.coverage));
    } else if (fit.coverage.largestGap_deg > 60) {
        result.nextSteps.push_back(turnMore(fit.coverage));
    }
    const auto doubt = [&](Message why) {
        result.reasons.push_back(std::move(why));
        if (result.verdict == CalibrationVerdict::Good)
            result.verdict = CalibrationVerdict::Doubtful;
    };
    if (fit.rms > kResidualLimit * fit.field) {
        doubt(
            {MARKED("core",
                 "the field's size is off by %1 % (rms) after calibration; expected %2 % or less: it was not the same everywhere, or the sensor's scale is not of this shape"),
                figureText(100 * fit.rms / fit.field, 1), figureText(100 * kResidualLimit, 0)});
        result.nextSteps.push_back({MARKED("core", "log again away from iron, cars and cables")});
    }
    const std::size_t trimmed = result.samples - result.used;
    if (trimmed * 5 > result.samples)
        doubt(
            {MARKED("core", "%1 of %2 samples were left out as spikes or faults; expected one in five or fewer"), trimmed, result.samples});
    if (field_nT && log.unit != FieldUnit::Counts) {
        const double mean = fit.field * std::cbrt((Eigen::Matrix3d::Identity() + fit.softIron).determinant());
        const double off = mean / *field_nT - 1.0;
        if (std::abs(off) > kFieldContradiction)
            doubt(
                {MARKED("core",
                     "the log's field is %1 nT, %2 % off the %3 nT that were given; expected within %4 %: another unit, another place, or a sensor of another scale"),
                    figureText(mean, 0), signedFigureText(100 * off, 0), figureText(*field_nT, 0),
                    figureText(100 * kFieldContradiction, 0)});
        else if (std::abs(off) > 0.1)
            result.warnings.push_back({MARKED("core", "the log's field is %1 nT, %2 % off the %3 nT that were given"), figureText(mean, 0),
                signedFigureText(100 * off, 0), figureText(*field_nT, 0)});
    }
}

} // namespace

std::string_view nameOf(CalibrationVerdict verdict)
{
    return verdict == CalibrationVerdict::Good ? "good" : verdict == CalibrationVerdict::Doubtful ? "doubtful" : "not determined";
}

double residualOf(const EllipsoidFit& fit, const Eigen::Vector3d& measured)
{
    return ((Eigen::Matrix3d::Identity() + fit.softIron).inverse() * (measured - fit.hardIron)).norm() - fit.field;
}

EllipsoidResult fitEllipsoid(const SensorLog& log, EllipsoidShape shape, std::optional<double> field_nT)
{
    EllipsoidResult result;
    result.samples = log.size();
    if (log.unit == FieldUnit::Counts && field_nT) {
        result.warnings.push_back(
            {MARKED("core", "the log is in counts: the field that was given is not used, and the radius is in counts")});
        field_nT.reset();
    }
    const LogQuality quality = qualityOf(log);
    result.warnings.insert(result.warnings.end(), quality.remarks.begin(), quality.remarks.end());
    if (quality.rate_hz && log.size() > 100)
        if (Message zero = warningOfZero(*quality.rate_hz, 0.005 * *quality.rate_hz); !zero.empty())
            result.warnings.push_back(std::move(zero));
    std::vector<std::uint8_t> offered(log.size(), 0);
    for (std::size_t row = 0; row < log.size(); ++row)
        offered[row] = quality.faults[row] == SampleFault::None || quality.faults[row] == SampleFault::Repeat ? 1 : 0;
    dropFarRows(log, offered);
    const auto rows = someRows(offered);
    result.usedRows = offered;
    result.used = static_cast<std::size_t>(std::count(offered.begin(), offered.end(), std::uint8_t{1}));
    if (const Message flat = flatness(log, rows, shape); !flat.empty()) {
        if (Message why = whyFewUsable(log, quality); !why.empty())
            result.reasons.push_back(std::move(why));
        result.reasons.push_back(flat);
        result.nextSteps.push_back({MARKED("core", "turn the sensor through all attitudes, each side up once, with a full turn in each")});
        return result;
    }

    Trimmed best = trimmedFit(log, offered, shape, {});
    const double radius = best.quadric ? 1.0 / std::cbrt(best.quadric->toUnit.determinant()) : 0.0;
    if (!best.quadric || best.scatter > 0.01 * radius) {
        Trimmed other = trimmedFit(log, offered, shape, consensusSphere(log, someRows(offered, 1000)));
        if (other.quadric && (!best.quadric || other.scatter < 0.8 * best.scatter))
            best = std::move(other);
    }
    if (!best.quadric) {
        result.reasons.push_back(
            {MARKED("core", "no ellipsoid goes through the samples: too few attitudes, or a field that was not the same everywhere")});
        result.nextSteps.push_back({MARKED("core", "turn the sensor through all attitudes, each side up once, with a full turn in each")});
        return result;
    }
    result.usedRows = std::move(best.used);
    result.used = static_cast<std::size_t>(std::count(result.usedRows.begin(), result.usedRows.end(), std::uint8_t{1}));
    result.fit = fitOf(log, *best.quadric, result.usedRows, shape, field_nT);
    judge(result, log, field_nT);
    return result;
}

} // namespace lubberline
