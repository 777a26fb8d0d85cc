#pragma once
/// Swings for the tests of documents: the published ones, and simulated ones of any length.

#include <array>
#include <string>
#include <vector>

#include "core/record/Fleet.h"
#include "core/swing/Card.h"
#include "ui/report/card/CardDocument.h"
#include "ui/report/swing/Report.h"

namespace lubberline::test {

/// "Compass Compensation Worksheet Examples" (QNSC PEWB), questions 1 to 3: the check swing on eight headings
/// (landing compass, aircraft compass), coefficient A and the STEER figures for 000, 045 … 315.
struct WorksheetSwing {
    std::vector<std::pair<double, double>> readings_deg;
    double A_deg;
    std::array<int, 8> steer_deg;
};
extern const std::array<WorksheetSwing, 3> kWorksheet;

/// NGA Handbook of Magnetic Compass Adjustment (2004), art. 501: deviation on N, NE … NW by compass.
extern const std::array<double, 8> kNga501Deviation_deg;

/// Particulars of every kind filled in, limits 10° of 14 CFR 25.1327, complete, no readings.
SwingRecord emptyRecord();
SwingRecord worksheetRecord(const WorksheetSwing& swing);
SwingRecord nga501Record();
/// `points` equally spaced magnetic headings of a compass with the given scale of its coefficients, and reading noise.
SwingRecord simulatedRecord(int points, double scale = 1.0);

/// Analysed; made at a fixed time.
ui::ReportInput reportOf(const SwingRecord& record);
ui::CardInput cardOf(const SwingRecord& record, const CardOptions& options, const QString& heading = "STEER");

} // namespace lubberline::test
