#pragma once
/// Whether a swing counts as signed: one rule for pages, lists, paper, commands and what is due.

#include <map>
#include <vector>

#include "core/record/FleetRows.h"
#include "db/engine/Database.h"

namespace lubberline::db {

enum class SignedMark {
    No,           ///< a draft, or complete
    ByStateAlone, ///< the record says signed, and no signatures stand over what it says now: it counts as not signed
    NotChecked,   ///< signatures are there; whether they stand was not looked at
    Stands,
};

/// SigningStore::stands() over what is stored now: hashes and audit trail. Keys are asked by the swing's own page and paper, which run
/// gpg. A swing that cannot be read stands for nothing: `db verify` names what is wrong with it.
[[nodiscard]] SignedMark signedMark(Database& database, SwingId swing, SwingState state);

/// Of the lines of a list, in their order. Hashing takes its time by the readings: of a long list the first ones are checked, as many as
/// the window's thread has time for; of the others no more than that somebody has signed.
Result<std::vector<SignedMark>> signedMarks(Database& database, const std::vector<SwingRow>& rows);

/// signedMark() is Stands, each swing looked at once: for work that comes back to the same ones.
class StandingSwings {
public:
    explicit StandingSwings(Database& database) : m_database(database) {}
    [[nodiscard]] bool has(SwingId swing);

private:
    Database& m_database;
    std::map<SwingId, bool> m_known;
};

Result<RadioState> radioOf(Database& database, SwingId swing); ///< Errors: NotFound

} // namespace lubberline::db
