#pragma once
/// A report's content as blocks of pages.

#include <vector>

#include "ui/report/page/Page.h"
#include "ui/report/swing/ReportContent.h"

namespace lubberline::ui {

/// @param body the room for content on a page [units of the page]. Blocks refer to `content`, which must outlive them.
[[nodiscard]] std::vector<Block> reportBlocks(const ReportContent& content, const QString& family, QSizeF body);

} // namespace lubberline::ui
