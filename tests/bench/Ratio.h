#pragma once
/// Speed as a ratio of two things measured in the same run, in turns, so that a slow or busy machine does not matter.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <vector>

namespace lubberline::bench {

inline double seconds(const std::function<void()>& work)
{
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

inline double median(std::vector<double> values)
{
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

struct Timing {
    double ours_s = 0;
    double reference_s = 0;
    [[nodiscard]] double ratio() const { return ours_s / reference_s; }
};

/// Medians of `rounds` runs of both, taken in turns after one warm-up of each.
inline Timing compare(const std::function<void()>& ours, const std::function<void()>& reference, int rounds)
{
    ours();
    reference();
    std::vector<double> a, b;
    for (int i = 0; i < rounds; ++i) {
        a.push_back(seconds(ours));
        b.push_back(seconds(reference));
    }
    return {median(a), median(b)};
}

/// Prints one row of the table of installer/bench and says whether the target is met.
inline bool row(const char* what, double ours, double theirs, const char* against, double limit)
{
    const bool met = ours / theirs <= limit;
    std::printf("| %-44s | %10.2f | %10.2f | %7.2f | %6.2f | %-6s | %s\n", what, ours, theirs, ours / theirs, limit, met ? "met" : "MISSED",
        against);
    std::fflush(stdout);
    return met;
}

/// The same, of times [ms].
inline bool report(const char* what, const Timing& timing, const char* reference, double limit)
{
    return row(what, timing.ours_s * 1e3, timing.reference_s * 1e3, reference, limit);
}

} // namespace lubberline::bench
