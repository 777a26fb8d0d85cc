#pragma once
/// What is wrong with a log before anything is computed of it: gaps, repeats, a stuck axis, clipping, spikes.

#include <cstdint>
#include <vector>

#include "core/calibration/SensorLog.h"

namespace lubberline {

enum class SampleFault : std::uint8_t { None, Missing, Repeat, Stuck, Clipped, Spike };

struct TimeGap {
    std::size_t before = 0; ///< the row behind the gap
    double from_s = 0, length_s = 0;
};

/// The finite ends of an axis, and how many rows stand there.
struct AxisEnds {
    double lowest = std::numeric_limits<double>::infinity(), highest = -std::numeric_limits<double>::infinity();
    std::size_t atLowest = 0, atHighest = 0;
};

struct LogQuality {
    std::vector<SampleFault> faults; ///< of each row; the first that applies
    std::array<std::int64_t, 6> count{};
    std::array<AxisEnds, 3> ends;
    std::optional<double> rate_hz; ///< of the median step; none without time
    std::vector<TimeGap> gaps;     ///< longer than 2.5 median steps
    std::vector<Message> remarks;  ///< each fault in words, with its figure

    [[nodiscard]] std::int64_t of(SampleFault fault) const { return count[static_cast<std::size_t>(fault)]; }
};

/// Why most rows cannot be used, with their figure and the axis that is at fault; empty where most can.
[[nodiscard]] Message whyFewUsable(const SensorLog& log, const LogQuality& quality);

/// Repeat: a row of three figures that are the row's before it (data read faster than the sensor makes them); kept in use, as it is only
/// no news. Stuck: one axis shows the same figure in 50 rows and more while another one moves by more than 20 of its own steps.
/// Clipped: three rows and more stand at the largest or smallest figure of an axis, and no figure is near it. Spike: a row that leaves
/// the line between its neighbours (median of five) by more than 12 of the log's own scatter, and neither comes again after equal
/// steps nor stands among many such rows, as a strong line of the spectrum does.
[[nodiscard]] LogQuality qualityOf(const SensorLog& log);

} // namespace lubberline
