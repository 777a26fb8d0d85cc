#pragma once
/// Scenario JSON: a flight and the instruments that are carried through it (core/reference/Scenario.h). Every part may be left out:
/// there is none of it then.
///   {"latitude_deg", "dip_deg", "speed_m_s", "heading_deg", "step_s", "duration_s",
///    "manoeuvres": [{"from_s", "to_s", "turn_rate_deg_s" | "acceleration_m_s2" | "climb_m_s"}],
///    "gusts": {"rms_m_s2", "period_s", "seed"} | {"peak_m_s2", "period_s"},
///    "vertical": {"loop": "first" | "damped" | "integral" | "third", "tau1_s", "tau2_s", "tau3_s", "drift_deg_h", "cutoff_deg",
///      "rate_limit_deg_min", "reverse_rate_limit_deg_min", "switch": {"dead_zone_deg", "rate_deg_min", "reverse_rate_deg_min"},
///      "rate_compensation", "acceleration_correction", "turn_rate_error_deg_h", "exact_tilt", "initial_tilt_deg",
///      "fast_levelling": {"until_s", "tau1_s"}, "unbalance_deg_h_g", "anisoelastic_deg_h_g2"},
///    "gyro": {"drift_deg_h", "apparent_drift", "slaving_tau_s", "slaving_rate_deg_min", "fast_slaving": {"above_deg", "rate_deg_min"},
///      "slaving_cutout_deg_s", "outer_axis_tilt_deg", "spin_axis_deg", "level_outer_axis", "initial_error_deg", "unbalance_deg_h_g",
///      "anisoelastic_deg_h_g2"},
///    "compass": {"kind": "needle" | "flux valve", "model": Model JSON | null, "card": {"period_s", "damping", "liquid_lag_s", "stop_deg"}}}
/// dip_deg may be left out where the compass's model has a field; where both stand, dip_deg counts. Strict, as our other files are.

#include <string>
#include <string_view>

#include "core/base/Result.h"
#include "core/reference/Scenario.h"

namespace lubberline {

/// Errors: Format, InvalidInput, naming the key's path; those of checkScenario().
Result<Scenario> readScenarioJson(std::string_view text, const std::string& name);
/// Scenario JSON, or Scenario CSV (core/format/reference/ScenarioCsv.h) where it does not begin with a brace. Errors: also Io.
Result<Scenario> readScenarioFile(const std::string& path);
/// Reads back equal.
[[nodiscard]] std::string writeScenarioJson(const Scenario& scenario);

} // namespace lubberline
