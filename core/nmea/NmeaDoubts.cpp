#include "core/nmea/NmeaDoubts.h"

#include <Eigen/Core>
#include <cmath>

#include "core/algebra/Solve.h"
#include "core/deviation/ToldCoefficients.h"

namespace lubberline {

namespace {

/// A record says no more figures than the doubt has.
double rounded(double error_deg) { return std::round(error_deg * 1e4) / 1e4; }

} // namespace

SharedErrors sharedErrorsOf(const NmeaSwing& swing)
{
    const auto readings = static_cast<Eigen::Index>(swing.used), doubts = static_cast<Eigen::Index>(swing.doubts.size());
    SharedErrors shared;
    if (readings < 3 || doubts == 0)
        return shared;
    Eigen::MatrixXd design(readings, 5), turned(readings, doubts);
    Eigen::Index row = 0;
    for (const auto& pair : swing.pairs) {
        if (!pair.used)
            continue;
        const double heading = pair.compass.radians();
        design.row(row) << 1.0, std::sin(heading), std::cos(heading), std::sin(2.0 * heading), std::cos(2.0 * heading);
        for (Eigen::Index doubt = 0; doubt < doubts; ++doubt)
            turned(row, doubt) = swing.doubts[static_cast<std::size_t>(doubt)][static_cast<std::size_t>(row)];
        ++row;
    }
    const ToldCoefficients told = toldBy(design, static_cast<int>(readings));
    if (told.columns.empty())
        return shared;
    // The exact coefficients are the approximate ones to the first order, and a doubt is no better known than that.
    const Eigen::MatrixXd shifts = pivotedSolve(design(Eigen::all, told.columns), turned).solution;
    for (std::size_t i = 0; i < told.columns.size(); ++i)
        shared.of_deg[static_cast<std::size_t>(told.columns[i])] = rounded(shifts.row(static_cast<Eigen::Index>(i)).norm());
    return shared;
}

} // namespace lubberline
