#include "db/engine/Transaction.h"

#include <utility>

#include "db/engine/Changes.h"
#include "db/engine/Statement.h"

namespace lubberline::db {

Result<Transaction> Transaction::begin(Database& database) { return beginWith(database, true); }

Result<Transaction> Transaction::beginReading(Database& database) { return beginWith(database, false); }

Result<Transaction> Transaction::beginWith(Database& database, bool writing)
{
    TransactionState& state = database.transactionState();
    if (state.depth == 0)
        if (const auto begun = execute(database, writing ? "BEGIN IMMEDIATE" : "BEGIN"); !begun)
            return begun.error();
    ++state.depth;
    return Transaction(database, writing);
}

Transaction::Transaction(Transaction&& other) noexcept : m_database(std::exchange(other.m_database, nullptr)), m_writing(other.m_writing) {}

Result<void> Transaction::commit()
{
    LUBBERLINE_EXPECT(m_database, "a transaction is committed once");
    TransactionState& state = m_database->transactionState();
    if (state.broken)
        return Error{
            ErrorCode::Conflict, MARKED("db", "a part of the change failed; nothing was stored"), m_database->path().toStdString()};
    if (state.depth == 1)
        if (const auto done = execute(*m_database, "COMMIT"); !done)
            return done; // the destructor rolls back
    Database& database = *std::exchange(m_database, nullptr);
    if (--state.depth == 0)
        database.changes().ended(true);
    return {};
}

Transaction::~Transaction()
{
    if (!m_database)
        return;
    TransactionState& state = m_database->transactionState();
    state.broken = state.broken || m_writing;
    if (--state.depth > 0)
        return; // the outermost rolls back, so that nothing is stored piecemeal in between
    state.broken = false;
    (void)execute(*m_database, "ROLLBACK"); // after some errors (a full drive) SQLite has rolled back already
    m_database->changes().ended(false);
}

} // namespace lubberline::db
