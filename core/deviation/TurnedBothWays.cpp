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
constexpr double kSureBy = 3;          ///< standard errors from nothing
constexpr double kWide_deg = 60;       ///< between readings: wider than any step that swings are made in
constexpr double kMostSteps = 2.0 / 3; ///< of a run go its way round

Message wordOf(int wayRound)
{
    return wayRound > 0 ? Message(MARKED("core", "clockwise"))
        : wayRound < 0  ? Message(MARKED("core", "counter-clockwise"))
                        : Message(MARKED("core", "no one way"));
}

std::string paddedHeading(double heading_deg)
{
    const std::string digits = figureText(heading_deg, 0);
    return std::string(digits.size() < 3 ? 3 - digits.size() : 0, '0') + digits + "\u00B0";
}

struct Arc {
    double from_deg = 0, to_deg = 0, width_deg = 0;
};

/// The widest arc of a run without a reading, clockwise.
Arc widestArc(std::span<const Observation> run)
{
    std::vector<double> headings;
    for (const Observation& read : run)
        headings.push_back(read.compass.degrees());
    std::sort(headings.begin(), headings.end());
    Arc widest;
    for (std::size_t i = 0; i < headings.size(); ++i) {
        const bool last = i + 1 == headings.size();
        const double to = last ? headings.front() : headings[i + 1], width = to - headings[i] + (last ? 360.0 : 0.0);
        if (width > widest.width_deg)
            widest = {headings[i], to, width};
    }
    return widest;
}

/// +1: its rows go round clockwise, −1: the other way, 0: neither.
int wayRound(std::span<const Observation> run)
{
    int clockwise = 0, other = 0;
    for (std::size_t i = 1; i < run.size(); ++i) {
        const double step = wrap180(run[i].compass.degrees() - run[i - 1].compass.degrees());
        clockwise += step > 0 ? 1 : 0;
        other += step < 0 ? 1 : 0;
    }
    const double most = kMostSteps * (clockwise + other);
    return clockwise > most ? 1 : other > most ? -1 : 0;
}

/// What keeps two runs from being one each way round over the same headings.
std::vector<Message> whyNoComparison(std::span<const Observation> clockwise, std::span<const Observation> counterClockwise)
{
    std::vector<Message> findings;
    const int first = wayRound(clockwise), second = wayRound(counterClockwise);
    if (first < 0 && second > 0)
        findings.push_back(MARKED(
            "core", "the rows of the first run go counter-clockwise and those of the second clockwise: expected the clockwise run first"));
    else if (first != 1 || second != -1)
        findings.push_back(
            {MARKED("core",
                 "the rows of the run clockwise go %1 and those of the other %2: one way round nothing is compared; expected one run each way, rows in the order in which they were read"),
                wordOf(first), wordOf(second)});
    for (const bool whichIsFirst : {true, false})
        if (const Arc arc = widestArc(whichIsFirst ? clockwise : counterClockwise); arc.width_deg > kWide_deg)
            findings.push_back({whichIsFirst
                    ? MARKED("core",
                        "the run clockwise has no reading from %1 to %2: over these %3° nothing is compared; expected %4° or less between readings")
                    : MARKED("core",
                        "the run counter-clockwise has no reading from %1 to %2: over these %3° nothing is compared; expected %4° or less between readings"),
                paddedHeading(arc.from_deg), paddedHeading(arc.to_deg), figureText(arc.width_deg, 0), figureText(kWide_deg, 0)});
    return findings;
}

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
    both.findings = whyNoComparison(clockwise, counterClockwise);
    both.passes = both.within() && both.findings.empty();
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
