#include "app/QtSession.h"

#include <QSettings>

#include <clocale>
#include <cstdio>
#include <cstdlib>

#include "app/Console.h"
#include "ui/text/AngleWords.h"
#include "ui/text/Language.h"

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

/// Qt takes the C library's locale from the environment, too: our files and tables have points in their figures everywhere.
void keepDecimalPoints() { std::setlocale(LC_NUMERIC, "C"); }

/// Qt's own remarks on the machine (no runtime folder, no size hints offscreen) are not for whoever reads our messages.
void showMessage(QtMsgType type, const QMessageLogContext&, const QString& message)
{
    if (message.startsWith("QStandardPaths: ") || message.startsWith("This plugin does not support"))
        return;
    say(message.toStdString());
    if (type == QtFatalMsg)
        std::abort();
}

} // namespace

bool hasDisplay()
{
    const bool x11 = !qEnvironmentVariableIsEmpty("DISPLAY"), wayland = !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY");
    // "offscreen:size=800x600;xcb": the first of several, without its options.
    const QByteArray platform = qgetenv("QT_QPA_PLATFORM").split(';').front().split(':').front().trimmed();
    if (platform == "offscreen" || platform == "minimal")
        return false; // a window there is seen by nobody, and nobody can close it
    if (platform == "xcb")
        return x11;
    if (platform.startsWith("wayland"))
        return wayland;
    return !platform.isEmpty() || x11 || wayland; // linuxfb, eglfs, vnc: screens of their own
}

std::unique_ptr<QApplication> makeDrawingSession()
{
    // Qt keeps references to both for as long as the application lives.
    static char name[] = "lubberline", option[] = "-platform", platform[] = "offscreen";
    static char* arguments[] = {name, option, platform, nullptr};
    static int count;
    count = 3; // whatever the environment names: a platform without its display would end the program
    qInstallMessageHandler(showMessage);
    auto session = std::make_unique<QApplication>(count, arguments);
    keepDecimalPoints();
    describeApplication();
    ui::speak({QStringLiteral("en")}); // what commands write is English, with its plurals
    // What is drawn is read by the same people: their documents write angles alike. Tables, CSV and JSON stay in decimal degrees.
    ui::showAnglesIn(QSettings().value("view/minutes", false).toBool() ? AngleStyle::DegreesMinutes : AngleStyle::DecimalDegrees);
    return session;
}

Result<std::unique_ptr<QApplication>> makeWindowSession(int& argc, char** argv)
{
    if (!hasDisplay())
        return Error{ErrorCode::Unsupported,
            MARKED("app",
                "there is no display to open a window on (neither DISPLAY nor WAYLAND_DISPLAY is set, or QT_QPA_PLATFORM names one that nobody sees); commands work without one: lubberline --help")};
    qInstallMessageHandler(showMessage);
    auto session = std::make_unique<QApplication>(argc, argv);
    keepDecimalPoints();
    describeApplication();
    ui::speak(ui::wantedLanguages(QSettings().value("view/language").toString()));
    return session;
}

} // namespace lubberline::app
