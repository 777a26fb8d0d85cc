#include "db/engine/Copy.h"

#include <QFile>
#include <QFileInfo>

#include <fcntl.h>
#include <unistd.h>

#include "core/base/OutputFile.h"
#include "core/base/PartialFile.h"
#include "db/engine/Statement.h"

namespace lubberline::db {

namespace {

constexpr auto kForOthers = QFile::ReadGroup | QFile::WriteGroup | QFile::ExeGroup | QFile::ReadOther | QFile::WriteOther | QFile::ExeOther;

void keepFolder(const QString& folder)
{
    const int handle = ::open(QFile::encodeName(folder).constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (handle < 0)
        return;
    ::fsync(handle);
    ::close(handle);
}

Error ofFile(Error error, const std::string& file)
{
    error.file = file;
    return error;
}

} // namespace

/// A connection for reading only refuses to write into the copy, too, so it is let write for this.
Result<void> copyInto(const Database& database, const QString& path)
{
    if (const auto allowed = execute(database, "PRAGMA query_only = OFF"); !allowed)
        return allowed;
    Statement statement(database, "VACUUM INTO ?");
    statement << path.toStdString();
    const auto copied = statement.run();
    const auto restored = database.readOnly() ? execute(database, "PRAGMA query_only = ON") : Result<void>();
    return copied ? restored : copied;
}

Result<void> copyTo(const Database& database, const QString& path)
{
    const std::string file = path.toStdString();
    if (QFileInfo::exists(path))
        return Error{ErrorCode::Conflict, MARKED("db", "there is a file of this name already; expected a new name for the backup"), file};
    if (auto allowed = checkOutput(file); !allowed)
        return allowed;
    const QString folder = QFileInfo(path).absolutePath();
    const Error unwritten{
        ErrorCode::Io, MARKED("db", "the backup could not be written to its place; expected a folder that may be written"), file};
    PartialFile partial(folder.toStdString());
    if (!partial.isOpen())
        return unwritten;
    if (const auto copied = copyInto(database, QString::fromStdString(partial.name())); !copied)
        return ofFile(copied.error(), file);
    if (const auto rights = QFile::permissions(database.path()); !(rights & kForOthers))
        QFile::setPermissions(QString::fromStdString(partial.name()), rights & ~kForOthers); // what nobody else may read stays so
    // SQLite does not wait for a copy to reach the drive (sqlite.org/lang_vacuum.html); a backup that a power cut empties is none.
    if (!partial.finish() || !partial.renameTo(file))
        return unwritten;
    keepFolder(folder);
    return {};
}

} // namespace lubberline::db
