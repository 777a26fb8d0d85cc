#pragma once
/// Plots as files.

#include <QSize>
#include <QString>

#include <functional>

#include "core/base/Result.h"

class QPainter;
class QRectF;

namespace lubberline::ui {

using PaintPlot = std::function<void(QPainter& painter, const QRectF& target)>;

/// Writes .png, .svg or .pdf, by the ending or by `kind` (where the path is "-", standard output); 96 pixels are an inch of the drawing. Written beside the file and renamed.
/// Errors: InvalidInput (another ending, an empty size), Io (the folder is missing or not writable, the disk is full),
/// Unsupported (no font).
Result<void> writePlotFile(const QString& path, QSize size_px, const QString& title, const PaintPlot& paint, const QString& kind = {});

} // namespace lubberline::ui
