#pragma once
/// Critical values of the jump test where errors are known, as tables by pattern of dates, each made once. A pattern is what they depend
/// on, roughly: where figures lie between the first and the last, in eighths of their mean distance (swings every year are one pattern,
/// be it every second year, and some weeks early or late); errors to their nearest 2^(1/4); what is corrected or known; wandering against
/// the errors to the nearest 2^(1/2). Chances are those of exact dates within a tenth of themselves.
/// A table comes of its pattern alone: the same whoever asked first, in whatever order and on however many threads.

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "core/fleet/JumpTest.h"

namespace lubberline {

struct JumpPattern {
    struct Figure {
        std::int32_t position = 0; ///< in eighths of the mean distance
        std::int16_t error = 0;    ///< quarters of the binary logarithm of its standard error over that of all
        bool known = false;        ///< a correction or a known jump before it
        auto operator<=>(const Figure&) const = default;
    };
    std::vector<Figure> figures;
    std::int32_t wander = kStill; ///< halves of the binary logarithm of its variance over the mean distance, over that of a figure
    std::int32_t leastSegment = 1;
    bool trend = true;
    static constexpr std::int32_t kStill = INT32_MIN;
    auto operator<=>(const JumpPattern&) const = default;
};
[[nodiscard]] JumpPattern jumpPatternOf(std::span<const DatedValue> series, const JumpOptions& options);

/// Of one pattern.
class JumpTable {
public:
    explicit JumpTable(const JumpPattern& pattern);
    /// That the largest statistic of all places is as far from 0 or farther, if there is no jump; never less than that of one place.
    [[nodiscard]] double chanceBeyond(double statistic) const;
    /// The statistic that is exceeded with a chance.
    [[nodiscard]] double criticalValue(double chance) const;

private:
    static constexpr double kStep = 0.25;
    static constexpr std::size_t kSteps = 33; ///< 0 to 8: beyond, places exclude one another
    std::array<double, kSteps> m_worth{};     ///< JumpDesign::worthOfPlaces(); none: nothing can be tested
};

/// The tables that were asked for, up to a bound.
class JumpChances {
public:
    [[nodiscard]] std::shared_ptr<const JumpTable> of(const JumpPattern& pattern);
    [[nodiscard]] std::size_t patterns() const;

private:
    static constexpr std::size_t kMost = 8192;
    mutable std::mutex m_mutex;
    std::map<JumpPattern, std::shared_ptr<const JumpTable>> m_tables;
};

/// Those of this run of the program.
[[nodiscard]] JumpChances& jumpChances();

} // namespace lubberline
