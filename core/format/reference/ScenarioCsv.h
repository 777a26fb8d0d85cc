#pragma once
/// Scenario CSV: the manoeuvres as a table, everything else as `# key: value` lines above its header, with a point for what stands
/// inside something: `# latitude_deg: 52`, `# vertical.tau1_s: 60`, `# gyro.slaving_tau_s: 147`, `# compass.kind: needle`.
///   from_s,to_s,turn_rate_deg_s,acceleration_m_s2,climb_m_s
/// Comma, semicolon or tab between cells; a decimal comma where the separator is another. Empty cells are none.

#include <string>
#include <string_view>

#include "core/base/Result.h"

namespace lubberline {

/// The same as Scenario JSON. Errors: Format, InvalidInput, with the line.
Result<std::string> scenarioCsvToJson(std::string_view text, const std::string& name);

} // namespace lubberline
