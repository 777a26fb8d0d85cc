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
    ReadOnly,        ///< a missing file is an error; one of an old schema is read as a copy that was brought up to date, and stays as it is
};

class Database;

/// A numbered step of the schema. It runs in one transaction together with the new user_version: whole or not at all.
struct Migration {
    int version = 0; ///< of the schema afterwards
    const char* description = "";
    std::vector<const char*> statements;
    Result<void> (*work)(const Database& database) = nullptr; ///< what statements cannot say, after them
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
    /// NewerSchema (names both versions), Locked, ReadOnly (of an old schema, and no copy of it could be made), Full.
    /// Before a file is brought up to date a copy of it as it was is made beside it: told() says where.
    /// `steps`: those of the schema (db/schema), or others in tests of failing migrations.
    static Result<Database> open(const QString& path, OpenMode mode, const std::vector<Migration>& steps);

    Database(Database&&) noexcept;
    Database& operator=(Database&&) noexcept;
    ~Database();

    /// A file of ours in whatever schema it has, for reading it as a whole: no store understands it. Errors: those of open().
    static Result<Database> openAsItIs(const QString& path);

    [[nodiscard]] QString path() const;
    /// What who opened it should know: that it was brought up to date, and where a copy as it was stands.
    [[nodiscard]] const std::vector<Message>& told() const;
    [[nodiscard]] int fileSchema() const;  ///< of the file, before anything was done to it; of a new one 0
    [[nodiscard]] bool readAsCopy() const; ///< of an old schema: what is read is a copy
    [[nodiscard]] bool readOnly() const;
    /// How long a statement waits for the writer of another connection before it answers Locked (2 s, unless it is said otherwise).
    Result<void> setPatience(int milliseconds);
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
    static std::unique_ptr<State> stateFor(const QString& path, OpenMode mode);
    static Result<Database> openCopy(const QString& path, const Database& original, const std::vector<Migration>& steps);
    Result<void> connectToOurs(int newest);
    Result<void> connectAndConfigure(int newest);
    Result<void> bringUpToDate(const std::vector<Migration>& steps);
    std::unique_ptr<State> m_state;
};

} // namespace lubberline::db
