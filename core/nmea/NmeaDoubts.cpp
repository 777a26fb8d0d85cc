#include "core/nmea/NmeaDoubts.h"

#include <Eigen/Core>
#include <Eigen/QR>

#include <cmath>

namespace lubberline {

namespace {

void widenFit(SmithFitReport& fit, const Eigen::MatrixXd& shifts_rad)
{
    const auto p = static_cast<Eigen::Index>(fit.parameters);
    if (p == 0)
        return;
    fit.covariance.topLeftCorner(p, p) += shifts_rad * shifts_rad.transpose();
    for (Eigen::Index i = 0; i < p; ++i)
        fit.standardError[static_cast<std::size_t>(i)] = std::sqrt(fit.covariance(i, i));
}

} // namespace

void widenByDoubts(Analysis& analysis, const NmeaSwing& swing)
{
    const auto readings = static_cast<Eigen::Index>(analysis.readings.size());
    Eigen::MatrixXd design(readings, 5), turned(readings, static_cast<Eigen::Index>(swing.doubts.size()));
    if (turned.cols() == 0 || static_cast<std::size_t>(readings) != swing.used)
        return;
    for (Eigen::Index i = 0; i < readings; ++i) {
        const double heading = analysis.readings[static_cast<std::size_t>(i)].compass.radians();
        design.row(i) << 1.0, std::sin(heading), std::cos(heading), std::sin(2.0 * heading), std::cos(2.0 * heading);
        for (Eigen::Index doubt = 0; doubt < turned.cols(); ++doubt)
            turned(i, doubt) = toRadians(swing.doubts[static_cast<std::size_t>(doubt)][static_cast<std::size_t>(i)]);
    }
    // The exact coefficients are the approximate ones to the first order, and a doubt is no better known than that.
    for (SmithFitReport* fit : {static_cast<SmithFitReport*>(&analysis.approximate), static_cast<SmithFitReport*>(&analysis.exact)})
        widenFit(*fit, design.leftCols(fit->parameters).colPivHouseholderQr().solve(turned));
}

} // namespace lubberline
