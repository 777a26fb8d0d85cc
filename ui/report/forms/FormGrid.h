#pragma once
/// Tables to write in by hand: every cell has its frame and room for a pen.

#include <QString>

#include <vector>

#include "ui/report/page/Page.h"

namespace lubberline::ui {

struct FormColumn {
    QString head;
    double width_mm = 20;
};

/// The columns take the whole width, in proportion; the head is repeated on the next page. [units of the page]
[[nodiscard]] std::vector<Block> formGrid(const QString& title, const std::vector<FormColumn>& columns,
    const std::vector<QStringList>& rows, double width, const QString& family, double rowHeight = mm(8));

} // namespace lubberline::ui
