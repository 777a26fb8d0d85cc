#pragma once
/// The JSON of `reference`, `sun`, `alignment` and `grid` (the contract of the command line): every key carries its unit.

#include <span>
#include <string>

#include "core/record/Swing.h"
#include "core/reference/Alignment.h"
#include "core/reference/ReferenceRun.h"

namespace lubberline {

[[nodiscard]] const char* nameOf(ErrorSource source); ///< tilt, deviation, slaving, drift, gimbal, card, together

/// One object, no newline at the end. @param every only each of so many steps, and the last.
[[nodiscard]] std::string toJson(const Scenario& scenario, const ReferenceRun& run, std::size_t every = 1);
/// time_s, heading_deg, vertical_error_deg, heading_error_deg, and a column a share.
[[nodiscard]] std::string toCsv(const ReferenceRun& run, std::size_t every = 1);

[[nodiscard]] std::string toJson(const SunPosition& sun, const ErrorBudget& budget, const SunDoubts& doubts);
[[nodiscard]] std::string toJson(const ErrorBudget& budget);

/// A swing by the sun. @param errors_deg of the sun's azimuth at each reading, one standard deviation
[[nodiscard]] std::string toJson(const Swing& bySun, std::span<const double> errors_deg, const std::vector<Message>& warnings);

/// Which points a file of every so many steps holds.
[[nodiscard]] std::vector<std::size_t> pointsOf(const ReferenceRun& run, std::size_t every);

} // namespace lubberline
