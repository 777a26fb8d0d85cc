#pragma once
/// Datum instruments as JSON. The keys go inside an object that the caller opens and closes.

#include "core/format/json/JsonObject.h"
#include "core/format/json/JsonWriter.h"
#include "core/record/DatumInstrument.h"

namespace lubberline {

void writeInstrument(JsonWriter& json, const DatumInstrument& instrument);
[[nodiscard]] DatumInstrument readInstrument(JsonObject& object); ///< with its record; the whole object

} // namespace lubberline
