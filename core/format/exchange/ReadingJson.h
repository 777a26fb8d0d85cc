#pragma once
/// A reading as the exchange file and the recovery file hold it: {"nominal_deg", "magnetic_heading_deg", "compass_heading_deg",
/// "true_heading_deg", "pitch_deg", "roll_deg", raw figures (core/format/exchange/SwingJson.h), "time_utc", "note", "excluded",
/// "extra": [{"name", "value"}]}; what is not stated is left out.

#include "core/format/json/JsonObject.h"
#include "core/format/json/JsonWriter.h"
#include "core/record/Swing.h"

namespace lubberline {

void writeReadingKeys(JsonWriter& json, const Reading& reading);
/// The whole object. @param withRaw it may have figures as they were read, and a time: from version 3 of the exchange file on.
[[nodiscard]] Reading readReading(JsonObject& object, bool withRaw);

} // namespace lubberline
