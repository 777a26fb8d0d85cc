#pragma once
/// Deviation from winds on paper: what each aircraft has and how sure it is, the tables to upload, winds before and after, the fleet by size
/// and what is out of line, recalibrations.

#include <QString>

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/inflight/WindStudy.h"

namespace lubberline::ui {

struct WindSheet {
    WindResult result;
    TableFactor factor = TableFactor::Paper;
    QString source; ///< the file
    QString madeAtUtc;
};

/// Errors: InvalidInput (an ending other than .pdf), Io, Unsupported (no font).
Result<void> writeWindSheet(const WindSheet& sheet, const QString& path, const Progress& progress = {});

} // namespace lubberline::ui
