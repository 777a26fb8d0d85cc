#pragma once
/// A database and its stores: what the window and the commands work with. It belongs to the thread that opened it.
/// Every writing call is one transaction: when it returns ok, the change is on disk, and whoever follows Changes has been told.
/// Several calls are made one by a Transaction around them. Calls take well under 100 ms; long work (import, export) is done on a
/// worker with openForWorker().

#include <cstdint>
#include <memory>
#include <utility>

#include "db/engine/Changes.h"
#include "db/engine/Database.h"
#include "db/engine/Transaction.h"
#include "db/stores/CoilStore.h"
#include "db/stores/DueStore.h"
#include "db/stores/ElectricalStore.h"
#include "db/stores/FleetStore.h"
#include "db/stores/JobStore.h"
#include "db/stores/KeyStore.h"
#include "db/stores/ResultStore.h"
#include "db/stores/SensorStore.h"
#include "db/stores/SigningStore.h"
#include "db/stores/SiteStore.h"
#include "db/stores/SwingStore.h"

namespace lubberline::db {

class Stores {
public:
    explicit Stores(Database database);
    Stores(const Stores&) = delete;
    Stores& operator=(const Stores&) = delete;

    [[nodiscard]] Database& database() { return m_database; }
    [[nodiscard]] Changes& changes() const { return m_database.changes(); }
    [[nodiscard]] QString location() const { return m_database.path(); } ///< for the status bar
    [[nodiscard]] bool readOnly() const { return m_database.readOnly(); }
    [[nodiscard]] const Clock& clock() const { return m_database.clock(); } ///< for all who work with these stores
    [[nodiscard]] Result<Transaction> begin() { return Transaction::begin(m_database); }

    /// Whether another connection (another window, a command) has stored something since this was asked last; figures that are being typed
    /// over there are not.
    Result<bool> changedElsewhere();

    /// A connection of its own to the same database, to be made, used and destroyed on one worker thread. Nobody is told of what it
    /// stores: the caller calls Changes::announceFleet() on the window's stores when the worker is done.
    [[nodiscard]] Result<std::unique_ptr<Stores>> openForWorker() const;

private:
    Database m_database;
    using Newest = std::pair<std::int64_t, std::int64_t>; ///< entry of the trail, step of a guided swing
    std::int64_t m_dataVersion = 0;                       ///< when it was asked last; 0: never
    Newest m_newest;

public:
    FleetStore fleet;
    SwingStore swings;
    SigningStore signing;
    JobStore jobs;
    ResultStore results;
    SensorStore sensors;
    SiteStore sites;
    DueStore due;
    ElectricalStore electrical;
    CoilStore coilBenches;
    KeyStore keys;
};

/// Opens a database; a new one gets the shipped limits profiles. Errors: those of Database::open().
Result<std::unique_ptr<Stores>> openStores(const QString& path, OpenMode mode);

} // namespace lubberline::db
