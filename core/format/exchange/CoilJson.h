#pragma once
/// Coil benches as JSON: readings as they were taken; what they tell is recomputed.

#include <string>
#include <string_view>

#include "core/base/Result.h"
#include "core/record/CoilBench.h"

namespace lubberline {

class JsonObject;
class JsonWriter;

/// The keys of the record inside an object that the caller opens and closes; what is not stated is left out.
void writeCoilBench(JsonWriter& json, const CoilBench& bench);
[[nodiscard]] CoilBench readCoilBench(JsonObject& object); ///< the whole object; the record id is empty when it is not there

[[nodiscard]] std::string writeCoilBenchJson(const CoilBench& bench);
/// Errors: Format, InvalidInput, naming the key. `name` is named in errors.
Result<CoilBench> readCoilBenchJson(std::string_view text, const std::string& name);

} // namespace lubberline
