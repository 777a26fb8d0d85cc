#include "db/stores/JobStore.h"

#include <algorithm>
#include <cmath>

#include "core/format/exchange/JobJson.h"
#include "core/record/RecordWords.h"
#include "db/engine/Statement.h"
#include "db/engine/Transaction.h"
#include "db/saving/Audit.h"
#include "db/saving/Saving.h"
#include "db/stores/SwingStore.h"

namespace lubberline::db {

namespace {

enum class JobStanding { Open, Finished, Abandoned };

struct JobRowIn {
    std::int64_t id = 0;
    RecordId record;
    SwingId swing;
    std::string plan;
    JobStanding standing = JobStanding::Open;
};

JobRowIn jobRowFrom(const Statement& row)
{
    return {row.integer(0), row.record(1), row.id<SwingId>(2), row.longText(3), row.as(4, JobStanding::Abandoned)};
}

const QString kSelectJob = "SELECT j.id, j.record, j.swing_id, j.plan_json, j.state FROM swing_job j ";

Result<JobRowIn> rowOf(Database& database, SwingId swing)
{
    Statement statement(database, kSelectJob + "WHERE j.swing_id = ?");
    statement << swing;
    return oneOf<JobRowIn>(statement, database, MARKED("db", "guided swing"), jobRowFrom);
}

Error corruptJob(const Database& database, const RecordId& record, const Error& error)
{
    return {
        ErrorCode::Corrupt, {MARKED("db", "the guided swing %1 does not read: %2"), record, error.message}, database.path().toStdString()};
}

Result<SwingJob> jobFrom(Database& database, const JobRowIn& row)
{
    const std::string file = database.path().toStdString();
    auto job = readJobPlan(row.plan, file);
    if (!job)
        return corruptJob(database, row.record, job.error());
    job->record = row.record;
    Statement statement(database, "SELECT event_json, id FROM job_event WHERE job_id = ? ORDER BY place");
    statement << row.id;
    const auto lines = rowsOf<std::string>(statement, [](Statement& event) { return event.longText(0); });
    if (!lines)
        return lines.error();
    for (const auto& line : *lines) {
        auto event = readJobEvent(line, file);
        if (!event)
            return corruptJob(database, row.record, event.error());
        job->events.push_back(std::move(*event));
    }
    return job;
}

Result<void> insertEvent(Database& database, std::int64_t job, std::size_t place, const JobEvent& event)
{
    Statement statement(database, "INSERT INTO job_event (job_id, place, event_json) VALUES (?, ?, ?)");
    statement << job << static_cast<std::int64_t>(place) << writeJobEvent(event);
    return statement.run();
}

Result<void> forgetTyped(Database& database, const JobRowIn& row)
{
    Statement statement(database, "DELETE FROM job_typed WHERE job_id = ?");
    statement << row.id;
    return statement.run();
}

/// The open job, for what follows its first `place` events.
Result<JobRowIn> openRowAt(Database& database, SwingId swing, std::size_t place)
{
    auto row = rowOf(database, swing);
    if (!row)
        return row;
    const std::string file = database.path().toStdString();
    if (row->standing != JobStanding::Open)
        return Error{ErrorCode::Frozen, MARKED("db", "the guided swing is finished; nothing is added to it"), file};
    Statement count(database, "SELECT COUNT(*) FROM job_event WHERE job_id = ?");
    count << row->id;
    const auto stored = oneOf<std::int64_t>(count, database, MARKED("db", "guided swing"), [](Statement& one) { return one.integer(0); });
    if (!stored)
        return stored.error();
    if (*stored != static_cast<std::int64_t>(place))
        return Error{ErrorCode::Conflict,
            {MARKED("db",
                 "this guided swing has gone on in another window (%1 steps there, %2 known here); nothing was overwritten: take it up again"),
                *stored, place},
            file};
    return row;
}

} // namespace

Result<std::vector<JobRow>> JobStore::open()
{
    Statement statement(m_database,
        "SELECT j.swing_id, j.record, a.registration, c.name, s.date, (SELECT COUNT(*) FROM job_event e WHERE e.job_id = j.id)"
        " FROM swing_job j JOIN swing s ON s.id = j.swing_id JOIN compass c ON c.id = s.compass_id"
        " JOIN aircraft a ON a.id = c.aircraft_id WHERE j.state = 0 ORDER BY j.id DESC");
    return rowsOf<JobRow>(statement, [](Statement& row) {
        return JobRow{row.id<SwingId>(0), row.record(1), row.text(2), row.text(3), row.day(4), static_cast<int>(row.integer(5))};
    });
}

Result<std::optional<JobRecord>> JobStore::jobOf(SwingId swing)
{
    const auto snapshot = Transaction::beginReading(m_database);
    if (!snapshot)
        return snapshot.error();
    Statement statement(
        m_database, kSelectJob + "WHERE j.swing_id = ? OR j.record = (SELECT job_record FROM swing WHERE id = ? AND job_record <> '')");
    statement << swing << swing;
    const auto row = firstOf<JobRowIn>(statement, jobRowFrom);
    if (!row)
        return row.error();
    if (!*row)
        return std::optional<JobRecord>{};
    auto job = jobFrom(m_database, **row);
    if (!job)
        return job.error();
    auto owner = SwingStore(m_database).swing((*row)->swing);
    if (!owner)
        return owner.error();
    job->particulars = std::move(*owner);
    job->particulars.readings.clear();
    return std::optional(JobRecord{(*row)->swing, std::move(*job)});
}

Result<std::vector<JobRecord>> JobStore::all()
{
    Statement statement(m_database, kSelectJob + "ORDER BY j.id");
    const auto rows = rowsOf<JobRowIn>(statement, jobRowFrom);
    if (!rows)
        return rows.error();
    std::vector<JobRecord> jobs;
    for (const auto& row : *rows) {
        auto job = jobFrom(m_database, row);
        if (!job)
            return job.error();
        jobs.push_back({row.swing, std::move(*job)});
    }
    return jobs;
}

Result<RecordId> JobStore::add(SwingId swing, const SwingJob& job, bool finished)
{
    auto transaction = Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    const RecordId record = job.record.empty() ? newRecordId() : job.record;
    Statement statement(m_database, "INSERT INTO swing_job (record, swing_id, plan_json, state) VALUES (?, ?, ?, ?)");
    statement << record << swing << writeJobPlan(job) << static_cast<int>(finished ? JobStanding::Finished : JobStanding::Open);
    if (const auto done = statement.run(); !done)
        return done.error();
    const std::int64_t id = statement.insertedId();
    for (std::size_t place = 0; place < job.events.size(); ++place)
        if (const auto done = insertEvent(m_database, id, place, job.events[place]); !done)
            return done.error();
    if (const auto kept = audit(m_database, "added guided swing", record, std::string(fileWord(job.plan.kind))); !kept)
        return kept.error();
    if (const auto committed = transaction->commit(); !committed)
        return committed.error();
    return record;
}

Result<void> JobStore::append(SwingId swing, std::size_t place, const JobEvent& event)
{
    auto transaction = Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    const auto row = openRowAt(m_database, swing, place);
    if (!row)
        return row.error();
    if (const auto done = insertEvent(m_database, row->id, place, event); !done)
        return done;
    if (const auto done = forgetTyped(m_database, *row); !done)
        return done;
    m_database.changes().note(change::OfSwing{swing}); // lists say where it stands
    return transaction->commit();
}

Result<void> JobStore::keepTyped(SwingId swing, std::size_t place, const std::vector<TypedText>& typed)
{
    auto transaction = Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    const auto row = openRowAt(m_database, swing, place);
    if (!row)
        return row.error();
    if (const auto done = forgetTyped(m_database, *row); !done)
        return done;
    for (const TypedText& one : typed) {
        Statement statement(m_database, "INSERT INTO job_typed (job_id, field, typed) VALUES (?, ?, ?)");
        statement << row->id << one.field << one.text;
        if (const auto done = statement.run(); !done)
            return done;
    }
    return transaction->commit();
}

Result<std::vector<TypedText>> JobStore::typed(SwingId swing)
{
    Statement statement(
        m_database, "SELECT t.field, t.typed FROM job_typed t JOIN swing_job j ON j.id = t.job_id WHERE j.swing_id = ? ORDER BY t.id");
    statement << swing;
    return rowsOf<TypedText>(statement, [](Statement& row) { return TypedText{row.name(0), row.text(1)}; });
}

Result<SwingId> JobStore::start(const Swing& particulars, const SwingJob& job)
{
    const auto store = [&]() -> Result<SwingId> {
        Swing swing = particulars;
        swing.job = job.record.empty() ? newRecordId() : job.record;
        const auto id = SwingStore(m_database).add(swing);
        if (!id)
            return id;
        SwingJob stored = job;
        stored.record = swing.job;
        const auto added = add(*id, stored, false);
        return added ? id : added.error();
    };
    return noting(m_database, store, [](SwingId) {}); // the swing's store has noted it
}

Result<void> JobStore::finish(SwingId swing, const Swing& asLeft, const std::vector<Swing>& others)
{
    const auto store = [&]() -> Result<void> {
        SwingStore swings(m_database);
        const auto own = swings.swing(swing);
        if (!own)
            return own.error();
        Swing particulars = asLeft;
        particulars.id = swing;
        particulars.record = own->record;
        particulars.compass = own->compass;
        particulars.job = own->job;
        particulars.field = own->field;
        particulars.state = own->state;
        if (auto changed = swings.change(*own, particulars); !changed)
            return changed;
        if (auto replaced = swings.replaceReadings(swing, asLeft.readings); !replaced)
            return replaced;
        for (Swing other : others) {
            other.id = {};
            other.compass = own->compass;
            other.job = own->job;
            if (const auto added = swings.add(other); !added)
                return added.error();
        }
        return close(swing, true);
    };
    return noting(m_database, store, [] {});
}

Result<void> JobStore::abandon(SwingId swing) { return close(swing, false); }

Result<void> JobStore::close(SwingId swing, bool finished)
{
    auto transaction = Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    const auto row = rowOf(m_database, swing);
    if (!row)
        return row.error();
    Statement statement(m_database, "UPDATE swing_job SET state = ? WHERE id = ?");
    statement << static_cast<int>(finished ? JobStanding::Finished : JobStanding::Abandoned) << row->id;
    if (const auto done = statement.run(); !done)
        return done;
    if (const auto done = forgetTyped(m_database, *row); !done)
        return done;
    if (const auto kept = audit(m_database, finished ? "finished guided swing" : "abandoned guided swing", row->record, {}); !kept)
        return kept;
    m_database.changes().note(change::OfSwing{swing});
    m_database.changes().note(change::Fleet{});
    return transaction->commit();
}

} // namespace lubberline::db
