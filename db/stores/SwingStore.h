#pragma once
/// Swings and their readings. A writing call is one transaction: readings, cached results and audit entry together.

#include <functional>
#include <span>
#include <vector>

#include "core/base/Progress.h"
#include "core/record/Fleet.h"
#include "core/record/FleetRows.h"
#include "db/engine/Database.h"

namespace lubberline::db {

/// What is read of each reading.
enum class ReadingParts {
    All,
    Headings, ///< and whether it is left out: what results need (a log has many readings)
};

/// A row as the caller knows it, and as it is to be.
struct ReadingChange {
    Reading known, reading;
};

class SwingStore {
public:
    explicit SwingStore(Database& database) : m_database(database) {}

    Result<std::vector<SwingRow>> swingsOf(CompassId compass); ///< newest first
    Result<std::vector<NewestSwing>> newest(int count);        ///< by their days, of every compass
    Result<Swing> swing(SwingId id, ReadingParts parts = ReadingParts::All);
    /// With compass, aircraft, type, site and limits.
    Result<SwingRecord> record(SwingId id, ReadingParts parts = ReadingParts::All);
    Result<Reading> reading(SwingId swing, ReadingId id);
    /// The last swing of the same compass that is dated before this one, as left rather than as found; where there is none, the
    /// last before it of the same day. One that another supersedes, or that this one does, is not meant.
    Result<std::optional<Swing>> previous(SwingId id);
    Result<std::optional<SwingRow>> previousRow(SwingId id); ///< likewise, as a line of a list
    Result<RecordId> recordOf(SwingId id);
    /// By record id or the beginning of one. Errors: NotFound, Conflict when several begin so.
    Result<SwingId> named(const std::string& beginning);
    /// All swings with their readings, in order of id, in two statements; the callback returns false to stop.
    Result<void> forEach(const std::function<bool(const Swing&)>& callback);

    /// A new swing with its readings. One without a field stamp gets that of its site and date (core/swing/SwingField.h), where there is
    /// one, unless it is signed.
    Result<SwingId> add(const Swing& swing);
    /// The same without a stamp of ours: for transfer only.
    Result<SwingId> addAsIs(const Swing& swing);
    /// The changed particulars of a known swing; its readings and its state stay as they are.
    /// @param known as the caller knows it. Errors: Conflict when the particulars are others by now; Frozen; InvalidInput (another state).
    Result<void> change(const Swing& known, const Swing& swing);
    /// The same with any state: for transfer and signing only.
    Result<void> replace(const Swing& known, const Swing& swing);
    /// Errors: Frozen unless it is a draft that nobody has signed.
    Result<void> remove(SwingId id);
    /// A new row at `position` (0 …) of the readings; what was there moves down. Errors: Frozen when signed.
    Result<ReadingId> insertReading(SwingId swing, int position, const Reading& reading);
    /// Several as one change: results are computed once. @return their ids
    Result<std::vector<ReadingId>> insertReadings(SwingId swing, int position, std::span<const Reading> readings);
    /// @param known the row as the caller knows it. Errors: Conflict when it is another by now, unless it is as the caller
    /// wants it.
    Result<void> changeReading(SwingId swing, const Reading& known, const Reading& reading);
    Result<void> changeReadings(SwingId swing, std::span<const ReadingChange> changes); ///< as one change
    Result<void> replaceReadings(SwingId swing, const std::vector<Reading>& readings);
    Result<void> removeReading(SwingId swing, ReadingId reading);
    Result<void> removeReadings(SwingId swing, std::span<const ReadingId> readings); ///< as one change

private:
    Result<SwingId> insert(Swing swing);
    Database& m_database;
};

} // namespace lubberline::db
