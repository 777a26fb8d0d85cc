#pragma once

#include <string>
#include <vector>

namespace lubberline {

/// Procedures 3.1, as far as sources say it: what a crew ticks off.
[[nodiscard]] std::vector<std::string> usualChecklist();

} // namespace lubberline
