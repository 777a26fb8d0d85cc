#pragma once
/// A whole text that is one JSON object.

#include <type_traits>

#include "core/format/json/JsonDocument.h"
#include "core/format/json/JsonObject.h"

namespace lubberline {

/// `read(object)`, or `read(object, fault)`, makes the value; the first fault of the object is the answer. Errors: those of parseJson and of the object.
template <class Value, class Read>
Result<Value> readJsonObject(std::string_view text, const std::string& name, const Message& expected, Read read)
{
    const auto json = parseJson(text, name, expected);
    if (!json)
        return json.error();
    FirstFault fault(name);
    const JsonPath root{};
    JsonObject object(*json, root, fault);
    Value value = [&] {
        if constexpr (std::is_invocable_v<Read, JsonObject&, FirstFault&>)
            return read(object, fault);
        else
            return read(object);
    }();
    if (fault.error())
        return *fault.error();
    return value;
}

} // namespace lubberline
