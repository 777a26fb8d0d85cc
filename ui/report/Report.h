#pragma once
/// Swing reports: A4 pages with vector plots, HTML with the plots inside, CSV and JSON. All show the same result object.

#include <QString>

#include <optional>

#include "core/angle/AngleText.h"
#include "core/base/Result.h"
#include "core/deviation/Analysis.h"
#include "core/record/Fleet.h"

namespace lubberline::ui {

struct ReportInput {
    SwingRecord record;
    Analysis analysis;
    std::optional<Swing> previous; ///< last swing of the same compass: drawn behind the curve
    AngleStyle angleStyle = AngleStyle::DecimalDegrees;
    QString madeAtUtc;             ///< ISO 8601; printed
    bool archive = false;          ///< PDF/A-1b, which may carry no attachment; else PDF 1.6 with the exchange JSON attached
};

/// SHA-256, lower-case hexadecimal, of the record's exchange JSON: what is printed on every page.
[[nodiscard]] QString dataHash(const SwingRecord& record);

/// Writes a report; the ending says which: .pdf, .html, .csv or .json. Written beside and renamed: no half file is left.
/// Errors: InvalidInput (another ending), Io (folder missing or not writable: named), Unsupported (no font for a PDF).
Result<void> writeReport(const ReportInput& input, const QString& path);

/// The exchange JSON inside a report of ours. Errors: Io, Format (not a PDF; no such attachment).
Result<std::string> exchangeInReport(const QString& path);

} // namespace lubberline::ui
