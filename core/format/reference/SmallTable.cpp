#include "core/format/reference/SmallTable.h"

#include <algorithm>
#include <optional>

#include "core/base/FileText.h"
#include "core/format/csv/RowSplitter.h"

namespace lubberline {

namespace {

class SmallTable {
public:
    SmallTable(std::span<const std::string_view> columns, std::size_t required)
        : m_columns(columns)
        , m_required(required)
        , m_place(columns.size())
    {
    }

    Result<void> take(std::string_view line, const std::function<Result<void>(const SmallRow&)>& each)
    {
        line = trimmed(line);
        if (line.empty() || line.front() == '#')
            return {};
        if (!m_header)
            for (const char separator : {'\t', ';', ','})
                if (line.find(separator) != std::string_view::npos) {
                    m_separator = separator;
                    break;
                }
        RowSplitter row(m_separator);
        if (row.begin(line) != RowSplitter::State::Complete)
            return wrong(MARKED("core", "a cell in quotes that does not end; expected its closing quote in the same line"));
        if (!m_header)
            return takeHeader(row.cells());
        SmallRow cells(m_columns.size());
        bool any = false;
        for (std::size_t i = 0; i < cells.size(); ++i)
            if (m_place[i] && *m_place[i] < row.cells().size()) {
                cells[i] = std::string(trimmed(row.cells()[*m_place[i]]));
                any = any || !cells[i].empty();
            }
        return any ? each(cells) : Result<void>();
    }
    [[nodiscard]] bool hasHeader() const { return m_header; }

private:
    static Error wrong(Message what) { return {ErrorCode::Format, std::move(what)}; }

    Result<void> takeHeader(const std::vector<std::string>& cells)
    {
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const auto found = std::find(m_columns.begin(), m_columns.end(), inSmallLetters(trimmed(cells[i])));
            if (found == m_columns.end())
                continue;
            auto& place = m_place[static_cast<std::size_t>(found - m_columns.begin())];
            if (place)
                return wrong({MARKED("core", "column %1 stands twice; expected it once"), inQuotes(*found)});
            place = i;
        }
        for (std::size_t i = 0; i < m_required; ++i)
            if (!m_place[i])
                return wrong({MARKED("core", "no column %1; expected it in the header"), std::string(m_columns[i])});
        m_header = true;
        return {};
    }

    std::span<const std::string_view> m_columns;
    std::size_t m_required;
    std::vector<std::optional<std::size_t>> m_place;
    char m_separator = ',';
    bool m_header = false;
};

} // namespace

Result<void> readSmallTable(std::string_view text, const std::string& name, std::span<const std::string_view> columns, std::size_t required,
    const std::function<Result<void>(const SmallRow& row)>& take)
{
    if (auto why = otherEncoding(text); !why.empty())
        return Error{ErrorCode::Format, std::move(why), name};
    if (text.starts_with(kByteOrderMark))
        text.remove_prefix(kByteOrderMark.size());
    SmallTable table(columns, required);
    std::int64_t number = 0;
    while (!text.empty()) {
        const auto end = text.find_first_of("\r\n");
        const std::string_view line = text.substr(0, end);
        ++number;
        if (auto why = notUtf8(line); !why.empty())
            return Error{ErrorCode::Format, std::move(why), name, number};
        if (const auto taken = table.take(line, take); !taken)
            return Error{taken.error().code, taken.error().message, name, number};
        if (end == std::string_view::npos)
            break;
        text.remove_prefix(text.substr(end).starts_with("\r\n") ? end + 2 : end + 1);
    }
    if (!table.hasHeader())
        return Error{ErrorCode::Format,
            {MARKED("core", "no header; expected the columns %1 and %2"), std::string(columns[0]), std::string(columns[1])}, name};
    return {};
}

} // namespace lubberline
