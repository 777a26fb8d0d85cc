#include "app/Window.h"

#include <QMessageBox>
#include <QProcess>
#include <QSettings>
#include <QStandardPaths>

#include "app/Console.h"
#include "app/Demonstration.h"
#include "app/OpenStores.h"
#include "app/QtSession.h"
#include "app/commands/Command.h"
#include "db/schema/Schema.h"
#include "db/transfer/Maintenance.h"
#include "ui/text/Translated.h"
#include "ui/window/MainWindow.h"

namespace lubberline::app {

namespace {

/// Said on standard error, and in a box for whoever started the program from a menu.
int failVisibly(const Error& error)
{
    QMessageBox::critical(nullptr, "Lubberline", ui::messageOf(error));
    return fail(error);
}

/// The demonstration has a database of its own, so its window does too: this one makes room for it.
void startDemonstration(ui::MainWindow& window)
{
    const auto demonstration = openDemonstration({});
    if (!demonstration) {
        window.fail(ui::messageOf(demonstration.error()));
        return;
    }
    if (QProcess::startDetached(QCoreApplication::applicationFilePath(), {"--db", (*demonstration)->location()}))
        window.close();
    else
        window.fail(ui::translated(MARKED("app", "The window of the demonstration fleet could not be started.")));
}

/// Beside the program's own data; where that drive is full, too, in memory until the machine is switched off.
QStringList recoveryFiles()
{
    QStringList files;
    for (const auto place : {QStandardPaths::AppLocalDataLocation, QStandardPaths::RuntimeLocation, QStandardPaths::TempLocation})
        if (const QString folder = QStandardPaths::writableLocation(place); !folder.isEmpty())
            files += folder + QStringLiteral("/lubberline-recovery.jsonl");
    files.removeDuplicates();
    return files;
}

} // namespace

int openWindow(const Invocation& invocation)
{
    auto session = makeWindowSession(invocation.argc, invocation.argv);
    if (!session)
        return fail(session.error());
    auto stores = openStores(invocation.database, db::OpenMode::ReadWriteCreate);
    if (!stores)
        return failVisibly(stores.error());

    QSettings settings;
    ui::DesktopDialogs dialogs(settings);
    ui::MainWindow* opened = nullptr;
    const QString path = (*stores)->location();
    ui::MainWindow window(**stores,
        {dialogs, settings, [&opened] { startDemonstration(*opened); },
            [path](const QString& copy) -> Result<void> { // may run on a worker: a connection of its own
                auto database = db::openDatabase(path, db::OpenMode::ReadOnly);
                return database ? db::backup(*database, copy) : Result<void>(database.error());
            },
            recoveryFiles()});
    opened = &window;
    window.show();
    return (*session)->exec();
}

} // namespace lubberline::app
