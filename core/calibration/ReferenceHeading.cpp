#include "core/calibration/ReferenceHeading.h"

#include <Eigen/Core>
#include <algorithm>

#include "core/algebra/Solve.h"
#include "core/angle/Angle.h"
#include "core/base/Number.h"
#include "core/calibration/ModelHeader.h"

namespace lubberline {

namespace {

constexpr double kAgreement_deg = 0.02;

/// What headings are rounded to: the coarsest of the usual steps that all are whole numbers of.
double roundingOf(const std::vector<double>& values)
{
    for (const double step : {1.0, 0.5, 0.1, 0.01})
        if (std::all_of(values.begin(), values.end(),
                [step](double value) { return !std::isfinite(value) || std::abs(value / step - std::round(value / step)) < 1e-6; }))
            return step;
    return 0;
}

/// A heading that the compass made of its own field and then smoothed or delayed: what it differs by from the field's own heading goes with
/// the rate of turn, and neither with heading nor with tilt, though the size of the field tells of iron that must turn it.
bool smoothedOwn(const SensorLog& log, const std::vector<std::uint8_t>& used)
{
    using Row = Eigen::Matrix<double, 7, 1>;
    Eigen::Matrix<double, 7, 7> normal = Eigen::Matrix<double, 7, 7>::Zero();
    Row right = Row::Zero();
    double squares = 0, rows = 0, sizes = 0, sizeSquares = 0;
    const bool tilted = !log.pitch_deg.empty() && !log.roll_deg.empty();
    for (std::size_t row = 1; row + 1 < log.size(); ++row) {
        const double heading = log.heading_deg[row], before = wrap180(heading - log.heading_deg[row - 1]),
                     behind = wrap180(log.heading_deg[row + 1] - heading);
        if (used[row] == 0 || used[row - 1] == 0 || used[row + 1] == 0 || !std::isfinite(before + behind))
            continue;
        const double own = headingOf_deg(log.at(row), tilted ? log.pitch_deg[row] : 0.0, tilted ? log.roll_deg[row] : 0.0);
        const double off = wrap180(own - heading), angle = toRadians(heading);
        Row x;
        x << 1, (before + behind) / 2, behind - before, std::sin(angle), std::cos(angle), std::sin(2 * angle), std::cos(2 * angle);
        normal += x * x.transpose();
        right += off * x;
        squares += off * off;
        rows += 1;
        const double size = log.at(row).norm();
        sizes += size;
        sizeSquares += size * size;
    }
    if (rows < 200)
        return false;
    const double mean = sizes / rows, iron_deg = toDegrees(std::sqrt(std::max(0.0, sizeSquares / rows - mean * mean)) / mean);
    const Row solved = leastNorm(normal, right);
    const double left_deg = std::sqrt(std::max(0.0, squares - solved.dot(right)) / rows);
    const double turned_deg = std::hypot(solved[3], solved[4]) + std::hypot(solved[5], solved[6]);
    return iron_deg >= 1.0 && turned_deg < 0.1 * iron_deg && left_deg < 0.3 * iron_deg;
}

constexpr double kLongestDelay_s = 3;
constexpr std::size_t kRowsForDelays = 20000, kFewestForDelays = 200;
constexpr double kFollows = 0.1; ///< of what iron must do: less of a deviation is none

struct DelayedOwn {
    double rms_deg = 0;      ///< of own heading of then − heading of now, without its mean
    double goesWith_deg = 0; ///< of that, what goes with heading and tilt, as deviation does
    double iron_deg = 0;     ///< what iron must turn, by the field's size
    double error_deg = 0;    ///< of what goes with them, by noise alone
};

/// The log's own heading of `delay` rows ago against the heading that stands in the row.
std::optional<DelayedOwn> delayedOwn(
    const SensorLog& log, const std::vector<double>& own_deg, const std::vector<std::uint8_t>& used, std::size_t delay)
{
    using Row = Eigen::Matrix<double, 11, 1>;
    Eigen::Matrix<double, 11, 11> normal = Eigen::Matrix<double, 11, 11>::Zero();
    Row right = Row::Zero();
    const std::size_t step = std::max<std::size_t>(1, log.size() / kRowsForDelays);
    double sine = 0, cosine = 0, squares = 0, rows = 0, sizes = 0, sizeSquares = 0;
    const auto offAt
        = [&](std::size_t row) { return used[row] != 0 ? wrap180(own_deg[row - delay] - log.heading_deg[row]) : std::nan(""); };
    for (std::size_t row = delay; row < log.size(); row += step)
        if (const double off = offAt(row); std::isfinite(off)) {
            sine += std::sin(toRadians(off));
            cosine += std::cos(toRadians(off));
        }
    const double mean_deg = toDegrees(std::atan2(sine, cosine));
    for (std::size_t row = delay; row < log.size(); row += step) {
        const double off = wrap180(offAt(row) - mean_deg), angle = toRadians(log.heading_deg[row]);
        if (!std::isfinite(off))
            continue;
        const double s = std::sin(angle), c = std::cos(angle), p = toRadians(log.pitch_deg[row]), r = toRadians(log.roll_deg[row]);
        Row x;
        x << 1, s, c, std::sin(2 * angle), std::cos(2 * angle), p, r, p * s, p * c, r * s, r * c;
        normal += x * x.transpose();
        right += off * x;
        squares += off * off;
        rows += 1;
        const double size = log.at(row).norm();
        sizes += size;
        sizeSquares += size * size;
    }
    if (rows < static_cast<double>(kFewestForDelays))
        return {};
    const double size = sizes / rows, mean = right[0] / rows, variance = std::max(0.0, squares / rows - mean * mean);
    const Row solved = leastNorm(normal, right);
    const double explained = std::clamp(solved.dot(right) / rows - mean * mean, 0.0, variance);
    DelayedOwn result;
    result.rms_deg = std::sqrt(variance);
    result.goesWith_deg = std::sqrt(explained);
    result.error_deg = std::sqrt(10 * (variance - explained) / rows);
    result.iron_deg = toDegrees(std::sqrt(std::max(0.0, sizeSquares / rows - size * size)) / size);
    return result;
}

/// The same of a heading that is smoothed, late or noisy by itself: at the delay that suits it best nothing of it goes with heading or tilt.
bool lateOwn(const SensorLog& log, const std::vector<std::uint8_t>& used)
{
    if (log.pitch_deg.empty() || log.roll_deg.empty() || log.size() < 2 * kFewestForDelays)
        return false;
    std::vector<double> own_deg;
    for (std::size_t row = 0; row < log.size(); ++row)
        own_deg.push_back(used[row] != 0 ? headingOf_deg(log.at(row), log.pitch_deg[row], log.roll_deg[row]) : std::nan(""));
    const double lasting_s = log.time_s.empty() ? 0 : log.time_s.back() - log.time_s.front();
    const double rows_s = lasting_s > 0 ? static_cast<double>(log.size()) / lasting_s : 20;
    const std::size_t longest = std::min(log.size() / 4, static_cast<std::size_t>(kLongestDelay_s * rows_s));
    std::optional<DelayedOwn> best;
    for (std::size_t delay = 0; delay <= longest; delay += 1 + delay / 4) {
        const auto one = delayedOwn(log, own_deg, used, delay);
        if (one && (!best || one->rms_deg < best->rms_deg))
            best = one;
    }
    return best && best->iron_deg >= 1.0 && best->goesWith_deg < kFollows * best->iron_deg + 2 * best->error_deg
        && best->error_deg < kFollows * best->iron_deg && best->rms_deg < 2 * best->iron_deg;
}

} // namespace

Message headingOfItsOwn(const SensorLog& log, const std::vector<std::uint8_t>& used)
{
    if (log.heading_deg.empty())
        return {};
    const double allowed = kAgreement_deg + roundingOf(log.heading_deg) / 2;
    for (const bool levelled : {true, false}) {
        double sine = 0, cosine = 0;
        std::vector<double> differences;
        for (std::size_t row = 0; row < log.size(); ++row) {
            if (used[row] == 0 || !std::isfinite(log.heading_deg[row]))
                continue;
            const bool tilted = levelled && !log.pitch_deg.empty() && !log.roll_deg.empty();
            const double own = headingOf_deg(log.at(row), tilted ? log.pitch_deg[row] : 0.0, tilted ? log.roll_deg[row] : 0.0);
            differences.push_back(wrap180(own - log.heading_deg[row]));
            sine += std::sin(toRadians(differences.back()));
            cosine += std::cos(toRadians(differences.back()));
        }
        if (differences.size() < 8)
            return {};
        const double turn = toDegrees(std::atan2(sine, cosine));
        if (std::all_of(
                differences.begin(), differences.end(), [&](double difference) { return std::abs(wrap180(difference - turn)) <= allowed; }))
            return {
                MARKED("core",
                    "heading_deg is what this compass itself reads%1, to %2° in every row: it cannot show its own deviation; expected a "
                    "reference of its own (inertial, GPS, datum compass)"),
                std::abs(turn) > 0.1 ? " (" + signedFigureText(turn, 2) + "°)" : std::string(), figureText(allowed, 2)};
    }
    if (smoothedOwn(log, used) || lateOwn(log, used))
        return {MARKED("core",
            "heading_deg is what this compass itself reads, smoothed or delayed: it goes with its field, though iron must turn that; expected a "
            "reference of its own (inertial, GPS, datum compass)")};
    return {};
}

} // namespace lubberline
