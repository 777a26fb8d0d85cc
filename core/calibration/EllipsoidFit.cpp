#include <Eigen/LU>
#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>

#include "core/algebra/Products.h"
#include "core/algebra/Spectra.h"
#include "core/base/Number.h"
#include "core/calibration/ChangeInTime.h"
#include "core/calibration/EllipsoidParts.h"

namespace lubberline {

namespace {

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

/// P, Q, R and the gain along the nine of W and p: m = (1 + gain) W⁻¹ B + p.
Eigen::MatrixXd ironAndGain(const Eigen::Matrix3d& w)
{
    Eigen::MatrixXd steps = Eigen::MatrixXd::Zero(9, 4);
    steps.block<3, 3>(6, 0).setIdentity();
    steps.col(3).head<6>() << -w(0, 0), -w(0, 1), -w(0, 2), -w(1, 1), -w(1, 2), -w(2, 2);
    return steps;
}

/// Of a … R and F in the ten: what a change of iron and gain is of them.
Eigen::Matrix<double, 10, 1> alongReported(const ChangeInTime& change, const EllipsoidFit& fit, bool fieldKnown)
{
    Eigen::Matrix<double, 10, 1> along = Eigen::Matrix<double, 10, 1>::Zero();
    along.segment<3>(6) = change.hardIron;
    const Eigen::Matrix3d soft = (Eigen::Matrix3d::Identity() + fit.softIron) * change.gain;
    if (fieldKnown)
        along.head<6>() << soft(0, 0), soft(0, 1), soft(0, 2), soft(1, 1), soft(1, 2), soft(2, 2);
    else
        along(9) = fit.field * change.gain;
    return along * change.worse();
}

constexpr int kCellsOfAnEdge = 4; ///< of a face of the cube that directions are sorted on: 96 cells
constexpr double kFewestOfACell = 5, kFewestCells = 20;
constexpr double kChanceOfDirection = 1e-4;

std::size_t cellOf(const Eigen::Vector3d& direction)
{
    Eigen::Index face = 0;
    const double most = std::max(direction.cwiseAbs().maxCoeff(&face), 1e-300);
    const auto place = [&](Eigen::Index axis) {
        const double along = direction[axis] / most; // −1 … 1
        return std::clamp(static_cast<int>(kCellsOfAnEdge * (along + 1) / 2), 0, kCellsOfAnEdge - 1);
    };
    const int side = 2 * static_cast<int>(face) + (direction[face] < 0 ? 1 : 0);
    return static_cast<std::size_t>((side * kCellsOfAnEdge + place((face + 1) % 3)) * kCellsOfAnEdge + place((face + 2) % 3));
}

/// What of the residuals goes with the direction of the field: their means in cells of directions against their scatter inside (F test).
WithDirection withDirection(const std::vector<Eigen::Vector3d>& directions, const std::vector<double>& residuals, std::size_t free)
{
    struct Cell {
        double count = 0, sum = 0, squares = 0;
    };
    std::array<Cell, 6 * kCellsOfAnEdge * kCellsOfAnEdge> cells{};
    for (std::size_t i = 0; i < residuals.size(); ++i) {
        Cell& cell = cells[cellOf(directions[i])];
        cell.count += 1;
        cell.sum += residuals[i];
        cell.squares += residuals[i] * residuals[i];
    }
    double between = 0, within = 0, count = 0, seen = 0;
    for (const Cell& cell : cells)
        if (cell.count >= kFewestOfACell) {
            between += cell.sum * cell.sum / cell.count;
            within += cell.squares - cell.sum * cell.sum / cell.count;
            count += cell.count;
            seen += 1;
        }
    const double asked = seen - static_cast<double>(free), rest = count - seen;
    if (seen < kFewestCells || asked < 1 || !(within > 0))
        return {};
    const double ratio = between / asked / (within / rest);
    if (ratio <= quantile(complement(boost::math::fisher_f(asked, rest), kChanceOfDirection)))
        return {};
    return {std::sqrt(std::max(0.0, between - asked * within / rest) / count), ratio};
}

} // namespace

std::size_t freeOf(EllipsoidShape shape) { return shape == EllipsoidShape::Sphere ? 4 : shape == EllipsoidShape::Axes ? 6 : 9; }

std::vector<std::size_t> someRows(const std::vector<std::uint8_t>& used, std::size_t most)
{
    const auto count = static_cast<std::size_t>(std::count(used.begin(), used.end(), std::uint8_t{1}));
    const std::size_t step = std::max<std::size_t>(1, (count + most - 1) / most);
    std::vector<std::size_t> rows;
    rows.reserve(count / step + 1);
    if (count == used.size()) {
        for (std::size_t row = 0; row < count; row += step)
            rows.push_back(row);
        return rows;
    }
    std::size_t seen = 0, next = 0;
    for (std::size_t row = 0; row < used.size(); ++row)
        if (used[row] != 0 && seen++ == next) {
            rows.push_back(row);
            next += step;
        }
    return rows;
}

FieldSamples samplesOf(const SensorLog& log, const std::vector<std::size_t>& rows)
{
    FieldSamples samples;
    samples.reserve(rows.size());
    for (const auto row : rows)
        samples.push_back(log.at(row));
    return samples;
}

Spread spreadOf(const FieldSamples& samples)
{
    Spread spread;
    const auto count = static_cast<double>(samples.size());
    for (const auto& sample : samples)
        spread.centre += sample;
    spread.centre /= count;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const auto& sample : samples) {
        const Eigen::Vector3d off = sample - spread.centre;
        covariance += off * off.transpose();
    }
    const SymmetricParts parts = symmetricParts(covariance / count);
    spread.axes = parts.values.cwiseMax(0).cwiseSqrt();
    spread.thinnest = parts.vectors.col(0);
    spread.scale = std::max(spread.axes[2], 1e-300);
    return spread;
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
    std::array<Eigen::Matrix<double, 9, 9>, kTimeBlocks> normals;
    std::array<Eigen::Matrix<double, 9, 1>, kTimeBlocks> scores;
    normals.fill(Eigen::Matrix<double, 9, 9>::Zero());
    scores.fill(Eigen::Matrix<double, 9, 1>::Zero());
    std::vector<Eigen::Vector3d> directions;
    std::vector<double> residuals;
    directions.reserve(rows.size());
    residuals.reserve(rows.size());
    double weighted = 0, plain = 0;
    for (const auto row : rows) {
        const Eigen::Vector3d d = log.at(row) - fit.hardIron, field_ = w * d;
        const auto jacobian = jacobianRow(w, d);
        const std::size_t block = timeBlockOf(row, log.size());
        normals[block] += jacobian.transpose() * jacobian;
        directions.push_back(field_.normalized());
        const double residual = field_.norm() - fit.field;
        residuals.push_back(residual);
        plain += residual * residual;
        const double size = residual / (w * directions.back()).norm();
        weighted += size * size;
        scores[block] -= jacobian.transpose() * size; // what the parameters should have been more there
    }
    Eigen::Matrix<double, 9, 9> normal = Eigen::Matrix<double, 9, 9>::Zero();
    TimeBlocks blocks;
    for (std::size_t i = 0; i < kTimeBlocks; ++i) {
        normal += normals[i];
        blocks[i] = {normals[i], scores[i]};
    }
    const auto some = static_cast<double>(rows.size());
    fit.rms = std::sqrt(plain / some);
    fit.sigma = std::sqrt(weighted / std::max(1.0, some - static_cast<double>(freeOf(shape))));
    fit.coverage = coverageOf(directions);

    const Eigen::MatrixXd reduced = carried(free.transpose(), normal);
    const Eigen::VectorXd scale = reduced.diagonal().cwiseSqrt().cwiseMax(1e-300);
    const Eigen::MatrixXd normalised = scale.asDiagonal().inverse() * reduced * scale.asDiagonal().inverse();
    const SymmetricParts parts = symmetricParts(normalised);
    const double largest = parts.values.maxCoeff(), smallest = std::max(parts.values.minCoeff(), 1e-15 * largest);
    fit.condition = std::sqrt(largest / smallest);
    fit.rank = static_cast<int>((parts.values.array() > 1e-12 * largest).count());
    fit.gate = fit.condition * fit.sigma / fit.field;
    const Eigen::MatrixXd inverse = composed(scale.asDiagonal().inverse() * parts.vectors, parts.values.cwiseMax(smallest).cwiseInverse());
    const bool whole = rows.size() == static_cast<std::size_t>(count);
    fit.slow = whole ? slowResidualFactor(residuals) : 1.0;
    fit.structured = withDirection(directions, residuals, freeOf(shape));
    fit.slow = std::max(fit.slow, fit.structured.ratio); // what neighbours in direction share is no independent witness either
    const auto by = reportedBy(w, fit.field, field.has_value());
    Eigen::Matrix<double, 10, 10> covariance = fit.sigma * fit.sigma * fit.slow * (some / count) * carried(by, carried(free, inverse));
    if (auto change = changeInTime(blocks, free, {ironAndGain(w)}, fit.sigma * fit.sigma)) {
        // Neighbours that resemble each other without it too make it less sure.
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (change->isAfter(rows[i], log.size()))
                residuals[i] -= directions[i].dot(w * change->hardIron) + fit.field * change->gain;
        change->widen(std::sqrt(whole ? slowResidualFactor(residuals) : 1.0));
        fit.changed = wordsOf(*change, log, fit.field);
        if (!fit.changed.empty()) {
            const auto along = alongReported(*change, fit, field.has_value());
            covariance += along * along.transpose();
        }
    }
    describeParameters(fit, covariance, field.has_value(), log.figureUnit());
    constexpr std::array<int, kUncertainParameters> kFrom{0, 1, 2, 1, 3, 4, 2, 4, 5, 6, 7, 8}; // of a … R in the ten
    for (int i = 0; i < kUncertainParameters; ++i)
        for (int j = 0; j < kUncertainParameters; ++j)
            fit.uncertainty.covariance(i, j) = covariance(kFrom[static_cast<std::size_t>(i)], kFrom[static_cast<std::size_t>(j)]);
    return fit;
}

} // namespace lubberline
