#pragma once
/// The sensor models of compasses.

#include <string>
#include <vector>

#include "core/record/SensorRecord.h"
#include "db/engine/Database.h"

namespace lubberline::db {

class SensorStore {
public:
    explicit SensorStore(Database& database) : m_database(database) {}

    /// Errors: Corrupt (a model that does not read: names it and its compass).
    Result<std::vector<SensorRecord>> of(CompassId compass); ///< newest first
    Result<SensorRecord> sensor(SensorModelId id);
    /// What is wrong with stored models, one line each: for verify().
    Result<std::vector<Message>> faults();

    /// As FleetStore::add() and change(). Errors: also InvalidInput (a figure of the model that is not finite; a bench that
    /// checkBench() refuses).
    Result<SensorModelId> add(const SensorRecord& sensor);
    Result<void> change(const SensorRecord& known, const SensorRecord& sensor);
    /// What is removed stays readable in the audit trail. Errors: NotFound.
    Result<void> remove(SensorModelId id);

private:
    Database& m_database;
};

} // namespace lubberline::db
