#pragma once
/// A small table of named columns, read whole: what PairCsv and SunCsv share.

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/Result.h"

namespace lubberline {

/// A row: the cells of the columns that were asked for, in their order; empty where the table has no such column or cell.
using SmallRow = std::vector<std::string>;

/// What a table may look like: core/format/csv/FigureCsv.h. Calls `take(row)` for each row that has one of the columns.
/// Errors: those of FigureCsv; Format (one of the first `required` columns missing); those of `take`, with the line.
Result<void> readSmallTable(std::string_view text, const std::string& name, std::span<const std::string_view> columns, std::size_t required,
    const std::function<Result<void>(const SmallRow& row)>& take);

} // namespace lubberline
