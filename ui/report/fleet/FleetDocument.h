#pragma once
/// The fleet report on paper and as HTML.

#include <QString>

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/fleet/FleetReport.h"
#include "core/fleet/FleetSelection.h"

namespace lubberline::ui {

struct FleetDocument {
    const FleetReport& report;
    const FleetSwings& fleet;
    const FleetSelection& selection;
    QString madeAtUtc;
};

enum class DocumentKind { Pdf, Html };

/// A4 with vector plots, or one self-contained page. Errors: Io, Unsupported (no font).
Result<void> writeFleetDocument(const FleetDocument& document, const QString& path, DocumentKind kind, const Progress& progress = {});

} // namespace lubberline::ui
