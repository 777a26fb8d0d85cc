#include "app/Window.h"

#include <QFileInfo>
#include <QMessageBox>
#include <QSettings>
#include <QStandardPaths>

#include <unistd.h>

#include "app/Console.h"
#include "app/Demonstration.h"
#include "app/OpenStores.h"
#include "app/Paths.h"
#include "app/QtSession.h"
#include "app/commands/Command.h"
#include "db/engine/HeldFile.h"
#include "db/schema/Schema.h"
#include "db/transfer/Maintenance.h"
#include "ui/text/Language.h"
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

/// Beside the program's own data; where that drive is full, too, in memory until the machine is switched off.
QStringList recoveryFiles()
{
    QStringList files;
    const QString name = QStringLiteral("/lubberline-recovery.jsonl");
    for (const auto place : {QStandardPaths::AppLocalDataLocation, QStandardPaths::RuntimeLocation})
        if (const QString folder = QStandardPaths::writableLocation(place); !folder.isEmpty())
            files += folder + name;
    // Everybody writes into that folder: a folder of one's own in it.
    files += QStandardPaths::writableLocation(QStandardPaths::TempLocation) + QStringLiteral("/lubberline-%1").arg(::geteuid()) + name;
    files.removeDuplicates();
    return files;
}

/// "fleet before 2026-11-27 142233.lubberline", beside the database.
QString asideOf(const QString& path)
{
    constexpr int kToTheSecond = 19;
    const QFileInfo file(path);
    const QString now = nowUtc().left(kToTheSecond).replace(u'T', u' ').remove(u':');
    return QStringLiteral("%1/%2 before %3.%4").arg(file.absolutePath(), file.completeBaseName(), now, file.suffix());
}

/// One window after another, each on a database of its own: another is opened before the window before it goes, and where that cannot be
/// done it stays.
class Windows {
public:
    explicit Windows(std::unique_ptr<db::Stores> stores) : m_stores(std::move(stores)) {}

    int run(QApplication& session)
    {
        for (;;) {
            const int status = show(session);
            if (!m_again)
                return status;
            if (auto moved = moveOn(); !moved)
                return failVisibly(moved.error());
        }
    }

private:
    int show(QApplication& session)
    {
        m_again = false;
        m_restored.clear();
        QSettings settings;
        ui::speak(ui::wantedLanguages(settings.value("view/language").toString()));
        const db::HeldFile held(m_stores->location());
        ui::DesktopDialogs dialogs(settings);
        ui::MainWindow window(*m_stores, services(dialogs, settings));
        m_window = &window;
        window.show();
        const int status = session.exec();
        m_window = nullptr;
        return status;
    }

    ui::WindowServices services(ui::DesktopDialogs& dialogs, QSettings& settings)
    {
        const QString path = m_stores->location();
        ui::WindowServices services{dialogs, settings,
            [this] {
                if (const auto opened = goTo(openDemonstration({})); !opened)
                    m_window->fail(ui::messageOf(opened.error()));
            },
            [path](const QString& copy) -> Result<void> { // may run on a worker: a connection of its own
                auto database = db::openDatabase(path, db::OpenMode::ReadOnly);
                return database ? db::backup(*database, copy) : Result<void>(database.error());
            },
            recoveryFiles()};
        services.openDatabase = [this](const QString& wanted, bool make) -> Result<void> {
            if (!make && !QFileInfo::exists(wanted))
                return Error{
                    ErrorCode::NotFound, MARKED("app", "there is no such database; expected the name of one"), wanted.toStdString()};
            return goTo(openStores(wanted.toStdString(), db::OpenMode::ReadWriteCreate));
        };
        services.restore = [this](const QString& backup) -> Result<void> {
            const auto readable = db::openDatabase(backup, db::OpenMode::ReadOnly);
            if (!readable && readable.error().code != ErrorCode::ReadOnly) // an older one is brought up to date
                return readable.error();
            m_restored = backup;
            return close();
        };
        services.reopen = [this] { static_cast<void>(close()); };
        const auto demonstration = demonstrationPath({});
        services.demonstration = demonstration && QFileInfo(*demonstration) == QFileInfo(path);
        return services;
    }

    /// Errors: those of opening it; then this window stays.
    Result<void> goTo(Result<std::unique_ptr<db::Stores>> next)
    {
        if (!next)
            return next.error();
        m_next = std::move(next.value());
        return close();
    }

    Result<void> close()
    {
        m_again = m_window->close();
        if (!m_again)
            m_next.reset();
        return {};
    }

    /// The window is gone: what its database was is closed first.
    Result<void> moveOn()
    {
        const QString path = m_stores->location();
        if (m_next) {
            m_stores = std::move(m_next);
            return {};
        }
        m_stores.reset();
        auto restored = m_restored.isEmpty() ? Result<void>() : db::restore(m_restored, path, asideOf(path));
        auto again = openStores(path.toStdString(), db::OpenMode::ReadWriteCreate);
        if (!again)
            return again.error();
        m_stores = std::move(again.value());
        if (!restored) // the database is as it was
            QMessageBox::critical(nullptr, "Lubberline", ui::messageOf(restored.error()));
        return {};
    }

    std::unique_ptr<db::Stores> m_stores, m_next;
    ui::MainWindow* m_window = nullptr;
    QString m_restored;
    bool m_again = false;
};

} // namespace

int openWindow(const Invocation& invocation)
{
    auto session = makeWindowSession(invocation.argc, invocation.argv);
    if (!session)
        return fail(session.error());
    auto stores = openStores(invocation.database, db::OpenMode::ReadWriteCreate);
    if (!stores)
        return failVisibly(stores.error());

    return Windows(std::move(stores.value())).run(**session);
}

} // namespace lubberline::app
