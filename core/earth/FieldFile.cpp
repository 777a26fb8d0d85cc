// The published coefficient files, read strictly: a coefficient that is missing, doubled or out of its place would bend every
// compass.

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "core/base/FileText.h"
#include "core/base/Number.h"
#include "core/earth/FieldTables.h"

namespace lubberline {

namespace {

constexpr std::size_t kMostLines = 700'000;

struct Line {
    std::vector<std::string> words;
    std::int64_t number = 0;
};

class FieldFile {
public:
    explicit FieldFile(const std::string& path) : m_path(path) {}
    Result<FieldTable> read();

private:
    Error wrong(const Message& what, const Line& line) const { return {ErrorCode::Format, what, m_path, line.number}; }
    Error wrong(const Message& what) const { return {ErrorCode::Format, what, m_path, 0}; }
    Result<void> readLines();
    Result<FieldTable> readCof();
    Result<FieldTable> readIgrf();
    Result<double> number(const Line& line, std::size_t word) const;
    Result<int> whole(const Line& line, std::size_t word) const;
    Result<int> readCofRows(std::vector<std::array<Gauss, 2>>& rows) const;
    Result<void> checkPlace(const Line& line, std::size_t firstWord, int n, int m) const;

    const std::string& m_path;
    std::vector<Line> m_lines; ///< without comments and blank lines
};

Result<void> FieldFile::readLines()
{
    std::error_code ignored;
    if (std::filesystem::is_directory(m_path, ignored))
        return Error{ErrorCode::Io, MARKED("core", "is a folder; expected a file of magnetic coefficients"), m_path};
    std::ifstream file(m_path, std::ios::binary);
    if (!file)
        return Error{ErrorCode::Io, MARKED("core", "cannot be opened; expected a file of magnetic coefficients"), m_path};
    std::string text;
    for (std::int64_t number = 1; std::getline(file, text); ++number) {
        if (text.find('\0') != std::string::npos || text.size() > 4096 || m_lines.size() > kMostLines)
            return wrong(MARKED("core", "is no text of magnetic coefficients (WMM .COF or IGRF table)"));
        std::istringstream words(text);
        Line line{{}, number};
        for (std::string word; words >> word;)
            line.words.push_back(word);
        if (!line.words.empty() && line.words.front()[0] != '#')
            m_lines.push_back(std::move(line));
    }
    if (m_lines.empty())
        return wrong(MARKED("core", "is empty; expected magnetic coefficients (WMM .COF or IGRF table)"));
    return {};
}

Result<double> FieldFile::number(const Line& line, std::size_t word) const
{
    if (word >= line.words.size())
        return wrong({MARKED_N("core", "the line has %n figure(s); it is cut short"), line.words.size()}, line);
    const FileNumber read = readNumber(line.words[word]);
    if (read.fault != NumberFault::None)
        return wrong({MARKED("core", "%1 is not a number"), inQuotes(line.words[word])}, line);
    return read.value;
}

Result<int> FieldFile::whole(const Line& line, std::size_t word) const
{
    const auto value = number(line, word);
    if (!value)
        return value.error();
    if (*value < 0 || *value > kMostDegree || *value != static_cast<int>(*value))
        return wrong({MARKED("core", "%1 is no degree or order; expected a whole number"), inQuotes(line.words[word])}, line);
    return static_cast<int>(*value);
}

Result<void> FieldFile::checkPlace(const Line& line, std::size_t firstWord, int n, int m) const
{
    const auto degree = whole(line, firstWord), order = whole(line, firstWord + 1);
    if (!degree)
        return degree.error();
    if (!order)
        return order.error();
    if (*degree == n && *order == m)
        return {};
    return wrong(
        {MARKED("core", "holds degree %1 order %2 where degree %3 order %4 was expected: a line is missing, doubled or out of order"),
            *degree, *order, n, m},
        line);
}

bool isEndOfCof(const Line& line)
{
    return line.words.front().size() > 20 && line.words.front().find_first_not_of('9') == std::string::npos;
}

/// @return the degree of the last complete row of orders.
Result<int> FieldFile::readCofRows(std::vector<std::array<Gauss, 2>>& rows) const
{
    int n = 1, m = 0;
    for (std::size_t i = 1; i < m_lines.size(); ++i) {
        const Line& line = m_lines[i];
        if (isEndOfCof(line)) {
            if (m != 0 || n == 1)
                return wrong({MARKED("core", "ends within degree %1, before order %2: it is cut short"), n, m}, line);
            return n - 1;
        }
        if (const auto placed = checkPlace(line, 0, n, m); !placed)
            return placed.error();
        std::array<double, 4> figures{};
        for (std::size_t k = 0; k < 4; ++k) {
            const auto figure = number(line, k + 2);
            if (!figure)
                return figure.error();
            figures[k] = *figure;
        }
        if (line.words.size() > 6)
            return wrong(MARKED("core", "has more than the six figures n m g h dg dh"), line);
        if (m == 0 && (figures[1] != 0.0 || figures[3] != 0.0))
            return wrong(MARKED("core", "gives h for order 0, where there is none"), line);
        rows.push_back({Gauss{figures[0], figures[1]}, Gauss{figures[2], figures[3]}});
        if (++m > n)
            ++n, m = 0;
    }
    return wrong({MARKED("core", "ends without its line of nines after degree %1 order %2: it is cut short"), n, m - 1});
}

Result<FieldTable> FieldFile::readCof()
{
    const Line& header = m_lines.front();
    const auto epoch = number(header, 0);
    if (!epoch)
        return epoch.error();
    if (header.words.size() < 2 || *epoch < 1900 || *epoch > 2200)
        return wrong(
            MARKED("core", "is no header of a WMM coefficient file; expected epoch, name and date, as in \"2025.0 WMM-2025 11/13/2024\""),
            header);
    std::vector<std::array<Gauss, 2>> rows;
    const auto degree = readCofRows(rows);
    if (!degree)
        return degree.error();
    FieldTable table = emptyTable(header.words[1], *epoch, 1, *degree);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        table.main[0][i] = rows[i][0];
        table.change[i] = rows[i][1];
    }
    std::erase(table.name, '-'); // "WMM-2025" is WMM2025
    return table;
}

Result<FieldTable> FieldFile::readIgrf()
{
    // c/s deg ord IGRF IGRF …; g/h n m 1900.0 1905.0 … 2025.0 2025-30
    const auto years = std::find_if(m_lines.begin(), m_lines.end(), [](const Line& line) { return line.words.front() == "g/h"; });
    if (years == m_lines.end() || years->words.size() < 6)
        return wrong(MARKED("core", "has no header \"g/h n m 1900.0 …\" with its epochs; expected an IGRF table"));
    const auto epochs = static_cast<int>(years->words.size()) - 4; // g/h, n, m and the column of the change
    std::vector<double> epoch;
    for (int i = 0; i < epochs; ++i) {
        const auto year = number(*years, static_cast<std::size_t>(3 + i));
        if (!year)
            return year.error();
        epoch.push_back(*year);
        if (i > 0 && std::abs(epoch[static_cast<std::size_t>(i)] - epoch[static_cast<std::size_t>(i - 1)] - 5.0) > 1e-9)
            return wrong(MARKED("core", "has epochs that are not five years apart"), *years);
    }
    struct Row {
        int n, m;
        bool isG;
        const Line* line;
    };
    int degree = 0, n = 1, m = 0;
    bool isG = true;
    std::vector<Row> rows;
    for (auto line = years + 1; line != m_lines.end(); ++line) {
        if (line->words.front() != (isG ? "g" : "h"))
            return wrong(
                {MARKED("core", "begins with %1 where %2 of degree %3 order %4 was expected: a line is missing, doubled or out of order"),
                    inQuotes(line->words.front()), isG ? 'g' : 'h', n, m},
                *line);
        if (const auto placed = checkPlace(*line, 1, n, m); !placed)
            return placed.error();
        if (line->words.size() != years->words.size())
            return wrong({MARKED_N("core", "has %n word(s) where the header has %1"), line->words.size(), years->words.size()}, *line);
        rows.push_back({n, m, isG, &*line});
        degree = n;
        if (isG && m > 0) {
            isG = false;
        } else {
            isG = true;
            if (++m > n)
                ++n, m = 0;
        }
    }
    if (degree == 0 || m != 0 || !isG)
        return wrong({MARKED("core", "ends within degree %1: it is cut short"), n});
    FieldTable table = emptyTable("IGRF of " + std::to_string(static_cast<int>(epoch.back())), epoch.front(), epochs, degree);
    for (const Row& row : rows)
        for (int i = 0; i <= epochs; ++i) {
            const auto figure = number(*row.line, static_cast<std::size_t>(3 + i));
            if (!figure)
                return figure.error();
            GaussSet& set = i < epochs ? table.main[static_cast<std::size_t>(i)] : table.change;
            Gauss& gauss = set[gaussIndex(row.n, row.m)];
            (row.isG ? gauss.g : gauss.h) = *figure;
        }
    return table;
}

Result<FieldTable> FieldFile::read()
{
    if (const auto lines = readLines(); !lines)
        return lines.error();
    const std::string& first = m_lines.front().words.front();
    return first == "c/s" || first == "g/h" ? readIgrf() : readCof();
}

} // namespace

Result<FieldTable> readFieldTable(const std::string& path) { return FieldFile(path).read(); }

} // namespace lubberline
