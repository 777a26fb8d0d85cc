#include "core/format/reference/SmallTable.h"

#include <algorithm>
#include <optional>
#include <sstream>

#include "core/format/csv/FigureCsv.h"

namespace lubberline {

Result<void> readSmallTable(std::string_view text, const std::string& name, std::span<const std::string_view> columns, std::size_t required,
    const std::function<Result<void>(const SmallRow& row)>& take)
{
    std::istringstream input{std::string(text)};
    FigureCsv table(
        input, name, {MARKED("core", "a table with the columns %1 and %2"), std::string(columns[0]), std::string(columns[1])}, {});
    if (const auto header = table.readHeader(columns); !header)
        return header;
    std::vector<std::optional<std::size_t>> places;
    for (const std::string_view column : columns) {
        places.push_back(table.column(column));
        if (!places.back() && places.size() <= required)
            return Error{
                ErrorCode::Format, {MARKED("core", "no column %1; expected it in the header"), std::string(column)}, name, table.line()};
    }
    for (;;) {
        const auto more = table.next();
        if (!more)
            return more.error();
        if (!*more)
            return {};
        SmallRow cells;
        for (const auto& place : places)
            cells.emplace_back(place ? table.cell(*place) : std::string_view());
        if (std::all_of(cells.begin(), cells.end(), [](const std::string& cell) { return cell.empty(); }))
            continue;
        if (const auto taken = take(cells); !taken)
            return Error{taken.error().code, taken.error().message, name, table.line()};
    }
}

} // namespace lubberline
