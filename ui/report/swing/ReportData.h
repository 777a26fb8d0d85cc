#pragma once
/// Reports for programs: CSV and JSON.

#include <QByteArray>

#include "ui/report/swing/Report.h"

namespace lubberline::ui {

/// A Swing CSV that our own reader takes, with the results in columns after the readings.
[[nodiscard]] QByteArray reportCsv(const ReportInput& input);

/// {"made_at_utc", "data_sha256", "record": the exchange JSON, "analysis": as the command `analyse` prints it}.
[[nodiscard]] QByteArray reportJson(const ReportInput& input);

} // namespace lubberline::ui
