#include "core/format/exchange/UtcJson.h"

#include "core/base/UtcTime.h"

namespace lubberline {

namespace {

std::string checked(JsonObject& object, std::string_view key, std::string text)
{
    if (!text.empty() && !isUtcText(text))
        object.fault(key, MARKED("core", "is no moment; expected UTC as YYYY-MM-DDTHH:MM:SSZ"));
    return text;
}

} // namespace

std::string utcText(JsonObject& object, std::string_view key) { return checked(object, key, object.text(key)); }

std::string requiredUtcText(JsonObject& object, std::string_view key) { return checked(object, key, object.requiredText(key)); }

} // namespace lubberline
