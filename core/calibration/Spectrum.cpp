#include "core/calibration/Spectrum.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>

#include "core/angle/Angle.h"
#include "core/base/FileText.h"
#include "core/base/Middle.h"
#include "core/base/Number.h"
#include "core/calibration/LogQuality.h"
#include "core/calibration/Welch.h"

namespace lubberline {

namespace {

constexpr double kFalseAlarm = 1e-3; ///< of a whole spectrum
constexpr int kNear = 3;             ///< bins that a line fills on either side (Hann)
constexpr int kNeighbours = 25;

/// The column as stretches without gaps; what is missing inside one, or a spike, lies on the line between its neighbours.
std::vector<std::vector<double>> runsOf(const std::vector<double>& values, const LogQuality& quality, bool isField)
{
    std::vector<std::vector<double>> runs(1);
    std::size_t gap = 0;
    for (std::size_t row = 0; row < values.size(); ++row) {
        if (gap < quality.gaps.size() && quality.gaps[gap].before == row) {
            runs.emplace_back();
            ++gap;
        }
        const bool bad = !std::isfinite(values[row]) || (isField && quality.faults[row] == SampleFault::Spike);
        runs.back().push_back(bad ? kNoValue : values[row]);
    }
    for (auto& run : runs) {
        std::size_t last = run.size();
        for (std::size_t i = 0; i < run.size(); ++i) {
            if (std::isnan(run[i]))
                continue;
            const double before = last < run.size() ? run[last] : run[i];
            const std::size_t from = last < run.size() ? last + 1 : 0;
            for (std::size_t k = from; k < i; ++k)
                run[k] = before + (run[i] - before) * static_cast<double>(k + 1 - from) / static_cast<double>(i + 1 - from);
            last = i;
        }
        if (last == run.size())
            run.clear();
        else
            for (std::size_t k = last + 1; k < run.size(); ++k)
                run[k] = run[last];
    }
    return runs;
}

std::size_t segmentFor(const std::vector<std::vector<double>>& runs)
{
    std::size_t longest = 0;
    for (const auto& run : runs)
        longest = std::max(longest, run.size());
    std::size_t segment = 16;
    while (segment * 2 <= longest / 8 && segment < 8192)
        segment *= 2;
    return segment;
}

struct Peak {
    double frequency_hz = 0, amplitude = 0;
    double within_hz = 0; ///< how far the true frequency may lie off
};

/// A parabola through the logarithms of three bins of a Hann window is off by less than this part of a bin.
constexpr double kOfABin = 0.05;
/// Noise moves its top by 0.7/√(peak over floor × segments) bins; three times that.
double frequencyError_hz(double overFloor, std::size_t segments, double step_hz)
{
    return step_hz * std::min(1.0, kOfABin + 2.1 / std::sqrt(overFloor * static_cast<double>(segments)));
}

/// Less than this of the largest figure is the rounding of numbers, and no line.
double leastLine(const std::vector<std::vector<double>>& runs)
{
    double largest = 0;
    for (const auto& run : runs)
        for (const double value : run)
            largest = std::max(largest, std::abs(value));
    return 1e-9 * largest;
}

std::vector<Peak> peaksOf(const WelchSpectrum& spectrum, double leastAmplitude)
{
    const auto& density = spectrum.density;
    const auto bins = static_cast<int>(density.size());
    const double freedom = std::max(2.0, 1.9 * static_cast<double>(spectrum.segments));
    const auto factorOf = [&](double degrees) {
        const boost::math::chi_squared chance(degrees);
        return quantile(complement(chance, kFalseAlarm / bins)) / quantile(chance, 0.5);
    };
    // At half the sampling rate the spectrum goes on as it came. The bin itself is real: of noise it holds half of what others do, of a line
    // beside it as much, as the line's mirror image stands there too.
    const int last = bins - 1;
    const double factorInside = factorOf(freedom), factorLast = factorOf(std::max(1.0, freedom / 2));
    const auto at = [&](int i) { return density[static_cast<std::size_t>(i > last ? 2 * last - i : i)]; };
    const auto ofNoise = [&](int i) { return i == last ? 0.5 : 1.0; };
    std::vector<Peak> peaks;
    for (int k = kNear; k <= last; ++k) {
        const double factor = k == last ? factorLast : factorInside;
        if (at(k) < at(k - 1) || at(k) < at(k + 1))
            continue;
        std::vector<double> beside;
        for (int i = std::max(2, k - kNeighbours); i <= std::min(bins - 1, k + kNeighbours); ++i)
            if (std::abs(i - k) > kNear)
                beside.push_back(at(i));
        if (beside.size() < 5)
            continue;
        const double floor = middleOf(std::move(beside));
        if (at(k) <= factor * floor * ofNoise(k))
            continue;
        double power = 0;
        for (int i = std::max(1, k - kNear); i <= std::min(bins - 1, k + kNear); ++i)
            power += std::max(0.0, at(i) - floor * ofNoise(i)) * spectrum.step_hz;
        const double amplitude = std::sqrt(k == last ? power : 2 * power);
        if (amplitude <= leastAmplitude)
            continue;
        const double left = std::log(std::max(at(k - 1), 1e-300)), middle = std::log(at(k)), right = std::log(std::max(at(k + 1), 1e-300));
        const double bend = left - 2 * middle + right;
        const double shift = bend < 0 ? std::clamp(0.5 * (left - right) / bend, -0.5, 0.5) : 0.0;
        peaks.push_back({(k + shift) * spectrum.step_hz, amplitude,
            frequencyError_hz(at(k) / (floor * ofNoise(k)), spectrum.segments, spectrum.step_hz)});
    }
    std::sort(peaks.begin(), peaks.end(), [](const Peak& a, const Peak& b) { return a.amplitude > b.amplitude; });
    // The skirts of a strong line are no lines of their own.
    std::vector<Peak> kept;
    for (const auto& peak : peaks)
        if (std::none_of(kept.begin(), kept.end(), [&](const Peak& other) {
                return std::abs(other.frequency_hz - peak.frequency_hz) <= (kNear + 1) * spectrum.step_hz
                    || (std::abs(other.frequency_hz - peak.frequency_hz) <= 12 * spectrum.step_hz
                        && peak.amplitude < 0.01 * other.amplitude);
            }))
            kept.push_back(peak);
    return kept;
}

/// Supplies that sampling folds so far down that the segments are too short for them: their lines look like hard iron that drifts. In
/// longer segments, of which there are fewer; a sensor that is turned has slow lines of its own, so that only those with a name are told.
void addSlowLines(LogSpectrum& result, const std::vector<std::vector<double>>& runs)
{
    std::size_t longest = 0, segment = result.segment;
    for (const auto& run : runs)
        longest = std::max(longest, run.size());
    constexpr std::size_t kLonger = 8;
    while (segment * 2 <= longest / 2 && segment < kLonger * result.segment)
        segment *= 2;
    if (segment == result.segment)
        return;
    const double seenFrom_hz = (kNear + 1) * result.rate_hz / static_cast<double>(result.segment);
    const WelchSpectrum spectrum = welch(runs, segment, result.rate_hz);
    for (const auto& peak : peaksOf(spectrum, leastLine(runs))) {
        SpectralLine line{peak.frequency_hz, peak.amplitude, {}, {}, {}};
        nameLine(line, result.rate_hz, peak.within_hz);
        const bool seen = std::any_of(result.lines.begin(), result.lines.end(),
            [&](const SpectralLine& other) { return std::abs(other.frequency_hz - line.frequency_hz) < seenFrom_hz; });
        // Here mains that are a little off are no reason: whatever moves slowly would be near one.
        const bool there = std::any_of(line.sources.begin(), line.sources.end(), [&](const LineSource& one) {
            return one.exactly && one.aliasOf_hz
                && std::abs(aliasOf_hz(*one.aliasOf_hz, result.rate_hz) - line.frequency_hz) <= spectrum.step_hz;
        });
        if (line.frequency_hz > seenFrom_hz || !there || seen)
            continue;
        result.lines.push_back(std::move(line));
    }
}

const std::vector<double>* columnNamed(const SensorLog& log, const std::string& name)
{
    const std::string small = inSmallLetters(name);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::string own = std::string("b") + "xyz"[axis];
        if (small == own || small.starts_with(own + "_"))
            return &log.field[axis];
    }
    const auto given = [](const std::vector<double>& values) { return values.empty() ? nullptr : &values; };
    if (small == "heading_deg")
        return given(log.heading_deg);
    if (small == "pitch_deg")
        return given(log.pitch_deg);
    if (small == "roll_deg")
        return given(log.roll_deg);
    for (const auto* columns : {&log.others, &log.currents})
        for (const auto& column : *columns)
            if (inSmallLetters(column.name) == small || "current_a:" + inSmallLetters(column.name) == small)
                return &column.values;
    return nullptr;
}

/// Orders of a rotor: the column at even steps of its angle, so that a rotor that changes its speed has lines all the same.
void addOrders(LogSpectrum& result, const std::vector<double>& values, const std::vector<double>& tachometer_rpm)
{
    std::vector<double> turns(values.size(), 0.0);
    double fastest = 0, mean = 0;
    for (std::size_t row = 0; row < values.size(); ++row) {
        const double rate = std::isfinite(tachometer_rpm[row]) ? tachometer_rpm[row] / 60.0 : 0.0;
        turns[row] = (row > 0 ? turns[row - 1] : 0.0) + rate / result.rate_hz;
        fastest = std::max(fastest, rate);
        mean += rate / static_cast<double>(values.size());
    }
    if (fastest <= 0 || turns.back() < 16)
        return;
    const double perTurn = std::max(4.0, std::floor(result.rate_hz / fastest));
    std::vector<std::vector<double>> even(1);
    std::size_t row = 0;
    for (double turn = turns.front(); turn < turns.back(); turn += 1.0 / perTurn) {
        while (row + 2 < turns.size() && turns[row + 1] <= turn)
            ++row;
        const double step = turns[row + 1] - turns[row], part = step > 0 ? std::clamp((turn - turns[row]) / step, 0.0, 1.0) : 0.0;
        even[0].push_back(values[row] + part * (values[row + 1] - values[row]));
    }
    const WelchSpectrum orders = welch(even, segmentFor(even), perTurn);
    for (const auto& peak : peaksOf(orders, leastLine(even))) {
        const double order = std::round(peak.frequency_hz);
        if (order < 1 || std::abs(peak.frequency_hz - order) > 1.5 * orders.step_hz)
            continue;
        std::erase_if(result.lines, [&](const SpectralLine& line) { // seen twice: by frequency and by order
            return std::abs(line.frequency_hz - order * mean) <= 2 * result.rate_hz / static_cast<double>(result.segment);
        });
        result.lines.push_back({order * mean, peak.amplitude, {MARKED("core", "rotor order %1"), static_cast<int>(order)}, {}, {}});
    }
}

Result<LogSpectrum> spectrumOfColumn(
    const SensorLog& log, const std::vector<double>& values, const LogQuality& quality, const SpectrumOptions& options)
{
    LogSpectrum result;
    result.rate_hz = *quality.rate_hz;
    const bool isField = &values == &log.field[0] || &values == &log.field[1] || &values == &log.field[2];
    const auto runs = runsOf(values, quality, isField);
    result.segment = options.segment > 0 ? options.segment : segmentFor(runs);
    const WelchSpectrum spectrum = welch(runs, result.segment, result.rate_hz);
    if (spectrum.segments == 0)
        return Error{ErrorCode::InvalidInput,
            {MARKED("core", "has no stretch of %1 samples without a gap; expected at least one segment"), result.segment}};
    result.segments = spectrum.segments;
    result.density = spectrum.density;
    for (std::size_t k = 0; k < result.density.size(); ++k)
        result.frequency_hz.push_back(static_cast<double>(k) * spectrum.step_hz);
    for (const auto& peak : peaksOf(spectrum, leastLine(runs))) {
        SpectralLine line{peak.frequency_hz, peak.amplitude, {}, {}, {}};
        nameLine(line, result.rate_hz, peak.within_hz);
        result.lines.push_back(std::move(line));
    }
    addSlowLines(result, runs);
    std::sort(
        result.lines.begin(), result.lines.end(), [](const SpectralLine& a, const SpectralLine& b) { return a.amplitude > b.amplitude; });
    return result;
}

} // namespace

Result<LogSpectrum> spectrumOf(const SensorLog& log, const SpectrumOptions& options)
{
    const LogQuality quality = qualityOf(log);
    if (!quality.rate_hz)
        return Error{ErrorCode::InvalidInput, MARKED("core", "has no time; expected a column time_s that goes on")};
    Result<LogSpectrum> result = Error{ErrorCode::InvalidInput, MARKED("core", "has no such column")};
    const std::vector<double>* values = nullptr;
    if (!options.column.empty()) {
        values = columnNamed(log, options.column);
        if (!values)
            return Error{ErrorCode::InvalidInput, {MARKED("core", "has no column %1"), inQuotes(options.column)}};
        result = spectrumOfColumn(log, *values, quality, options);
        if (result)
            result->column = options.column;
    } else {
        double strongest = -1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            auto one = spectrumOfColumn(log, log.field[axis], quality, options);
            if (!one)
                return one;
            const double amplitude = one->lines.empty() ? 0.0 : one->lines.front().amplitude;
            if (amplitude <= strongest)
                continue;
            strongest = amplitude;
            one->column = std::string("b") + "xyz"[axis];
            values = &log.field[axis];
            result = std::move(one);
        }
    }
    if (!result)
        return result;
    if (!options.tachometer.empty()) {
        const auto* tachometer = columnNamed(log, options.tachometer);
        if (!tachometer)
            return Error{ErrorCode::InvalidInput, {MARKED("core", "has no column %1"), inQuotes(options.tachometer)}};
        addOrders(*result, *values, *tachometer);
        std::sort(result->lines.begin(), result->lines.end(),
            [](const SpectralLine& a, const SpectralLine& b) { return a.amplitude > b.amplitude; });
    }
    if (options.maxDelay_ms) {
        std::vector<double> lines_hz;
        for (const auto& line : result->lines)
            lines_hz.push_back(line.frequency_hz);
        result->filter = chooseFilter(result->frequency_hz, result->density, lines_hz, *options.maxDelay_ms);
    }
    for (const auto& line : result->lines) {
        if (line.frequency_hz >= result->frequency_hz.back())
            result->warnings.push_back(
                {MARKED("core",
                     "a line stands at half the sampling rate (%1 Hz): the column goes up and down by %2 %3 from sample to sample, and what makes it may be stronger, as only a part of such a wave shows"),
                    figureText(line.frequency_hz, 2), figureText(line.amplitude, 1), std::string(log.figureUnit())});
        std::string folded;
        for (const auto& source : line.sources)
            if (source.aliasOf_hz)
                folded += (folded.empty() ? "" : ", ") + shortestNumber(std::round(10 * *source.aliasOf_hz) / 10);
        if (!folded.empty())
            result->warnings.push_back(
                {MARKED("core",
                     "the line at %1 Hz may be %2 Hz, folded down by sampling: a filter behind the sensor cannot tell it from what is there"),
                    figureText(line.frequency_hz, 2), folded});
    }
    if (Message zero = warningOfZero(result->rate_hz, result->frequency_hz[1]); !zero.empty())
        result->warnings.push_back(std::move(zero));
    if (options.maxDelay_ms && *options.maxDelay_ms * 1e-3 * result->rate_hz < 1)
        result->warnings.push_back(
            {MARKED("core", "%1 ms are less than one sample of this log (%2 ms): such a filter runs in the sensor, not behind it"),
                figureText(*options.maxDelay_ms, 2), figureText(1e3 / result->rate_hz, 2)});
    result->warnings.insert(result->warnings.end(), quality.remarks.begin(), quality.remarks.end());
    return result;
}

Result<Spectrogram> spectrogramOf(const SensorLog& log, const std::string& column, std::size_t segment, std::size_t most)
{
    const LogQuality quality = qualityOf(log);
    const auto* values = columnNamed(log, column);
    if (!values)
        return Error{ErrorCode::InvalidInput, {MARKED("core", "has no column %1"), inQuotes(column)}};
    if (!quality.rate_hz)
        return Error{ErrorCode::InvalidInput, MARKED("core", "has no time; expected a column time_s that goes on")};
    Spectrogram spectrogram;
    spectrogram.rate_hz = *quality.rate_hz;
    spectrogram.step_hz = *quality.rate_hz / static_cast<double>(segment);
    const auto runs = runsOf(*values, quality, values == &log.field[0] || values == &log.field[1] || values == &log.field[2]);
    const std::size_t length = std::max(segment, values->size() / std::max<std::size_t>(1, most) / segment * segment);
    for (std::size_t place = 0; place < runs.size(); ++place) {
        const auto& run = runs[place];
        const std::size_t first = place == 0 ? 0 : quality.gaps[place - 1].before; // row of the run
        for (std::size_t from = 0; from + length <= run.size(); from += length) {
            const std::vector<std::vector<double>> part{
                {run.begin() + static_cast<std::ptrdiff_t>(from), run.begin() + static_cast<std::ptrdiff_t>(from + length)}};
            spectrogram.density.push_back(welch(part, segment, *quality.rate_hz).density);
            spectrogram.time_s.push_back((log.time_s[first + from] + log.time_s[first + from + length - 1]) / 2);
        }
    }
    return spectrogram;
}

} // namespace lubberline
