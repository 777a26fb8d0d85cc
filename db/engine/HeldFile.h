#pragma once
/// A database that is open for long keeps its locks whatever else the process does with the file.

#include <QString>

namespace lubberline::db {

/// SQLite's locks on a file are those of POSIX: they are the process's, and gone as soon as it closes the file after opening it by any other
/// way. A dialog for files does that to every file of a folder, to tell its icon. Another program would then take itself for the only one,
/// and remove the log that this one still writes to. While this object lives, the locks that say "somebody has it open" are held a
/// second time, by a description of the file that nothing else closes. Only of a database in WAL mode; elsewhere than on Linux nothing.
class HeldFile {
public:
    explicit HeldFile(const QString& database);
    ~HeldFile();
    HeldFile(const HeldFile&) = delete;
    HeldFile& operator=(const HeldFile&) = delete;

private:
    int m_main = -1, m_shared = -1; ///< of the database and of its shared memory
};

} // namespace lubberline::db
