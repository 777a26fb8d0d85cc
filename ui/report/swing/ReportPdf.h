#pragma once
/// The PDF of a report.

#include <QByteArray>

#include "ui/report/swing/Report.h"

namespace lubberline::ui {

/// Errors: Unsupported (no font), Io.
Result<QByteArray> reportPdf(const ReportInput& input, const Progress& progress);

} // namespace lubberline::ui
