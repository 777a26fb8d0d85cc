#pragma once
/// Charts are widgets and belong to the window's thread; documents are painted on a worker. What a document wants of a chart is drawn in the
/// window's thread and goes to the worker as a picture.

#include <QRectF>

#include <functional>

class QPainter;

namespace lubberline::ui {

/// Has `draw` called with a painter and the target: at once in the window's thread; from another it is waited for, and what was drawn is
/// painted then. The window's thread must be in its event loop, or in drawWanted().
void drawOnPaper(QPainter& painter, const QRectF& target, const std::function<void(QPainter&, const QRectF&)>& draw);

/// For the window's thread while it waits for a worker itself: draws what that waits for.
void drawWanted();

} // namespace lubberline::ui
