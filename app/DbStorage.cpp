#include "app/DbStorage.h"

#include "app/Paths.h"
#include "core/swing/SwingField.h"
#include "db/Transaction.h"
#include "db/Transfer.h"

namespace lubberline::app {

namespace {

ui::Storage::Imported toUi(const db::Imported& imported)
{
    return {imported.aircraft, imported.swings, imported.alreadyThere, imported.swingIds};
}

/// What a swing that comes in without a field stamp is given; what was signed without one stays so.
void stampUnlessSigned(Swing& swing, const std::optional<Site>& site)
{
    if (!swing.field && swing.state != SwingState::Signed)
        swing.field = stampFor(swing, site);
}

/// A database without any limits profile is new: it gets those whose source was read.
Result<void> addShippedLimits(DbStorage& storage)
{
    const auto profiles = storage.limitsProfiles();
    if (!profiles)
        return profiles.error();
    if (!profiles->empty() || storage.readOnly())
        return {};
    auto transaction = db::Transaction::begin(storage.database());
    if (!transaction)
        return transaction.error();
    for (const auto& profile : shippedLimitsProfiles())
        if (const auto saved = storage.save(profile); !saved)
            return saved.error();
    return transaction->commit();
}

} // namespace

DbStorage::DbStorage(db::Database database)
    : m_database(std::move(database))
    , m_due(m_database)
    , m_electrical(m_database)
    , m_fleet(m_database)
    , m_instruments(m_database)
    , m_jobs(m_database)
    , m_sensors(m_database)
    , m_signing(m_database)
    , m_sites(m_database)
    , m_swings(m_database)
{
}

Result<RecordId> DbStorage::recordOf(SwingId id)
{
    const auto swing = m_swings.swing(id);
    if (!swing)
        return swing.error();
    return swing->record;
}

Result<ui::Storage::Imported> DbStorage::importAll(const std::vector<Fleet>& fleets, const Progress& progress)
{
    auto transaction = db::Transaction::begin(m_database);
    if (!transaction)
        return transaction.error();
    Imported all;
    for (const auto& fleet : fleets) {
        const auto one = db::importFleet(m_database, fleet, progress, stampUnlessSigned);
        if (!one)
            return one.error();
        all.aircraft += one->aircraft;
        all.swings += one->swings;
        all.alreadyThere += one->alreadyThere;
        all.swingIds.insert(all.swingIds.end(), one->swingIds.begin(), one->swingIds.end());
    }
    if (const auto committed = transaction->commit(); !committed)
        return committed.error();
    emit fleetChanged();
    return all;
}

Result<std::unique_ptr<ui::Storage>> DbStorage::openForWorker() const
{
    auto database = db::Database::open(m_database.path(), m_database.readOnly() ? db::OpenMode::ReadOnly : db::OpenMode::ReadWriteCreate);
    if (!database)
        return database.error();
    return std::unique_ptr<ui::Storage>(std::make_unique<DbStorage>(std::move(database.value())));
}

Result<AircraftTypeId> DbStorage::save(const AircraftType& type)
{
    const auto id = m_fleet.save(type);
    if (id)
        emit fleetChanged();
    return id;
}

Result<AircraftId> DbStorage::save(const Aircraft& aircraft)
{
    const auto id = m_fleet.save(aircraft);
    if (id) {
        emit fleetChanged();
        emit aircraftChanged(*id);
    }
    return id;
}

Result<CompassId> DbStorage::save(const CompassSystem& compass)
{
    const auto id = m_fleet.save(compass);
    if (id) {
        emit fleetChanged();
        emit aircraftChanged(compass.aircraft);
    }
    return id;
}

Result<SiteId> DbStorage::save(const Site& site)
{
    const auto id = m_sites.save(site);
    if (id)
        emit sitesChanged();
    return id;
}

Result<LimitsProfileId> DbStorage::save(const LimitsProfile& profile)
{
    const auto id = m_sites.save(profile);
    if (id)
        emit fleetChanged();
    return id;
}

Result<EventId> DbStorage::save(const Event& event)
{
    const auto id = m_fleet.save(event);
    if (id) {
        emit aircraftChanged(event.aircraft);
        emit dueChanged();
    }
    return id;
}

Result<SwingId> DbStorage::saveParticulars(const Swing& swing)
{
    const auto id = swing.id.valid() ? m_swings.save(swing) : addSwing(swing);
    if (!id)
        return id;
    if (!swing.id.valid())
        emit fleetChanged();
    emit swingChanged(*id);
    return id;
}

Result<void> DbStorage::changeParticulars(const Swing& before, const Swing& swing)
{
    const auto done = m_swings.changeFrom(before, swing);
    if (done)
        emit swingChanged(swing.id);
    return done;
}

Result<SwingId> DbStorage::addSwing(Swing swing)
{
    const auto site = m_sites.site(swing.site);
    if (!site)
        return site.error();
    stampUnlessSigned(swing, *site);
    return m_swings.save(swing);
}

Result<SensorModelId> DbStorage::save(const SensorRecord& sensor)
{
    const auto id = m_sensors.save(sensor);
    if (id)
        emit sensorsChanged(sensor.compass);
    return id;
}

Result<void> DbStorage::removeSensor(SensorModelId id)
{
    const auto sensor = m_sensors.sensor(id);
    if (!sensor)
        return sensor.error();
    const auto done = m_sensors.remove(id);
    if (done)
        emit sensorsChanged(sensor->compass);
    return done;
}

Result<void> DbStorage::removeSwing(SwingId id)
{
    const auto done = m_swings.remove(id);
    if (done)
        emit fleetChanged();
    return done;
}

Result<ReadingId> DbStorage::insertReading(SwingId swing, int position, const Reading& reading)
{
    const auto id = m_swings.insertReading(swing, position, reading);
    if (id)
        emit swingChanged(swing);
    return id;
}

Result<void> DbStorage::saveReading(SwingId swing, const Reading& known, const Reading& reading)
{
    const auto done = m_swings.saveReading(swing, known, reading);
    if (done)
        emit swingChanged(swing);
    return done;
}

Result<void> DbStorage::removeReading(SwingId swing, ReadingId reading)
{
    const auto done = m_swings.removeReading(swing, reading);
    if (done)
        emit swingChanged(swing);
    return done;
}

Result<Fleet> DbStorage::exportFleet(const std::vector<AircraftId>& aircraft, const Progress& progress)
{
    return db::exportFleet(m_database, aircraft, progress);
}

Result<ui::Storage::Imported> DbStorage::importFleet(const Fleet& fleet, const Progress& progress)
{
    const auto imported = db::importFleet(m_database, fleet, progress, stampUnlessSigned);
    if (!imported)
        return imported.error();
    emit fleetChanged();
    return toUi(*imported);
}

Result<std::unique_ptr<DbStorage>> openStorage(const std::string& option, db::OpenMode mode)
{
    const auto path = databasePath(option);
    if (!path)
        return path.error();
    auto database = db::Database::open(*path, mode);
    if (!database)
        return database.error();
    auto storage = std::make_unique<DbStorage>(std::move(database.value()));
    if (const auto added = addShippedLimits(*storage); !added)
        return added.error();
    return storage;
}

} // namespace lubberline::app
