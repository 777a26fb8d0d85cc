#include "core/format/json/JsonWriter.h"

#include <nlohmann/json.hpp>

#include "core/base/Contract.h"
#include "core/base/Number.h"

namespace lubberline {

void JsonWriter::newLine()
{
    m_text += '\n';
    m_text.append(2 * m_levels.size(), ' ');
}

void JsonWriter::string(std::string_view value)
{
    m_text += nlohmann::json(value).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void JsonWriter::startValue(std::string_view key)
{
    if (m_levels.empty())
        return;
    Level& level = m_levels.back();
    if (!level.empty)
        m_text += level.inOneLine && !m_compact ? ", " : ",";
    level.empty = false;
    if (!level.inOneLine)
        newLine();
    if (level.closing == '}') {
        string(key);
        m_text += m_compact ? ":" : ": ";
    }
}

void JsonWriter::begin(std::string_view key, char opening, Level level)
{
    startValue(key);
    level.inOneLine |= m_compact || (!m_levels.empty() && m_levels.back().inOneLine);
    m_text += opening;
    m_levels.push_back(level);
}

void JsonWriter::beginObject(std::string_view key, bool inOneLine) { begin(key, '{', {'}', inOneLine}); }
void JsonWriter::beginArray(std::string_view key, bool inOneLine) { begin(key, '[', {']', inOneLine}); }

void JsonWriter::end()
{
    LUBBERLINE_EXPECT(!m_levels.empty(), "what is ended was begun");
    const Level level = m_levels.back();
    m_levels.pop_back();
    if (!level.empty && !level.inOneLine)
        newLine();
    m_text += level.closing;
}

void JsonWriter::text(std::string_view key, std::string_view value)
{
    startValue(key);
    string(value);
}

void JsonWriter::number(std::string_view key, double value)
{
    startValue(key);
    m_text += shortestNumber(value);
}

void JsonWriter::numbers(std::string_view key, std::span<const double> values)
{
    beginArray(key, true);
    for (const double value : values)
        number({}, value);
    end();
}

void JsonWriter::integer(std::string_view key, std::int64_t value)
{
    startValue(key);
    m_text += std::to_string(value);
}

void JsonWriter::boolean(std::string_view key, bool value)
{
    startValue(key);
    m_text += value ? "true" : "false";
}

void JsonWriter::null(std::string_view key)
{
    startValue(key);
    m_text += "null";
}

std::string JsonWriter::take()
{
    LUBBERLINE_EXPECT(m_levels.empty(), "every object and array has been ended");
    if (!m_compact)
        m_text += '\n';
    return std::move(m_text);
}

} // namespace lubberline
