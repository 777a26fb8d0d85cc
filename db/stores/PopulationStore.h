#pragma once
/// The swings of a selection as columns, for statistics over years: constant work a reading, no records.

#include "core/base/Progress.h"
#include "core/fleet/FleetSelection.h"
#include "core/fleet/FleetSwings.h"
#include "db/engine/Database.h"

namespace lubberline::db {

class PopulationStore {
public:
    explicit PopulationStore(Database& database) : m_database(database) {}

    /// In order (putInOrder), as the database is at one moment, whatever others write meanwhile. Drafts, swings that a later revision
    /// amends and those without a date are left out and counted (SwingsLeftOut: "draft", "superseded", "no date"); so are readings that are
    /// excluded or not complete, without being counted.
    /// `most` > 0: only so many swings, spread over the whole selection, for a first look.
    /// Errors: NotFound (a name that the database does not know), Cancelled.
    Result<FleetSwings> columns(const FleetSelection& selection, const Progress& progress = {}, int most = 0);

private:
    Database& m_database;
};

} // namespace lubberline::db
