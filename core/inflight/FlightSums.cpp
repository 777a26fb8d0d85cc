#include "core/inflight/FlightSums.h"

#include <algorithm>
#include <cmath>

#include "core/angle/Angle.h"

namespace lubberline {

FlightSums& FlightSums::operator+=(const FlightSums& other)
{
    count += other.count;
    normal += other.normal;
    product += other.product;
    squares += other.squares;
    turned += other.turned;
    turnedAcross += other.turnedAcross;
    error += other.error;
    errorAcross += other.errorAcross;
    squaredError += other.squaredError;
    squaredAcross += other.squaredAcross;
    airspeedOffset += other.airspeedOffset;
    airspeedSquares += other.airspeedSquares;
    airspeed += other.airspeed;
    declination += other.declination;
    declined += other.declined;
    withoutTold += other.withoutTold;
    return *this;
}

void FlightSums::add(const Report& report)
{
    ++count;
    double* const plain = normal.data();
    double* const whole = turned.data();
    double* const across = turnedAcross.data();
    for (int j = 0; j < kWindColumns; ++j) {
        const double x = report.row[static_cast<std::size_t>(j)];
        for (int i = j; i < kWindColumns; ++i) {
            const double outer = x * report.row[static_cast<std::size_t>(i)];
            const int place = j * kWindColumns + i;
            plain[place] += report.weight * outer;
            whole[place] += report.turned * outer;
            across[place] += report.turnedAcross * outer;
        }
        product(j) += report.weight * report.error_deg * x;
        error(j) += report.product * x;
        errorAcross(j) += report.productAcross * x;
    }
    squares += report.weight * report.error_deg * report.error_deg;
    squaredError += report.squaredError;
    squaredAcross += report.squaredAcross;
    airspeedOffset += report.airspeedOffset;
    airspeedSquares += report.airspeedOffset * report.airspeedOffset;
    airspeed += report.airspeed;
}

WindRmse WindSquares::rmse() const
{
    const double n = static_cast<double>(std::max<std::int64_t>(count, 1));
    return {std::sqrt(total / n), std::sqrt(std::max(0.0, total - across) / n), std::sqrt(across / n)};
}

WindSquares windSquares(const FlightSums& sums, const WindRow& beta_deg)
{
    const WindRow beta = beta_deg * kRadiansPerDegree;
    const auto with = [&](double squares, const WindRow& products, const WindMatrix& turned) {
        return std::max(0.0, squares + 2.0 * beta.dot(products) + beta.dot(turned.selfadjointView<Eigen::Lower>() * beta));
    };
    return {with(sums.squaredError, sums.error, sums.turned), with(sums.squaredAcross, sums.errorAcross, sums.turnedAcross), sums.count};
}

} // namespace lubberline
