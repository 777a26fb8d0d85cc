#include "core/calibration/DipoleSource.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/algebra/Products.h"
#include "core/algebra/Solve.h"
#include "core/base/Number.h"

namespace lubberline {

namespace {

constexpr double kMu0Over4Pi_nT = 100.0; ///< T·m/A times 10⁹ nT/T
constexpr std::size_t kFewestReadings = 5;

/// Field of unit moments along x, y and z.
Eigen::Matrix3d fieldOfUnits(const Eigen::Vector3d& from_m)
{
    const double d = std::max(from_m.norm(), 1e-6);
    const Eigen::Vector3d n = from_m / d;
    return kMu0Over4Pi_nT / (d * d * d) * (3 * n * n.transpose() - Eigen::Matrix3d::Identity());
}

struct LinearPart {
    Eigen::Matrix<double, 6, 1> value = Eigen::Matrix<double, 6, 1>::Zero(); ///< moment, uniform field
    Eigen::VectorXd residual;
    [[nodiscard]] double squares() const { return residual.squaredNorm(); }
};

Eigen::MatrixXd designAt(std::span<const StrayReading> readings, const Eigen::Vector3d& at_m)
{
    Eigen::MatrixXd design(static_cast<Eigen::Index>(3 * readings.size()), 6);
    for (std::size_t i = 0; i < readings.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(3 * i);
        design.block<3, 3>(row, 0) = fieldOfUnits(readings[i].at_m - at_m);
        design.block<3, 3>(row, 3) = Eigen::Matrix3d::Identity();
    }
    return design;
}

LinearPart solveAt(std::span<const StrayReading> readings, const Eigen::VectorXd& fields, const Eigen::Vector3d& at_m)
{
    const Eigen::MatrixXd design = designAt(readings, at_m);
    // Columns of one length: a moment of one A·m² far away is little beside a nanotesla.
    const Eigen::VectorXd scale = design.colwise().norm().transpose().cwiseMax(1e-30);
    LinearPart part;
    part.value = pivotedSolve(design * scale.cwiseInverse().asDiagonal(), fields).solution.col(0).cwiseQuotient(scale);
    part.residual = fields - design * part.value;
    return part;
}

struct Placed {
    Eigen::Vector3d at_m;
    LinearPart part;
};

Eigen::MatrixXd slopeAt(std::span<const StrayReading> readings, const Eigen::VectorXd& fields, const Placed& placed, double step_m)
{
    Eigen::MatrixXd slope(fields.size(), 3);
    for (int axis = 0; axis < 3; ++axis) {
        Eigen::Vector3d moved = placed.at_m;
        moved[axis] += step_m;
        slope.col(axis) = (solveAt(readings, fields, moved).residual - placed.part.residual) / step_m;
    }
    return slope;
}

Placed descendFrom(std::span<const StrayReading> readings, const Eigen::VectorXd& fields, const Eigen::Vector3d& begin_m, double size_m)
{
    Placed now{begin_m, solveAt(readings, fields, begin_m)};
    double damping = 1e-2;
    constexpr int kMostSteps = 60;
    for (int step = 0; step < kMostSteps && damping < 1e8; ++step) {
        const Eigen::MatrixXd slope = slopeAt(readings, fields, now, 1e-5 * size_m);
        Eigen::Matrix3d normal = product(slope.transpose(), slope);
        normal.diagonal() *= 1 + damping;
        normal.diagonal().array() += 1e-30;
        const Eigen::Vector3d tried = now.at_m - solvePositive(normal, slope.transpose() * now.part.residual);
        LinearPart there = solveAt(readings, fields, tried);
        if (!(there.squares() < now.part.squares())) {
            damping *= 10;
            continue;
        }
        const bool settled = now.part.squares() - there.squares() < 1e-14 * now.part.squares();
        now = {tried, std::move(there)};
        damping = std::max(damping / 10, 1e-12);
        if (settled)
            break;
    }
    return now;
}

double nearestTo(std::span<const StrayReading> readings, const Eigen::Vector3d& at_m)
{
    double nearest = std::numeric_limits<double>::max();
    for (const StrayReading& reading : readings)
        nearest = std::min(nearest, (reading.at_m - at_m).norm());
    return nearest;
}

Result<void> checkReadings(std::span<const StrayReading> readings)
{
    if (readings.size() < kFewestReadings)
        return Error{ErrorCode::InvalidInput,
            {MARKED("core", "%1 readings; expected %2 or more: a place, a moment and a uniform field are nine unknown figures"),
                readings.size(), kFewestReadings}};
    for (std::size_t i = 0; i < readings.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (readings[i].at_m == readings[k].at_m)
                return Error{ErrorCode::InvalidInput,
                    {MARKED("core", "readings %1 and %2 are at one place; expected each somewhere else"), k + 1, i + 1}};
    return {};
}

} // namespace

Eigen::Vector3d DipoleSource::fieldAt_nT(const Eigen::Vector3d& place_m) const { return fieldOfUnits(place_m - at_m) * moment_A_m2; }

Result<DipoleSource> locateDipole(std::span<const StrayReading> readings, double length_m)
{
    if (const auto fine = checkReadings(readings); !fine)
        return fine.error();
    Eigen::VectorXd fields(static_cast<Eigen::Index>(3 * readings.size()));
    Eigen::Vector3d low = readings.front().at_m, high = low, mean = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < readings.size(); ++i) {
        fields.segment<3>(static_cast<Eigen::Index>(3 * i)) = readings[i].field_nT;
        low = low.cwiseMin(readings[i].at_m);
        high = high.cwiseMax(readings[i].at_m);
        mean += readings[i].field_nT / static_cast<double>(readings.size());
    }
    const double size_m = std::max((high - low).norm(), 1e-3);
    double without = 0; // squares that a uniform field alone leaves
    for (const StrayReading& reading : readings)
        without += (reading.field_nT - mean).squaredNorm();
    std::optional<Placed> best;
    constexpr std::array kParts{-0.6, -0.2, 0.2, 0.6};
    for (const double x : kParts)
        for (const double y : kParts)
            for (const double z : kParts) {
                const Eigen::Vector3d begin = (low + high) / 2 + size_m * Eigen::Vector3d(x, y, z);
                if (nearestTo(readings, begin) < 1e-3 * size_m)
                    continue;
                Placed placed = descendFrom(readings, fields, begin, size_m);
                if (!best || placed.part.squares() < best->part.squares())
                    best = std::move(placed);
            }
    const double freedom = static_cast<double>(fields.size()) - 9;
    if (!best || !(best->part.squares() < 0.5 * without))
        return Error{ErrorCode::Numeric,
            MARKED(
                "core", "no dipole explains the readings: the field hardly changes from place to place, or there is more than one source")};
    DipoleSource source;
    source.at_m = best->at_m;
    source.moment_A_m2 = best->part.value.head<3>();
    source.uniform_nT = best->part.value.tail<3>();
    source.rms_nT = std::sqrt(best->part.squares() / freedom);
    source.nearest_m = nearestTo(readings, source.at_m);
    const Eigen::MatrixXd design = designAt(readings, source.at_m);
    Eigen::MatrixXd whole(fields.size(), 9);
    whole << slopeAt(readings, fields, *best, 1e-5 * size_m), design;
    const Eigen::VectorXd scale = whole.colwise().norm().transpose().cwiseMax(1e-30);
    const Eigen::MatrixXd scaled = whole * scale.cwiseInverse().asDiagonal();
    const Eigen::MatrixXd inverse = pseudoInverse(product(scaled.transpose(), scaled));
    const auto errorOf = [&](Eigen::Index i) { return source.rms_nT * std::sqrt(std::max(0.0, inverse(i, i))) / scale[i]; };
    source.atError_m = {errorOf(0), errorOf(1), errorOf(2)};
    source.momentError_A_m2 = std::hypot(errorOf(3), errorOf(4), errorOf(5));
    if (length_m > 0 && source.nearest_m < 3 * length_m)
        source.warnings.push_back(
            {MARKED("core", "the nearest reading is %1 m from the source, less than three of its lengths (%2 m): it is no dipole there"),
                figureText(source.nearest_m, 2), figureText(3 * length_m, 2)});
    if (source.atError_m.norm() > 0.5 * source.nearest_m)
        source.warnings.push_back({MARKED("core", "the place is sure to %1 m only: read nearer to it, and on more sides"),
            figureText(source.atError_m.norm(), 2)});
    return source;
}

std::span<const InstallationDistance> installationDistances()
{
    static constexpr std::array<InstallationDistance, 6> kDistances{
        {{MARKED("core", "electric motors and relays, magnets, loudspeakers"), 3.0},
            {MARKED("core", "ferrous parts of more than 1 kg"), 2.5}, {MARKED("core", "ferrous parts of less than 1 kg"), 1.0},
            {MARKED("core", "wires of more than 100 mA"), 1.0}, {MARKED("core", "wires of less than 100 mA"), 0.6},
            {MARKED("core", "another flux gate"), 0.6}}};
    return kDistances;
}

} // namespace lubberline
