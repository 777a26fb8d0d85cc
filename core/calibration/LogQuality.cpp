#include "core/calibration/LogQuality.h"

#include <algorithm>

#include "core/base/Middle.h"
#include "core/base/Number.h"
#include "core/calibration/QuickLook.h"

namespace lubberline {

namespace {

constexpr double kSpikeScatters = 12.0;
constexpr std::size_t kLongestPeriod = 64; ///< rows, of what comes again
constexpr double kMedianToSigma = 1.4826;

void note(LogQuality& quality, std::size_t row, SampleFault fault)
{
    if (quality.faults[row] == SampleFault::None)
        quality.faults[row] = fault;
}

constexpr std::size_t kStretch = 256; ///< rows

/// Stretches of rows all over a long log: as many as tell its scatter to a percent.
template <class Use>
void someStretches(std::size_t count, Use&& use)
{
    constexpr std::size_t stretches = 200;
    const std::size_t step = std::max(kStretch, count / stretches);
    for (std::size_t from = 0; from < count; from += step)
        use(from, std::min(from + kStretch, count));
}

void findGaps(const SensorLog& log, LogQuality& quality)
{
    // Of a long log's steps enough to tell the middle one: nearly all are alike.
    std::vector<double> some;
    const auto take = [&](std::size_t from, std::size_t to) {
        for (std::size_t row = std::max<std::size_t>(from, 1); row < to; ++row)
            if (log.time_s[row] > log.time_s[row - 1])
                some.push_back(log.time_s[row] - log.time_s[row - 1]);
    };
    someStretches(log.time_s.size(), take);
    if (some.empty())
        take(1, log.time_s.size());
    if (some.empty()) {
        if (log.time_s.size() > 1)
            quality.remarks.push_back(
                {MARKED("core", "time stands at %1 s in all rows: no rate and no gaps are known"), shortestNumber(log.time_s.front())});
        return;
    }
    const double step = middleOf(std::move(some));
    // The mean of those like it: times that are written to a millisecond or two have no step of their true length.
    double lasting = 0, alike = 0, longest = 0, lost = 0;
    for (std::size_t row = 1; row < log.time_s.size(); ++row) {
        const double length = log.time_s[row] - log.time_s[row - 1];
        const bool isAlike = length > 0.5 * step && length < 1.5 * step;
        lasting += isAlike ? length : 0.0;
        alike += isAlike ? 1.0 : 0.0;
        if (length > 2.5 * step) {
            quality.gaps.push_back({row, log.time_s[row - 1], length});
            longest = std::max(longest, length);
            lost += length - step;
        }
    }
    quality.rate_hz = alike / lasting;
    if (!quality.gaps.empty())
        quality.remarks.push_back({MARKED_N("core", "%n gap(s) in time, the longest %1 s, together %2 s"), quality.gaps.size(),
            figureText(longest, 2), figureText(lost, 2)});
}

void findMissingAndRepeats(const SensorLog& log, LogQuality& quality)
{
    for (std::size_t row = 0; row < log.size(); ++row) {
        if (!log.hasField(row))
            note(quality, row, SampleFault::Missing);
        else if (row > 0 && log.field[0][row] == log.field[0][row - 1] && log.field[1][row] == log.field[1][row - 1]
            && log.field[2][row] == log.field[2][row - 1])
            note(quality, row, SampleFault::Repeat);
    }
}

/// Whether the other axes move while this one stands, over rows [from, to).
bool othersMove(const SensorLog& log, std::size_t axis, std::size_t from, std::size_t to)
{
    for (std::size_t other = 0; other < 3; ++other) {
        if (other == axis)
            continue;
        std::size_t changes = 0;
        for (std::size_t row = from + 1; row < to; ++row)
            changes += log.field[other][row] != log.field[other][row - 1] ? 1 : 0;
        if (2 * changes > to - from)
            return true;
    }
    return false;
}

void findStuck(const SensorLog& log, const QuickLook& look, LogQuality& quality)
{
    constexpr std::array<char, 3> kAxes{'x', 'y', 'z'};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!look.stands[axis])
            continue;
        const auto& values = log.field[axis];
        std::size_t rows = 0;
        for (std::size_t from = 0; from < values.size();) {
            std::size_t to = from + 1;
            while (to < values.size() && values[to] == values[from])
                ++to;
            if (to - from >= kStuckRows && quality.faults[from] != SampleFault::Clipped && othersMove(log, axis, from, to)) {
                rows += to - from;
                for (std::size_t row = from; row < to; ++row)
                    note(quality, row, SampleFault::Stuck);
            }
            from = to;
        }
        if (rows > 0)
            quality.remarks.push_back(
                {MARKED_N("core", "axis %1 is stuck in %n row(s): its figure stands while another axis moves"), rows, kAxes[axis]});
    }
}

/// Rows that stand at the end of an axis' range, where more of them do than a crest that is not cut off would leave.
void findClipped(const SensorLog& log, LogQuality& quality)
{
    constexpr std::array<char, 3> kAxes{'x', 'y', 'z'};
    constexpr std::size_t kFewest = 5;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const AxisEnds& ends = quality.ends[axis];
        if (std::max(ends.atLowest, ends.atHighest) < kFewest)
            continue;
        std::vector<double> values;
        for (const double value : log.field[axis])
            if (std::isfinite(value))
                values.push_back(value);
        if (values.size() < 20)
            continue;
        const double lowest = ends.lowest, highest = ends.highest;
        if (highest <= lowest)
            continue;
        for (const double end : {lowest, highest}) {
            const double near = 0.002 * (highest - lowest);
            std::size_t at = 0, beside = 0, run = 0, longest = 0;
            for (const double value : log.field[axis]) {
                at += value == end ? 1 : 0;
                beside += value != end && std::abs(value - end) <= near ? 1 : 0;
                run = value == end ? run + 1 : 0;
                longest = std::max(longest, run);
            }
            // Coarse figures repeat their largest, too: then what lies beside it repeats as often.
            if (longest < 3 || at < kFewest || at < 3 * beside)
                continue;
            std::size_t distinct = 0;
            std::sort(values.begin(), values.end());
            for (std::size_t i = 1; i < values.size(); ++i)
                distinct += values[i] != values[i - 1] ? 1 : 0;
            if (distinct < 50 || at * distinct < 10 * values.size())
                continue;
            // A crest that is cut off comes and goes; an axis that died at its largest figure stays.
            if (longest >= 2 * kStuckRows && 10 * longest > 9 * at && 2 * at > values.size())
                continue;
            for (std::size_t row = 0; row < log.size(); ++row)
                if (log.field[axis][row] == end)
                    note(quality, row, SampleFault::Clipped);
            quality.remarks.push_back({MARKED_N("core", "axis %1 is cut off at %2 %3 in %n row(s): the field is beyond the sensor's range"),
                at, kAxes[axis], figureText(end, 1), log.figureUnit()});
        }
    }
}

/// How far a row may leave the middle of five: 12 of the log's own scatter.
double spikeLimit(const std::vector<double>& values)
{
    std::vector<double> off;
    std::size_t asked = 0;
    std::array<double, kStretch> away{};
    someStretches(values.size(), [&](std::size_t from, std::size_t to) {
        asked += to - from;
        from = std::max<std::size_t>(from, 2);
        to = std::min(to, values.size() - 2);
        if (from >= to)
            return;
        awayFromMiddle(&values[from - 2], to - from, away.data());
        for (std::size_t i = 0; i < to - from; ++i)
            if (std::isfinite(away[i]) && away[i] != 0)
                off.push_back(std::abs(away[i]));
    });
    if (off.size() < asked / 8) { // so smooth that most samples are the middle of their neighbours: what bends is its scatter
        off.clear();
        someStretches(values.size(), [&](std::size_t from, std::size_t to) {
            for (std::size_t row = std::max<std::size_t>(from, 1); row < std::min(to, values.size() - 1); ++row) {
                const double bend = values[row] - 0.5 * (values[row - 1] + values[row + 1]);
                if (std::isfinite(bend) && bend != 0)
                    off.push_back(std::abs(bend));
            }
        });
    }
    return off.empty() ? std::numeric_limits<double>::max() : kSpikeScatters * kMedianToSigma * middleOf(std::move(off));
}

/// In a log whose samples follow each other; of one whose rows are in no order the scatter is as large as the field, and nothing is found.
std::array<double, 3> spikeLimits(const SensorLog& log)
{
    constexpr std::size_t fewest = 20;
    std::array<double, 3> limits;
    limits.fill(std::numeric_limits<double>::max());
    for (std::size_t axis = 0; axis < 3 && log.size() >= fewest; ++axis)
        limits[axis] = spikeLimit(log.field[axis]);
    return limits;
}

/// Whether what leaves its neighbours at a row does so again after equal steps, on both sides or twice on one: a line of the spectrum, maybe
/// one that was switched on for a part of the log, and no spike. Of spikes at random, 3 in 100 rows, one in twenty looks like that.
bool comesAgain(const std::vector<double>& away, std::size_t row)
{
    const auto alike = [&](std::size_t at) { // a row before the first wraps around, and is none
        const double ratio = at < away.size() ? away[at] / away[row] : 0.0;
        return ratio > 0.5 && ratio < 2.0;
    };
    for (std::size_t step = 2; step <= kLongestPeriod; ++step) {
        const bool before = alike(row - step), behind = alike(row + step);
        if ((before && behind) || (before && alike(row - 2 * step)) || (behind && alike(row + 2 * step)))
            return true;
    }
    return false;
}

/// Whether a row is one of many around it that leave their neighbours, and by no more than they do: a disturbance, and no spike.
bool amongMany(const std::vector<double>& away, std::size_t row, double limit)
{
    std::vector<double> others;
    for (std::size_t at = row - std::min(row, kLongestPeriod / 2); at <= row + kLongestPeriod / 2 && at < away.size(); ++at)
        if (std::abs(away[at]) > limit)
            others.push_back(std::abs(away[at]));
    return others.size() * 5 > kLongestPeriod && std::abs(away[row]) < 4 * middleOf(std::move(others));
}

void findSpikes(const SensorLog& log, const QuickLook& look, const std::array<double, 3>& limits, LogQuality& quality)
{
    std::vector<double> away; // how far each row leaves the middle of five around it; NaN where that is not known
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!look.leaves[axis])
            continue;
        away.resize(log.size(), kNoValue);
        awayFromMiddle(log.field[axis].data(), log.size() - 4, away.data() + 2);
        for (std::size_t row = 0; row < away.size(); ++row)
            if (std::abs(away[row]) > limits[axis] && log.hasField(row) && !comesAgain(away, row) && !amongMany(away, row, limits[axis]))
                note(quality, row, SampleFault::Spike);
    }
}

} // namespace

Message whyFewUsable(const SensorLog& log, const LogQuality& quality)
{
    const auto lost = [&quality](SampleFault fault) { return quality.of(fault); };
    const auto usable = lost(SampleFault::None) + lost(SampleFault::Repeat), all = static_cast<std::int64_t>(log.size());
    if (all == 0 || 2 * usable > all)
        return {};
    constexpr std::array kFaults{SampleFault::Stuck, SampleFault::Missing, SampleFault::Clipped, SampleFault::Spike};
    const SampleFault worst
        = *std::max_element(kFaults.begin(), kFaults.end(), [&](SampleFault a, SampleFault b) { return lost(a) < lost(b); });
    switch (worst) {
    case SampleFault::Stuck: {
        // The axis that stands longest.
        std::array<std::int64_t, 3> standing{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (std::size_t row = 1; row < log.size(); ++row)
                standing[axis] += log.field[axis][row] == log.field[axis][row - 1] ? 1 : 0;
        const auto axis = std::max_element(standing.begin(), standing.end()) - standing.begin();
        return {MARKED("core",
                    "axis %1 is stuck in %2 of %3 samples: its figure stands while another axis moves; look at its cable and its column"),
            "xyz"[axis], lost(worst), all};
    }
    case SampleFault::Missing: return {MARKED("core", "%1 of %2 samples have no whole field: empty cells, or NaN"), lost(worst), all};
    case SampleFault::Clipped:
        return {MARKED("core", "%1 of %2 samples are cut off: the field is beyond the sensor's range"), lost(worst), all};
    default: return {MARKED("core", "%1 of %2 samples are spikes"), lost(worst), all};
    }
}

LogQuality qualityOf(const SensorLog& log)
{
    LogQuality quality;
    quality.faults.assign(log.size(), SampleFault::None);
    findGaps(log, quality);
    const auto limits = spikeLimits(log);
    const QuickLook look = lookOver(log, limits);
    quality.ends = look.ends;
    findClipped(log, quality);
    findStuck(log, look, quality);
    findSpikes(log, look, limits, quality);
    if (look.incomplete)
        findMissingAndRepeats(log, quality);
    quality.count.fill(0);
    for (const auto fault : quality.faults)
        ++quality.count[static_cast<std::size_t>(fault)];
    const auto tell = [&](SampleFault fault, Pattern pattern) {
        if (quality.of(fault) > 0)
            quality.remarks.push_back({pattern, quality.of(fault)});
    };
    tell(SampleFault::Missing, MARKED_N("core", "%n row(s) left out without a whole field (empty cells or NaN)"));
    tell(SampleFault::Spike, MARKED_N("core", "%n spike(s) left out, away from both neighbours by more than 12 times the log's scatter"));
    if (quality.of(SampleFault::Repeat) * 20 > quality.count[0])
        tell(SampleFault::Repeat,
            MARKED_N("core", "%n row(s) alike the row before: the sensor was read faster than it measures, which tells nothing new"));
    return quality;
}

} // namespace lubberline
