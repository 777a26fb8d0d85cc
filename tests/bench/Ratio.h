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

/// Prints one line and says whether the limit is kept.
inline bool report(const char* what, const Timing& timing, const char* reference, double limit)
{
    const bool kept = timing.ratio() <= limit;
    std::printf("%-44s %9.2f ms  = %5.2f x %s (%.2f ms); limit %.2f: %s\n", what, timing.ours_s * 1e3, timing.ratio(), reference,
        timing.reference_s * 1e3, limit, kept ? "kept" : "MISSED");
    std::fflush(stdout);
    return kept;
}

} // namespace lubberline::bench
