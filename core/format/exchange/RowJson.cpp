#include "core/format/exchange/RowJson.h"

#include <array>
#include <cmath>

#include <nlohmann/json.hpp>

#include "core/format/json/JsonDocument.h"
#include "core/format/json/JsonWriter.h"
#include "core/record/Ranges.h"

namespace lubberline {

namespace {

Error wrongRow(const Message& expected)
{
    return {ErrorCode::InvalidInput, {MARKED("core", "what is stored does not read; expected %1"), expected}};
}

} // namespace

std::string writeExtraRow(const ExtraColumns& extra)
{
    JsonWriter json(JsonLayout::Compact);
    json.beginArray();
    for (const auto& [name, value] : extra) {
        json.beginArray();
        json.text({}, name);
        json.text({}, value);
        json.end();
    }
    json.end();
    return json.take();
}

Result<ExtraColumns> readExtraRow(std::string_view text)
{
    ExtraColumns extra;
    if (text == "[]") // nearly always
        return extra;
    constexpr Pattern kExpected = MARKED("core", "pairs of texts");
    const auto json = parseJson(text, {}, kExpected);
    if (!json)
        return json.error();
    if (!json->is_array())
        return wrongRow(kExpected);
    for (const auto& pair : *json) {
        if (!pair.is_array() || pair.size() != 2 || !pair[0].is_string() || !pair[1].is_string())
            return wrongRow(kExpected);
        extra.emplace_back(pair[0].get<std::string>(), pair[1].get<std::string>());
    }
    return extra;
}

std::string writeRawRow(const RawFigures& raw)
{
    if (raw.empty())
        return {};
    JsonWriter json(JsonLayout::Compact);
    json.beginArray();
    for (const auto* figures : {&raw.datum_deg, &raw.astern_deg, &raw.compass_deg})
        json.numbers({}, *figures);
    json.end();
    return json.take();
}

Result<RawFigures> readRawRow(std::string_view text)
{
    RawFigures raw;
    if (text.empty()) // nearly always
        return raw;
    constexpr Pattern kExpected = MARKED("core", "three lists of figures");
    const auto json = parseJson(text, {}, kExpected);
    if (!json)
        return json.error();
    const std::array all{&raw.datum_deg, &raw.astern_deg, &raw.compass_deg};
    if (!json->is_array() || json->size() != all.size())
        return wrongRow(kExpected);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!(*json)[i].is_array())
            return wrongRow(kExpected);
        for (const auto& figure : (*json)[i]) {
            if (!figure.is_number() || !kFigureRange.has(figure.get<double>()))
                return wrongRow(kExpected);
            all[i]->push_back(figure.get<double>());
        }
    }
    return raw;
}

std::string writeStatesRow(const BenchStates& states)
{
    JsonWriter json(JsonLayout::Compact);
    json.beginObject();
    for (const auto& [group, state] : states)
        json.text(group, state);
    json.end();
    return json.take();
}

Result<BenchStates> readStatesRow(std::string_view text)
{
    constexpr Pattern kExpected = MARKED("core", "an object of texts");
    const auto json = parseJson(text, {}, kExpected);
    if (!json)
        return json.error();
    if (!json->is_object())
        return wrongRow(kExpected);
    BenchStates states;
    for (const auto& [group, state] : json->items()) {
        if (!state.is_string() || state == "" || group.empty())
            return wrongRow(kExpected);
        states[group] = state.get<std::string>();
    }
    return states;
}

} // namespace lubberline
