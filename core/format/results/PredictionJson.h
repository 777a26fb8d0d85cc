#pragma once
/// The JSON of `predict` and `separate` (the contract of the command line).

#include <optional>
#include <span>
#include <string>

#include "core/swing/Prediction.h"

namespace lubberline {

struct PredictionContext {
    std::optional<LimitsProfile> limits;
    std::optional<SwingAgain> swingAgain;
};
[[nodiscard]] std::string toJson(const Prediction& prediction, const PredictionContext& context);
[[nodiscard]] std::string toJson(const IronSeparation& separation, std::span<const Knowledge> knowledge);

/// heading and deviation with the band [°], a row a heading.
[[nodiscard]] std::string toCsv(const Prediction& prediction);

/// "in_limits", "may_leave_limits", "out_of_limits", "no_limit".
[[nodiscard]] const char* nameOf(PredictedVerdict verdict);

} // namespace lubberline
