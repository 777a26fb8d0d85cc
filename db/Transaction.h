#pragma once

#include "db/Database.h"

namespace lubberline::db {

/// All or nothing: what is not committed when it goes out of scope is rolled back. One inside another joins it.
/// BEGIN IMMEDIATE: a second writer waits here, not in the middle of its work.
class Transaction {
public:
    static Result<Transaction> begin(Database& database);
    Result<void> commit();

    Transaction(Transaction&& other) noexcept;
    Transaction& operator=(Transaction&&) = delete;
    ~Transaction();

private:
    explicit Transaction(Database& database) : m_database(&database) {}
    Database* m_database;
};

} // namespace lubberline::db
