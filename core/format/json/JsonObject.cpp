#include "core/format/json/JsonObject.h"

#include <algorithm>

#include "core/base/FileText.h"
#include "core/base/NearWord.h"
#include "core/base/Number.h"
#include "core/record/Id.h"
#include "core/record/Ranges.h"

namespace lubberline {

using Json = nlohmann::json;

namespace {

std::string listed(std::span<const std::string_view> keys)
{
    std::string text;
    for (const auto key : keys)
        text.append(text.empty() ? "" : ", ").append(key);
    return text;
}

} // namespace

void FirstFault::report(ErrorCode code, const JsonPath& path, const Message& what)
{
    if (m_error)
        return;
    const std::string place = path.text();
    m_error = Error{
        code, {MARKED("core", "%1: %2"), place.empty() ? Message(MARKED("core", "the file")) : Message::verbatim(place), what}, m_file};
}

namespace {

std::optional<double> numberOf(const Json& value, const JsonPath& path, FirstFault& fault, const NumberRange& range)
{
    if (!value.is_number()) {
        fault.report(ErrorCode::Format, path, {MARKED("core", "has a value of the wrong kind; expected %1"), inWords(range)});
        return {};
    }
    const double figure = value.get<double>();
    if (!range.has(figure)) {
        fault.report(
            ErrorCode::InvalidInput, path, {MARKED("core", "%1 is out of range; expected %2"), shortestNumber(figure), inWords(range)});
        return {};
    }
    return figure;
}

} // namespace

void readNumbers(const Json& value, const JsonPath& path, FirstFault& fault, std::span<double> into, NumberRange range)
{
    if (!value.is_array() || value.size() != into.size()) {
        fault.report(
            ErrorCode::Format, path, {MARKED("core", "is not an array of %1; expected %2 numbers in brackets"), into.size(), into.size()});
        return;
    }
    std::vector<double> figures;
    for (std::size_t i = 0; i < into.size(); ++i)
        if (const auto figure = numberOf(value[i], JsonPath{&path, {}, i}, fault, range))
            figures.push_back(*figure);
    if (figures.size() == into.size())
        std::copy(figures.begin(), figures.end(), into.begin());
}

JsonObject::JsonObject(const Json& value, const JsonPath& path, FirstFault& fault) : m_value(value), m_path(path), m_fault(fault)
{
    if (!value.is_object())
        m_fault.report(ErrorCode::Format, path, MARKED("core", "is not an object; expected {\u2026}"));
    m_asked.reserve(32);
}

const Json* JsonObject::find(std::string_view key)
{
    m_asked.push_back(key);
    if (!m_value.is_object())
        return nullptr;
    const auto found = m_value.find(key);
    if (found == m_value.end())
        return nullptr;
    ++m_found;
    return &*found;
}

const Json* JsonObject::find(std::string_view key, Json::value_t type, Pattern expected)
{
    const Json* value = find(key);
    if (value && value->type() != type) {
        wrongType(key, expected);
        return nullptr;
    }
    return value;
}

bool JsonObject::has(std::string_view key) const { return m_value.is_object() && m_value.contains(key); }

void JsonObject::wrongType(std::string_view key, const Message& expected)
{
    m_fault.report(ErrorCode::Format, JsonPath{&m_path, key}, {MARKED("core", "has a value of the wrong kind; expected %1"), expected});
}

std::string JsonObject::longText(std::string_view key)
{
    const Json* value = find(key, Json::value_t::string, MARKED("core", "text"));
    return value ? value->get_ref<const std::string&>() : std::string();
}

std::string JsonObject::text(std::string_view key)
{
    std::string words = longText(key);
    if (words.size() > kLongestText)
        fault(key, {MARKED("core", "is a text of %1 bytes; expected at most %2"), words.size(), kLongestText});
    return words;
}

std::string JsonObject::requiredText(std::string_view key, const Message& expected)
{
    if (!has(key))
        missing(key, expected);
    std::string value = text(key);
    if (value.empty())
        fault(key, {MARKED("core", "is empty; expected %1"), expected});
    return value;
}

std::optional<std::string> JsonObject::optionalText(std::string_view key)
{
    return has(key) ? std::optional(requiredText(key)) : std::nullopt;
}

Date JsonObject::date(std::string_view key)
{
    const std::string value = text(key);
    const auto day = Date::read(value);
    if (!value.empty() && !day)
        fault(key, {MARKED("core", "%1 is not a date; expected a day of the calendar as YYYY-MM-DD"), inQuotes(value)});
    return day.value_or(Date());
}

std::string JsonObject::recordId(std::string_view key)
{
    std::string value = requiredText(key, MARKED("core", "a record id"));
    if (!isRecordId(value))
        fault(key, {MARKED("core", "%1 is not a record id; expected a UUID in lower case with hyphens"), inQuotes(value)});
    return value;
}

std::optional<double> JsonObject::number(std::string_view key, NumberRange range)
{
    const Json* value = find(key);
    return value ? numberOf(*value, JsonPath{&m_path, key}, m_fault, range) : std::nullopt;
}

double JsonObject::requiredNumber(std::string_view key, NumberRange range)
{
    if (!has(key))
        missing(key, inWords(range));
    return number(key, range).value_or(range.least);
}

std::optional<int> JsonObject::integer(std::string_view key, NumberRange range)
{
    const auto value = number(key, range);
    if (value && *value != std::floor(*value))
        fault(key, {MARKED("core", "%1 is not whole; expected a whole number"), shortestNumber(*value)});
    return value ? std::optional(static_cast<int>(*value)) : std::nullopt;
}

bool JsonObject::boolean(std::string_view key)
{
    const Json* value = find(key, Json::value_t::boolean, MARKED("core", "true or false"));
    return value && value->get<bool>();
}

void JsonObject::numbers(std::string_view key, std::span<double> into, NumberRange range)
{
    if (const Json* value = find(key))
        readNumbers(*value, JsonPath{&m_path, key}, m_fault, into, range);
}

void JsonObject::numberRows(std::string_view key, std::span<double> into, std::size_t columns, NumberRange range)
{
    const Json* value = find(key);
    if (!value)
        return;
    const JsonPath here{&m_path, key};
    const std::size_t rows = into.size() / columns;
    if (!value->is_array() || value->size() != rows)
        m_fault.report(ErrorCode::Format, here,
            {MARKED("core", "is not an array of %1 rows; expected %2 rows of %3 numbers in brackets"), rows, rows, columns});
    else
        for (std::size_t row = 0; row < rows; ++row)
            readNumbers((*value)[row], JsonPath{&here, {}, row}, m_fault, into.subspan(row * columns, columns), range);
}

void JsonObject::only(std::span<const std::string_view> keys)
{
    if (m_value.is_object())
        refuseOthers(keys);
}

void JsonObject::finish()
{
    if (m_value.is_object() && m_found != m_value.size())
        refuseOthers(m_asked);
}

void JsonObject::refuseOthers(std::span<const std::string_view> known)
{
    for (const auto& [key, value] : m_value.items()) {
        if (std::find(known.begin(), known.end(), key) != known.end())
            continue;
        if (const auto near = nearWord(key, known); !near.empty())
            m_fault.report(
                ErrorCode::Format, JsonPath{&m_path, key}, {MARKED("core", "is not known; did you mean \"%1\"?"), std::string(near)});
        else
            m_fault.report(ErrorCode::Format, JsonPath{&m_path, key}, {MARKED("core", "is not known; expected only %1"), listed(known)});
        return; // the first fault is the one that is told
    }
}

} // namespace lubberline
