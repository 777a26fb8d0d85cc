#pragma once
/// Reads the keys of one JSON object. The first fault is kept in a place shared by all objects of a file, and reading goes on
/// with empty values: the code that reads a record stays a list of its keys, and the fault is looked at once at the end.

#include <cmath>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/base/Date.h"
#include "core/base/NumberRange.h"
#include "core/base/Result.h"
#include "core/format/json/JsonPath.h"

namespace lubberline {

class FirstFault {
public:
    explicit FirstFault(const std::string& file) : m_file(file) {}
    void report(ErrorCode code, const JsonPath& path, const Message& what);
    [[nodiscard]] const std::optional<Error>& error() const { return m_error; }

private:
    std::string m_file; ///< its own: callers may give a temporary
    std::optional<Error> m_error;
};

/// Reads an array of exactly as many numbers as `into` holds; it is left alone where there is a fault.
void readNumbers(const nlohmann::json& value, const JsonPath& path, FirstFault& fault, std::span<double> into, NumberRange range = {});

class JsonObject {
public:
    JsonObject(const nlohmann::json& value, const JsonPath& path, FirstFault& fault);
    JsonObject(const JsonObject&) = delete;
    JsonObject& operator=(const JsonObject&) = delete;

    [[nodiscard]] std::string text(std::string_view key);     ///< empty when the key is not there
    [[nodiscard]] std::string longText(std::string_view key); ///< a document; the others are of people and have at most kLongestText bytes
    [[nodiscard]] std::string requiredText(
        std::string_view key, const Message& expected = MARKED("core", "text")); ///< neither missing nor empty
    [[nodiscard]] std::optional<std::string> optionalText(std::string_view key); ///< when there, not empty
    [[nodiscard]] Date date(std::string_view key);                               ///< empty where there is none
    [[nodiscard]] std::string recordId(std::string_view key);
    [[nodiscard]] std::optional<double> number(std::string_view key, NumberRange range = {});
    [[nodiscard]] double requiredNumber(std::string_view key, NumberRange range);
    [[nodiscard]] std::optional<int> integer(std::string_view key, NumberRange range);
    [[nodiscard]] bool boolean(std::string_view key);                                   ///< false when the key is not there
    void numbers(std::string_view key, std::span<double> into, NumberRange range = {}); ///< `into` is left alone when the key is not there
    /// An array of rows of `columns` numbers each, into row after row.
    void numberRows(std::string_view key, std::span<double> into, std::size_t columns, NumberRange range = {});

    /// Calls `read(object)` for the object inside this one; not when the key is not there.
    template <class Read>
    void object(std::string_view key, Read read)
    {
        if (const auto* value = find(key)) {
            const JsonPath here{&m_path, key};
            JsonObject inner(*value, here, m_fault);
            read(inner);
        }
    }

    /// Calls `read(object)` for the objects of an array; none when the key is not there.
    template <class Read>
    void objects(std::string_view key, Read read)
    {
        array(key, [&](const nlohmann::json& value, const JsonPath& path) {
            JsonObject inner(value, path, m_fault);
            read(inner);
        });
    }

    /// Calls `each(element, path)` for the elements of an array; none when the key is not there, or what was read before is refused: a
    /// hostile file's million empty records are not kept.
    template <class Each>
    void array(std::string_view key, Each each)
    {
        const auto* value = find(key, nlohmann::json::value_t::array, MARKED("core", "an array"));
        if (!value)
            return;
        const JsonPath here{&m_path, key};
        for (std::size_t i = 0; i < value->size() && !m_fault.error(); ++i)
            each((*value)[i], JsonPath{&here, {}, i});
    }

    [[nodiscard]] bool has(std::string_view key) const;
    void fault(std::string_view key, const Message& what) { m_fault.report(ErrorCode::InvalidInput, JsonPath{&m_path, key}, what); }
    void missing(std::string_view key, const Message& expected)
    {
        m_fault.report(ErrorCode::Format, JsonPath{&m_path, key}, {MARKED("core", "is missing; expected %1"), expected});
    }
    /// Refuses all keys but these, before a required one that is only misspelt is said to be missing. No finish() is needed
    /// then.
    void only(std::span<const std::string_view> keys);
    void only(std::initializer_list<std::string_view> keys) { only(std::span(keys.begin(), keys.size())); }
    /// Refuses keys that nobody asked for; called when all keys have been read.
    void finish();

private:
    const nlohmann::json* find(std::string_view key);
    const nlohmann::json* find(std::string_view key, nlohmann::json::value_t type, Pattern expected);
    void wrongType(std::string_view key, const Message& expected);
    void refuseOthers(std::span<const std::string_view> known);

    const nlohmann::json& m_value;
    const JsonPath& m_path;
    FirstFault& m_fault;
    std::vector<std::string_view> m_asked;
    std::size_t m_found = 0;
};

} // namespace lubberline
