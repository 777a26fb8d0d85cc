#pragma once
/// Electrical swings as JSON: figures as they stand on the swing data sheet; errors are recomputed.

#include <string>
#include <string_view>

#include "core/base/Result.h"
#include "core/record/ElectricalSwing.h"

namespace lubberline {

class JsonObject;
class JsonWriter;

/// The keys of the record inside an object that the caller opens and closes; what is not stated is left out.
void writeElectrical(JsonWriter& json, const ElectricalSwing& swing);
[[nodiscard]] ElectricalSwing readElectrical(JsonObject& object); ///< the whole object; the record id is empty when it is not there

[[nodiscard]] std::string writeElectricalJson(const ElectricalSwing& swing);
/// Errors: Format, InvalidInput, naming the key. `name` is named in errors.
Result<ElectricalSwing> readElectricalJson(std::string_view text, const std::string& name);

} // namespace lubberline
