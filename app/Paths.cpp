#include "app/Paths.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

#include <sys/stat.h>
#include <unistd.h>

#include "core/base/Clock.h"
#include "core/base/FileText.h"
#include "core/base/WholeFile.h"
#include "db/engine/Database.h"

namespace lubberline::app {

namespace {

QString dataFolder() { return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) + "/lubberline"; }

/// Who swung what, and who signed it, is nobody else's to read.
bool keepFolderPrivate(const QString& folder)
{
    struct stat state = {};
    const QByteArray name = QFile::encodeName(folder);
    if (::stat(name.constData(), &state) != 0)
        return false;
    const bool isOthers = state.st_uid != ::geteuid(); // an administrator's to decide
    return isOthers || (state.st_mode & 0777) == 0700 || ::chmod(name.constData(), 0700) == 0;
}

Result<QString> inDataFolder(const QString& name)
{
    const QString folder = dataFolder();
    if (!QDir().mkpath(folder) || !keepFolderPrivate(folder))
        return Error{ErrorCode::Io, MARKED("app", "the data folder cannot be made; name a database with --db FILE"), folder.toStdString()};
    return folder + "/" + name;
}

Result<QString> named(const std::string& option)
{
    if (option.starts_with("postgresql:"))
        return Error{ErrorCode::Unsupported, MARKED("app", "PostgreSQL databases are not supported yet; expected an SQLite file"), option};
    if (isStandardStream(option))
        return Error{ErrorCode::Unsupported, MARKED("app", "a database is no stream; expected the name of an SQLite file"), option};
    if (!isUtf8(option)) // Qt would make another name of it
        return Error{ErrorCode::InvalidInput, MARKED("app", "the name of the database is not UTF-8; expected one that is"), option};
    return plainName(option);
}

} // namespace

Result<QString> databasePath(const std::string& option)
{
    if (!option.empty())
        return named(option);
    if (const QByteArray environment = qgetenv("LUBBERLINE_DB"); !environment.isEmpty())
        return named(environment.toStdString());
    return inDataFolder("fleet.lubberline");
}

Result<QString> demonstrationPath(const std::string& option)
{
    return option.empty() ? inDataFolder("demonstration.lubberline") : named(option);
}

void keepPrivate(const QString& database)
{
    if (QFileInfo(database).absolutePath() != dataFolder())
        return;
    constexpr mode_t kForOthers = 077;
    struct stat state = {};
    for (const std::string& file : db::filesOf(database))
        if (::stat(file.c_str(), &state) == 0 && state.st_uid == ::geteuid() && (state.st_mode & kForOthers) != 0)
            (void)::chmod(file.c_str(), state.st_mode & 0700);
}

QString plainName(const std::string& path)
{
    const QString name = QString::fromStdString(path);
    return name.startsWith(':') ? "./" + name : name;
}

QString nowUtc() { return QString::fromStdString(machineClock().nowUtc()); }
Date today() { return machineClock().today(); }

} // namespace lubberline::app
