#pragma once
/// Private to db: the tables of records, for what looks at all of them.

#include <vector>

#include "db/saving/Saving.h"

namespace lubberline::db {

[[nodiscard]] const Table& typeTable();
[[nodiscard]] const Table& aircraftTable();
[[nodiscard]] const Table& compassTable();
[[nodiscard]] const Table& eventTable();
[[nodiscard]] const Table& swingTable();
[[nodiscard]] const Table& siteTable();
[[nodiscard]] const Table& limitsTable();
[[nodiscard]] const Table& instrumentTable();
[[nodiscard]] const Table& sensorTable();
[[nodiscard]] const Table& electricalTable();
[[nodiscard]] const Table& coilTable();
[[nodiscard]] const Table& ruleTable();
[[nodiscard]] const Table& waiverTable();

/// Every row of every table, read as its store reads it: what is wrong with them, each once with table, row and column.
[[nodiscard]] std::vector<Message> damagedRows(Database& database);

/// Of them what the lists of swings show: types, aircraft, compasses, kept results.
[[nodiscard]] std::vector<Message> damagedLists(Database& database);

} // namespace lubberline::db
