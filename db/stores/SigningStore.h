#pragma once
/// Draft → complete → signed, signatures and amendments. Every step is one transaction with its audit entry.

#include <string>
#include <vector>

#include "core/record/FleetRows.h"
#include "core/record/Signature.h"
#include "db/engine/Database.h"

namespace lubberline::db {

class SigningStore {
public:
    explicit SigningStore(Database& database) : m_database(database) {}

    /// Errors: InvalidInput (not a draft; what is missing: core/record/Completeness.h), Frozen.
    Result<void> complete(SwingId id);
    /// Errors: InvalidInput (not complete, no reason), Frozen.
    Result<void> reopen(SwingId id, const std::string& reason);
    /// Time and hash are made here. A performer's with an inspector's or authority's that hold sign the swing; an authority may
    /// sign later, too. Errors: InvalidInput (a draft, no name).
    Result<void> sign(SwingId id, Signature signature);
    Result<std::vector<bool>> hold(SwingId id); ///< as Swing::signatures
    /// Errors: InvalidInput (not signed, no reason), Conflict (superseded already).
    Result<SwingId> amend(SwingId id, const std::string& reason);
    Result<std::vector<AuditRow>> auditOf(const RecordId& record); ///< oldest first
    /// That a card of it was written, as it is signed now: one that is written after is a reprint.
    Result<void> noteCard(SwingId id);
    Result<bool> cardWasWritten(SwingId id);
    /// Signed swings of which a deciding signature does not hold: for verify().
    Result<std::vector<Message>> faults();

private:
    void noteState(SwingId id);
    /// What a signature by that version of the signed content would stand for.
    Result<std::string> hashOf(SwingId id, int contents);
    Result<void> setState(SwingId id, SwingState state, const std::string& what, const std::string& detail);
    Database& m_database;
};

} // namespace lubberline::db
