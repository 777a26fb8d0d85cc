#pragma once
/// The page about the Earth's field and the sensor model, as blocks.

#include <vector>

#include "ui/report/page/Page.h"
#include "ui/report/swing/FieldPage.h"

namespace lubberline::ui {

/// @param body the room for content on a page [units of the page]. Blocks refer to `page`, which must outlive them.
[[nodiscard]] std::vector<Block> fieldBlocks(const FieldPage& page, const QString& family, QSizeF body);

/// "• …", wrapped: one block a line of a list.
[[nodiscard]] std::vector<Block> listBlocks(const QStringList& lines, const QString& family, double size_pt, double width);

} // namespace lubberline::ui
