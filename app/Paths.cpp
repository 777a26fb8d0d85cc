#include "app/Paths.h"

#include <QDir>
#include <QStandardPaths>

#include "core/base/Clock.h"
#include "core/base/WholeFile.h"

namespace lubberline::app {

namespace {

Result<QString> inDataFolder(const QString& name)
{
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) + "/lubberline";
    if (!QDir().mkpath(folder))
        return Error{ErrorCode::Io, MARKED("app", "the data folder cannot be made; name a database with --db FILE"), folder.toStdString()};
    return folder + "/" + name;
}

Result<QString> named(const std::string& option)
{
    if (option.starts_with("postgresql:"))
        return Error{ErrorCode::Unsupported, MARKED("app", "PostgreSQL databases are not supported yet; expected an SQLite file"), option};
    if (isStandardStream(option))
        return Error{ErrorCode::Unsupported, MARKED("app", "a database is no stream; expected the name of an SQLite file"), option};
    return QString::fromStdString(option);
}

} // namespace

Result<QString> databasePath(const std::string& option)
{
    if (!option.empty())
        return named(option);
    if (const QString environment = qEnvironmentVariable("LUBBERLINE_DB"); !environment.isEmpty())
        return named(environment.toStdString());
    return inDataFolder("fleet.lubberline");
}

Result<QString> demonstrationPath(const std::string& option)
{
    return option.empty() ? inDataFolder("demonstration.lubberline") : named(option);
}

QString nowUtc() { return QString::fromStdString(machineClock().nowUtc()); }
Date today() { return machineClock().today(); }

} // namespace lubberline::app
