#include "core/calibration/Interference.h"

#include <Eigen/Core>
#include <algorithm>

#include "core/algebra/Solve.h"
#include "core/base/FileText.h"
#include "core/base/Middle.h"
#include "core/base/Number.h"
#include "core/calibration/LogQuality.h"

namespace lubberline {

namespace {

constexpr std::size_t kLeastSamples = 3;

/// Rows of [from, to) with a field, and none that leaves its neighbours alone.
std::vector<std::size_t> rowsBetween(const SensorLog& log, const LogQuality& quality, double from_s, double to_s)
{
    std::vector<std::size_t> rows;
    const auto begin = std::lower_bound(log.time_s.begin(), log.time_s.end(), from_s);
    for (auto at = begin; at != log.time_s.end() && *at < to_s; ++at)
        if (const auto row = static_cast<std::size_t>(at - log.time_s.begin());
            log.hasField(row) && quality.faults[row] != SampleFault::Spike)
            rows.push_back(row);
    return rows;
}

/// What is no change that an action made, as it is there for one sample: told with the largest of it, for it may be a switch's own.
Message spikesInWords(const SensorLog& log, const LogQuality& quality)
{
    const auto count = static_cast<std::int64_t>(quality.of(SampleFault::Spike));
    double most = 0, when_s = 0;
    std::size_t axis = 0;
    for (std::size_t row = 1; row + 1 < log.size(); ++row)
        if (quality.faults[row] == SampleFault::Spike && log.hasField(row - 1))
            for (std::size_t k = 0; k < 3; ++k)
                if (const double away = log.field[k][row] - log.field[k][row - 1]; std::abs(away) > std::abs(most)) {
                    most = away;
                    when_s = log.time_s[row];
                    axis = k;
                }
    if (count == 0)
        return {};
    return {
        MARKED_N("core",
            "%n spike(s) left out, the largest of %1 nT along %2 at %3 s: there for a sample alone; where one comes again as often as a thing is switched, it is that thing's"),
        count, signedFigureText(most, 0), "xyz"[axis], figureText(when_s, 2)};
}

double middleAlong(const SensorLog& log, std::size_t axis, const std::vector<std::size_t>& rows, double from = 0, bool size = false)
{
    std::vector<double> values;
    for (const auto row : rows)
        values.push_back(size ? std::abs(log.field[axis][row] - from) : log.field[axis][row] - from);
    return middleOf(std::move(values));
}

/// Field per ampere: the aircraft stands still, so the field is a constant and what the currents make.
void fitCircuits(InterferenceResult& result, const SensorLog& log)
{
    std::vector<std::size_t> changing;
    for (std::size_t k = 0; k < log.currents.size(); ++k) {
        const auto [low, high] = std::minmax_element(log.currents[k].values.begin(), log.currents[k].values.end());
        if (*high - *low > 1e-6)
            changing.push_back(k);
    }
    if (changing.empty())
        return;
    const auto size = static_cast<Eigen::Index>(changing.size() + 1);
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(size, size), right = Eigen::MatrixXd::Zero(size, 3);
    for (std::size_t row = 0; row < log.size(); ++row) {
        Eigen::VectorXd x(size);
        x[0] = 1;
        for (std::size_t k = 0; k < changing.size(); ++k)
            x[static_cast<Eigen::Index>(k + 1)] = log.currents[changing[k]].values[row];
        if (!log.hasField(row) || !x.allFinite())
            continue;
        normal += x * x.transpose();
        right += x * log.at(row).transpose();
    }
    const PivotedSolution fit = pivotedSolve(normal, right);
    if (fit.rank < size) {
        result.warnings.push_back({MARKED("core", "the currents changed together only: their fields per ampere cannot be told apart")});
        return;
    }
    for (std::size_t k = 0; k < changing.size(); ++k) {
        Circuit circuit;
        circuit.name = log.currents[changing[k]].name;
        circuit.field_nT_per_A = fit.solution.row(static_cast<Eigen::Index>(k + 1)).transpose();
        for (const double value : log.currents[changing[k]].values)
            if (std::isfinite(value) && std::abs(value) > std::abs(circuit.current_A))
                circuit.current_A = value;
        result.circuits.push_back(std::move(circuit));
    }
}

} // namespace

Result<InterferenceResult> interferenceTest(const SensorLog& log, const std::vector<TimedAction>& actions, const Eigen::Vector3d& limits_nT)
{
    if (log.time_s.empty())
        return Error{ErrorCode::InvalidInput, MARKED("core", "has no time; expected a column time_s")};
    if (log.unit == FieldUnit::Counts)
        return Error{ErrorCode::InvalidInput, MARKED("core", "is in counts; expected a log in nT, uT, mG or G, as the limits are in nT")};
    InterferenceResult result;
    result.limits_nT = limits_nT;
    result.passes = true;
    const LogQuality quality = qualityOf(log);
    double before_s = log.time_s.front();
    for (std::size_t i = 0; i < actions.size(); ++i) {
        const double from = actions[i].time_s,
                     to = i + 1 < actions.size() ? actions[i + 1].time_s : std::nextafter(log.time_s.back(), 1e300);
        const auto before = rowsBetween(log, quality, before_s, from), after = rowsBetween(log, quality, from, to);
        if (before.size() < kLeastSamples || after.size() < kLeastSamples)
            return Error{ErrorCode::InvalidInput,
                {MARKED("core",
                     "%1 at %2 s has %3 samples before and %4 after it; expected %5 or more of each: actions inside the log, and time between them"),
                    inQuotes(actions[i].action), shortestNumber(from), before.size(), after.size(), kLeastSamples}};
        ActionOutcome outcome;
        outcome.action = actions[i].action;
        outcome.from_s = from;
        outcome.to_s = std::min(to, log.time_s.back());
        outcome.passes = true;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto k = static_cast<Eigen::Index>(axis);
            const double quiet = middleAlong(log, axis, before);
            if (i == 0)
                result.noise_nT[k] = 1.4826 * middleAlong(log, axis, before, quiet, true);
            outcome.change_nT[k] = middleAlong(log, axis, after) - quiet;
            for (const auto row : after)
                if (const double away = log.field[axis][row] - quiet; std::abs(away) > std::abs(outcome.worst_nT[k])) {
                    outcome.worst_nT[k] = away;
                    outcome.worstAt_s[k] = log.time_s[row];
                }
            outcome.passes = outcome.passes && std::abs(outcome.worst_nT[k]) <= limits_nT[k];
        }
        result.passes = result.passes && outcome.passes;
        result.actions.push_back(std::move(outcome));
        before_s = from;
    }
    if (actions.empty())
        return Error{ErrorCode::InvalidInput, MARKED("core", "there are no actions; expected at least one")};
    for (Eigen::Index k = 0; k < 3; ++k)
        if (4 * result.noise_nT[k] > limits_nT[k])
            result.warnings.push_back(
                {MARKED("core", "the noise of axis %1 is %2 nT: with a limit of %3 nT the test may fail by noise alone"), "xyz"[k],
                    figureText(result.noise_nT[k], 0), figureText(limits_nT[k], 0)});
    if (Message spikes = spikesInWords(log, quality); !spikes.empty())
        result.warnings.push_back(std::move(spikes));
    if (!quality.gaps.empty())
        result.warnings.push_back(quality.remarks.front());
    fitCircuits(result, log);
    return result;
}

} // namespace lubberline
