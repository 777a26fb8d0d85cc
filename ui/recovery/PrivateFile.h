#pragma once
/// A file that only its user may have written: what stands in it is put into a record when he says so.

#include <QByteArray>
#include <QString>

#include "core/base/Result.h"

namespace lubberline::ui {

/// Empty where there is none. Errors: Io when it, or its folder, is not the user's own and his alone to write: a link, a pipe or a device,
/// another owner's, one that others may write; or larger than any that the program has written.
Result<QByteArray> readPrivateFile(const QString& path);

/// On the drive when this returns. Folder and file are made where they are missing, for the user alone. Errors: Io, as above.
Result<void> appendPrivately(const QString& path, const QByteArray& text);

} // namespace lubberline::ui
