#pragma once
/// Studies of simulated fleets.

#include <algorithm>

#include "tests/core/inflight/SimulatedWinds.h"

namespace lubberline::test {

inline bool says(const std::vector<Message>& warnings, const std::string& words)
{
    return std::any_of(
        warnings.begin(), warnings.end(), [&](const Message& one) { return one.english().find(words) != std::string::npos; });
}

inline WindResult studyOf(const std::vector<SimulatedAircraft>& fleet, std::uint64_t seed, const SimulatedReference& reference = {},
    const std::function<void(WindReport&)>& spoil = {}, const WindOptions& options = {})
{
    SimulatedWinds winds(seed);
    WindStudy study(options);
    for (const auto& aircraft : fleet)
        winds.fly(aircraft, reference, [&](WindReport& report) {
            if (spoil)
                spoil(report);
            study.add(report);
        });
    return study.finish();
}

inline std::vector<SimulatedAircraft> someAircraft(int count, std::uint64_t seed)
{
    SimulatedWinds random(seed);
    std::vector<SimulatedAircraft> fleet(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        auto& one = fleet[static_cast<std::size_t>(i)];
        one.name = "A" + std::to_string(10 + i);
        one.c_deg = 0.5 * random.normal();
        one.a_deg = 1.5 * random.normal();
        one.b_deg = 1.5 * random.normal();
    }
    return fleet;
}

} // namespace lubberline::test
