#include "core/swing/SharedDoubts.h"

#include <Eigen/Core>
#include <cmath>

#include "core/algebra/Solve.h"
#include "core/base/Contract.h"
#include "core/deviation/ToldCoefficients.h"

namespace lubberline {

namespace {

/// A record says no more figures than the doubt has.
double rounded(double error_deg) { return std::round(error_deg * 1e4) / 1e4; }

} // namespace

SharedErrors sharedErrorsOf(std::span<const CompassHeading> readings, std::span<const SharedDoubt> doubts)
{
    const auto rows = static_cast<Eigen::Index>(readings.size()), columns = static_cast<Eigen::Index>(doubts.size());
    SharedErrors shared;
    if (rows < 3 || columns == 0)
        return shared;
    Eigen::MatrixXd design(rows, 5), turned(rows, columns);
    for (Eigen::Index row = 0; row < rows; ++row) {
        const double heading = readings[static_cast<std::size_t>(row)].radians();
        design.row(row) << 1.0, std::sin(heading), std::cos(heading), std::sin(2.0 * heading), std::cos(2.0 * heading);
    }
    for (Eigen::Index column = 0; column < columns; ++column) {
        const SharedDoubt& doubt = doubts[static_cast<std::size_t>(column)];
        LUBBERLINE_EXPECT(doubt.size() == readings.size(), "a doubt says what it adds to each reading");
        turned.col(column) = Eigen::Map<const Eigen::VectorXd>(doubt.data(), rows);
    }
    const ToldCoefficients told = toldBy(design, static_cast<int>(rows));
    if (told.columns.empty())
        return shared;
    // The exact coefficients are the approximate ones to the first order, and a doubt is no better known than that.
    const Eigen::MatrixXd shifts = pivotedSolve(design(Eigen::all, told.columns), turned).solution;
    for (std::size_t i = 0; i < told.columns.size(); ++i)
        shared.of_deg[static_cast<std::size_t>(told.columns[i])] = rounded(shifts.row(static_cast<Eigen::Index>(i)).norm());
    return shared;
}

} // namespace lubberline
