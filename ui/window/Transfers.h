#pragma once
/// Files in and out, as work for a background job.

#include <vector>

#include "db/stores/Stores.h"
#include "ui/intake/ImportFile.h"
#include "ui/kit/BackgroundJob.h"

namespace lubberline::ui {

/// Reads a file (see readImportFile()) and stores it through a connection of the worker's own.
[[nodiscard]] Work importing(const db::Stores& stores, const QString& path, const CsvParticulars& particulars);

/// Writes aircraft (none: all) as an exchange file: beside it, then renamed. Errors: Io.
[[nodiscard]] Work exporting(const db::Stores& stores, const std::vector<AircraftId>& aircraft, const QString& path);

} // namespace lubberline::ui
