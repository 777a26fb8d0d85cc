#pragma once
/// Tables and lists set in blocks: title and head kept with the first row, one block a row, the head repeated on the next page.

#include <vector>

#include "ui/report/page/Page.h"
#include "ui/report/page/Table.h"

namespace lubberline::ui {

/// Height of a row of one line: the usual one, and one for tables that would go on on the next page for a few rows.
inline constexpr double kTableRow = mm(4.5), kDenseTableRow = mm(3.8);

/// The columns take the whole width, in proportion. [units of the page]
[[nodiscard]] std::vector<Block> tableBlocks(const Table& table, double width, const QString& family, double lineHeight = kTableRow);

/// A heading over a part of the page.
[[nodiscard]] Block titleBlock(const QString& title, const QString& family);

/// How a list of facts is set.
struct FactStyle {
    QString family;
    double size_pt = 8;
    double nameWidth = 0; ///< [units of the page]
};
/// Names at the left, what they say beside them, wrapped.
[[nodiscard]] std::vector<Block> factBlocks(const std::vector<Fact>& facts, const FactStyle& style, double width);

} // namespace lubberline::ui
