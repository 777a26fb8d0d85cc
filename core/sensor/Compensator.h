#pragma once
/// A compensator beside the sensor: magnets along three axes and soft-iron correctors along two, each within its reach, and the setting that is
/// best over a range of attitudes. What is adjusted level only is not best there: the vertical magnet (heeling) and the split between magnets
/// and soft iron show in pitch and roll alone.

#include <array>

#include "core/base/Message.h"
#include "core/sensor/SensorReading.h"

namespace lubberline {

/// What the correctors add to the model: p by magnets, a and e of S by spheres or bars.
struct CompensatorSetting {
    Eigen::Vector3d magnets_nT = Eigen::Vector3d::Zero();
    double foreAft = 0, athwart = 0; ///< added to a and e
};
[[nodiscard]] SensorModel withCompensator(SensorModel model, const CompensatorSetting& setting);

/// How far each can be set, either way; 0: it is not there.
struct CompensatorReach {
    Eigen::Vector3d magnets_nT{10000, 10000, 10000};
    double foreAft = 0.1, athwart = 0.1;
};

/// Attitudes from −pitch to +pitch and −roll to +roll; 0 and 0: level.
struct AttitudeRange {
    double pitch_deg = 20, roll_deg = 20;
};

/// Of all headings every 15°, level and at the ends of the range.
struct RangeResidual {
    double largest_deg = 0, rms_deg = 0;                 ///< of |deviation|; where the field vanishes it counts as 180°
    double heading_deg = 0, pitch_deg = 0, roll_deg = 0; ///< of the largest
};
[[nodiscard]] RangeResidual residualOver(const SensorModel& model, const MeridianField& field, const AttitudeRange& range);

struct CompensatorResult {
    CompensatorSetting best, level;          ///< best over the range; best on level ground
    RangeResidual before, afterLevel, after; ///< all over the range; afterLevel: as it was set on level ground
    std::array<bool, 5> atEnd{};             ///< of the best: magnets x, y, z, fore-aft, athwart stand at the end of their reach
    std::vector<Message> warnings;
};

/// Smallest largest |deviation| over the range: least squares by damped Gauss–Newton within the reaches, then Lawson's weights, which grow
/// where the deviation is large.
[[nodiscard]] CompensatorResult bestCompensator(
    const SensorModel& model, const MeridianField& field, const AttitudeRange& range, const CompensatorReach& reach);

} // namespace lubberline
