#include "db/stores/Stores.h"

#include <utility>

#include "db/engine/Statement.h"
#include "db/schema/Schema.h"

namespace lubberline::db {

namespace {

/// Only counted: a profile of a damaged file may not read.
Result<bool> hasLimits(Stores& stores)
{
    const auto profiles = number(stores.database(), "SELECT COUNT(*) FROM limits_profile");
    return profiles ? Result<bool>(*profiles > 0) : profiles.error();
}

/// A database without any limits profile is new: it gets those whose source was read.
Result<void> addShippedLimits(Stores& stores)
{
    if (const auto there = hasLimits(stores); !there || *there || stores.readOnly())
        return noValue(there);
    auto transaction = stores.begin();
    if (!transaction)
        return transaction.error();
    if (const auto there = hasLimits(stores); !there || *there) // another first writer was faster
        return noValue(there);
    for (const auto& profile : shippedLimitsProfiles())
        if (const auto added = stores.sites.add(profile); !added)
            return added.error();
    return transaction->commit();
}

} // namespace

Stores::Stores(Database database)
    : m_database(std::move(database))
    , fleet(m_database)
    , swings(m_database)
    , signing(m_database)
    , jobs(m_database)
    , results(m_database)
    , sensors(m_database)
    , sites(m_database)
    , due(m_database)
    , electrical(m_database)
    , coilBenches(m_database)
    , keys(m_database)
{
}

Result<bool> Stores::changedElsewhere()
{
    Statement statement(m_database, "PRAGMA data_version"); // SQLite: another value when another connection has committed
    const auto version = firstOf<std::int64_t>(statement, [](Statement& row) { return row.integer(0); });
    if (!version)
        return version.error();
    const std::int64_t before = std::exchange(m_dataVersion, version->value_or(0));
    if (before == m_dataVersion)
        return false;
    // All that is stored leaves an entry in the trail or is a step of a guided swing. What is typed there and no step yet is no news: every
    // key of it would be.
    Statement newest(m_database, "SELECT (SELECT COALESCE(MAX(id), 0) FROM audit_entry), (SELECT COALESCE(MAX(id), 0) FROM job_event)");
    const auto stored = firstOf<Newest>(newest, [](Statement& row) { return Newest{row.integer(0), row.integer(1)}; });
    if (!stored)
        return stored.error();
    const Newest known = std::exchange(m_newest, stored->value_or(Newest()));
    return before != 0 && known != m_newest;
}

Result<std::unique_ptr<Stores>> Stores::openForWorker() const
{
    auto database = openDatabase(m_database.path(), m_database.readOnly() ? OpenMode::ReadOnly : OpenMode::ReadWriteCreate);
    if (!database)
        return database.error();
    database->setFault(m_database.fault());
    database->setClock(m_database.clock());
    return std::make_unique<Stores>(std::move(database.value()));
}

Result<std::unique_ptr<Stores>> openStores(const QString& path, OpenMode mode)
{
    auto database = openDatabase(path, mode);
    if (!database)
        return database.error();
    auto stores = std::make_unique<Stores>(std::move(database.value()));
    if (const auto added = addShippedLimits(*stores); !added)
        return added.error();
    if (!stores->readOnly())
        if (const auto done = refreshBehind(stores->database()); !done)
            return done.error();
    return stores;
}

} // namespace lubberline::db
