#pragma once
/// Draft → complete → signed, signatures and amendments. Every step is one transaction with its audit entry.

#include <string>
#include <vector>

#include "core/base/Progress.h"
#include "core/record/FleetRows.h"
#include "core/record/SignatureState.h"
#include "db/chain/Links.h"
#include "db/engine/Database.h"

namespace lubberline::db {

class SigningStore {
public:
    explicit SigningStore(Database& database) : m_database(database) {}

    /// Errors: InvalidInput (not a draft; what is missing: core/record/Completeness.h), Frozen. @param howDayIsKnown of a day that clocks show
    /// which do not know it (ClockDates.h): it stands in the audit trail; of any other day it is not kept.
    Result<void> complete(SwingId id, const std::string& howDayIsKnown = {});
    /// Errors: InvalidInput (not complete, no reason), Frozen.
    Result<void> reopen(SwingId id, const std::string& reason);
    /// Time and hash are made here. A performer's with an inspector's or authority's that hold sign the swing; an authority may
    /// sign later, too. Errors: InvalidInput (a draft, no name, one person on both sides).
    Result<void> sign(SwingId id, Signature signature);
    /// In two steps, where a key signs in between: whose the signature is, with all that it will cover and its hash. Changes nothing.
    Result<Signature> prepare(SwingId id, Signature signature);
    /// The text that such a signature stands for.
    Result<std::string> contentOf(SwingId id, const Signature& signature);
    /// Errors: besides those of sign(), Conflict when the record is not what was prepared any more.
    Result<void> add(SwingId id, const Signature& prepared);
    Result<std::vector<bool>> hold(SwingId id);             ///< as Swing::signatures
    Result<std::vector<SignatureState>> states(SwingId id); ///< likewise
    /// Whether signatures stand over what a signed swing says now. @param states of its signatures, in their order; a swing without any
    /// stands only where it was signed before signatures were kept.
    Result<bool> stands(const Swing& swing, const std::vector<SignatureState>& states);
    /// Of each signature what its key is worth, by the station's list. Runs gpg for those that have one: on a worker.
    Result<std::vector<KeyVerdict>> verdicts(SwingId id, const Progress& progress);
    /// states() with the verdicts in them.
    Result<std::vector<SignatureState>> checkedStates(SwingId id, const Progress& progress);
    /// The last entry of the audit trail when the clock stands before it: what is signed now would seem older. Empty: it does not.
    Result<std::string> clockStandsBefore();
    /// Errors: InvalidInput (not signed, no reason), Conflict (superseded already).
    Result<SwingId> amend(SwingId id, const std::string& reason);
    Result<std::vector<AuditRow>> auditOf(const RecordId& record); ///< oldest first
    /// That a card of it was written, as it is signed now: one that is written after is a reprint.
    Result<void> noteCard(SwingId id);
    Result<bool> cardWasWritten(SwingId id);
    Result<ChainHead> trailHead();                                    ///< of the whole database's audit trail
    Result<std::vector<Message>> trailFaults(const RecordId& record); ///< of that record's own entries

private:
    void noteState(SwingId id);
    Result<void> setState(SwingId id, SwingState state, const std::string& what, const std::string& detail);
    Database& m_database;
};

} // namespace lubberline::db
