#pragma once
/// A log of a three-axis magnetic sensor as columns: body axes (x forward, y starboard, z down). What a cell did not hold is NaN.

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "core/base/Message.h"

namespace lubberline {

inline constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// What the field of a log is counted in. Counts stay counts: nothing tells what one is worth.
enum class FieldUnit { Nanotesla, Microtesla, Milligauss, Gauss, Counts };
[[nodiscard]] double nanoteslaPer(FieldUnit unit); ///< 1 for counts
[[nodiscard]] std::string_view nameOf(FieldUnit unit);

/// Any other column: a current, a temperature, a tachometer, an applied field.
struct LogColumn {
    std::string name; ///< as in the file; of `current_A:NAME` the NAME alone, in `currents`
    std::vector<double> values;
};

/// How many cells and rows were not what they should be.
struct LogCounts {
    std::int64_t rows = 0;
    std::int64_t emptyCells = 0, nanCells = 0, badCells = 0; ///< of the columns in use; bad: neither empty, nor "nan", nor a number
    std::int64_t shortRows = 0;                              ///< fewer cells than the header
};

struct SensorLog {
    std::vector<double> time_s;               ///< empty: the log has no time
    std::array<std::vector<double>, 3> field; ///< in nT, or in counts
    FieldUnit unit = FieldUnit::Nanotesla;    ///< of the file
    Message unitReason;                       ///< how it is known
    std::vector<double> heading_deg;          ///< magnetic; empty: no such column (likewise below)
    std::vector<double> pitch_deg, roll_deg;
    std::vector<LogColumn> currents; ///< [A]
    std::vector<LogColumn> others;
    LogCounts counts;
    std::vector<Message> warnings;

    [[nodiscard]] std::size_t size() const { return field[0].size(); }
    [[nodiscard]] bool hasAttitude() const { return !heading_deg.empty() && !pitch_deg.empty() && !roll_deg.empty(); }
    [[nodiscard]] Eigen::Vector3d at(std::size_t row) const { return {field[0][row], field[1][row], field[2][row]}; }
    [[nodiscard]] bool hasField(std::size_t row) const
    {
        return std::isfinite(field[0][row]) && std::isfinite(field[1][row]) && std::isfinite(field[2][row]);
    }
    /// "nT" or "counts": what figures of this log are in.
    [[nodiscard]] std::string_view figureUnit() const { return unit == FieldUnit::Counts ? "counts" : "nT"; }
};

/// Another column by its name in small or large letters; null: there is none.
[[nodiscard]] const std::vector<double>* columnOf(const SensorLog& log, std::string_view name);

/// The rows of a time span, both ends belong to it. A log without time is counted in rows.
[[nodiscard]] SensorLog partOf(const SensorLog& log, double from, double to);

} // namespace lubberline
