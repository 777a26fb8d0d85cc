#pragma once
/// A document of blocks between the usual header and footer: forms and style sheets.

#include <QString>

#include <functional>

#include "ui/report/page/Page.h"
#include "ui/report/page/PageFrame.h"

class QPagedPaintDevice;

namespace lubberline::ui {

/// The blocks of a sheet in a font, for a room. [units of the page]
using SheetBlocks = std::function<std::vector<Block>(const QString& family, QSizeF room)>;

Result<void> printSheet(const PageFrame& frame, const SheetBlocks& blocks, QPagedPaintDevice& device, const Progress& progress = {});
/// Errors: InvalidInput (an ending other than .pdf), Io, Unsupported (no font).
/// PDF/A-1b.
Result<void> writeSheet(const PageFrame& frame, const SheetBlocks& blocks, const QString& path, const Progress& progress = {});

} // namespace lubberline::ui
