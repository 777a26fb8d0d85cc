#include "db/engine/WorkFolder.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace lubberline::db {

namespace {

const QString kName = "lubberline-work-", kLock = "in-use";

/// Ours, and nobody holds its lock. A folder that has none yet is being made.
void removeIfLeft(const QString& folder)
{
    const QByteArray lock = QFile::encodeName(folder + "/" + kLock);
    const int handle = ::open(lock.constData(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (handle < 0)
        return;
    struct stat state = {};
    const bool left = ::fstat(handle, &state) == 0 && state.st_uid == ::geteuid() && ::flock(handle, LOCK_EX | LOCK_NB) == 0;
    if (left)
        QDir(folder).removeRecursively();
    ::close(handle);
}

} // namespace

WorkFolder::WorkFolder() : m_folder(QDir::tempPath() + "/" + kName + "XXXXXX")
{
    const QDir temporary(QDir::tempPath());
    for (const QFileInfo& other : temporary.entryInfoList({kName + "*"}, QDir::Dirs | QDir::NoSymLinks | QDir::NoDotAndDotDot))
        if (other.filePath() != m_folder.path())
            removeIfLeft(other.filePath());
    const QByteArray lock = QFile::encodeName(m_folder.filePath(kLock));
    m_lock = ::open(lock.constData(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (m_lock >= 0)
        ::flock(m_lock, LOCK_EX | LOCK_NB);
}

WorkFolder::~WorkFolder()
{
    if (m_lock >= 0)
        ::close(m_lock);
}

} // namespace lubberline::db
