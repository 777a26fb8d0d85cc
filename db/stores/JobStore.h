#pragma once
/// Guided swings: a plan, and events that are only ever added, each in a transaction of its own.

#include <optional>
#include <vector>

#include "core/record/Fleet.h"
#include "core/record/FleetRows.h"
#include "db/engine/Database.h"

namespace lubberline::db {

class JobStore {
public:
    explicit JobStore(Database& database) : m_database(database) {}

    Result<std::vector<JobRow>> open(); ///< newest first
    /// The job that belongs to the swing or made it. Its particulars are those of the swing that it belongs to.
    /// Errors: Corrupt (an event that does not read).
    Result<std::optional<JobRecord>> jobOf(SwingId swing);
    Result<std::vector<JobRecord>> all(); ///< of every swing, without particulars: for the exchange file

    /// A new draft for the job, and the job with its first events; the particulars are those of the swing.
    Result<SwingId> start(const Swing& particulars, const SwingJob& job);
    /// The readings of the job's swing, and the other swings that it made; the job is not open any more. All in one transaction.
    Result<void> finish(SwingId swing, const Swing& asLeft, const std::vector<Swing>& others);
    Result<void> abandon(SwingId swing); ///< its events stay; the draft stays

    /// Stores the job and the events that it has, for a swing that is stored and has none. A record id is made when empty.
    Result<RecordId> add(SwingId swing, const SwingJob& job, bool finished);
    /// Errors: Conflict unless exactly `place` events are stored; Frozen when the job is no longer open.
    Result<void> append(SwingId swing, std::size_t place, const JobEvent& event);
    Result<void> close(SwingId swing, bool finished);

    /// What is typed of the step that follows the first `place` ones, in place of what was: storing that step takes it away. Nobody is told.
    /// Errors: those of append().
    Result<void> keepTyped(SwingId swing, std::size_t place, const std::vector<TypedText>& typed);
    Result<std::vector<TypedText>> typed(SwingId swing); ///< of the step that it stands at

private:
    Database& m_database;
};

} // namespace lubberline::db
