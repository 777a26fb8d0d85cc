#pragma once
/// One SQLite database file of ours: opened, checked to be ours, migrated, and set up to lose nothing
/// (WAL, synchronous=FULL, foreign keys). A Database belongs to the thread that opened it.

#include <QString>

#include <memory>
#include <string>
#include <vector>

#include "core/base/Clock.h"
#include "core/base/Result.h"
#include "db/engine/Faults.h"

class QSqlDatabase;

namespace lubberline::db {

enum class OpenMode {
    ReadWriteCreate, ///< a missing file is made; where file or folder may not be written it is opened for reading
    ReadOnly,        ///< a missing file is an error
};

/// A numbered step of the schema. It runs in one transaction together with the new user_version: whole or not at all.
struct Migration {
    int version = 0; ///< of the schema afterwards
    const char* description = "";
    std::vector<const char*> statements;
};

/// The database and what SQLite may keep beside it while it is open: files that nothing else may be written over.
[[nodiscard]] std::vector<std::string> filesOf(const QString& path);

class Changes;

/// For Transaction only.
struct TransactionState {
    int depth = 0;       ///< of transactions inside one another
    bool broken = false; ///< an inner one was not committed: the outer ones cannot be
};

class Database {
public:
    /// Errors, each naming the file: NotFound (missing, ReadOnly), Io (folder), Format (not a database of ours), Corrupt,
    /// NewerSchema (names both versions), Locked, ReadOnly (needs migrating but may not be written), Full.
    /// `steps`: those of the schema (db/schema), or others in tests of failing migrations.
    static Result<Database> open(const QString& path, OpenMode mode, const std::vector<Migration>& steps);

    Database(Database&&) noexcept;
    Database& operator=(Database&&) noexcept;
    ~Database();

    [[nodiscard]] QString path() const;
    [[nodiscard]] bool readOnly() const;
    /// From now on nothing is written through this connection.
    Result<void> onlyRead();
    /// Told of what stores change here.
    [[nodiscard]] Changes& changes() const;
    /// For tests; what is opened of this one for a worker has the same.
    void setFault(Fault fault);
    [[nodiscard]] const Fault& fault() const;
    /// Of what is stored with a time; the machine's, unless a test gives another. What is opened of this one for a worker has the same.
    void setClock(Clock clock);
    [[nodiscard]] const Clock& clock() const;
    /// For the other sources of db only.
    [[nodiscard]] QSqlDatabase connection() const;
    [[nodiscard]] TransactionState& transactionState();

private:
    struct State;
    explicit Database(std::unique_ptr<State> state);
    Result<void> connectToOurs(int newest);
    std::unique_ptr<State> m_state;
};

} // namespace lubberline::db
