#pragma once
/// A log with its sensor's model taken out: how far headings were off before and are after, and what a helmet system would ask.

#include <optional>
#include <span>

#include "core/base/Result.h"
#include "core/calibration/SensorLog.h"
#include "core/earth/EarthField.h"
#include "core/sensor/ModelUncertainty.h"
#include "core/sensor/SensorModel.h"

namespace lubberline {

/// Of heading errors: indication error, read − magnetic.
struct HeadingErrors {
    double mean_deg = 0, rms_deg = 0;
    double p95_deg = 0, max_deg = 0;       ///< of their size
    std::array<double, 9> harmonics_deg{}; ///< of the error over magnetic heading: constant, sine and cosine of orders 1 to 4
};

/// A demand that has a figure of its own; none is known where nothing tells it.
struct Demand {
    Message name;
    std::optional<double> value;
    double limit = 0;
    std::string unit;
    bool atLeast = false; ///< the value must be at least the limit; else at most
    [[nodiscard]] std::optional<bool> met() const
    {
        return value ? std::optional(atLeast ? *value >= limit : *value <= limit) : std::nullopt;
    }
};

/// Of the deviation of a log over heading and pitch, as the log itself shows it.
inline constexpr double kCellHeading_deg = 15, kCellPitch_deg = 10;

/// Means of a cell; deviation is magnetic − read.
struct ErrorCell {
    double heading_deg = 0, pitch_deg = 0; ///< the middle
    std::size_t samples = 0;
    double before_deg = 0;
    std::optional<double> after_deg; ///< none without a reference heading: then what compensation makes is the reference of `before`
    std::optional<double> sigma_deg; ///< of a compensated heading there, as sure as the calibration is
};

struct CompensationOptions {
    std::optional<MeridianField> field = {};          ///< of the model: held against the log
    std::optional<double> latency_ms = {};            ///< of the sensor, as its maker states it
    double filter_ms = 0;                             ///< delay of a filter before the heading is used
    std::optional<ModelUncertainty> uncertainty = {}; ///< of the model's calibration
};

struct CompensatedLog {
    std::array<std::vector<double>, 3> field;  ///< NaN where the log has none
    std::vector<double> before_deg, after_deg; ///< compass headings, level where the log has no attitude
    std::optional<double> rate_hz;
    std::optional<HeadingErrors> before, after; ///< none without a reference heading
    double spreadBefore = 0, spreadAfter = 0;   ///< standard deviation of the field's size
    std::vector<ErrorCell> map;                 ///< deviation before and after over heading and pitch
    std::vector<Demand> demands;                ///< of helmet systems [P]: 240 Hz, 3.5 ms, 0.2° rms
    std::vector<Message> warnings;
};

/// A circuit of the model carries the log's current of its name; where the log has none, what the model says.
/// Errors: Numeric (the model has no inverse), InvalidInput (a log in counts and a model with a field, no samples; a reference that is the compass itself).
Result<CompensatedLog> compensate(const SensorLog& log, const SensorModel& model, const CompensationOptions& options);

/// B = matrix (m − offset) and the level heading of each, in a loop that vectorises: what a computer on board does 240 times a second.
void levelHeadings(const std::array<std::span<const double>, 3>& measured, const Eigen::Matrix3d& matrix, const Eigen::Vector3d& offset,
    std::span<double> heading_deg);

/// `time_s, bx_nT … , heading_before_deg, heading_after_deg` of a compensated log.
[[nodiscard]] std::string writeCompensatedCsv(const SensorLog& log, const CompensatedLog& compensated);

} // namespace lubberline
