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
    airspeedOffset += other.airspeedOffset;
    airspeedSquares += other.airspeedSquares;
    airspeed += other.airspeed;
    windOnReference += other.windOnReference;
    referenceSquares += other.referenceSquares;
    declination += other.declination;
    declined += other.declined;
    withoutTold += other.withoutTold;
    return *this;
}

void FlightSums::add(const Report& report)
{
    ++count;
    double* const plain = normal.data();
    for (int j = 0; j < kWindColumns; ++j) {
        const double x = report.weight * report.row[static_cast<std::size_t>(j)];
        for (int i = j; i < kWindColumns; ++i)
            plain[j * kWindColumns + i] += x * report.row[static_cast<std::size_t>(i)];
        product(j) += x * report.error_deg;
    }
    squares += report.weight * report.error_deg * report.error_deg;
    airspeedOffset += report.airspeedOffset;
    airspeedSquares += report.airspeedOffset * report.airspeedOffset;
    airspeed += report.airspeed;
}

WindForms& WindForms::operator+=(const WindForms& other)
{
    count += other.count;
    turned += other.turned;
    turnedAcross += other.turnedAcross;
    error += other.error;
    errorAcross += other.errorAcross;
    squaredError += other.squaredError;
    squaredAcross += other.squaredAcross;
    return *this;
}

void WindForms::add(const FlightSums::Report& report)
{
    ++count;
    double* const whole = turned.data();
    double* const across = turnedAcross.data();
    for (int j = 0; j < kWindColumns; ++j) {
        const double x = report.row[static_cast<std::size_t>(j)];
        for (int i = j; i < kWindColumns; ++i) {
            const double outer = x * report.row[static_cast<std::size_t>(i)];
            const int place = j * kWindColumns + i;
            whole[place] += report.turned * outer;
            across[place] += report.turnedAcross * outer;
        }
        error(j) += report.product * x;
        errorAcross(j) += report.productAcross * x;
    }
    squaredError += report.squaredError;
    squaredAcross += report.squaredAcross;
}

WindSquares& WindSquares::operator+=(const WindSquares& other)
{
    total += other.total;
    across += other.across;
    count += other.count;
    return *this;
}

WindRmse WindSquares::rmse() const
{
    const double n = static_cast<double>(std::max<std::int64_t>(count, 1));
    return {std::sqrt(total / n), std::sqrt(std::max(0.0, total - across) / n), std::sqrt(across / n)};
}

WindSquares windSquares(const WindForms& forms, const WindRow& beta_deg)
{
    const WindRow beta = beta_deg * kRadiansPerDegree;
    const auto with = [&](double squares, const WindRow& products, const WindMatrix& turned) {
        return std::max(0.0, squares + 2.0 * beta.dot(products) + beta.dot(turned.selfadjointView<Eigen::Lower>() * beta));
    };
    return {
        with(forms.squaredError, forms.error, forms.turned), with(forms.squaredAcross, forms.errorAcross, forms.turnedAcross), forms.count};
}

} // namespace lubberline
