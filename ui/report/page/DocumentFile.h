#pragma once
/// Documents as files: whole or not at all.

#include <QByteArray>
#include <QString>

#include "core/base/Result.h"

namespace lubberline::ui {

/// Writes beside the file and renames. Errors: Io, naming the folder that is missing, is no folder, or takes no file; full
/// disk.
Result<void> writeDocument(const QString& path, const QByteArray& bytes);

} // namespace lubberline::ui
