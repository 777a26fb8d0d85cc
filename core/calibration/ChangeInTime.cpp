#include "core/calibration/ChangeInTime.h"

#include <algorithm>
#include <cmath>

#include "core/algebra/Products.h"
#include "core/algebra/Spectra.h"
#include "core/base/Number.h"

namespace lubberline {

namespace {

constexpr double kSurely = 30;            ///< χ² of four parameters at fifteen moments: once in 10⁴ logs by chance
constexpr double kNoDirection = 1e-3;     ///< of the largest: a step that the attitudes after the moment do not tell
constexpr double kStandardErrors = 5;     ///< that a change is told from
constexpr double kLeastOfField = 0.004;   ///< 0.3° where H is 0.4 F
constexpr double kNearlyWhole = 0.5;      ///< of a part of the log
constexpr std::size_t kFewestOffered = 5; ///< of such a part

/// M⁺ and what of it counts, by its parts.
Eigen::MatrixXd inverseOf(const Eigen::MatrixXd& matrix, double least)
{
    const Eigen::VectorXd scale = matrix.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    const SymmetricParts parts = symmetricParts(scale.asDiagonal() * matrix * scale.asDiagonal());
    Eigen::VectorXd values = parts.values;
    const double limit = least * std::max(0.0, values.maxCoeff());
    for (double& value : values)
        value = value > limit && value > 0 ? 1.0 / value : 0.0;
    return composed(scale.asDiagonal() * parts.vectors, values);
}

/// Of steps of iron and, last, gain. Where the attitudes do not tell one from the other, all of it is called iron.
Eigen::MatrixXd inverseOfSteps(const Eigen::MatrixXd& left)
{
    const Eigen::MatrixXd both = inverseOf(left, kNoDirection);
    const Eigen::Index irons = left.cols() - 1;
    if (product(both, left).trace() > static_cast<double>(irons) + 0.5)
        return both;
    Eigen::MatrixXd iron = Eigen::MatrixXd::Zero(left.rows(), left.cols());
    iron.topLeftCorner(irons, irons) = inverseOf(left.topLeftCorner(irons, irons), kNoDirection);
    return iron;
}

} // namespace

std::optional<ChangeInTime> changeInTime(
    const TimeBlocks& blocks, const Eigen::MatrixXd& free, const std::vector<Eigen::MatrixXd>& steps, double variance)
{
    if (!(variance > 0))
        return {};
    Eigen::MatrixXd normal = blocks[0].normal, score = blocks[0].score;
    for (std::size_t i = 1; i < kTimeBlocks; ++i) {
        normal += blocks[i].normal;
        score += blocks[i].score;
    }
    const Eigen::MatrixXd inverse = free.cols() > 0 ? carried(free, inverseOf(carried(free.transpose(), normal), 1e-12))
                                                    : Eigen::MatrixXd::Zero(normal.rows(), normal.cols());
    Eigen::MatrixXd later = normal, laterScore = score;
    ChangeInTime best;
    double most = kSurely;
    for (std::size_t after = 1; after < kTimeBlocks; ++after) {
        later -= blocks[after - 1].normal;
        laterScore -= blocks[after - 1].score;
        const Eigen::MatrixXd taken = product(inverse, later), left = later - product(later, taken);
        ChangeInTime change;
        change.after = after;
        double explained = 0;
        for (std::size_t axis = 0; axis < steps.size(); ++axis) {
            const Eigen::MatrixXd& step = steps[axis];
            const auto column = static_cast<Eigen::Index>(axis);
            const Eigen::MatrixXd unexplained = inverseOfSteps(carried(step.transpose(), left));
            const Eigen::VectorXd own = step.transpose() * (laterScore.col(column) - taken.transpose() * score.col(column));
            const Eigen::VectorXd size = unexplained * own;
            explained += own.dot(size) / variance;
            const Eigen::Index irons = step.cols() - 1;
            for (Eigen::Index i = 0; i < irons; ++i) {
                change.hardIron(column + i) = size(i);
                change.error(column + i) = std::sqrt(std::max(0.0, variance * unexplained(i, i)));
            }
            if (std::abs(size(irons)) >= std::abs(change.gain)) {
                change.gain = size(irons);
                change.gainError = std::sqrt(std::max(0.0, variance * unexplained(irons, irons)));
            }
        }
        if (explained <= most)
            continue;
        most = explained;
        best = change;
    }
    return best.after > 0 ? std::optional(best) : std::nullopt;
}

Message wordsOf(const ChangeInTime& change, const SensorLog& log, double field)
{
    Eigen::Index axis = 0;
    const double iron = change.hardIron.cwiseAbs().maxCoeff(&axis);
    const std::size_t row = std::min(log.size() - 1, change.after * log.size() / kTimeBlocks);
    const bool timed = !log.time_s.empty() && std::isfinite(log.time_s[row]);
    const Message when = timed ? Message{MARKED("core", "about %1 s"), figureText(log.time_s[row], 0)}
                               : Message{MARKED("core", "about sample %1"), row + 1};
    if (iron > kLeastOfField * field && iron > kStandardErrors * change.error(axis))
        return {
            MARKED("core",
                "what the fit leaves over changes with time: along %1 it is %2 %3 more after %4 than before; expected less than %5 %3: iron that was put down or magnetised on the way, or a sensor that drifts"),
            "xyz"[axis], signedFigureText(change.hardIron(axis), 0), std::string(log.figureUnit()), when,
            figureText(kLeastOfField * field, 0)};
    if (std::abs(change.gain) > kLeastOfField && std::abs(change.gain) > kStandardErrors * change.gainError)
        return {MARKED("core",
                    "the sensor's gain changes with time: it is %1 % more after %2 than before; expected less than %3 %: a sensor that "
                    "warms up, or another place"),
            signedFigureText(100 * change.gain, 1), when, figureText(100 * kLeastOfField, 1)};
    return {};
}

Message leftOutTogether(const std::vector<std::uint8_t>& offered, const std::vector<std::uint8_t>& used)
{
    for (std::size_t block = 0; block < kTimeBlocks; ++block) {
        const std::size_t from = block * offered.size() / kTimeBlocks, to = (block + 1) * offered.size() / kTimeBlocks;
        std::size_t all = 0, out = 0;
        for (std::size_t row = from; row < to; ++row) {
            all += offered[row];
            out += offered[row] != 0 && used[row] == 0 ? 1 : 0;
        }
        if (all >= kFewestOffered && static_cast<double>(out) > kNearlyWhole * static_cast<double>(all))
            return {
                MARKED("core",
                    "of the samples %1 to %2 most do not lie on what the others lie on: no spikes, but another field or other iron for that time"),
                from + 1, to};
    }
    return {};
}

double slowResidualFactor(std::span<const double> residuals)
{
    if (residuals.size() < 100)
        return 1.0;
    const auto stretch = static_cast<std::size_t>(std::sqrt(static_cast<double>(residuals.size())));
    const std::size_t stretches = residuals.size() / stretch;
    double mean = 0, variance = 0, between = 0;
    for (const double residual : residuals)
        mean += residual / static_cast<double>(residuals.size());
    for (const double residual : residuals)
        variance += (residual - mean) * (residual - mean) / static_cast<double>(residuals.size() - 1);
    for (std::size_t i = 0; i < stretches; ++i) {
        double sum = 0;
        for (std::size_t k = 0; k < stretch; ++k)
            sum += residuals[i * stretch + k] - mean;
        between += sum * sum / static_cast<double>(stretch) / static_cast<double>(stretches - 1);
    }
    const double factor = variance > 0 ? between / variance : 1.0;
    const double chance = 1.0 + 3.5 * std::sqrt(2.0 / static_cast<double>(stretches));
    return factor > chance ? factor : 1.0;
}

} // namespace lubberline
