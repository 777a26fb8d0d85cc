#include "core/calibration/DelayFilter.h"

#include <algorithm>
#include <cmath>

#include "core/angle/Angle.h"

namespace lubberline {

namespace {

constexpr double kNotchQ = 5;

double notchDelay_ms(double frequency_hz) { return 1e3 / (2 * kPi * frequency_hz * kNotchQ); }

DelayFilter filterWith(
    std::span<const double> frequency_hz, std::span<const double> density, std::vector<double> notches, double maxDelay_ms)
{
    DelayFilter filter;
    filter.notches_hz = std::move(notches);
    for (const double frequency : filter.notches_hz)
        filter.delay_ms += notchDelay_ms(frequency);
    if (const double rest = maxDelay_ms - filter.delay_ms; rest > 1e-6) {
        filter.lowPass_hz = 1e3 / (2 * kPi * rest);
        filter.delay_ms = maxDelay_ms;
    }
    filter.from_hz = std::max(1.0, 3 * frequency_hz[1]);
    for (std::size_t k = 1; k < density.size(); ++k)
        if (frequency_hz[k] >= filter.from_hz) {
            const double power = density[k] * frequency_hz[1];
            filter.before_rms += power;
            filter.left_rms += power * gainSquared(filter, frequency_hz[k]);
        }
    filter.before_rms = std::sqrt(filter.before_rms);
    filter.left_rms = std::sqrt(filter.left_rms);
    return filter;
}

} // namespace

double gainSquared(const DelayFilter& filter, double frequency_hz)
{
    double gain = 1;
    for (const double notch : filter.notches_hz) {
        const double r = frequency_hz / notch, top = (1 - r * r) * (1 - r * r);
        gain *= top / (top + r * r / (kNotchQ * kNotchQ));
    }
    if (filter.lowPass_hz) {
        const double r = frequency_hz / *filter.lowPass_hz;
        gain /= 1 + r * r;
    }
    return gain;
}

DelayFilter chooseFilter(
    std::span<const double> frequency_hz, std::span<const double> density, std::span<const double> lines_hz, double maxDelay_ms)
{
    DelayFilter best = filterWith(frequency_hz, density, {}, maxDelay_ms);
    for (;;) {
        std::optional<DelayFilter> better;
        for (const double line_hz : lines_hz) {
            auto notches = best.notches_hz;
            if (line_hz < 1 || std::find(notches.begin(), notches.end(), line_hz) != notches.end())
                continue;
            notches.push_back(line_hz);
            double delay = 0;
            for (const double frequency : notches)
                delay += notchDelay_ms(frequency);
            if (delay > maxDelay_ms)
                continue;
            if (DelayFilter filter = filterWith(frequency_hz, density, notches, maxDelay_ms);
                filter.left_rms < (better ? better->left_rms : 0.99 * best.left_rms))
                better = std::move(filter);
        }
        if (!better)
            break;
        best = std::move(*better);
    }
    std::sort(best.notches_hz.begin(), best.notches_hz.end());
    return best;
}

} // namespace lubberline
