#pragma once
/// Any file that can be imported, as a fleet: Swing CSV, exchange JSON (.lubberline.json, .json), or a report PDF of ours,
/// which carries its exchange JSON. The window and the command line share it; it may be called on a worker thread.

#include <QString>

#include <string>
#include <vector>

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/record/Fleet.h"

namespace lubberline::ui {

/// Particulars that a CSV may not state.
struct CsvParticulars {
    std::string aircraft; ///< registration
    std::string type;
    std::string compass;
};

struct ImportFile {
    Fleet fleet;
    std::vector<Message> warnings;
};

/// What a CSV states itself goes before `particulars`. Errors: those of the readers; InvalidInput for another ending and for a
/// CSV whose aircraft nobody names.
Result<ImportFile> readImportFile(const QString& path, const CsvParticulars& particulars, const Progress& progress);

} // namespace lubberline::ui
