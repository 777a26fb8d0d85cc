#include "core/format/reference/ScenarioCsv.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/base/FileText.h"
#include "core/base/Number.h"
#include "core/format/csv/RowSplitter.h"

namespace lubberline {

namespace {

class ScenarioRows {
public:
    explicit ScenarioRows(const std::string& name) : m_name(name) {}

    Result<void> take(std::string_view line)
    {
        ++m_line;
        line = trimmed(line);
        if (line.empty())
            return {};
        if (line.front() == '#')
            return takeKey(trimmed(line.substr(1)));
        if (m_columns.empty())
            return takeHeader(line);
        return takeRow(line);
    }
    Result<std::string> json()
    {
        if (m_columns.empty() && m_json.empty())
            return wrong(MARKED("core", "neither Scenario JSON nor a table of manoeuvres; expected { or from_s,to_s,turn_rate_deg_s,…"));
        return m_json.dump();
    }

private:
    [[nodiscard]] Error wrong(const Message& what) const { return {ErrorCode::Format, what, m_name, m_line}; }

    Result<void> takeKey(std::string_view line)
    {
        const auto colon = line.find(':');
        if (colon == std::string_view::npos)
            return {}; // a comment
        std::string_view key = trimmed(line.substr(0, colon));
        const std::string_view value = trimmed(line.substr(colon + 1));
        if (std::count(key.begin(), key.end(), '.') > kMostPoints)
            return wrong({MARKED("core", "%1 is nested too deeply; expected at most %2 points in it"), inQuotes(key), kMostPoints});
        nlohmann::json* place = &m_json;
        for (auto point = key.find('.'); point != std::string_view::npos; point = key.find('.')) {
            place = &(*place)[std::string(key.substr(0, point))];
            key.remove_prefix(point + 1);
            if (!place->is_null() && !place->is_object())
                return wrong({MARKED("core", "%1 stands inside a figure; expected it beside"), inQuotes(line.substr(0, colon))});
        }
        if (place->contains(std::string(key)))
            return wrong({MARKED("core", "%1 stands twice; expected it once"), inQuotes(line.substr(0, colon))});
        nlohmann::json& into = (*place)[std::string(key)];
        const FileNumber number = readNumber(value, true);
        if (number.fault == NumberFault::None)
            into = std::floor(number.value) == number.value && std::abs(number.value) < 1e9
                ? nlohmann::json(static_cast<std::int64_t>(number.value))
                : nlohmann::json(number.value);
        else if (value == "true" || value == "false")
            into = value == "true";
        else
            into = std::string(value);
        return {};
    }

    Result<void> takeHeader(std::string_view line)
    {
        for (const char separator : {'\t', ';', ','})
            if (line.find(separator) != std::string_view::npos) {
                m_separator = separator;
                break;
            }
        RowSplitter row(m_separator);
        if (row.begin(line) != RowSplitter::State::Complete)
            return wrong(MARKED("core", "a cell in quotes that does not end; expected names of columns"));
        for (const std::string& cell : row.cells()) {
            const std::string column = inSmallLetters(trimmed(cell));
            if (std::find(m_columns.begin(), m_columns.end(), column) != m_columns.end())
                return wrong({MARKED("core", "column %1 stands twice; expected it once"), inQuotes(column)});
            if (std::find(kColumns.begin(), kColumns.end(), column) == kColumns.end())
                return wrong({MARKED("core", "column %1; expected from_s, to_s, turn_rate_deg_s, acceleration_m_s2 and climb_m_s"),
                    inQuotes(column)});
            m_columns.push_back(column);
        }
        m_json["manoeuvres"] = nlohmann::json::array();
        return {};
    }

    Result<void> takeRow(std::string_view line)
    {
        RowSplitter row(m_separator);
        if (row.begin(line) != RowSplitter::State::Complete || row.cells().size() > m_columns.size())
            return wrong({MARKED("core", "%1 cells and %2 columns; expected a cell a column"), row.cells().size(), m_columns.size()});
        nlohmann::json manoeuvre = nlohmann::json::object();
        for (std::size_t i = 0; i < row.cells().size(); ++i) {
            const std::string_view cell = trimmed(row.cells()[i]);
            if (cell.empty())
                continue;
            const FileNumber number = readNumber(cell, m_separator != ',');
            if (number.fault != NumberFault::None)
                return wrong({MARKED("core", "%1: %2 is no number"), m_columns[i], figuresInQuotes(cell)});
            manoeuvre[m_columns[i]] = number.value;
        }
        if (manoeuvre.empty())
            return {};
        for (const char* needed : {"from_s", "to_s"})
            if (!manoeuvre.contains(needed))
                return wrong({MARKED("core", "%1 is missing; expected when the manoeuvre begins and ends"), std::string(needed)});
        m_json["manoeuvres"].push_back(std::move(manoeuvre));
        return {};
    }

    static constexpr std::array<std::string_view, 5> kColumns{"from_s", "to_s", "turn_rate_deg_s", "acceleration_m_s2", "climb_m_s"};
    static constexpr std::ptrdiff_t kMostPoints = 4; // writing what is nested calls itself
    const std::string& m_name;
    std::int64_t m_line = 0;
    char m_separator = ',';
    std::vector<std::string> m_columns;
    nlohmann::json m_json = nlohmann::json::object();
};

} // namespace

Result<std::string> scenarioCsvToJson(std::string_view text, const std::string& name)
{
    if (auto why = otherEncoding(text); !why.empty())
        return Error{ErrorCode::Format, std::move(why), name};
    ScenarioRows rows(name);
    while (!text.empty()) {
        const auto end = text.find_first_of("\r\n");
        const std::string_view line = text.substr(0, end);
        if (auto why = notUtf8(line); !why.empty())
            return Error{ErrorCode::Format, std::move(why), name};
        if (const auto taken = rows.take(line); !taken)
            return taken.error();
        if (end == std::string_view::npos)
            break;
        text.remove_prefix(text.substr(end).starts_with("\r\n") ? end + 2 : end + 1);
    }
    return rows.json();
}

} // namespace lubberline
