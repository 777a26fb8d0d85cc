#include "db/stores/KeyStore.h"

#include <algorithm>

#include "db/engine/Changes.h"
#include "db/engine/Statement.h"
#include "db/engine/Transaction.h"
#include "db/saving/Audit.h"

namespace lubberline::db {

bool isFingerprint(const std::string& text)
{
    return (text.size() == 40 || text.size() == 64) && text.find_first_not_of("0123456789ABCDEF") == std::string::npos;
}

Result<std::vector<StationKey>> KeyStore::all()
{
    Statement statement(m_database, "SELECT fingerprint, holder, public_key, added_utc, id FROM signing_key ORDER BY holder, fingerprint");
    return rowsOf<StationKey>(statement, [](Statement& row) { return StationKey{row.text(0), row.text(1), row.longText(2), row.text(3)}; });
}

Result<void> KeyStore::put(StationKey key)
{
    if (!isFingerprint(key.fingerprint))
        return Error{ErrorCode::InvalidInput,
            {MARKED("db", "'%1' is no fingerprint; expected 40 or 64 capital hexadecimal digits"), key.fingerprint}};
    if (key.holder.find_first_not_of(' ') == std::string::npos)
        return Error{ErrorCode::InvalidInput, MARKED("db", "the name is empty; expected whose key it is, as he signs")};
    auto transaction = Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    const auto known = all();
    if (!known)
        return known.error();
    const auto before
        = std::find_if(known->begin(), known->end(), [&](const StationKey& one) { return one.fingerprint == key.fingerprint; });
    if (before != known->end() && before->holder != key.holder)
        return Error{ErrorCode::Conflict,
            {MARKED("db", "this key is known as that of %1; expected it to be removed first"), before->holder},
            m_database.path().toStdString()};
    key.addedUtc = m_database.clock().nowUtc();
    Statement statement(m_database,
        "INSERT INTO signing_key (fingerprint, holder, public_key, added_utc) VALUES (?, ?, ?, ?)"
        " ON CONFLICT (fingerprint) DO UPDATE SET public_key = excluded.public_key");
    statement << key.fingerprint << key.holder << key.publicKey << key.addedUtc;
    if (const auto kept = statement.run(); !kept)
        return kept;
    if (const auto kept = audit(m_database, before == known->end() ? "added key" : "renewed key", key.fingerprint, "holder: " + key.holder);
        !kept)
        return kept;
    m_database.changes().note(change::Due{}); // what signatures are worth may be other
    return transaction->commit();
}

Result<StationKey> KeyStore::remove(const std::string& fingerprint)
{
    auto transaction = Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    const auto known = all();
    if (!known)
        return known.error();
    constexpr std::size_t kLeast = 8;
    std::vector<StationKey> found;
    for (const StationKey& one : *known)
        if (fingerprint.size() >= kLeast && one.fingerprint.ends_with(fingerprint))
            found.push_back(one);
    const std::string file = m_database.path().toStdString();
    if (found.empty())
        return Error{ErrorCode::NotFound,
            {MARKED("db", "no key of the station ends in %1; expected eight digits or more of one"), fingerprint}, file};
    if (found.size() > 1)
        return Error{ErrorCode::Conflict, {MARKED("db", "several keys end in %1; expected more of it"), fingerprint}, file};
    Statement statement(m_database, "DELETE FROM signing_key WHERE fingerprint = ?");
    statement << found.front().fingerprint;
    if (const auto done = statement.run(); !done)
        return done.error();
    if (const auto kept = audit(m_database, "removed key", found.front().fingerprint, "holder: " + found.front().holder); !kept)
        return kept.error();
    m_database.changes().note(change::Due{});
    if (const auto committed = transaction->commit(); !committed)
        return committed.error();
    return found.front();
}

} // namespace lubberline::db
