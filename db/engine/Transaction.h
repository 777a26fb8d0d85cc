#pragma once

#include "db/engine/Database.h"

namespace lubberline::db {

/// All or nothing: what is not committed when it goes out of scope is rolled back. One inside another joins it; when an inner
/// one is not committed, the outer one cannot be either.
class Transaction {
public:
    /// For writing. BEGIN IMMEDIATE: a second writer waits here, not in the middle of its work.
    static Result<Transaction> begin(Database& database);
    /// For reading with several statements: all see the same state, whatever others write meanwhile. Needs no commit.
    static Result<Transaction> beginReading(Database& database);

    Result<void> commit();

    Transaction(Transaction&& other) noexcept;
    Transaction& operator=(Transaction&&) = delete;
    ~Transaction();

private:
    static Result<Transaction> beginWith(Database& database, bool writing);
    Transaction(Database& database, bool writing) : m_database(&database), m_writing(writing) {}
    Database* m_database;
    bool m_writing;
};

} // namespace lubberline::db
