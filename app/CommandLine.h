#pragma once

namespace lubberline::app {

/// Runs `lubberline ARGS…`. Without a command, the window is opened. @return the exit status: 0 done, 1 failed, 2 usage.
int runCommandLine(int argc, char** argv);

} // namespace lubberline::app
