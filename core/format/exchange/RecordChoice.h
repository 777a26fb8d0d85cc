#pragma once
/// Reads a choice of core/record from a JSON object by its word.

#include "core/base/FileText.h"
#include "core/format/json/JsonObject.h"
#include "core/record/RecordWords.h"

namespace lubberline {

template <class Choice>
Choice choice(JsonObject& object, std::string_view key)
{
    const std::string allowed = allowedWords<Choice>();
    const std::string word = object.requiredText(key, Message::verbatim(allowed));
    const auto found = choiceOf<Choice>(word);
    if (!found)
        object.fault(key, {MARKED("core", "%1 is not allowed; expected %2"), inQuotes(word), allowed});
    return found.value_or(Choice{});
}

/// The choice's first value where the key is not there.
template <class Choice>
Choice optionalChoice(JsonObject& object, std::string_view key)
{
    return object.has(key) ? choice<Choice>(object, key) : Choice{};
}

} // namespace lubberline
