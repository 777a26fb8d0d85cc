#include "core/swing/RepeatedReadings.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace lubberline {

namespace {

struct ListedOnce {
    std::vector<Observation> readings; ///< in the order of their first
    std::size_t times = 1;             ///< that each is there
};

std::optional<ListedOnce> listedOnce(std::span<const Observation> readings)
{
    constexpr std::size_t kLeastList = 4, kLongestList = 200;
    if (readings.size() < 2 * kLeastList || readings.size() > kLongestList)
        return std::nullopt;
    ListedOnce once;
    std::map<std::pair<double, double>, std::size_t> times;
    for (const Observation& reading : readings)
        if (++times[{reading.magnetic.degrees(), reading.compass.degrees()}] == 1)
            once.readings.push_back(reading);
    once.times = times.begin()->second;
    const bool equally = std::all_of(times.begin(), times.end(), [&](const auto& one) { return one.second == once.times; });
    return equally && once.times > 1 && once.readings.size() >= kLeastList ? std::optional(std::move(once)) : std::nullopt;
}

void takeErrors(SmithFitReport& fit, const SmithFitReport& once)
{
    fit.standardError = once.standardError;
    fit.covariance = once.covariance;
    fit.unitCovariance = once.unitCovariance;
    fit.intervalFactor = once.intervalFactor;
    fit.lagOneCorrelation = once.lagOneCorrelation;
    fit.degreesOfFreedom = once.degreesOfFreedom;
    fit.sigma_rad = once.sigma_rad;
}

} // namespace

std::optional<Message> countOnce(std::span<const Observation> readings, ApproximateFit& approximate, ExactFit& exact)
{
    const auto once = listedOnce(readings);
    if (!once || !approximate.fitted() || !exact.fitted())
        return std::nullopt;
    const auto approximateOnce = fitApproximate(once->readings);
    const auto exactOnce = fitExact(once->readings);
    if (!approximateOnce || !exactOnce)
        return std::nullopt;
    takeErrors(approximate, *approximateOnce);
    takeErrors(exact, *exactOnce);
    return Message{MARKED("core",
                       "every reading is there %1 times with the same figures, as when a list is entered again: the errors are those of %2 "
                       "readings, and a slip hides behind its copies; take the copies out"),
        once->times, once->readings.size()};
}

} // namespace lubberline
