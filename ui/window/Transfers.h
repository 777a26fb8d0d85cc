#pragma once
/// Files in and out, as work for a worker.

#include <QStringList>

#include <vector>

#include "db/stores/Stores.h"
#include "ui/intake/ImportFile.h"
#include "ui/kit/FileQuestions.h"
#include "ui/kit/Worker.h"

namespace lubberline::ui {

struct TransferOutcome {
    QString message;
    QStringList warnings;
    SwingId swing; ///< what to show then, if valid
    bool fleetChanged = false;
    std::function<void()> then = {}; ///< on the window's thread
};
using Transfer = Worker<TransferOutcome>::Work;

/// Reads a file (see readImportFile()) and stores it through a connection of the worker's own.
[[nodiscard]] Transfer importing(const db::Stores& stores, const QString& path, const CsvParticulars& particulars);

/// Writes aircraft (none: all) as an exchange file: beside it, then renamed. Errors: Io.
[[nodiscard]] Transfer exporting(const db::Stores& stores, const std::vector<AircraftId>& aircraft, const QString& path);

/// A document. Errors: those of its work.
[[nodiscard]] Transfer writing(const FileToWrite& file);

} // namespace lubberline::ui
