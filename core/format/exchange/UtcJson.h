#pragma once
/// Private to the exchange format: moments, which records keep as texts.

#include <string>

#include "core/format/json/JsonObject.h"

namespace lubberline {

/// Empty when the key is not there; a text that is no moment of UTC is a fault.
[[nodiscard]] std::string utcText(JsonObject& object, std::string_view key);
/// Neither missing nor empty.
[[nodiscard]] std::string requiredUtcText(JsonObject& object, std::string_view key);

} // namespace lubberline
