#include "db/transfer/ImportChecks.h"

#include <optional>
#include <set>

#include "db/saving/Audit.h"
#include "db/stores/SignatureChecks.h"
#include "db/stores/SigningStore.h"
#include "db/stores/SwingStore.h"

namespace lubberline::db {

Result<void> checkSigned(const Database& database, const Fleet& fleet, const Swing& original, const JobRecord* job)
{
    if (original.signatures.empty() || original.state != SwingState::Signed)
        return {};
    std::optional<SwingJob> own;
    if (job) {
        own = job->job;
        own->particulars = {};
    }
    const SwingRecord record = recordIn(fleet, original);
    const bool cannotBeTold = !original.job.empty() && !job; // a report holds no guided swing: checkStored() marks it
    if (cannotBeTold || freezes(original.signatures, holding(statesBy(record, own))))
        return {};
    return Error{ErrorCode::Corrupt,
        {MARKED("db",
             "the signed swing of %1, %2, %3 (record %4) is not what was signed; expected one whose signatures hold. Nothing was stored"),
            record.aircraft.registration, record.compass.name, original.date, original.record},
        database.path().toStdString()};
}

Result<std::vector<Message>> checkStored(Database& database, const Fleet& fleet, SwingId id, const Swing& original, const JobRecord* job)
{
    const auto record = SwingStore(database).record(id);
    if (!record)
        return record.error();
    const Swing& swing = record->swing;
    std::vector<Message> warnings;
    const auto tell = [&](Message what) {
        warnings.push_back({MARKED("db", "the swing of %1, %2, %3 (record %4): %5"), record->aircraft.registration, record->compass.name,
            swing.date, swing.record, std::move(what)});
    };
    if (swing.signatures.empty()) {
        if (swing.state == SwingState::Signed) // before signatures were kept, or they were taken out of the file
            tell(MARKED("db", "the file has it as signed and does not say by whom; it is printed as not signed"));
        return warnings;
    }
    // What was changed where it comes from, after it was signed: said here, in the trail and wherever it is printed.
    std::set<std::string> told;
    for (const auto& state : statesBy(recordIn(fleet, original), job ? std::optional(job->job) : std::nullopt))
        for (const auto& one : state.since) {
            const std::string change = one.what.english() + ": " + one.before.english() + " -> " + one.after.english();
            if (!told.insert(change).second)
                continue;
            tell({MARKED("db", "signed as %1 \"%2\", in the file it is \"%3\""), one.what, one.before, one.after});
            if (const auto kept = audit(database, "changed elsewhere", record->aircraft.record, change); !kept)
                return kept.error();
        }
    const auto states = SigningStore(database).states(id);
    if (!states)
        return states.error();
    for (std::size_t i = 0; i < states->size(); ++i) {
        if ((*states)[i].holds)
            continue;
        tell({MARKED("db", "the signature of %1 does not hold"), swing.signatures[i].name});
        for (const auto& one : (*states)[i].since)
            tell({MARKED("db", "signed as %1 \"%2\", here it is \"%3\""), one.what, one.before, one.after});
    }
    return warnings;
}

} // namespace lubberline::db
