#pragma once
/// JSON of what a bench does at its sensor.
///   {"soft_iron": [[a,b,c],…], "hard_iron_nT": [P,Q,R], "circuits": [{"name","field_nT_per_A","current_A","on"}],
///    "states": {"gear": "extended"}, "parts": [{"part","method": "tensor"|"dipole","distance_m","soft_iron","hard_iron_nT",
///      "iron": "soft"|"between"|"hard"|null,"may_drift_nT"}],
///    "warnings": […]}

#include <string>

#include "core/iron/BenchModel.h"

namespace lubberline {

[[nodiscard]] std::string toJson(const BenchModel& model, const BenchStates& states);

} // namespace lubberline
