#include "db/stores/SigningStore.h"

#include <algorithm>
#include <optional>
#include <span>

#include "core/format/exchange/SignedContent.h"
#include "core/record/ClockDates.h"
#include "core/record/Completeness.h"
#include "core/record/RecordWords.h"
#include "db/chain/Links.h"
#include "db/engine/Changes.h"
#include "db/engine/Statement.h"
#include "db/engine/Transaction.h"
#include "db/openpgp/KeyCheck.h"
#include "db/saving/Audit.h"
#include "db/stores/JobStore.h"
#include "db/stores/KeyStore.h"
#include "db/stores/SignatureChecks.h"
#include "db/stores/Signatures.h"
#include "db/stores/SwingStore.h"

namespace lubberline::db {

namespace {

constexpr const char* kWroteCard = "wrote card"; // in the audit trail

/// A swing with the guided swing that belongs to it.
struct Whole {
    SwingRecord record;
    std::optional<SwingJob> job;
};

Result<Whole> wholeOf(Database& database, SwingId id)
{
    auto record = SwingStore(database).record(id);
    if (!record)
        return record.error();
    auto found = JobStore(database).jobOf(id);
    if (!found)
        return found.error();
    Whole whole{std::move(record.value()), {}};
    if (*found && (*found)->swing == id)
        whole.job = std::move((*found)->job);
    return whole;
}

Result<void> checkSigner(Database& database, const Swing& swing, const Signature& signature, const std::vector<bool>& hold)
{
    if (swing.state == SwingState::Draft)
        return Error{
            ErrorCode::InvalidInput, MARKED("db", "the swing is a draft; expected a complete one: it is completed before it is signed")};
    if (swing.state == SwingState::Signed && swing.signatures.empty()) { // else a first signature would make it look as if it had been
        const auto before = signedBeforeSignatures(database, swing.record);
        if (!before)
            return before.error();
        if (!*before)
            return Error{ErrorCode::InvalidInput,
                MARKED("db",
                    "the swing is frozen as a signed one, and nobody's signature is there; expected an amendment, which can be signed")};
    }
    if (signature.name.find_first_not_of(' ') == std::string::npos)
        return Error{ErrorCode::InvalidInput, MARKED("db", "the name is empty; expected who signs")};
    if (const auto why = whyNotSign(signature, swing.signatures, hold, swing.people.adjuster, swing.people.inspector); !why.empty())
        return Error{ErrorCode::InvalidInput, why};
    return {};
}

} // namespace

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

Result<void> SigningStore::complete(SwingId id, const std::string& howDayIsKnown)
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
    const Date today = m_database.clock().today();
    if (const auto missing = missingIn(*swing, today, DayKnown::Yes); !missing.empty())
        return Error{ErrorCode::InvalidInput, {MARKED("db", "the swing is not complete: %1"), missing}};
    const auto doubt = doubtOfClock(swing->date, today);
    if (!doubt.empty() && howDayIsKnown.empty())
        return Error{
            ErrorCode::InvalidInput, {MARKED("db", "the swing is not complete: %1; if it was that day, say how it is known"), doubt}};
    if (const auto done
        = setState(id, SwingState::Complete, "completed swing", doubt.empty() ? std::string() : "the day is known: " + howDayIsKnown);
        !done)
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
    const auto prepared = prepare(id, std::move(signature));
    if (!prepared)
        return prepared.error();
    if (const auto added = add(id, *prepared); !added)
        return added;
    return transaction->commit();
}

Result<Signature> SigningStore::prepare(SwingId id, Signature signature)
{
    const auto snapshot = Transaction::beginReading(m_database);
    if (!snapshot)
        return snapshot.error();
    const auto whole = wholeOf(m_database, id);
    if (!whole)
        return whole.error();
    const auto states = statesIn(m_database, whole->record, whole->job);
    if (!states)
        return states.error();
    if (const auto may = checkSigner(m_database, whole->record.swing, signature, holding(*states)); !may)
        return may.error();
    const auto head = chainHead(m_database);
    const auto own = recordHead(m_database, whole->record.swing.record);
    if (!head || !own)
        return head ? own.error() : head.error();
    signature.contents = kSignedContents;
    signature.timeUtc = m_database.clock().nowUtc();
    signature.file = head->file;
    signature.fileHead = head->head;
    signature.recordHead = *own;
    signature.particulars = signedParticulars(whole->record);
    signature.hash = sha256(signedContent(whole->record, whole->job, signature, whole->record.swing.signatures));
    return signature;
}

Result<std::string> SigningStore::contentOf(SwingId id, const Signature& signature)
{
    const auto snapshot = Transaction::beginReading(m_database);
    if (!snapshot)
        return snapshot.error();
    const auto whole = wholeOf(m_database, id);
    if (!whole)
        return whole.error();
    const auto& all = whole->record.swing.signatures;
    const auto before = std::find(all.begin(), all.end(), signature) - all.begin(); // one that is not stored yet comes after all
    return signedContent(whole->record, whole->job, signature, std::span(all).first(static_cast<std::size_t>(before)));
}

Result<void> SigningStore::add(SwingId id, const Signature& prepared)
{
    auto transaction = Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    const auto whole = wholeOf(m_database, id);
    if (!whole)
        return whole.error();
    Swing swing = whole->record.swing;
    const auto states = statesIn(m_database, whole->record, whole->job);
    if (!states)
        return states.error();
    if (const auto may = checkSigner(m_database, swing, prepared, holding(*states)); !may)
        return may;
    const auto own = recordHead(m_database, swing.record);
    if (!own)
        return own.error();
    if (prepared.recordHead != *own || signedParticulars(whole->record) != prepared.particulars
        || sha256(signedContent(whole->record, whole->job, prepared, swing.signatures)) != prepared.hash)
        return Error{ErrorCode::Conflict, MARKED("db", "the swing was changed while it was being signed; look at it again and sign anew"),
            m_database.path().toStdString()};
    if (const auto kept = addSignature(m_database, id, swing.record, prepared, kSigned); !kept)
        return kept;
    noteState(id);
    swing.signatures.push_back(prepared);
    const auto holds = hold(id);
    if (!holds)
        return holds.error();
    if (swing.state == SwingState::Complete && freezes(swing.signatures, *holds))
        if (const auto done = setState(id, SwingState::Signed, "froze swing", "hash " + prepared.hash); !done)
            return done;
    return transaction->commit();
}

Result<std::vector<SignatureState>> SigningStore::states(SwingId id)
{
    const auto snapshot = Transaction::beginReading(m_database);
    if (!snapshot)
        return snapshot.error();
    const auto whole = wholeOf(m_database, id);
    if (!whole)
        return whole.error();
    return statesIn(m_database, whole->record, whole->job);
}

Result<std::vector<bool>> SigningStore::hold(SwingId id)
{
    const auto all = states(id);
    return all ? Result<std::vector<bool>>(holding(*all)) : all.error();
}

Result<bool> SigningStore::stands(const Swing& swing, const std::vector<SignatureState>& states)
{
    if (!swing.signatures.empty())
        return states.size() == swing.signatures.size() && freezes(swing.signatures, holding(states));
    return swing.state == SwingState::Signed ? signedBeforeSignatures(m_database, swing.record) : Result<bool>(false);
}

Result<std::vector<KeyVerdict>> SigningStore::verdicts(SwingId id, const Progress& progress)
{
    const auto signatures = signaturesOf(m_database, id);
    const auto station = KeyStore(m_database).all();
    if (!signatures || !station)
        return signatures ? station.error() : signatures.error();
    std::vector<KeyVerdict> verdicts;
    for (const Signature& one : *signatures) {
        const auto content = one.hasKey() ? contentOf(id, one) : Result<std::string>(std::string());
        if (!content)
            return content.error();
        verdicts.push_back(verdictOn(one, *content, *station, progress));
        const double done = static_cast<double>(verdicts.size()) / static_cast<double>(signatures->size());
        if (one.hasKey() && progress && !progress(done)) // "not checked" would be no answer to who asks again
            return Error{ErrorCode::Cancelled, MARKED("db", "cancelled: the keys of the signatures were not checked")};
    }
    return verdicts;
}

Result<std::vector<SignatureState>> SigningStore::checkedStates(SwingId id, const Progress& progress)
{
    auto all = states(id);
    const auto keys = verdicts(id, progress);
    if (!all || !keys)
        return all ? keys.error() : all.error();
    for (std::size_t i = 0; i < all->size() && i < keys->size(); ++i)
        (*all)[i].key = (*keys)[i];
    return all;
}

Result<std::string> SigningStore::clockStandsBefore()
{
    Statement statement(m_database, "SELECT time_utc FROM audit_entry ORDER BY id DESC LIMIT 1");
    const auto last = firstOf<std::string>(statement, [](Statement& row) { return row.text(0); });
    if (!last)
        return last.error();
    return *last && m_database.clock().nowUtc_ms() < **last ? **last : std::string();
}

Result<ChainHead> SigningStore::trailHead() { return chainHead(m_database); }

Result<std::vector<Message>> SigningStore::trailFaults(const RecordId& record) { return checkRecordChain(m_database, record); }

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
    const auto other = firstOf<std::string>(later, [](Statement& row) { return row.record(0); });
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
    Statement statement(m_database, "SELECT time_utc, what, detail, id FROM audit_entry WHERE record = ? ORDER BY id");
    statement << record;
    return rowsOf<AuditRow>(statement, [](Statement& row) { return AuditRow{row.text(0), row.text(1), row.longText(2)}; });
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

} // namespace lubberline::db
