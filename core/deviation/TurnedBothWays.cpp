#include "core/deviation/TurnedBothWays.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "core/algebra/Products.h"
#include "core/algebra/Solve.h"
#include "core/angle/Angle.h"
#include "core/base/Number.h"

namespace lubberline {

namespace {

constexpr int kBothWays = 8; ///< five coefficients, three of the difference
constexpr std::size_t kFewestOfARun = 6;
constexpr double kSureBy = 3; ///< standard errors from nothing

} // namespace

Result<BothWays> turnedBothWays(std::span<const Observation> clockwise, std::span<const Observation> counterClockwise, double limit_deg)
{
    if (std::min(clockwise.size(), counterClockwise.size()) < kFewestOfARun)
        return Error{ErrorCode::InvalidInput,
            {MARKED("core", "%1 readings clockwise and %2 counter-clockwise; expected %3 or more of each"), clockwise.size(),
                counterClockwise.size(), kFewestOfARun}};
    const auto count = static_cast<Eigen::Index>(clockwise.size() + counterClockwise.size());
    Eigen::MatrixXd rows(count, kBothWays);
    Eigen::VectorXd deviations(count);
    Eigen::Index row = 0;
    for (const auto& [run, half] : {std::pair(clockwise, 0.5), std::pair(counterClockwise, -0.5)})
        for (const Observation& read : run) {
            const double heading = toRadians(read.compass.degrees()), s = std::sin(heading), c = std::cos(heading);
            rows.row(row) << 1, s, c, std::sin(2 * heading), std::cos(2 * heading), half, half * s, half * c;
            deviations[row++] = wrap180(deviationOf(read.magnetic, read.compass).degrees());
        }
    const PivotedSolution solved = pivotedSolve(rows, deviations);
    if (solved.rank < kBothWays)
        return Error{ErrorCode::Numeric,
            MARKED("core", "the headings of both runs do not tell what differs between them; expected them all around")};
    const Eigen::VectorXd fit = solved.solution;
    BothWays both;
    both.limit_deg = limit_deg;
    const double squares = (deviations - rows * fit).squaredNorm();
    both.residual_deg = std::sqrt(squares / static_cast<double>(std::max<Eigen::Index>(count - kBothWays, 1)));
    const Eigen::MatrixXd inverse = inversePositive(product(rows.transpose(), rows));
    for (int i = 0; i < 3; ++i) {
        both.difference_deg[static_cast<std::size_t>(i)] = fit[5 + i];
        both.standardError_deg[static_cast<std::size_t>(i)] = both.residual_deg * std::sqrt(inverse(5 + i, 5 + i));
    }
    const double cycle = std::hypot(both.difference_deg[1], both.difference_deg[2]);
    both.largest_deg = std::abs(both.difference_deg[0]) + cycle;
    both.passes = both.largest_deg <= limit_deg;
    if (std::abs(both.difference_deg[0]) > kSureBy * both.standardError_deg[0])
        both.findings.push_back(
            {MARKED("core",
                 "the runs differ by %1° on all headings: something is late (card, liquid, reference); turn slower, 0.2 to 3 degrees a second"),
                signedFigureText(both.difference_deg[0], 2)});
    if (cycle > kSureBy * std::max(both.standardError_deg[1], both.standardError_deg[2]))
        both.findings.push_back(
            {MARKED("core",
                 "the runs differ by up to %1° once around: iron keeps a trace of the heading before, or the field of the site is not the same on both tracks"),
                figureText(cycle, 2)});
    if (both.findings.empty())
        both.findings.push_back(MARKED("core", "both runs tell the same"));
    return both;
}

} // namespace lubberline
