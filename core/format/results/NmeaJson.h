#pragma once
/// The JSON of `nmea` (the contract of the command line).

#include <optional>
#include <string>

#include "core/nmea/NmeaSwing.h"
#include "core/swing/Analysis.h"

namespace lubberline {

/// @param analysis of the used pairs; none where they allow no result: its keys are null then.
[[nodiscard]] std::string toJson(const NmeaSwing& swing, const std::optional<Analysis>& analysis);

} // namespace lubberline
