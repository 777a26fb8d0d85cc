#include "core/format/CsvRow.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace lubberline {

char separatorOf(const std::string& line)
{
    for (const char separator : {'\t', ';'})
        if (line.find(separator) != std::string::npos)
            return separator;
    return ',';
}

std::optional<std::vector<std::string>> splitCells(const std::string& line, char separator)
{
    std::vector<std::string> cells(1);
    bool quoted = false, wasQuoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quoted) {
            if (c != '"')
                cells.back() += c;
            else if (i + 1 < line.size() && line[i + 1] == '"')
                cells.back() += line[++i];
            else
                quoted = false;
        } else if (c == '"' && trimmed(cells.back()).empty()) {
            cells.back().clear();
            quoted = wasQuoted = true;
        } else if (c == separator) {
            if (!wasQuoted)
                cells.back() = trimmed(cells.back());
            cells.emplace_back();
            wasQuoted = false;
        } else if (!(wasQuoted && c == ' ')) {
            cells.back() += c;
        }
    }
    if (quoted)
        return std::nullopt;
    if (!wasQuoted)
        cells.back() = trimmed(cells.back());
    return cells;
}

std::string quoteCell(const std::string& cell)
{
    if (cell.find_first_of(",;\t\"\n\r#") == std::string::npos && trimmed(cell) == cell)
        return cell;
    std::string quoted = "\"";
    for (const char c : cell) {
        if (c == '\n' || c == '\r')
            quoted += ' '; // a row is one line
        else
            quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    }
    return quoted + "\"";
}

std::optional<double> parseNumber(std::string_view cell, bool commaToo)
{
    std::string text(cell);
    if (commaToo)
        std::replace(text.begin(), text.end(), ',', '.');
    if (text.starts_with("\u2212")) // the minus sign of typography
        text.replace(0, 3, "-");
    const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
    double value = 0;
    const auto [end, failure] = std::from_chars(begin, text.data() + text.size(), value);
    if (failure != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

std::string shortestText(double number)
{
    char buffer[32];
    const auto [end, failure] = std::to_chars(buffer, buffer + sizeof buffer, number + 0.0);
    return {buffer, end};
}

std::string trimmed(std::string_view text)
{
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos)
        return {};
    return std::string(text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

} // namespace lubberline
