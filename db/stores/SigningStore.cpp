#include "db/stores/SigningStore.h"

#include <QCryptographicHash>

#include <algorithm>
#include <map>

#include "core/format/exchange/SignedContent.h"
#include "core/record/Completeness.h"
#include "core/record/RecordWords.h"
#include "db/engine/Changes.h"
#include "db/engine/Statement.h"
#include "db/engine/Transaction.h"
#include "db/stores/Audit.h"
#include "db/stores/JobStore.h"
#include "db/stores/Signatures.h"
#include "db/stores/SwingStore.h"

namespace lubberline::db {

namespace {

constexpr const char* kWroteCard = "wrote card"; // in the audit trail

}

Result<std::string> SigningStore::hashOf(SwingId id, int contents)
{
    const auto record = SwingStore(m_database).record(id);
    if (!record)
        return record.error();
    const auto found = JobStore(m_database).jobOf(id);
    if (!found)
        return found.error();
    std::optional<SwingJob> job;
    if (*found && (*found)->swing == id)
        job = (*found)->job;
    return QCryptographicHash::hash(QByteArray::fromStdString(signedContent(*record, job, contents)), QCryptographicHash::Sha256)
        .toHex()
        .toStdString();
}

Result<void> SigningStore::setState(SwingId id, SwingState state, const std::string& what, const std::string& detail)
{
    const auto swing = SwingStore(m_database).swing(id);
    if (!swing)
        return swing.error();
    Statement statement(m_database, "UPDATE swing SET state = ? WHERE id = ?");
    statement << static_cast<int>(state) << id;
    if (const auto done = statement.run(); !done)
        return done;
    noteState(id);
    return audit(m_database, what, swing->record, detail);
}

/// The state of a swing stands in the tree, too, and decides what is due.
void SigningStore::noteState(SwingId id)
{
    m_database.changes().note(change::OfSwing{id});
    m_database.changes().note(change::Fleet{});
    m_database.changes().note(change::Due{});
}

Result<void> SigningStore::complete(SwingId id)
{
    auto transaction = Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    const auto swing = SwingStore(m_database).swing(id);
    if (!swing)
        return swing.error();
    if (swing->state != SwingState::Draft)
        return Error{
            ErrorCode::InvalidInput, {MARKED("db", "the swing is %1 already; expected a draft"), std::string(fileWord(swing->state))}};
    if (const auto missing = missingIn(*swing, m_database.clock().today()); !missing.empty())
        return Error{ErrorCode::InvalidInput, {MARKED("db", "the swing is not complete: %1"), missing}};
    if (const auto done = setState(id, SwingState::Complete, "completed swing", {}); !done)
        return done;
    return transaction->commit();
}

Result<void> SigningStore::reopen(SwingId id, const std::string& reason)
{
    auto transaction = Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    const auto swing = SwingStore(m_database).swing(id);
    if (!swing)
        return swing.error();
    if (swing->state == SwingState::Signed)
        return Error{ErrorCode::Frozen, MARKED("db", "the swing is signed and frozen; expected an amendment instead"),
            m_database.path().toStdString()};
    if (swing->state != SwingState::Complete)
        return Error{ErrorCode::InvalidInput, MARKED("db", "the swing is a draft already; expected a complete one")};
    if (reason.empty())
        return Error{ErrorCode::InvalidInput, MARKED("db", "the reason is empty; expected why a complete swing is opened again")};
    if (const auto done = setState(id, SwingState::Draft, "reopened swing", reason); !done)
        return done;
    return transaction->commit();
}

Result<void> SigningStore::sign(SwingId id, Signature signature)
{
    auto transaction = Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    auto swing = SwingStore(m_database).swing(id);
    if (!swing)
        return swing.error();
    if (swing->state == SwingState::Draft)
        return Error{
            ErrorCode::InvalidInput, MARKED("db", "the swing is a draft; expected a complete one: it is completed before it is signed")};
    if (signature.name.find_first_not_of(' ') == std::string::npos)
        return Error{ErrorCode::InvalidInput, MARKED("db", "the name is empty; expected who signs")};
    const auto held = hold(id);
    if (!held)
        return held.error();
    if (const auto why = whyNotSign(signature, swing->signatures, *held, swing->people.adjuster, swing->people.inspector); !why.empty())
        return Error{ErrorCode::InvalidInput, why};
    signature.contents = kSignedContents;
    const auto hash = hashOf(id, signature.contents);
    if (!hash)
        return hash.error();
    signature.timeUtc = m_database.clock().nowUtc();
    signature.hash = *hash;
    if (const auto kept = addSignature(m_database, id, signature); !kept)
        return kept;
    if (const auto kept = audit(m_database, "signed swing", swing->record,
            std::string(fileWord(signature.role)) + ": " + signature.name + " " + signature.licence + ", hash " + *hash);
        !kept)
        return kept;
    noteState(id);
    swing->signatures.push_back(std::move(signature));
    const auto holding = hold(id);
    if (!holding)
        return holding.error();
    if (swing->state == SwingState::Complete && freezes(swing->signatures, *holding))
        if (const auto done = setState(id, SwingState::Signed, "froze swing", "hash " + *hash); !done)
            return done;
    return transaction->commit();
}

Result<std::vector<bool>> SigningStore::hold(SwingId id)
{
    const auto snapshot = Transaction::beginReading(m_database);
    if (!snapshot)
        return snapshot.error();
    const auto signatures = signaturesOf(m_database, id);
    if (!signatures)
        return signatures.error();
    std::map<int, std::string> hashes; // of each version that was used
    std::vector<bool> hold;
    for (const auto& signature : *signatures) {
        auto& hash = hashes[signature.contents];
        if (hash.empty()) {
            const auto now = hashOf(id, signature.contents);
            if (!now)
                return now.error();
            hash = *now;
        }
        hold.push_back(signature.hash == hash);
    }
    return hold;
}

Result<SwingId> SigningStore::amend(SwingId id, const std::string& reason)
{
    auto transaction = Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    SwingStore swings(m_database);
    auto swing = swings.swing(id);
    if (!swing)
        return swing.error();
    if (swing->state != SwingState::Signed)
        return Error{
            ErrorCode::InvalidInput, MARKED("db", "the swing is not signed; expected a signed one: anything else can be changed as it is")};
    if (reason.find_first_not_of(' ') == std::string::npos)
        return Error{ErrorCode::InvalidInput, MARKED("db", "the reason is empty; expected why the signed swing is amended")};
    Statement later(m_database, "SELECT record FROM swing WHERE supersedes = ?");
    later << swing->record;
    const auto other = firstOf<std::string>(later, [](Statement& row) { return row.text(0); });
    if (!other)
        return other.error();
    if (*other)
        return Error{ErrorCode::Conflict,
            {MARKED("db", "the swing is amended already by the record %1; expected that one to be changed or amended"), **other},
            m_database.path().toStdString()};
    swing->supersedes = swing->record;
    swing->record.clear();
    swing->id = {};
    swing->state = SwingState::Draft;
    swing->amendment = reason;
    ++swing->revision;
    swing->signatures.clear();
    const auto made = swings.add(*swing);
    if (!made)
        return made;
    if (const auto kept = audit(m_database, "amended swing", swing->supersedes, reason); !kept)
        return kept.error();
    if (const auto committed = transaction->commit(); !committed)
        return committed.error();
    return made;
}

Result<std::vector<AuditRow>> SigningStore::auditOf(const RecordId& record)
{
    Statement statement(m_database, "SELECT time_utc, what, detail FROM audit_entry WHERE record = ? ORDER BY id");
    statement << record;
    return rowsOf<AuditRow>(statement, [](Statement& row) { return AuditRow{row.text(0), row.text(1), row.text(2)}; });
}

Result<void> SigningStore::noteCard(SwingId id)
{
    const auto swing = SwingStore(m_database).swing(id);
    if (!swing)
        return swing.error();
    if (swing->state != SwingState::Signed)
        return Error{ErrorCode::InvalidInput, MARKED("db", "the swing is not signed; only a signed card can be printed again")};
    return audit(m_database, kWroteCard, swing->record, {});
}

Result<bool> SigningStore::cardWasWritten(SwingId id)
{
    Statement statement(
        m_database, "SELECT 1 FROM audit_entry a JOIN swing s ON s.record = a.record WHERE s.id = ? AND a.what = ? LIMIT 1");
    statement << id << std::string(kWroteCard);
    const auto found = firstOf<int>(statement, [](Statement& row) { return static_cast<int>(row.integer(0)); });
    return found ? Result<bool>(found->has_value()) : found.error();
}

Result<std::vector<Message>> SigningStore::faults()
{
    Statement statement(m_database, "SELECT DISTINCT s.id FROM swing s JOIN signature g ON g.swing_id = s.id WHERE s.state = 2");
    const auto ids = rowsOf<SwingId>(statement, [](Statement& row) { return row.id<SwingId>(0); });
    if (!ids)
        return ids.error();
    std::vector<Message> faults;
    for (const auto id : *ids) {
        const auto holding = hold(id);
        const auto signatures = signaturesOf(m_database, id);
        const auto swing = SwingStore(m_database).swing(id);
        if (!signatures || !swing)
            return signatures ? swing.error() : signatures.error();
        if (!holding || !freezes(*signatures, *holding))
            faults.push_back({MARKED("db", "the signed swing of %1 (record %2) is not what was signed"), swing->date, swing->record});
    }
    return faults;
}

} // namespace lubberline::db
