#pragma once

namespace lubberline::app {

struct Invocation;

/// Opens the main window on the database of the invocation and runs until it is closed. @return the exit status.
int openWindow(const Invocation& invocation);

} // namespace lubberline::app
