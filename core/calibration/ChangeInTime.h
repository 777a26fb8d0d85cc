#pragma once
/// Private to the calibrations: whether what a fit leaves over is another before a moment of the log than after it. Iron that was put down or
/// magnetised on the way leaves the mean of both halves, which is right for neither, with an error that looks small.
/// The rows' normal equations are summed in kTimeBlocks parts of equal length; for each moment between two of them a step of some
/// parameters is added to the fit (score test), and the one that explains most is told.

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/algebra/Matrices.h"
#include "core/calibration/Ellipsoid.h"

namespace lubberline {

inline constexpr std::size_t kTimeBlocks = 16;

/// Of one part of a log: Σ j jᵀ and Σ j r, r the residuals of one or more axes that share j.
struct TimeBlock {
    Eigen::MatrixXd normal, score;
};
using TimeBlocks = std::array<TimeBlock, kTimeBlocks>;

[[nodiscard]] inline std::size_t timeBlockOf(std::size_t row, std::size_t rows) { return row * kTimeBlocks / rows; }

struct ChangeInTime {
    std::size_t after = 0;                             ///< blocks that lie before it
    Eigen::Vector3d hardIron{0, 0, 0}, error{0, 0, 0}; ///< after − before, with standard errors
    double gain = 0, gainError = 0;                    ///< part of the field
    [[nodiscard]] bool isAfter(std::size_t row, std::size_t rows) const { return row * kTimeBlocks >= after * rows; }
    void widen(double factor) ///< of the standard errors
    {
        error *= factor;
        gainError *= factor;
    }
    /// Of it, what the mean of both is wrong by in the part that it fits worse.
    [[nodiscard]] double worse() const { return static_cast<double>(std::max(after, kTimeBlocks - after)) / kTimeBlocks; }
};

/// @param free columns: what the fit fitted, of the rows' parameters
/// @param steps one for each axis of the residuals; columns: what may step, first its hard iron (three of one axis, or one of three axes), last its gain
/// @param variance of a residual, with what neighbours share
/// @return none where no step explains more than chance
[[nodiscard]] std::optional<ChangeInTime> changeInTime(
    const TimeBlocks& blocks, const Eigen::MatrixXd& free, const std::vector<Eigen::MatrixXd>& steps, double variance);

/// In words, where it matters: more than 5 standard errors and 0.4 % of the field, 0.3° of heading where a compass is at home.
[[nodiscard]] Message wordsOf(const ChangeInTime& change, const SensorLog& log, double field);

/// A part of a log that is left out nearly whole: no spikes, but another field. Empty: there is none.
[[nodiscard]] Message leftOutTogether(const std::vector<std::uint8_t>& offered, const std::vector<std::uint8_t>& used);

/// Residuals of a log that follow each other are no independent witnesses: the variance of the mean of whole stretches of them over what
/// independent ones would have, 1 and more; 1 where chance explains it, or where there are fewer than 100. @param residuals in the order of
/// the log
[[nodiscard]] double slowResidualFactor(std::span<const double> residuals);

} // namespace lubberline
