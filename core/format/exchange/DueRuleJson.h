#pragma once
/// Calendar rules, and the waivers that answer events, as JSON. The keys go inside an object that the caller opens and closes.

#include "core/format/json/JsonObject.h"
#include "core/format/json/JsonWriter.h"
#include "core/record/DueRule.h"

namespace lubberline {

void writeDueRule(JsonWriter& json, const DueRule& rule);
[[nodiscard]] DueRule readDueRule(JsonObject& object);                      ///< the whole object
void writeWaiver(JsonWriter& json, const Waiver& waiver);                   ///< without the event, inside which it stands
[[nodiscard]] Waiver readWaiver(JsonObject& object, const RecordId& event); ///< the whole object

} // namespace lubberline
