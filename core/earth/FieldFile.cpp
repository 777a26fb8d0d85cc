// The published coefficient files, read strictly: a coefficient that is missing, doubled or out of its place would bend every
// compass.

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "core/base/FileText.h"
#include "core/base/LineReader.h"
#include "core/base/Number.h"
#include "core/base/WholeFile.h"
#include "core/earth/FieldTables.h"

namespace lubberline {

namespace {

constexpr std::size_t kMostLines = 700'000;
constexpr std::size_t kMostWords = 128; ///< of a line: IGRF has one an epoch of five years
constexpr double kYearsOfEpoch = 5.0;

struct Line {
    std::vector<std::string> words;
    std::int64_t number = 0;
};

class FieldFile {
public:
    explicit FieldFile(const std::string& path) : m_path(path), m_name(nameOfInput(path)) {}
    Result<FieldTable> read();

private:
    Error wrong(const Message& what, const Line& line) const { return {ErrorCode::Format, what, m_name, line.number}; }
    Error wrong(const Message& what) const { return {ErrorCode::Format, what, m_name, 0}; }
    Result<void> readLines();
    Result<FieldTable> readCof();
    Result<FieldTable> readIgrf();
    Result<double> number(const Line& line, std::size_t word) const;
    Result<int> whole(const Line& line, std::size_t word) const;
    Result<std::vector<double>> epochsOf(const Line& years) const;
    Result<int> readCofRows(std::vector<std::array<Gauss, 2>>& rows) const;
    Result<void> checkPlace(const Line& line, std::size_t firstWord, int n, int m) const;

    const std::string& m_path;
    const std::string m_name;
    const Progress m_progress; ///< none: such files are small
    std::vector<Line> m_lines; ///< without comments and blank lines
};

Result<void> FieldFile::readLines()
{
    const auto file = openInput(m_path, MARKED("core", "a file of magnetic coefficients"));
    if (!file)
        return file.error();
    LineReader lines(**file, m_progress);
    if (const Message other = otherEncoding(lines.beginning()); !other.empty())
        return wrong(other);
    std::string text;
    LineOutcome outcome = lines.next(text);
    if (text.starts_with(kByteOrderMark))
        text.erase(0, kByteOrderMark.size());
    for (; outcome == LineOutcome::Line; outcome = lines.next(text)) {
        if (text.size() > 4096 || m_lines.size() > kMostLines)
            return wrong(MARKED("core", "is no text of magnetic coefficients (WMM .COF or IGRF table)"));
        std::istringstream words(text);
        Line line{{}, lines.lineNumber()};
        for (std::string word; words >> word && line.words.size() <= kMostWords;)
            line.words.push_back(word);
        if (line.words.size() > kMostWords)
            return wrong(MARKED("core", "is no text of magnetic coefficients (WMM .COF or IGRF table)"));
        if (!line.words.empty() && line.words.front()[0] != '#')
            m_lines.push_back(std::move(line));
    }
    if (outcome == LineOutcome::ReadError)
        return Error{ErrorCode::Io, MARKED("core", "cannot be read to its end"), m_name};
    if (outcome != LineOutcome::End)
        return wrong(MARKED("core", "is no text of magnetic coefficients (WMM .COF or IGRF table)"));
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
    if (m == 0 && n > 1)
        return wrong(
            {MARKED("core",
                 "ends without its line of nines behind degree %1: whether more degrees are missing cannot be told; expected a line of 48 nines at its end"),
                n - 1});
    return wrong({MARKED("core", "ends without its line of nines within degree %1, before order %2: it is cut short"), n, m});
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

/// g/h n m 1900.0 1905.0 … 2025.0, and for most tables 2025-30.
Result<std::vector<double>> FieldFile::epochsOf(const Line& years) const
{
    const bool hasChange = readNumber(years.words.back()).fault != NumberFault::None;
    std::vector<double> epochs;
    for (std::size_t word = 3; word < years.words.size() - (hasChange ? 1 : 0); ++word) {
        const auto year = number(years, word);
        if (!year)
            return year.error();
        if (!epochs.empty() && std::abs(*year - epochs.back() - kYearsOfEpoch) > 1e-9)
            return wrong(MARKED("core", "has epochs that are not five years apart"), years);
        epochs.push_back(*year);
    }
    return epochs;
}

Result<FieldTable> FieldFile::readIgrf()
{
    // c/s deg ord IGRF IGRF …; g/h n m 1900.0 1905.0 … 2025.0 2025-30
    const auto years = std::find_if(m_lines.begin(), m_lines.end(), [](const Line& line) { return line.words.front() == "g/h"; });
    constexpr Pattern kNoHeader = MARKED("core", "has no header \"g/h n m 1900.0 …\" with its epochs; expected an IGRF table");
    if (years == m_lines.end() || years->words.size() < 4)
        return wrong(kNoHeader);
    auto epoch = epochsOf(*years);
    if (!epoch)
        return epoch.error();
    if (epoch->empty())
        return wrong(kNoHeader, *years);
    const auto epochs = static_cast<int>(epoch->size());
    // Without its column of the change a table ends at its last epoch: up to there it is linear, as the change is.
    const bool hasChange = years->words.size() == epoch->size() + 4;
    if (!hasChange && epochs < 2)
        return wrong(
            MARKED("core",
                "has one epoch and no column of the yearly change (as \"2025-30\"), so it says nothing of any other year; expected both"),
            *years);
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
    const int sets = hasChange ? epochs : epochs - 1; // the last epoch alone gives the change of the years before it
    FieldTable table = emptyTable("IGRF of " + std::to_string(static_cast<int>(epoch->back())), epoch->front(), sets, degree);
    for (const Row& row : rows) {
        double before = 0;
        for (int i = 0; i <= sets; ++i) {
            const auto figure = number(*row.line, static_cast<std::size_t>(3 + i));
            if (!figure)
                return figure.error();
            GaussSet& set = i < sets ? table.main[static_cast<std::size_t>(i)] : table.change;
            Gauss& gauss = set[gaussIndex(row.n, row.m)];
            (row.isG ? gauss.g : gauss.h) = i < sets || hasChange ? *figure : (*figure - before) / kYearsOfEpoch;
            before = *figure;
        }
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
