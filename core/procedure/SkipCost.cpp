#include "core/procedure/SkipCost.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <cmath>
#include <limits>

#include "core/angle/Angle.h"
#include "core/base/Contract.h"

namespace lubberline {

namespace {

constexpr int kAll = 5, kFirstHarmonic = 3;
/// Below this the headings do not tell the coefficients apart: a few of them crowd together.
constexpr double kLeastPivot = 1e-3;

Eigen::VectorXd termsAt(double heading_deg, int terms)
{
    const double psi = toRadians(heading_deg);
    Eigen::VectorXd x(kAll);
    x << 1, std::sin(psi), std::cos(psi), std::sin(2 * psi), std::cos(2 * psi);
    return x.head(terms);
}

struct Largest {
    double error = std::numeric_limits<double>::infinity();
    double at_deg = 0;
};

Largest largestError(std::span<const double> headings_deg, int terms)
{
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(terms, terms);
    for (const double heading : headings_deg) {
        const Eigen::VectorXd x = termsAt(heading, terms);
        normal += x * x.transpose();
    }
    const Eigen::LDLT<Eigen::MatrixXd> solver(normal);
    if (solver.info() != Eigen::Success || solver.vectorD().minCoeff() < kLeastPivot)
        return {};
    Largest largest{0, 0};
    for (int degree = 0; degree < 360; ++degree) {
        const Eigen::VectorXd x = termsAt(degree, terms);
        const double error = std::sqrt(x.dot(solver.solve(x)));
        if (error > largest.error)
            largest = {error, static_cast<double>(degree)};
    }
    return largest;
}

} // namespace

SkipCost skipCost(std::span<const double> planned_deg, std::span<const double> read_deg)
{
    LUBBERLINE_EXPECT(planned_deg.size() >= kAll, "a plan has at least as many headings as there are coefficients");
    SkipCost cost;
    cost.planned = largestError(planned_deg, kAll).error;
    Largest now = largestError(read_deg, kAll);
    if (!std::isfinite(now.error)) {
        cost.withoutSecondHarmonic = true;
        now = largestError(read_deg, kFirstHarmonic);
    }
    cost.remaining = now.error;
    cost.at_deg = now.at_deg;
    return cost;
}

} // namespace lubberline
