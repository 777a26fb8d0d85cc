// The part of the storage that is used on the ramp: guided swings, signatures, instruments, due rules, electrical swings.

#include "app/DbStorage.h"
#include "db/Transaction.h"

namespace lubberline::app {

/// The state of a swing stands in the tree, too.
Result<void> DbStorage::announced(Result<void> done, SwingId id)
{
    if (done) {
        emit swingChanged(id);
        emit fleetChanged();
    }
    return done;
}

Result<void> DbStorage::announcedDue(Result<void> done)
{
    if (done)
        emit dueChanged();
    return done;
}

Result<void> DbStorage::sign(SwingId id, Signature signature)
{
    return announcedDue(announced(m_signing.sign(id, std::move(signature)), id));
}

Result<SwingId> DbStorage::amend(SwingId id, const std::string& reason)
{
    const auto made = m_signing.amend(id, reason);
    if (made)
        emit fleetChanged();
    return made;
}

Result<SwingId> DbStorage::startJob(const Swing& particulars, const SwingJob& job)
{
    auto transaction = db::Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    Swing swing = particulars;
    swing.job = job.record.empty() ? newRecordId() : job.record;
    const auto id = addSwing(swing);
    if (!id)
        return id;
    SwingJob stored = job;
    stored.record = swing.job;
    if (const auto added = m_jobs.add(*id, stored, false); !added)
        return added.error();
    if (const auto committed = transaction->commit(); !committed)
        return committed.error();
    emit fleetChanged();
    return id;
}

Result<void> DbStorage::finishJob(SwingId swing, const Swing& asLeft, const std::vector<Swing>& others)
{
    auto transaction = db::Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    auto own = m_swings.swing(swing);
    if (!own)
        return own.error();
    Swing particulars = asLeft;
    particulars.id = swing;
    particulars.record = own->record;
    particulars.compass = own->compass;
    particulars.job = own->job;
    particulars.field = own->field;
    if (const auto saved = m_swings.save(particulars); !saved)
        return saved.error();
    if (const auto replaced = m_swings.replaceReadings(swing, asLeft.readings); !replaced)
        return replaced;
    for (Swing other : others) {
        other.id = {};
        other.compass = own->compass;
        other.job = own->job;
        if (const auto saved = addSwing(std::move(other)); !saved)
            return saved.error();
    }
    if (const auto closed = m_jobs.close(swing, true); !closed)
        return closed;
    if (const auto committed = transaction->commit(); !committed)
        return committed;
    emit swingChanged(swing);
    emit fleetChanged();
    return {};
}

Result<void> DbStorage::abandonJob(SwingId swing) { return announced(m_jobs.close(swing, false), swing); }

Result<void> DbStorage::save(const DatumInstrument& instrument)
{
    const auto done = m_instruments.save(instrument);
    if (done)
        emit sitesChanged();
    return done;
}

Result<void> DbStorage::removeInstrument(const RecordId& record)
{
    const auto done = m_instruments.remove(record);
    if (done)
        emit sitesChanged();
    return done;
}

Result<void> DbStorage::save(const DueRule& rule) { return announcedDue(m_due.save(rule)); }

Result<void> DbStorage::removeDueRule(const RecordId& record) { return announcedDue(m_due.removeRule(record)); }

Result<void> DbStorage::save(const Waiver& waiver) { return announcedDue(m_due.save(waiver)); }

Result<void> DbStorage::save(CompassId compass, const ElectricalSwing& swing)
{
    const auto done = m_electrical.save(compass, swing);
    if (done)
        emit electricalChanged(compass);
    return done;
}

} // namespace lubberline::app
