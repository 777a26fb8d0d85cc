#include "db/stores/SignatureChecks.h"

#include <QDateTime>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <span>

#include "core/format/exchange/SignedContent.h"
#include "core/record/RecordWords.h"
#include "db/chain/Links.h"
#include "db/engine/Statement.h"
#include "db/stores/Signatures.h"
#include "db/stores/SigningStore.h"
#include "db/stores/SwingStore.h"

namespace lubberline::db {

namespace {

struct TrailRow {
    std::int64_t id;
    std::string timeUtc, what, detail;
};

Result<std::vector<TrailRow>> trailOf(Database& database, const RecordId& record)
{
    Statement statement(database, "SELECT id, time_utc, what, detail FROM audit_entry WHERE record = ? ORDER BY id");
    statement << record;
    return rowsOf<TrailRow>(statement, [](Statement& row) { return TrailRow{row.integer(0), row.text(1), row.text(2), row.longText(3)}; });
}

bool sameMoment(const std::string& one, const std::string& other)
{
    constexpr qint64 kMoment_s = 60; // two looks at the clock, one after the other, on a slow drive
    const auto read = [](const std::string& text) { return QDateTime::fromString(QString::fromStdString(text), Qt::ISODateWithMs); };
    return std::abs(read(one).secsTo(read(other))) <= kMoment_s;
}

bool namesSignature(const TrailRow& row) { return row.what == kSigned || row.what == kSignedElsewhere || row.what == kSignedBefore; }

/// Its place in the trail; 0: it has none.
std::int64_t entryOf(const std::vector<TrailRow>& trail, const Signature& signature)
{
    const std::string text = auditText(signature);
    const auto found
        = std::find_if(trail.rbegin(), trail.rend(), [&](const TrailRow& row) { return namesSignature(row) && row.detail == text; });
    return found == trail.rend() ? 0 : found->id;
}

/// What was changed of the particulars since that entry, through the program: the entries' details, one after the other.
Result<std::string> changesAfter(Database& database, const SwingRecord& record, std::int64_t entry)
{
    std::string details;
    for (const RecordId& one : {record.type.record, record.aircraft.record, record.compass.record,
             record.site ? record.site->record : RecordId(), record.limits ? record.limits->record : RecordId()}) {
        const auto trail = one.empty() ? std::vector<TrailRow>() : trailOf(database, one);
        if (!trail)
            return trail.error();
        for (const TrailRow& row : *trail)
            if (row.id > entry && row.what.starts_with("changed "))
                details += row.detail + "\n";
    }
    return details;
}

/// Whether those entries tell how the value came to be; one that refers to other records tells of all their values.
bool tells(const std::string& details, const SwingDifference& difference)
{
    const std::string after = difference.after.english();
    return !details.empty() && (after.empty() || details.find(after) != std::string::npos || details.find("_id: ") != std::string::npos);
}

/// Whether the swing was opened or changed after that entry: then it may well be something else than was signed.
bool changedAfter(const std::vector<TrailRow>& trail, std::int64_t entry)
{
    return std::any_of(trail.begin(), trail.end(), [&](const TrailRow& row) {
        const bool changes = row.what == "reopened swing" || row.what == "set readings" || row.what == "added reading"
            || row.what == "removed reading" || row.what.starts_with("changed ");
        return row.id > entry && changes && row.detail != "state: 1 -> 2"; // that one froze it
    });
}

/// An entry that says that the swing was frozen.
bool freezesSwing(const TrailRow& row)
{
    return row.what == "froze swing" || row.detail.find("state: 1 -> 2") != std::string::npos
        || (row.what == "added swing" && row.detail.find("; state: 2;") != std::string::npos);
}

bool signedBefore(const std::vector<TrailRow>& trail, const ChainHead& head)
{
    return std::none_of(trail.begin(), trail.end(), namesSignature)
        && std::any_of(trail.begin(), trail.end(), [&head](const TrailRow& row) { return row.id <= head.before && freezesSwing(row); });
}

class Signings {
public:
    Signings(
        Database& database, const ChainHead& head, std::vector<NotedHead>& heads, std::vector<Message>& notes, const Progress& progress)
        : m_database(database)
        , m_head(head)
        , m_heads(heads)
        , m_notes(notes)
        , m_progress(progress)
    {
    }

    Result<void> check(SwingId id, const std::string& file)
    {
        const auto swing = SwingStore(m_database).swing(id);
        if (!swing)
            return swing.error();
        const auto trail = trailOf(m_database, swing->record);
        if (!trail)
            return trail.error();
        const auto states = SigningStore(m_database).checkedStates(id, m_progress);
        if (!states)
            return states.error();
        matchTrail(*swing, *trail);
        checkHashes(*swing, *trail, *states);
        checkState(*swing, *trail, holding(*states));
        checkKeys(*swing, *states);
        for (const Signature& one : swing->signatures)
            if (one.file == file && !one.fileHead.empty())
                m_heads.push_back({one.fileHead, whose(one, *swing)});
        return {};
    }
    std::vector<Message> findings;

private:
    static Message whose(const Signature& one, const Swing& swing)
    {
        return {MARKED("db", "the signature of %1 (%2) on the swing of %3 (record %4)"), one.name, std::string(fileWord(one.role)),
            swing.date, swing.record};
    }

    /// Each row an entry, each entry a row.
    void matchTrail(const Swing& swing, const std::vector<TrailRow>& trail)
    {
        std::multimap<std::string, const TrailRow*> entries;
        for (const TrailRow& row : trail)
            if (namesSignature(row))
                entries.emplace(row.detail, &row);
        for (const Signature& one : swing.signatures) {
            const auto entry = entries.find(auditText(one));
            if (entry == entries.end()) {
                findings.push_back(
                    {MARKED("db", "%1 is not in the audit trail: it was put in, or its fields were changed"), whose(one, swing)});
                continue;
            }
            // Before version 3 the hash does not cover the time; the entry was made in the same moment.
            if (one.contents < 3 && entry->second->what == kSigned && !sameMoment(one.timeUtc, entry->second->timeUtc))
                findings.push_back(
                    {MARKED("db", "%1 has another time than its entry in the audit trail, %2"), whose(one, swing), entry->second->timeUtc});
            entries.erase(entry);
        }
        for (const auto& [detail, row] : entries)
            findings.push_back(
                {MARKED("db",
                     "the signature \"%1\", which the audit trail names at %2, is not there: it was taken out or changed (swing of %3, record %4)"),
                    detail, row->timeUtc, swing.date, swing.record});
    }

    void checkHashes(const Swing& swing, const std::vector<TrailRow>& trail, const std::vector<SignatureState>& states)
    {
        for (std::size_t i = 0; i < states.size(); ++i) {
            const Signature& one = swing.signatures[i];
            if (states[i].holds || changedAfter(trail, entryOf(trail, one)))
                continue;
            for (const SwingDifference& difference : states[i].since)
                findings.push_back({MARKED("db", "%1 does not hold: %2 was \"%3\" when it was signed and is \"%4\""), whose(one, swing),
                    difference.what, difference.before, difference.after});
            if (states[i].since.empty())
                findings.push_back(
                    {MARKED("db", "%1 does not hold: it, one before it, or the swing is not what was signed"), whose(one, swing)});
        }
    }

    void checkKeys(const Swing& swing, const std::vector<SignatureState>& states)
    {
        for (std::size_t i = 0; i < states.size(); ++i) {
            const Message said{MARKED("db", "%1: %2"), whose(swing.signatures[i], swing), states[i].key.words};
            switch (states[i].key.state) {
            case KeyState::Bad:
            case KeyState::Expired:
            case KeyState::OtherHolder: findings.push_back(said); break;
            case KeyState::NotKnown:
            case KeyState::NotChecked:
            case KeyState::Revoked: m_notes.push_back(said); break;
            case KeyState::NameOnly:
            case KeyState::Good: break;
            }
        }
    }

    void checkState(const Swing& swing, const std::vector<TrailRow>& trail, const std::vector<bool>& hold)
    {
        const bool frozen = swing.state == SwingState::Signed;
        if (swing.signatures.empty()) {
            if (!frozen || signedBefore(trail, m_head))
                return;
            const bool cameSo
                = std::none_of(trail.begin(), trail.end(), namesSignature) && std::any_of(trail.begin(), trail.end(), freezesSwing);
            const Message said = cameSo
                ? Message{MARKED("db",
                              "the swing of %1 (record %2) came with an import as a signed one, and the file does not say by whom: it is "
                              "printed as not signed"),
                    swing.date, swing.record}
                : Message{MARKED("db", "the swing of %1 (record %2) is signed, and the audit trail does not say by whom"), swing.date,
                    swing.record};
            (cameSo ? m_notes : findings).push_back(said);
        } else if (frozen && !freezes(swing.signatures, hold)) {
            findings.push_back({MARKED("db", "the signed swing of %1 (record %2) is not what was signed"), swing.date, swing.record});
        } else if (!frozen && freezes(swing.signatures, hold)) {
            findings.push_back(
                {MARKED("db", "the swing of %1 (record %2) was signed by two people and is not frozen"), swing.date, swing.record});
        }
    }

    Database& m_database;
    const ChainHead& m_head;
    std::vector<NotedHead>& m_heads;
    std::vector<Message>& m_notes;
    const Progress& m_progress;
};

} // namespace

std::vector<SignatureState> statesBy(const SwingRecord& record, const std::optional<SwingJob>& job)
{
    const std::vector<Signature>& signatures = record.swing.signatures;
    std::map<int, std::string> hashes; // of the versions that do not depend on who signs
    std::vector<SignatureState> states;
    for (std::size_t i = 0; i < signatures.size(); ++i) {
        const Signature& one = signatures[i];
        std::string hash;
        if (one.contents < 3) {
            std::string& known = hashes[one.contents];
            if (known.empty())
                known = sha256(signedContent(record, job, one, {}));
            hash = known;
        } else {
            hash = sha256(signedContent(record, job, one, std::span(signatures).first(i)));
        }
        states.push_back({hash == one.hash});
        if (one.contents >= 3)
            states.back().since = changedSince(one.particulars, record);
    }
    return states;
}

Result<std::vector<SignatureState>> statesIn(Database& database, const SwingRecord& record, const std::optional<SwingJob>& job)
{
    auto states = statesBy(record, job);
    if (std::none_of(states.begin(), states.end(), [](const SignatureState& one) { return !one.since.empty(); }))
        return states;
    const auto trail = trailOf(database, record.swing.record);
    if (!trail)
        return trail.error();
    for (std::size_t i = 0; i < states.size(); ++i) {
        if (states[i].since.empty())
            continue;
        const auto details = changesAfter(database, record, entryOf(*trail, record.swing.signatures[i]));
        if (!details)
            return details.error();
        states[i].holds = states[i].holds
            && std::all_of(states[i].since.begin(), states[i].since.end(), [&](const auto& one) { return tells(*details, one); });
    }
    return states;
}

Result<bool> signedBeforeSignatures(Database& database, const RecordId& record)
{
    const auto trail = trailOf(database, record);
    const auto head = chainHead(database);
    if (!trail || !head)
        return trail ? head.error() : trail.error();
    return signedBefore(*trail, *head);
}

Result<std::vector<Message>> signatureFaults(
    Database& database, std::vector<NotedHead>& heads, std::vector<Message>& notes, const Progress& progress)
{
    const auto head = chainHead(database);
    if (!head)
        return head.error();
    Statement statement(database,
        "SELECT s.id FROM swing s WHERE s.state = 2 OR EXISTS (SELECT 1 FROM signature g WHERE g.swing_id = s.id)"
        " OR EXISTS (SELECT 1 FROM audit_entry a WHERE a.record = s.record AND a.what IN ('signed swing', 'imported signature', 'kept signature'))");
    const auto ids = rowsOf<SwingId>(statement, [](Statement& row) { return row.id<SwingId>(0); });
    if (!ids)
        return ids.error();
    Signings all(database, *head, heads, notes, progress);
    for (const SwingId id : *ids)
        if (const auto done = all.check(id, head->file); !done)
            return done.error();
    return std::move(all.findings);
}

} // namespace lubberline::db
