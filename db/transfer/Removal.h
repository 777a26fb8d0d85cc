#pragma once
/// A type, an aircraft or a compass taken out of the database with all that belongs to it, and put back as it was.

#include <QVariant>

#include <string>
#include <vector>

#include "core/record/Id.h"
#include "db/engine/Database.h"

namespace lubberline::db {

/// What was taken out: rows as they were, those that others refer to last. In memory only.
class Removed {
public:
    [[nodiscard]] bool empty() const { return m_rows.empty(); }

private:
    friend class Removal;
    struct Row {
        QString table;
        std::vector<QString> columns;
        std::vector<QVariant> values;
    };
    std::vector<Row> m_rows;
};

class Removal {
public:
    explicit Removal(Database& database) : m_database(database) {}

    /// With its aircraft, compasses, events, sensor models, electrical swings and draft swings; what each said stays readable in the
    /// audit trail. Errors: NotFound; Frozen while a swing in it is signed or complete, or a waiver is signed.
    Result<Removed> remove(AircraftTypeId id);
    Result<Removed> remove(AircraftId id);
    Result<Removed> remove(CompassId id);
    /// Ids and all. Errors: Conflict when a record has taken a name or an id of it since.
    Result<void> putBack(const Removed& removed);

private:
    Result<Removed> take(const QString& table, std::int64_t id);
    Result<void> collect(Removed& removed, const QString& table, std::int64_t id);
    Result<void> collectChildren(Removed& removed, const QString& table, std::int64_t id);
    void note();
    Database& m_database;
};

} // namespace lubberline::db
