#include "db/Transaction.h"

#include <utility>

#include "db/Statement.h"

namespace lubberline::db {

Result<Transaction> Transaction::begin(Database& database)
{
    if (database.transactionDepth() == 0)
        if (const auto begun = execute(database, "BEGIN IMMEDIATE"); !begun)
            return begun.error();
    ++database.transactionDepth();
    return Transaction(database);
}

Transaction::Transaction(Transaction&& other) noexcept
    : m_database(std::exchange(other.m_database, nullptr))
{
}

Result<void> Transaction::commit()
{
    if (m_database->transactionDepth() == 1)
        if (const auto done = execute(*m_database, "COMMIT"); !done)
            return done; // the destructor rolls back
    --m_database->transactionDepth();
    m_database = nullptr;
    return {};
}

Transaction::~Transaction()
{
    if (!m_database)
        return;
    // An inner one that failed must take the outer one with it: its commit then fails with "no transaction is active".
    if (m_database->transactionDepth() > 0)
        (void)execute(*m_database, "ROLLBACK");
    --m_database->transactionDepth();
}

} // namespace lubberline::db
