#pragma once
/// A sensor model as a C header: what a computer on board needs to take the model out of a reading, with a self-test of its own.

#include <string>

#include "core/base/Result.h"
#include "core/sensor/SensorModel.h"

namespace lubberline {

/// C99, no dependency but math.h. lubberline_field(measured, field): B = gain⁻¹ (m − offset); lubberline_heading_deg(field, pitch, roll): [P 22],
/// clockwise from magnetic north; lubberline_self_test(): 0 when the compiled code gives what this program computed, else the number of
/// the first vector that differs by more than 0.01 of the unit. @param unit "nT" or "counts". @param note a line for the reader
/// Errors: Numeric (the model cannot be inverted).
Result<std::string> writeModelHeader(const SensorModel& model, std::string_view unit, std::string_view note);

/// B from what was measured: gain⁻¹ (m − offset). Errors: Numeric (a gain without an inverse).
struct FieldCompensator {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();
    [[nodiscard]] Eigen::Vector3d field(const Eigen::Vector3d& measured) const { return matrix * (measured - offset); }
};
Result<FieldCompensator> compensatorOf(const SensorModel& model);

/// The compass heading of a field in body axes at an attitude [P 22], [0, 360).
[[nodiscard]] double headingOf_deg(const Eigen::Vector3d& field, double pitch_deg, double roll_deg);

} // namespace lubberline
