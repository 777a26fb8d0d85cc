#pragma once
/// What a swing and its readings hold since version 3 of the exchange file: raw figures, times, revisions and signatures. The keys
/// go inside an object that the caller opens and closes; the reader of the rest of a swing says when it is finished.

#include "core/format/json/JsonObject.h"
#include "core/format/json/JsonWriter.h"
#include "core/record/Swing.h"

namespace lubberline {

/// "datum_read_deg", "astern_read_deg", "compass_read_deg", each where there are figures.
void writeRaw(JsonWriter& json, const RawFigures& raw);
[[nodiscard]] RawFigures readRaw(JsonObject& object);

/// When and where it was made, what it amends, and who signed.
void writeSwingRecord(JsonWriter& json, const Swing& swing);
void readSwingRecord(JsonObject& object, Swing& swing);
[[nodiscard]] bool hasSwingRecord(const Swing& swing);

} // namespace lubberline
