#pragma once
/// The Qt application object that a command needs. Commands that draw work without a display: they take the offscreen platform.

#include <QApplication>

#include <memory>

#include "core/base/Result.h"

namespace lubberline::app {

/// For commands that print or draw: the offscreen platform, whatever QT_QPA_PLATFORM names, and angles written as the window is set to.
[[nodiscard]] std::unique_ptr<QApplication> makeDrawingSession();

/// For the window, in the language of ui/text/Language.h. Errors: Unsupported when there is no display.
Result<std::unique_ptr<QApplication>> makeWindowSession(int& argc, char** argv);

/// Whether a window that is opened here is seen by somebody: there is a display, and QT_QPA_PLATFORM does not turn away from it
/// (offscreen, minimal).
[[nodiscard]] bool hasDisplay();

} // namespace lubberline::app
