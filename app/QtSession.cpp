#include "app/QtSession.h"

#include <QLoggingCategory>

namespace lubberline::app {

namespace {

void describeApplication()
{
    QCoreApplication::setApplicationName("lubberline");
    QCoreApplication::setOrganizationName("lubberline");
    QCoreApplication::setApplicationVersion(LUBBERLINE_VERSION);
    QGuiApplication::setApplicationDisplayName("Lubberline");
    QGuiApplication::setDesktopFileName("lubberline");
    // The offscreen platform says "This plugin does not support propagateSizeHints()" in the uncategorised log at every window.
    if (QGuiApplication::platformName() == "offscreen")
        QLoggingCategory::setFilterRules("default.warning=false\nqt.qpa.*=false");
}

} // namespace

bool hasDisplay()
{
    return !qEnvironmentVariableIsEmpty("DISPLAY") || !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY")
        || !qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM");
}

std::unique_ptr<QApplication> makeDrawingSession()
{
    // Qt keeps references to both for as long as the application lives.
    static char name[] = "lubberline", option[] = "-platform", platform[] = "offscreen";
    static char* arguments[] = {name, option, platform, nullptr};
    static int count;
    count = qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM") ? 3 : 1;
    auto session = std::make_unique<QApplication>(count, arguments);
    describeApplication();
    return session;
}

Result<std::unique_ptr<QApplication>> makeWindowSession(int& argc, char** argv)
{
    if (!hasDisplay())
        return Error{ErrorCode::Unsupported, "there is no display to open a window on (DISPLAY and WAYLAND_DISPLAY are not set); "
                                             "commands work without one: lubberline --help"};
    auto session = std::make_unique<QApplication>(argc, argv);
    describeApplication();
    return session;
}

} // namespace lubberline::app
