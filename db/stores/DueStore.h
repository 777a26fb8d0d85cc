#pragma once
/// Due rules, waivers, and what the rules look at.

#include <vector>

#include "core/record/DueRule.h"
#include "core/record/FleetRows.h"
#include "db/engine/Database.h"

namespace lubberline::db {

class DueStore {
public:
    explicit DueStore(Database& database) : m_database(database) {}

    Result<std::vector<DueRule>> rules(); ///< by name
    /// A record id is made when empty. Errors: Conflict when another has the name; InvalidInput when that is empty.
    Result<RecordId> add(const DueRule& rule);
    /// @param known as the caller knows it. Errors: also NotFound; Conflict when it is another by now.
    Result<void> change(const DueRule& known, const DueRule& rule);
    Result<void> removeRule(const RecordId& record); ///< Errors: NotFound

    Result<std::vector<Waiver>> waiversOf(AircraftId aircraft); ///< newest first
    /// Errors: NotFound (its event), InvalidInput (no reason, nobody answers), Conflict (a waiver is not changed).
    Result<void> add(const Waiver& waiver);

    /// Every compass system, by type, registration and name. The newest signed swings are hashed (SwingMarks.h): a large fleet's on a worker.
    Result<std::vector<DueCompass>> compasses();

private:
    void noteDue();
    Database& m_database;
};

} // namespace lubberline::db
