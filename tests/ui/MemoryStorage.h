#pragma once
/// Storage in memory for tests of the window: it counts what it is asked, and refuses when it is told to.

#include <QThread>

#include <algorithm>
#include <map>
#include <utility>

#include "core/format/csv/SwingCsv.h"
#include "core/format/exchange/SignedContent.h"
#include "core/record/Completeness.h"
#include "core/swing/Analysis.h"
#include "core/swing/Observations.h"
#include "core/swing/SwingField.h"
#include "ui/storage/Storage.h"

namespace lubberline::ui {

/// The records, shared between the window's storage and that of a worker.
struct MemoryFleet {
    std::vector<AircraftType> types;
    std::vector<Aircraft> aircraft;
    std::vector<CompassSystem> compasses;
    std::vector<SensorRecord> sensors;
    std::vector<Event> events;
    std::vector<Site> sites;
    std::vector<LimitsProfile> limits;
    std::vector<Swing> swings;
    struct Job {
        JobRecord record;
        bool open = true;
    };
    std::vector<Job> jobs;
    std::vector<DatumInstrument> instruments;
    std::vector<DueRule> dueRules;
    std::vector<Waiver> waivers;
    std::vector<ElectricalRecord> electrical;
    std::map<RecordId, std::vector<AuditRow>> audit;
    std::int64_t lastId = 0;
};

class MemoryStorage : public Storage {
public:
    MemoryStorage() : m_fleet(std::make_shared<MemoryFleet>()) {}

    bool refuseWrites = false; ///< as a full disk does
    bool isReadOnly = false;
    int importDelay_ms = 0; ///< between the steps of an import
    std::map<std::string, int> asked;
    MemoryFleet& fleet() { return *m_fleet; }

    QString location() const override { return QStringLiteral("memory.lubberline"); }
    bool readOnly() const override { return isReadOnly; }
    Result<std::unique_ptr<Storage>> openForWorker() const override
    {
        auto worker = std::make_unique<MemoryStorage>();
        worker->m_fleet = m_fleet;
        worker->isReadOnly = isReadOnly;
        worker->refuseWrites = refuseWrites;
        worker->importDelay_ms = importDelay_ms;
        return std::unique_ptr<Storage>(std::move(worker));
    }

    Result<Totals> totals() override
    {
        return Totals{int(m_fleet->types.size()), int(m_fleet->aircraft.size()), int(m_fleet->compasses.size()),
            std::int64_t(m_fleet->swings.size())};
    }
    Result<std::vector<TypeRow>> types() override
    {
        ++asked["types"];
        std::vector<TypeRow> rows;
        for (const auto& type : m_fleet->types) {
            TypeRow row{type.id, type.name, 0, Status::NotKnown};
            for (const auto& one : m_fleet->aircraft)
                if (one.type == type.id) {
                    ++row.aircraft;
                    row.status = std::max(row.status, statusOf(one.id));
                }
            rows.push_back(row);
        }
        return rows;
    }
    Result<std::vector<AircraftRow>> aircraftOf(AircraftTypeId type) override
    {
        ++asked["aircraft"];
        std::vector<AircraftRow> rows;
        for (const auto& one : m_fleet->aircraft)
            if (one.type == type)
                rows.push_back({one.id, type, one.registration, one.demonstration, statusOf(one.id)});
        return rows;
    }
    Result<std::vector<CompassRow>> compassesOf(AircraftId aircraft) override
    {
        ++asked["compasses"];
        std::vector<CompassRow> rows;
        for (const auto& compass : m_fleet->compasses)
            if (compass.aircraft == aircraft)
                rows.push_back({compass.id, aircraft, compass.name, int(of(compass.id).size()), statusOf(compass.id)});
        return rows;
    }
    Result<std::vector<SwingRow>> swingsOf(CompassId compass) override
    {
        ++asked["swings"];
        std::vector<SwingRow> rows;
        for (const Swing* swing : of(compass))
            rows.push_back(rowOf(*swing));
        return rows;
    }
    Result<std::vector<SearchHit>> search(const std::string& words, int limit) override
    {
        std::vector<SearchHit> hits;
        for (const auto& one : m_fleet->aircraft)
            if (one.registration.find(words) != std::string::npos && int(hits.size()) < limit)
                hits.push_back({one.registration, one.id, {}, {}});
        return hits;
    }

    Result<Aircraft> aircraft(AircraftId id) override { return find(m_fleet->aircraft, id, "aircraft"); }
    Result<CompassSystem> compass(CompassId id) override { return find(m_fleet->compasses, id, "compass"); }
    Result<std::vector<Event>> eventsOf(AircraftId id) override
    {
        std::vector<Event> events;
        std::copy_if(m_fleet->events.begin(), m_fleet->events.end(), std::back_inserter(events),
            [id](const Event& event) { return event.aircraft == id; });
        return events;
    }
    Result<std::vector<SensorRecord>> sensorsOf(CompassId compass) override
    {
        std::vector<SensorRecord> sensors;
        std::copy_if(m_fleet->sensors.rbegin(), m_fleet->sensors.rend(), std::back_inserter(sensors),
            [compass](const SensorRecord& sensor) { return sensor.compass == compass; });
        return sensors;
    }
    Result<SwingRecord> swingRecord(SwingId id) override
    {
        auto swing = find(m_fleet->swings, id, "swing");
        if (!swing)
            return swing.error();
        SwingRecord record;
        record.swing = *swing;
        record.compass = *compass(swing->compass);
        record.aircraft = *aircraft(record.compass.aircraft);
        record.type = *find(m_fleet->types, record.aircraft.type, "type");
        if (auto site = find(m_fleet->sites, swing->site, "site"))
            record.site = *site;
        if (auto limits = find(m_fleet->limits, record.compass.limits, "limits"))
            record.limits = *limits;
        return record;
    }
    Result<std::optional<Swing>> previousSwing(SwingId id) override
    {
        const auto swing = find(m_fleet->swings, id, "swing");
        if (!swing)
            return swing.error();
        for (const Swing* other : of(swing->compass))
            if (other->date < swing->date)
                return std::optional<Swing>(*other);
        return std::optional<Swing>();
    }
    Result<std::vector<Site>> sites() override { return m_fleet->sites; }
    Result<std::vector<LimitsProfile>> limitsProfiles() override { return m_fleet->limits; }

    Result<AircraftTypeId> save(const AircraftType& type) override { return told(put(m_fleet->types, type)); }
    Result<AircraftId> save(const Aircraft& aircraft) override
    {
        const auto id = told(put(m_fleet->aircraft, aircraft));
        if (id)
            emit aircraftChanged(*id);
        return id;
    }
    Result<CompassId> save(const CompassSystem& compass) override
    {
        const auto id = told(put(m_fleet->compasses, compass));
        if (id)
            emit aircraftChanged(compass.aircraft);
        return id;
    }
    Result<SiteId> save(const Site& site) override
    {
        const auto id = put(m_fleet->sites, site);
        if (id)
            emit sitesChanged();
        return id;
    }
    Result<LimitsProfileId> save(const LimitsProfile& profile) override { return told(put(m_fleet->limits, profile)); }
    Result<EventId> save(const Event& event) override
    {
        const auto id = put(m_fleet->events, event);
        if (id) {
            emit aircraftChanged(event.aircraft);
            emit dueChanged();
        }
        return id;
    }
    Result<SwingId> saveParticulars(const Swing& swing) override
    {
        if (const auto refused = refusal())
            return *refused;
        const bool known = swing.id.valid();
        Swing stored = swing;
        if (known)
            stored.readings = swingAt(swing.id)->readings;
        else if (const auto site = find(m_fleet->sites, swing.site, "site"); site && !swing.field && swing.state != SwingState::Signed)
            stored.field = stampFor(swing, *site);
        for (Reading& reading : stored.readings)
            if (!known)
                reading.id = {++m_fleet->lastId};
        const auto id = put(m_fleet->swings, stored);
        if (!known)
            emit fleetChanged();
        emit swingChanged(*id);
        return id;
    }

    Result<void> changeParticulars(const Swing& before, const Swing& swing) override
    {
        Swing known = before, stored = *swingAt(swing.id);
        known.readings = stored.readings = {};
        known.signatures = stored.signatures = {};
        if (known != stored)
            return Error{ErrorCode::Conflict, "the particulars of this swing have been changed elsewhere; nothing was overwritten"};
        const auto done = saveParticulars(swing);
        return done ? Result<void>() : done.error();
    }

    Result<void> complete(SwingId id) override
    {
        Swing& swing = *swingAt(id);
        if (const std::string missing = missingIn(swing); !missing.empty())
            return Error{ErrorCode::InvalidInput, "the swing is not complete: " + missing};
        return setState(swing, SwingState::Complete, "completed swing", {});
    }
    Result<void> reopen(SwingId id, const std::string& reason) override
    {
        Swing& swing = *swingAt(id);
        if (swing.state == SwingState::Signed)
            return Error{ErrorCode::Frozen, "the swing is signed and frozen"};
        if (reason.empty())
            return Error{ErrorCode::InvalidInput, "the reason is empty; expected why a complete swing is opened again"};
        return setState(swing, SwingState::Draft, "reopened swing", reason);
    }
    /// The hash is a stand-in: as many digits, and another one when the contents are others.
    Result<void> sign(SwingId id, Signature signature) override
    {
        Swing& swing = *swingAt(id);
        if (const auto refused = refusal())
            return *refused;
        if (swing.state == SwingState::Draft)
            return Error{ErrorCode::InvalidInput, "the swing is a draft; expected a complete one"};
        if (signature.name.empty())
            return Error{ErrorCode::InvalidInput, "the name is empty; expected who signs"};
        signature.timeUtc = "2026-11-23T12:00:00Z";
        signature.hash = standIn(id);
        swing.signatures.push_back(signature);
        const auto given = [&](SignatureRole role) {
            return std::any_of(swing.signatures.begin(), swing.signatures.end(),
                [&](const Signature& one) { return one.role == role && one.hash == signature.hash; });
        };
        const bool decided = given(SignatureRole::Performer) && (given(SignatureRole::Inspector) || given(SignatureRole::Authority));
        const auto done = setState(swing, decided ? SwingState::Signed : swing.state, "signed swing", signature.name);
        emit dueChanged();
        return done;
    }
    Result<std::vector<bool>> signaturesHold(SwingId id) override
    {
        std::vector<bool> hold;
        for (const auto& one : swingAt(id)->signatures)
            hold.push_back(one.hash == standIn(id));
        return hold;
    }
    Result<SwingId> amend(SwingId id, const std::string& reason) override
    {
        Swing swing = *swingAt(id);
        if (swing.state != SwingState::Signed)
            return Error{ErrorCode::InvalidInput, "the swing is not signed; expected a signed one"};
        if (reason.empty())
            return Error{ErrorCode::InvalidInput, "the reason is empty; expected why the signed swing is amended"};
        for (const Swing& other : m_fleet->swings)
            if (other.supersedes == swing.record)
                return Error{ErrorCode::Conflict, "the swing is amended already"};
        swing.supersedes = std::exchange(swing.record, {});
        swing.id = {};
        swing.state = SwingState::Draft;
        swing.amendment = reason;
        ++swing.revision;
        swing.signatures.clear();
        return told(saveParticulars(swing));
    }
    Result<std::vector<AuditRow>> auditOf(const RecordId& record) override { return m_fleet->audit[record]; }

    Result<std::vector<JobRow>> openJobs() override
    {
        std::vector<JobRow> rows;
        for (auto job = m_fleet->jobs.rbegin(); job != m_fleet->jobs.rend(); ++job)
            if (job->open) {
                const auto record = *swingRecord(job->record.swing);
                rows.push_back({job->record.swing, job->record.job.record, record.aircraft.registration, record.compass.name,
                    record.swing.date, int(job->record.job.events.size())});
            }
        return rows;
    }
    Result<std::optional<JobRecord>> jobOf(SwingId id) override
    {
        const Swing& swing = *swingAt(id);
        for (const auto& job : m_fleet->jobs)
            if (job.record.swing == id || (!swing.job.empty() && job.record.job.record == swing.job)) {
                JobRecord found = job.record;
                found.job.particulars = *swingAt(found.swing);
                found.job.particulars.readings.clear();
                return std::optional(found);
            }
        return std::optional<JobRecord>();
    }
    Result<SwingId> startJob(const Swing& particulars, const SwingJob& job) override
    {
        Swing swing = particulars;
        swing.job = job.record.empty() ? newRecordId() : job.record;
        const auto id = saveParticulars(swing);
        if (!id)
            return id;
        SwingJob stored = job;
        stored.record = swing.job;
        m_fleet->jobs.push_back({{*id, stored}, true});
        emit fleetChanged();
        return id;
    }
    Result<void> appendJobEvent(SwingId swing, std::size_t place, const JobEvent& event) override
    {
        if (const auto refused = refusal())
            return *refused;
        auto& job = jobAt(swing);
        if (!job.open)
            return Error{ErrorCode::Frozen, "the guided swing is finished"};
        if (job.record.job.events.size() != place)
            return Error{ErrorCode::Conflict, "this guided swing has gone on in another window"};
        job.record.job.events.push_back(event);
        return {};
    }
    Result<void> finishJob(SwingId swing, const Swing& asLeft, const std::vector<Swing>& others) override
    {
        if (const auto refused = refusal())
            return *refused;
        Swing& own = *swingAt(swing);
        const Swing before = own;
        own = asLeft;
        own.id = swing;
        own.record = before.record;
        own.compass = before.compass;
        own.job = before.job;
        for (Reading& reading : own.readings)
            reading.id = {++m_fleet->lastId};
        jobAt(swing).open = false;
        for (Swing other : others) {
            other.id = {};
            other.compass = before.compass;
            other.job = before.job;
            static_cast<void>(saveParticulars(other));
        }
        emit swingChanged(swing);
        emit fleetChanged();
        return {};
    }
    Result<void> abandonJob(SwingId swing) override
    {
        jobAt(swing).open = false;
        emit fleetChanged();
        return {};
    }

    Result<std::vector<DatumInstrument>> instruments() override { return m_fleet->instruments; }
    Result<void> save(const DatumInstrument& instrument) override
    {
        return keep(m_fleet->instruments, instrument, [this] { emit sitesChanged(); });
    }
    Result<void> removeInstrument(const RecordId& record) override
    {
        std::erase_if(m_fleet->instruments, [&](const DatumInstrument& one) { return one.record == record; });
        emit sitesChanged();
        return {};
    }
    Result<std::vector<DueRule>> dueRules() override { return m_fleet->dueRules; }
    Result<void> save(const DueRule& rule) override
    {
        return keep(m_fleet->dueRules, rule, [this] { emit dueChanged(); });
    }
    Result<void> removeDueRule(const RecordId& record) override
    {
        std::erase_if(m_fleet->dueRules, [&](const DueRule& one) { return one.record == record; });
        emit dueChanged();
        return {};
    }
    Result<std::vector<Waiver>> waiversOf(AircraftId aircraft) override
    {
        std::vector<Waiver> waivers;
        for (const auto& one : m_fleet->waivers)
            for (const auto& event : m_fleet->events)
                if (event.record == one.event && event.aircraft == aircraft)
                    waivers.push_back(one);
        return waivers;
    }
    Result<void> save(const Waiver& waiver) override
    {
        return keep(m_fleet->waivers, waiver, [this] { emit dueChanged(); });
    }
    Result<std::vector<DueCompass>> dueCompasses() override
    {
        ++asked["due"];
        std::vector<DueCompass> rows;
        for (const auto& compass : m_fleet->compasses) {
            const auto owner = *aircraft(compass.aircraft);
            const auto type = *find(m_fleet->types, owner.type, "type");
            DueCompass row{type.id, owner.id, compass.id, type.record, compass.record, type.name, owner.registration, compass.name,
                compass.installed, owner.base, {}, *eventsOf(owner.id), *waiversOf(owner.id)};
            for (const Swing* swing : of(compass.id))
                if (swing->state == SwingState::Signed)
                    row.signedSwings.push_back(swing->date);
            rows.push_back(row);
        }
        return rows;
    }
    Result<std::vector<ElectricalSwing>> electricalSwingsOf(CompassId compass) override
    {
        std::vector<ElectricalSwing> swings;
        for (auto one = m_fleet->electrical.rbegin(); one != m_fleet->electrical.rend(); ++one)
            if (one->compass == compass)
                swings.push_back(one->swing);
        return swings;
    }
    Result<void> save(CompassId compass, const ElectricalSwing& swing) override
    {
        if (const auto refused = refusal())
            return *refused;
        for (auto& one : m_fleet->electrical)
            if (one.swing.record == swing.record) {
                one.swing = swing;
                emit electricalChanged(compass);
                return {};
            }
        m_fleet->electrical.push_back({compass, swing});
        if (swing.record.empty())
            m_fleet->electrical.back().swing.record = newRecordId();
        emit electricalChanged(compass);
        return {};
    }

    Result<SensorModelId> save(const SensorRecord& sensor) override
    {
        const auto id = put(m_fleet->sensors, sensor);
        if (id)
            emit sensorsChanged(sensor.compass);
        return id;
    }
    Result<void> removeSensor(SensorModelId id) override
    {
        if (const auto refused = refusal())
            return *refused;
        const auto sensor = find(m_fleet->sensors, id, "sensor model");
        if (!sensor)
            return sensor.error();
        std::erase_if(m_fleet->sensors, [id](const SensorRecord& one) { return one.id == id; });
        emit sensorsChanged(sensor->compass);
        return {};
    }

    Result<void> removeSwing(SwingId id) override
    {
        if (const auto refused = refusal())
            return *refused;
        std::erase_if(m_fleet->swings, [id](const Swing& swing) { return swing.id == id; });
        emit fleetChanged();
        return {};
    }
    Result<ReadingId> insertReading(SwingId swing, int position, const Reading& reading) override
    {
        if (const auto refused = refusal())
            return *refused;
        Reading stored = reading;
        stored.id = {++m_fleet->lastId};
        auto& readings = swingAt(swing)->readings;
        readings.insert(readings.begin() + position, stored);
        emit swingChanged(swing);
        return stored.id;
    }
    Result<void> saveReading(SwingId swing, const Reading& before, const Reading& reading) override
    {
        if (const auto refused = refusal())
            return *refused;
        for (Reading& one : swingAt(swing)->readings)
            if (one.id == reading.id) {
                if (one != before && one != reading)
                    return Error{ErrorCode::Conflict, "this reading has been changed elsewhere; nothing was overwritten"};
                one = reading;
                emit swingChanged(swing);
                return {};
            }
        return Error{ErrorCode::NotFound, "there is no such reading any more"};
    }
    Result<void> removeReading(SwingId swing, ReadingId reading) override
    {
        if (const auto refused = refusal())
            return *refused;
        if (std::erase_if(swingAt(swing)->readings, [reading](const Reading& one) { return one.id == reading; }) == 0)
            return Error{ErrorCode::NotFound, "there is no such reading any more"};
        emit swingChanged(swing);
        return {};
    }

    Result<Fleet> exportFleet(const std::vector<AircraftId>&, const Progress&) override
    {
        return toFleet(*swingRecord(m_fleet->swings.front().id));
    }
    /// Adds everything as new records.
    Result<Imported> importFleet(const Fleet& fleet, const Progress& progress) override
    {
        if (const auto refused = refusal())
            return *refused;
        for (int step = 0; step < 10; ++step) {
            QThread::msleep(static_cast<unsigned long>(importDelay_ms));
            if (progress && !progress(step / 10.0))
                return Error{ErrorCode::Cancelled, "cancelled"};
        }
        return add(fleet);
    }

private:
    /// Known by its RecordId.
    template <class Record, class Tell>
    Result<void> keep(std::vector<Record>& records, Record record, Tell tell)
    {
        if (const auto refused = refusal())
            return *refused;
        if (record.record.empty())
            record.record = newRecordId();
        const auto found = std::find_if(records.begin(), records.end(), [&](const Record& one) { return one.record == record.record; });
        if (found == records.end())
            records.push_back(record);
        else
            *found = record;
        tell();
        return {};
    }
    Result<void> setState(Swing& swing, SwingState state, const char* what, const std::string& detail)
    {
        if (const auto refused = refusal())
            return *refused;
        swing.state = state;
        m_fleet->audit[swing.record].push_back({"2026-11-23T12:00:00Z", what, detail});
        emit swingChanged(swing.id);
        emit fleetChanged();
        return {};
    }
    std::string standIn(SwingId id)
    {
        const auto record = *swingRecord(id);
        std::string digits = std::to_string(std::hash<std::string>{}(signedContent(record, std::nullopt)));
        digits.resize(64, '0');
        return digits;
    }
    MemoryFleet::Job& jobAt(SwingId swing)
    {
        return *std::find_if(
            m_fleet->jobs.begin(), m_fleet->jobs.end(), [&](const MemoryFleet::Job& one) { return one.record.swing == swing; });
    }
    std::optional<Error> refusal() const
    {
        if (isReadOnly)
            return Error{ErrorCode::ReadOnly, "the database can only be read"};
        if (refuseWrites)
            return Error{ErrorCode::Full, "the disk is full; nothing was changed"};
        return std::nullopt;
    }
    template <class Record, class IdType>
    static Result<Record> find(const std::vector<Record>& records, IdType id, const char* what)
    {
        const auto found = std::find_if(records.begin(), records.end(), [id](const Record& record) { return record.id == id; });
        if (found == records.end())
            return Error{ErrorCode::NotFound, std::string("there is no such ") + what};
        return *found;
    }
    template <class Record>
    auto put(std::vector<Record>& records, Record record) -> Result<decltype(record.id)>
    {
        if (const auto refused = refusal())
            return *refused;
        if (record.id.valid()) {
            *std::find_if(records.begin(), records.end(), [&record](const Record& one) { return one.id == record.id; }) = record;
            return record.id;
        }
        record.id = {++m_fleet->lastId};
        if (record.record.empty())
            record.record = newRecordId();
        records.push_back(record);
        return record.id;
    }
    template <class T>
    Result<T> told(Result<T> id)
    {
        if (id)
            emit fleetChanged();
        return id;
    }
    Swing* swingAt(SwingId id)
    {
        return &*std::find_if(m_fleet->swings.begin(), m_fleet->swings.end(), [id](const Swing& swing) { return swing.id == id; });
    }
    std::vector<const Swing*> of(CompassId compass) const
    {
        std::vector<const Swing*> swings;
        for (const Swing& swing : m_fleet->swings)
            if (swing.compass == compass)
                swings.push_back(&swing);
        std::stable_sort(swings.begin(), swings.end(), [](const Swing* a, const Swing* b) { return a->date > b->date; });
        return swings;
    }
    SwingRow rowOf(const Swing& swing) const
    {
        SwingRow row;
        row.id = swing.id;
        row.compass = swing.compass;
        row.date = swing.date;
        row.kind = swing.kind;
        row.stage = swing.stage;
        row.state = swing.state;
        row.readings = int(swing.readings.size());
        const auto analysis = analyse(observationsOf(swing));
        if (!analysis)
            return row;
        row.maxAbsDeviation_deg = toDegrees(analysis->summary.maxAbsDeviation_rad);
        for (std::size_t i = 0; i < kCoefficientCount; ++i)
            if (analysis->approximate.value[i])
                row.coefficient_deg[i] = toDegrees(*analysis->approximate.value[i]);
        row.status = judged(analysis->summary, swing.compass);
        return row;
    }
    Status judged(const Summary& summary, CompassId compass) const
    {
        const auto system = find(m_fleet->compasses, compass, "compass");
        const auto limits = find(m_fleet->limits, system->limits, "limits");
        const auto verdict = judge(summary, limits ? std::optional(*limits) : std::nullopt).verdict;
        return verdict == Verdict::InLimits ? Status::InLimits : verdict == Verdict::OutOfLimits ? Status::OutOfLimits : Status::NotKnown;
    }
    Status statusOf(CompassId compass) const
    {
        const auto swings = of(compass);
        return swings.empty() ? Status::NotKnown : rowOf(*swings.front()).status;
    }
    Status statusOf(AircraftId aircraft) const
    {
        Status worst = Status::NotKnown;
        for (const auto& compass : m_fleet->compasses)
            if (compass.aircraft == aircraft)
                worst = std::max(worst, statusOf(compass.id));
        return worst;
    }
    Imported add(const Fleet& fleet)
    {
        Imported imported;
        std::map<AircraftTypeId, AircraftTypeId> types;
        std::map<AircraftId, AircraftId> aircraft;
        std::map<CompassId, CompassId> compasses;
        for (AircraftType type : fleet.types) {
            const auto old = std::exchange(type.id, {});
            types[old] = *put(m_fleet->types, type);
        }
        for (Aircraft one : fleet.aircraft) {
            const auto old = std::exchange(one.id, {});
            one.type = types[one.type];
            aircraft[old] = *put(m_fleet->aircraft, one);
            ++imported.aircraft;
        }
        for (CompassSystem compass : fleet.compasses) {
            const auto old = std::exchange(compass.id, {});
            compass.aircraft = aircraft[compass.aircraft];
            compass.limits = {};
            compasses[old] = *put(m_fleet->compasses, compass);
        }
        for (SensorRecord sensor : fleet.sensors) {
            sensor.id = {};
            sensor.compass = compasses[sensor.compass];
            static_cast<void>(put(m_fleet->sensors, sensor));
        }
        for (Swing swing : fleet.swings) {
            swing.id = {};
            swing.site = {};
            swing.compass = compasses[swing.compass];
            for (Reading& reading : swing.readings)
                reading.id = {++m_fleet->lastId};
            imported.swingIds.push_back(*put(m_fleet->swings, swing));
            ++imported.swings;
        }
        return imported;
    }

    std::shared_ptr<MemoryFleet> m_fleet;
};

} // namespace lubberline::ui
