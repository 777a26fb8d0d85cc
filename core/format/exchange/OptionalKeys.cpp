#include "core/format/exchange/OptionalKeys.h"

namespace lubberline {

void textIfAny(JsonWriter& json, std::string_view key, const std::string& value)
{
    if (!value.empty())
        json.text(key, value);
}

void textIfAny(JsonWriter& json, std::string_view key, Date day) { textIfAny(json, key, day.text()); }

void numberIfAny(JsonWriter& json, std::string_view key, std::optional<double> value)
{
    if (value)
        json.number(key, *value);
}

} // namespace lubberline
