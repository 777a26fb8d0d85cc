#pragma once
/// Private to the exchange file: parts of its objects.

#include <string_view>

#include "core/earth/FieldStamp.h"
#include "core/format/json/JsonObject.h"
#include "core/format/json/JsonWriter.h"
#include "core/record/SensorRecord.h"

namespace lubberline::exchange {

/// {"model", "latitude_deg", "longitude_deg", "height_m", "date", "north_nT", "east_nT", "down_nT"}, all of them.
[[nodiscard]] FieldStamp readStamp(JsonObject& object);
void writeStamp(JsonWriter& json, std::string_view key, const FieldStamp& stamp);

/// The keys "model" and "covariance" (as in a Model JSON), "bench" (as in a Bench JSON) and "bench_states" of a sensor; a sensor without
/// bench has neither of the last two.
void readSensorParts(JsonObject& object, SensorRecord& sensor, FirstFault& fault);
void writeSensorParts(JsonWriter& json, const SensorRecord& sensor);

} // namespace lubberline::exchange
