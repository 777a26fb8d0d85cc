#include "app/QtSession.h"

#include <cstdio>
#include <cstdlib>

namespace lubberline::app {

namespace {

void describeApplication()
{
    QCoreApplication::setApplicationName("lubberline");
    QCoreApplication::setOrganizationName("lubberline");
    QCoreApplication::setApplicationVersion(LUBBERLINE_VERSION);
    QGuiApplication::setApplicationDisplayName("Lubberline");
    QGuiApplication::setDesktopFileName("lubberline");
}

/// Qt's own remarks on the machine (no runtime folder, no size hints offscreen) are not for whoever reads our messages.
void showMessage(QtMsgType type, const QMessageLogContext&, const QString& message)
{
    if (message.startsWith("QStandardPaths: ") || message.startsWith("This plugin does not support"))
        return;
    std::fprintf(stderr, "lubberline: %s\n", qPrintable(message));
    if (type == QtFatalMsg)
        std::abort();
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
    qInstallMessageHandler(showMessage);
    auto session = std::make_unique<QApplication>(count, arguments);
    describeApplication();
    return session;
}

Result<std::unique_ptr<QApplication>> makeWindowSession(int& argc, char** argv)
{
    if (!hasDisplay())
        return Error{ErrorCode::Unsupported,
            "there is no display to open a window on (DISPLAY and WAYLAND_DISPLAY are not set); "
            "commands work without one: lubberline --help"};
    qInstallMessageHandler(showMessage);
    auto session = std::make_unique<QApplication>(argc, argv);
    describeApplication();
    return session;
}

} // namespace lubberline::app
