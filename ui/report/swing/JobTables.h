#pragma once
/// What a guided swing adds to its record: as found, adjustments, interference, readings put aside, figures as they were read;
/// and what a revision changes.

#include <vector>

#include "ui/report/page/Table.h"
#include "ui/report/swing/Report.h"

namespace lubberline::ui {

/// Those that have a row.
[[nodiscard]] std::vector<Table> jobTables(const ReportInput& input);

} // namespace lubberline::ui
