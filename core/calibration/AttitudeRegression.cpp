#include "core/calibration/AttitudeRegression.h"

#include <Eigen/LU>

#include "core/algebra/Products.h"
#include "core/algebra/Solve.h"
#include "core/algebra/Spectra.h"
#include "core/angle/Angle.h"
#include "core/sensor/Attitude.h"

namespace lubberline {

namespace {

/// An eigenvalue below this part of the largest is the rounding of a computer.
constexpr double kNullPart = 1e-10;

/// Gauss–Jordan: each direction begins with a regressor of its own, so that it names few.
std::vector<Eigen::VectorXd> reducedDirections(Eigen::MatrixXd rows)
{
    std::vector<Eigen::VectorXd> directions;
    Eigen::Index done = 0;
    for (Eigen::Index column = 0; column < rows.cols() && done < rows.rows(); ++column) {
        Eigen::Index best = 0;
        if (rows.col(column).tail(rows.rows() - done).cwiseAbs().maxCoeff(&best) < 1e-3)
            continue;
        rows.row(done).swap(rows.row(done + best));
        rows.row(done) /= rows(done, column);
        for (Eigen::Index other = 0; other < rows.rows(); ++other)
            if (other != done)
                rows.row(other) -= rows(other, column) * rows.row(done);
        ++done;
    }
    for (Eigen::Index i = 0; i < done; ++i)
        directions.emplace_back(rows.row(i).transpose());
    return directions;
}

} // namespace

Eigen::Vector3d fieldOfRow(const SensorLog& log, std::size_t row, const MeridianField& field, const AngleReading& reading)
{
    const double pitch = log.pitch_deg[row] * reading.tiltFactor, roll = log.roll_deg[row] * reading.tiltFactor;
    const Attitude attitude{MagneticHeading::fromDegrees(log.heading_deg[row] * reading.headingFactor + reading.headingOffset_deg),
        toRadians(reading.pitchSign * (reading.swapped ? roll : pitch)), toRadians(reading.rollSign * (reading.swapped ? pitch : roll))};
    return fieldInBody(field, attitude);
}

std::vector<double> currentScales(const SensorLog& log)
{
    std::vector<double> scales;
    for (const auto& current : log.currents) {
        double largest = 0;
        for (const double value : current.values)
            if (std::isfinite(value))
                largest = std::max(largest, std::abs(value));
        scales.push_back(largest > 0 ? largest : 1.0);
    }
    return scales;
}

void addRow(RegressionMoments& moments, const SensorLog& log, std::size_t row, const MeridianField& field,
    const std::vector<double>& scales, const AngleReading& reading)
{
    const auto size = static_cast<Eigen::Index>(4 + scales.size());
    if (moments.rows == 0) {
        moments.design = Eigen::MatrixXd::Zero(size, size);
        moments.across = Eigen::MatrixXd::Zero(size, 3);
    }
    const double total = field.total_nT();
    Eigen::VectorXd x(size);
    x.head<3>() = fieldOfRow(log, row, field, reading) / total;
    x[3] = 1.0;
    for (std::size_t k = 0; k < scales.size(); ++k)
        x[static_cast<Eigen::Index>(4 + k)] = log.currents[k].values[row] / scales[k];
    const Eigen::Vector3d m = log.at(row) / total;
    moments.design.noalias() += x * x.transpose();
    moments.across.noalias() += x * m.transpose();
    moments.own.noalias() += m * m.transpose();
    moments.rows += 1;
}

RegressionMoments without(RegressionMoments all, const RegressionMoments& part)
{
    all.design -= part.design;
    all.across -= part.across;
    all.own -= part.own;
    all.rows -= part.rows;
    return all;
}

Regression regress(const RegressionMoments& moments, double attitudeError_rad)
{
    const double s2 = attitudeError_rad * attitudeError_rad;
    const Eigen::Index size = moments.design.rows();
    Eigen::MatrixXd design = moments.design / moments.rows;
    Eigen::MatrixXd across = moments.across / moments.rows;
    // As the regressors are of size 1, F² is 1 here.
    design.topLeftCorner<3, 3>() = (design.topLeftCorner<3, 3>() - s2 * Eigen::Matrix3d::Identity()) / (1.0 - 3.0 * s2);
    design.topRightCorner(3, size - 3) /= 1.0 - s2;
    design.bottomLeftCorner(size - 3, 3) /= 1.0 - s2;
    across.topRows<3>() /= 1.0 - s2;

    Regression result;
    const SymmetricParts parts = symmetricParts(design);
    const double largest = parts.values.maxCoeff();
    // What moves the field in body axes by less than the attitude's own error is drowned in it.
    const double limit = std::max(kNullPart * largest, s2);
    const auto nulls = static_cast<Eigen::Index>((parts.values.array() < limit).count());
    result.null = reducedDirections(parts.vectors.leftCols(nulls).transpose());
    result.told.assign(static_cast<std::size_t>(size), true);
    auto& kept = result.kept;
    std::vector<bool> pivot(static_cast<std::size_t>(size), false);
    for (const auto& direction : result.null) {
        bool first = true;
        for (Eigen::Index i = 0; i < size; ++i)
            if (std::abs(direction[i]) > 1e-2) {
                result.told[static_cast<std::size_t>(i)] = false;
                if (first)
                    pivot[static_cast<std::size_t>(i)] = true;
                first = false;
            }
    }
    for (Eigen::Index i = 0; i < size; ++i)
        if (!pivot[static_cast<std::size_t>(i)])
            kept.push_back(i);

    const Eigen::MatrixXd reduced = design(kept, kept);
    Eigen::MatrixXd wanted = across;
    wanted -= design.leftCols<3>(); // of m − B: what is not told is then no iron
    const Eigen::MatrixXd solved = solvePositive(reduced, wanted(kept, Eigen::all)), inverse = inversePositive(reduced);
    result.solution = Eigen::MatrixXd::Zero(size, 3);
    result.covariance = Eigen::MatrixXd::Zero(size, size);
    for (std::size_t i = 0; i < kept.size(); ++i) {
        result.solution.row(kept[i]) = solved.row(static_cast<Eigen::Index>(i));
        for (std::size_t j = 0; j < kept.size(); ++j)
            result.covariance(kept[i], kept[j]) = inverse(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) / moments.rows;
    }
    const Eigen::VectorXd scale = reduced.diagonal().cwiseSqrt();
    const Eigen::VectorXd told = symmetricValues(scale.asDiagonal().inverse() * reduced * scale.asDiagonal().inverse());
    result.condition = std::sqrt(told.maxCoeff() / std::max(told.minCoeff(), 1e-300));

    // Residuals of what was read against what was stated, by the moments as they are.
    Eigen::MatrixXd all = result.solution;
    all.topRows<3>() += Eigen::Matrix3d::Identity();
    const Eigen::Matrix3d rest = moments.own - product(all.transpose(), moments.across) - product(moments.across.transpose(), all)
        + carried(all.transpose(), moments.design);
    result.variance = std::max(0.0, rest.trace() / 3.0) / std::max(1.0, moments.rows - static_cast<double>(kept.size()));
    return result;
}

} // namespace lubberline
