#pragma once
/// What the window asks of storage. `app` binds it to `db`; tests bind it to memory. No SQL here.
/// Every writing call is one transaction: when it returns ok, the change is on disk. Calls are made on the window's thread and
/// take well under 100 ms; long work (import, export) is done on a worker through openForWorker().

#include <QObject>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/record/Fleet.h"
#include "core/record/FleetRows.h"

namespace lubberline::ui {

class Storage : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    [[nodiscard]] virtual QString location() const = 0; ///< for the status bar
    [[nodiscard]] virtual bool readOnly() const = 0;

    /// A connection of its own to the same database, to be made, used and destroyed on one worker thread. It emits nothing;
    /// the caller calls announceFleetChange() on the window's storage when the worker is done.
    virtual Result<std::unique_ptr<Storage>> openForWorker() const = 0;
    void announceFleetChange() { emit fleetChanged(); }

    virtual Result<Totals> totals() = 0;
    virtual Result<std::vector<TypeRow>> types() = 0;
    virtual Result<std::vector<AircraftRow>> aircraftOf(AircraftTypeId type) = 0;
    virtual Result<std::vector<CompassRow>> compassesOf(AircraftId aircraft) = 0;
    virtual Result<std::vector<SwingRow>> swingsOf(CompassId compass) = 0; ///< newest first
    virtual Result<std::vector<SearchHit>> search(const std::string& words, int limit) = 0;

    virtual Result<Aircraft> aircraft(AircraftId id) = 0;
    virtual Result<CompassSystem> compass(CompassId id) = 0;
    virtual Result<std::vector<Event>> eventsOf(AircraftId id) = 0;
    virtual Result<std::vector<SensorRecord>> sensorsOf(CompassId compass) = 0; ///< newest first
    virtual Result<SwingRecord> swingRecord(SwingId id) = 0;
    /// The last swing of the same compass before this one by date, if any.
    virtual Result<std::optional<Swing>> previousSwing(SwingId id) = 0;
    virtual Result<std::vector<Site>> sites() = 0;
    virtual Result<std::vector<LimitsProfile>> limitsProfiles() = 0;

    /// Stores a new record (id not valid; a swing with its readings), or the changed particulars of a known one. The signals
    /// below are emitted before a writing call returns.
    virtual Result<AircraftTypeId> save(const AircraftType& type) = 0;
    virtual Result<AircraftId> save(const Aircraft& aircraft) = 0;
    virtual Result<CompassId> save(const CompassSystem& compass) = 0;
    virtual Result<SiteId> save(const Site& site) = 0;
    virtual Result<LimitsProfileId> save(const LimitsProfile& profile) = 0;
    virtual Result<EventId> save(const Event& event) = 0;
    /// A new swing without a field stamp gets the one of its site and date (core/swing/SwingField.h), where there is one.
    virtual Result<SwingId> saveParticulars(const Swing& swing) = 0;
    /// The changed particulars of a known swing. @param before as the caller knows them. Errors: Conflict when they are others
    /// now.
    virtual Result<void> changeParticulars(const Swing& before, const Swing& swing) = 0;
    virtual Result<SensorModelId> save(const SensorRecord& sensor) = 0;
    virtual Result<void> removeSensor(SensorModelId id) = 0;

    /// Draft swings only (Frozen otherwise).
    virtual Result<void> removeSwing(SwingId id) = 0;
    /// A new row at `position` of the swing's readings; what was there moves down.
    virtual Result<ReadingId> insertReading(SwingId swing, int position, const Reading& reading) = 0;
    /// @param before the row as the caller knows it. Errors: Conflict when it is another now: somebody else has changed it.
    virtual Result<void> saveReading(SwingId swing, const Reading& before, const Reading& reading) = 0;
    virtual Result<void> removeReading(SwingId swing, ReadingId reading) = 0;

    /// Draft → complete: readings and particulars are closed. Errors: InvalidInput, naming what is missing.
    virtual Result<void> complete(SwingId id) = 0;
    /// Complete → draft. Signatures given so far no longer hold once something is changed, and stay on the record.
    virtual Result<void> reopen(SwingId id, const std::string& reason) = 0;
    /// Adds a signature to a complete swing; its time and hash are filled in here. A performer's and an inspector's (or
    /// authority's) that hold freeze it. Errors: InvalidInput (not complete, no name), Frozen.
    virtual Result<void> sign(SwingId id, Signature signature) = 0;
    /// The signatures of a swing that hold: their hash is that of what the swing says now.
    virtual Result<std::vector<bool>> signaturesHold(SwingId id) = 0;
    /// A new draft that supersedes a signed swing, with its readings and particulars. Errors: InvalidInput (not signed,
    /// superseded already, no reason).
    virtual Result<SwingId> amend(SwingId id, const std::string& reason) = 0;
    virtual Result<std::vector<AuditRow>> auditOf(const RecordId& record) = 0; ///< oldest first

    /// Guided swings that are neither finished nor abandoned, newest first.
    virtual Result<std::vector<JobRow>> openJobs() = 0;
    /// The guided swing that belongs to this swing or made it, if any.
    virtual Result<std::optional<JobRecord>> jobOf(SwingId id) = 0;
    /// A new draft for the job, and the job with its first events; the particulars are those of the swing.
    virtual Result<SwingId> startJob(const Swing& particulars, const SwingJob& job) = 0;
    /// @param place how many events the caller knows. Errors: Conflict when there are more or fewer: another window has gone on
    /// with it.
    virtual Result<void> appendJobEvent(SwingId swing, std::size_t place, const JobEvent& event) = 0;
    /// The readings of the job's swing, and the other swings it made; the job is not open any more. All in one transaction.
    virtual Result<void> finishJob(SwingId swing, const Swing& asLeft, const std::vector<Swing>& others) = 0;
    virtual Result<void> abandonJob(SwingId swing) = 0; ///< its events stay; the draft stays

    virtual Result<std::vector<DatumInstrument>> instruments() = 0;   ///< by name
    virtual Result<void> save(const DatumInstrument& instrument) = 0; ///< known by its RecordId; a new one where that is empty
    virtual Result<void> removeInstrument(const RecordId& record) = 0;
    virtual Result<std::vector<DueRule>> dueRules() = 0; ///< by name
    virtual Result<void> save(const DueRule& rule) = 0;
    virtual Result<void> removeDueRule(const RecordId& record) = 0;
    virtual Result<std::vector<Waiver>> waiversOf(AircraftId aircraft) = 0; ///< newest first
    virtual Result<void> save(const Waiver& waiver) = 0;                    ///< new ones only: a waiver is not changed
    /// What the due rules look at, for every compass system of the fleet, by type, registration and compass.
    virtual Result<std::vector<DueCompass>> dueCompasses() = 0;
    virtual Result<std::vector<ElectricalSwing>> electricalSwingsOf(CompassId compass) = 0; ///< newest first
    virtual Result<void> save(CompassId compass, const ElectricalSwing& swing) = 0;

    virtual Result<Fleet> exportFleet(const std::vector<AircraftId>& aircraft, const Progress& progress) = 0; ///< none: all
    struct Imported {
        int aircraft = 0, swings = 0, alreadyThere = 0;
        std::vector<SwingId> swingIds;
    };
    /// New swings without a field stamp get one as above, unless they are signed.
    virtual Result<Imported> importFleet(const Fleet& fleet, const Progress& progress) = 0;

signals:
    void fleetChanged(); ///< the tree's structure changed
    void aircraftChanged(lubberline::AircraftId id);
    void swingChanged(lubberline::SwingId id);
    void sensorsChanged(lubberline::CompassId id);
    void sitesChanged(); ///< sites, instruments or limits profiles
    void dueChanged();   ///< rules, events, waivers or signatures: what is due may be other
    void electricalChanged(lubberline::CompassId id);
};

} // namespace lubberline::ui
