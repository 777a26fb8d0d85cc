#pragma once
/// The window's storage, bound to a database.

#include <memory>
#include <string>
#include <vector>

#include "db/Database.h"
#include "db/DueRepository.h"
#include "db/ElectricalRepository.h"
#include "db/FleetRepository.h"
#include "db/InstrumentRepository.h"
#include "db/JobRepository.h"
#include "db/SensorRepository.h"
#include "db/SigningRepository.h"
#include "db/SiteRepository.h"
#include "db/SwingRepository.h"
#include "ui/storage/Storage.h"

namespace lubberline::app {

class DbStorage : public ui::Storage {
    Q_OBJECT

public:
    explicit DbStorage(db::Database database);

    [[nodiscard]] db::Database& database() { return m_database; }
    /// By registration. Errors: NotFound.
    Result<AircraftId> aircraftNamed(const std::string& registration) { return m_fleet.aircraftNamed(registration); }
    /// By record id or the beginning of one. Errors: NotFound, Conflict.
    Result<SwingId> swingNamed(const std::string& beginning) { return m_swings.named(beginning); }
    Result<RecordId> recordOf(SwingId id);
    /// All of several fleets, or nothing.
    Result<Imported> importAll(const std::vector<Fleet>& fleets, const Progress& progress);

    [[nodiscard]] QString location() const override { return m_database.path(); }
    [[nodiscard]] bool readOnly() const override { return m_database.readOnly(); }
    Result<std::unique_ptr<ui::Storage>> openForWorker() const override;

    Result<Totals> totals() override { return m_fleet.totals(); }
    Result<std::vector<TypeRow>> types() override { return m_fleet.types(); }
    Result<std::vector<AircraftRow>> aircraftOf(AircraftTypeId type) override { return m_fleet.aircraftOf(type); }
    Result<std::vector<CompassRow>> compassesOf(AircraftId aircraft) override { return m_fleet.compassesOf(aircraft); }
    Result<std::vector<SwingRow>> swingsOf(CompassId compass) override { return m_swings.swingsOf(compass); }
    Result<std::vector<SearchHit>> search(const std::string& words, int limit) override { return m_fleet.search(words, limit); }

    Result<Aircraft> aircraft(AircraftId id) override { return m_fleet.aircraft(id); }
    Result<CompassSystem> compass(CompassId id) override { return m_fleet.compass(id); }
    Result<std::vector<Event>> eventsOf(AircraftId id) override { return m_fleet.eventsOf(id); }
    Result<std::vector<SensorRecord>> sensorsOf(CompassId compass) override { return m_sensors.sensorsOf(compass); }
    Result<SwingRecord> swingRecord(SwingId id) override { return m_swings.record(id); }
    Result<std::optional<Swing>> previousSwing(SwingId id) override { return m_swings.previous(id); }
    Result<std::vector<Site>> sites() override { return m_sites.sites(); }
    Result<std::vector<LimitsProfile>> limitsProfiles() override { return m_sites.limitsProfiles(); }

    Result<AircraftTypeId> save(const AircraftType& type) override;
    Result<AircraftId> save(const Aircraft& aircraft) override;
    Result<CompassId> save(const CompassSystem& compass) override;
    Result<SiteId> save(const Site& site) override;
    Result<LimitsProfileId> save(const LimitsProfile& profile) override;
    Result<EventId> save(const Event& event) override;
    Result<SwingId> saveParticulars(const Swing& swing) override;
    Result<void> changeParticulars(const Swing& before, const Swing& swing) override;
    Result<SensorModelId> save(const SensorRecord& sensor) override;
    Result<void> removeSensor(SensorModelId id) override;

    Result<void> removeSwing(SwingId id) override;
    Result<ReadingId> insertReading(SwingId swing, int position, const Reading& reading) override;
    Result<void> saveReading(SwingId swing, const Reading& known, const Reading& reading) override;
    Result<void> removeReading(SwingId swing, ReadingId reading) override;

    Result<void> complete(SwingId id) override { return announced(m_signing.complete(id), id); }
    Result<void> reopen(SwingId id, const std::string& reason) override { return announced(m_signing.reopen(id, reason), id); }
    Result<void> sign(SwingId id, Signature signature) override;
    Result<std::vector<bool>> signaturesHold(SwingId id) override { return m_signing.hold(id); }
    Result<SwingId> amend(SwingId id, const std::string& reason) override;
    Result<std::vector<AuditRow>> auditOf(const RecordId& record) override { return m_signing.auditOf(record); }

    Result<std::vector<JobRow>> openJobs() override { return m_jobs.open(); }
    Result<std::optional<JobRecord>> jobOf(SwingId id) override { return m_jobs.jobOf(id); }
    Result<SwingId> startJob(const Swing& particulars, const SwingJob& job) override;
    Result<void> appendJobEvent(SwingId swing, std::size_t place, const JobEvent& event) override
    {
        return m_jobs.append(swing, place, event);
    }
    Result<void> finishJob(SwingId swing, const Swing& asLeft, const std::vector<Swing>& others) override;
    Result<void> abandonJob(SwingId swing) override;

    Result<std::vector<DatumInstrument>> instruments() override { return m_instruments.instruments(); }
    Result<void> save(const DatumInstrument& instrument) override;
    Result<void> removeInstrument(const RecordId& record) override;
    Result<std::vector<DueRule>> dueRules() override { return m_due.rules(); }
    Result<void> save(const DueRule& rule) override;
    Result<void> removeDueRule(const RecordId& record) override;
    Result<std::vector<Waiver>> waiversOf(AircraftId aircraft) override { return m_due.waiversOf(aircraft); }
    Result<void> save(const Waiver& waiver) override;
    Result<std::vector<DueCompass>> dueCompasses() override { return m_due.compasses(); }
    Result<std::vector<ElectricalSwing>> electricalSwingsOf(CompassId compass) override { return m_electrical.of(compass); }
    Result<void> save(CompassId compass, const ElectricalSwing& swing) override;

    Result<Fleet> exportFleet(const std::vector<AircraftId>& aircraft, const Progress& progress) override;
    Result<Imported> importFleet(const Fleet& fleet, const Progress& progress) override;

private:
    Result<SwingId> addSwing(Swing swing);
    Result<void> announced(Result<void> done, SwingId id);
    Result<void> announcedDue(Result<void> done);

    db::Database m_database;
    db::DueRepository m_due;
    db::ElectricalRepository m_electrical;
    db::FleetRepository m_fleet;
    db::InstrumentRepository m_instruments;
    db::JobRepository m_jobs;
    db::SensorRepository m_sensors;
    db::SigningRepository m_signing;
    db::SiteRepository m_sites;
    db::SwingRepository m_swings;
};

/// Opens the database of `--db` (see databasePath()); a new one gets the shipped limits profiles.
Result<std::unique_ptr<DbStorage>> openStorage(const std::string& option, db::OpenMode mode);

} // namespace lubberline::app
