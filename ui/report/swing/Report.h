#pragma once
/// Swing reports: A4 pages with vector plots, HTML with the plots inside, CSV and JSON. All show the same result object.

#include <QSizeF>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

#include "core/angle/AngleText.h"
#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/record/Fleet.h"
#include "core/record/SignatureState.h"
#include "core/swing/Analysis.h"
#include "ui/text/AngleWords.h"

class QPagedPaintDevice;

namespace lubberline::ui {

class ReportPages;

/// The head of an audit trail: noted on paper, it can be held against the database later (`db verify --head`).
struct AuditHead {
    QString head; ///< 64 hexadecimal digits; empty: the swing is of no database
    qint64 entries = 0;
};

struct ReportInput {
    SwingRecord record;
    Analysis analysis;                      ///< of the record's used readings in their order
    std::optional<Swing> previous;          ///< last swing of the same compass: drawn behind the curve
    std::vector<SensorRecord> sensors = {}; ///< of the compass, newest first: the first is reported, with the swing's field if it keeps one
    std::optional<JobRecord> job = {};      ///< the guided swing that made it
    std::optional<JobRecord> previousJob = {};   ///< likewise of the last swing
    std::optional<Swing> superseded = {};        ///< the revision that it amends
    AngleStyle angleStyle = shownAngles();       ///< of readings and plots
    std::vector<SignatureState> signatures = {}; ///< as Swing::signatures; empty: their hashes alone are looked at
    bool signaturesStand = true;                 ///< over what a signed swing says now; a swing of a file: its hashes alone are looked at
    AuditHead audit = {};                        ///< of the database that it is of
    QString madeAtUtc;                           ///< ISO 8601; printed
    bool archive = false;                        ///< PDF/A-1b, which may carry no attachment; else PDF 1.6 with the exchange JSON attached
};

/// Writes a report; the ending says which: .pdf, .html, .csv or .json. Written beside and renamed: no half file is left.
/// @param kind  "pdf", "html", "csv" or "json" where the path, "-" for standard output, has no ending.
/// Errors: InvalidInput (another ending), Io (folder missing or not writable: named), Unsupported (no font for a PDF), Cancelled.
Result<void> writeReport(const ReportInput& input, const QString& path, const QString& kind = {}, const Progress& progress = {});

/// Paints the pages of the PDF on any paged device: a QPrinter of the print dialog or preview, in its page size.
/// Errors: Unsupported (no font), Io (the device takes no painting), Cancelled.
Result<void> printReport(const ReportInput& input, QPagedPaintDevice& device, const Progress& progress = {});

/// The same in two steps: what takes longest can be done on a worker, for the size of sheet that is to be expected.
/// Errors: Unsupported (no font).
Result<std::shared_ptr<const ReportPages>> layOutReport(const ReportInput& input, QSizeF sheet);
Result<void> printReport(const ReportPages& pages, QPagedPaintDevice& device, const Progress& progress);
[[nodiscard]] QSizeF a4Sheet(); ///< [units of the page]

/// How many A4 pages that makes. Errors: Unsupported (no font).
Result<int> reportPageCount(const ReportInput& input);

/// The exchange JSON inside a report of ours. Errors: Io, Format (not a PDF; no such attachment).
Result<std::string> exchangeInReport(const QString& path);
/// The same of a whole PDF that is read already; `name` is for messages.
Result<std::string> exchangeInPdf(const std::string& bytes, const QString& name);
[[nodiscard]] bool isPdf(std::string_view bytes);

} // namespace lubberline::ui
