#pragma once
/// The Qt application object that a command needs. Commands that draw work without a display: they take the offscreen platform.

#include <QApplication>

#include <memory>

#include "core/base/Result.h"

namespace lubberline::app {

/// For commands that print or draw: the offscreen platform, unless QT_QPA_PLATFORM names another.
[[nodiscard]] std::unique_ptr<QApplication> makeDrawingSession();

/// For the window. Errors: Unsupported when there is no display.
Result<std::unique_ptr<QApplication>> makeWindowSession(int& argc, char** argv);

/// Whether a window can be opened here (DISPLAY, WAYLAND_DISPLAY or QT_QPA_PLATFORM is set).
[[nodiscard]] bool hasDisplay();

} // namespace lubberline::app
