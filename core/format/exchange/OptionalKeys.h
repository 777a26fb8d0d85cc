#pragma once
/// Keys that are left out where nothing is stated.

#include <optional>
#include <string>
#include <string_view>

#include "core/base/Date.h"
#include "core/format/json/JsonWriter.h"

namespace lubberline {

void textIfAny(JsonWriter& json, std::string_view key, const std::string& value);
void textIfAny(JsonWriter& json, std::string_view key, Date day);
void numberIfAny(JsonWriter& json, std::string_view key, std::optional<double> value);

} // namespace lubberline
