#include "db/engine/HeldFile.h"

#include <QFile>

#include <fcntl.h>

namespace lubberline::db {

namespace {

#ifdef F_OFD_SETLK

// SQLite's file format, "File Locking": while a connection in WAL mode is open it reads these.
constexpr off_t kSharedFirst = 0x40000002, kSharedSize = 510; ///< of the database
constexpr off_t kDeadManSwitch = 128;                         ///< of the shared memory: who finds it free begins it anew

void lock(int file, short type, off_t first, off_t size)
{
    if (file < 0)
        return;
    struct flock range {};
    range.l_type = type;
    range.l_whence = SEEK_SET;
    range.l_start = first;
    range.l_len = size;
    static_cast<void>(::fcntl(file, F_OFD_SETLK, &range)); // where it cannot be had, all is as without it
}

int opened(const QString& path) { return ::open(QFile::encodeName(path).constData(), O_RDONLY | O_CLOEXEC); }

#endif

} // namespace

#ifdef F_OFD_SETLK

HeldFile::HeldFile(const QString& database)
{
    m_shared = opened(database + QStringLiteral("-shm"));
    if (m_shared < 0)
        return;
    m_main = opened(database);
    lock(m_shared, F_RDLCK, kDeadManSwitch, 1);
    lock(m_main, F_RDLCK, kSharedFirst, kSharedSize);
}

/// The files stay open until the process ends: to close them would take SQLite's own locks with them.
HeldFile::~HeldFile()
{
    lock(m_main, F_UNLCK, kSharedFirst, kSharedSize);
    lock(m_shared, F_UNLCK, kDeadManSwitch, 1);
}

#else

HeldFile::HeldFile(const QString&) {}
HeldFile::~HeldFile() = default;

#endif

} // namespace lubberline::db
