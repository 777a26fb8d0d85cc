// Rows come in any order: flights in order of time, the newest first, shuffled. A turn shows only between neighbours in time.

#include <algorithm>

#include "core/inflight/WindStudyParts.h"

namespace lubberline {

void WindStudy::Held::hold(WindStudy& study, Aircraft& aircraft, Flight& flight, const WindReport& report)
{
    if (flight.held.empty()) {
        waiting.push_back({&aircraft, &flight});
        if (!spare.empty()) {
            flight.held = std::move(spare.back());
            spare.pop_back();
        }
    }
    HeldReport& own = flight.held.emplace_back(HeldReport{report, std::string(report.source)});
    own.report.aircraft = aircraft.name;
    own.report.flight = flight.name;
    own.report.group = {};
    if (++count < kMost)
        return;
    const Waiting longest = waiting.front();
    waiting.pop_front();
    release(study, longest);
}

void WindStudy::Held::release(WindStudy& study, const Waiting& which)
{
    Flight& flight = *which.flight;
    std::vector<HeldReport> released = std::move(flight.held);
    flight.held = {};
    count -= released.size();
    const auto earlier = [](const HeldReport& a, const HeldReport& b) { return a.report.time_s < b.report.time_s; };
    if (!std::is_sorted(released.begin(), released.end(), earlier))
        std::stable_sort(released.begin(), released.end(), earlier);
    for (HeldReport& held : released) {
        held.report.source = held.source;
        if (held.report.time_s < flight.latest_s)
            ++which.aircraft->late;
        study.take(*which.aircraft, flight, held.report);
    }
    if (!released.empty())
        flight.latest_s = std::max(flight.latest_s, released.back().report.time_s);
    constexpr std::size_t kMostSpare = 16, kOrdinary = 1024;
    if (spare.size() < kMostSpare && released.capacity() <= kOrdinary) {
        released.clear();
        spare.push_back(std::move(released));
    }
}

/// By their beginnings: an aircraft's running fit sees its flights in order, whatever that of the rows.
void WindStudy::Held::releaseAll(WindStudy& study)
{
    std::stable_sort(
        waiting.begin(), waiting.end(), [](const Waiting& a, const Waiting& b) { return a.flight->from_s < b.flight->from_s; });
    for (const Waiting& one : waiting)
        release(study, one);
    waiting.clear();
}

} // namespace lubberline
