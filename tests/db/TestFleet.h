#pragma once
/// A small fleet for storage tests: one type, one aircraft, one compass with a 10° limit, one site.

#include <QTemporaryDir>

#include "core/record/Fleet.h"
#include "db/schema/Schema.h"
#include "db/stores/CoilStore.h"
#include "db/stores/DueStore.h"
#include "db/stores/ElectricalStore.h"
#include "db/stores/FleetStore.h"
#include "db/stores/SensorStore.h"
#include "db/stores/SiteStore.h"
#include "db/stores/SwingStore.h"

namespace lubberline::test {

inline constexpr int kSwingsAtOnce = 10; ///< in one transaction of the importing writer

/// Three axes up and down by themselves, ±60 000 nT: nothing but noise of 300 nT, nothing across.
inline CoilBench coilBenchOn(Date date)
{
    CoilBench bench;
    bench.date = date;
    bench.log = "bench.csv";
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const double at : {-60000., -30000., 0., 30000., 60000., 30000., 0., -30000.}) {
            std::array<double, 6> row{};
            row[axis] = at;
            row[axis + 3] = at + (bench.readings.size() % 3 == 0 ? 300 : -150);
            bench.readings.push_back(row);
        }
    return bench;
}

inline Reading reading(double magnetic_deg, double compass_deg)
{
    Reading result;
    result.magnetic = MagneticHeading::fromDegrees(magnetic_deg);
    result.compass = CompassHeading::fromDegrees(compass_deg);
    return result;
}

/// The check swing of the worksheet examples (QNSC PEWB), question 1: largest deviation 5°, A = 3°.
inline std::vector<Reading> worksheetReadings()
{
    return {reading(317, 316), reading(0, 358), reading(47, 42), reading(93, 89), reading(135, 134), reading(179, 177), reading(225, 220),
        reading(273, 269)};
}

/// A new record, or the changed one, whatever it was before.
inline Result<SwingId> save(db::SwingStore swings, const Swing& swing)
{
    if (!swing.id.valid())
        return swings.addAsIs(swing);
    const auto known = swings.swing(swing.id);
    if (!known)
        return known.error();
    const auto changed = swings.replace(*known, swing);
    return changed ? Result<SwingId>(swing.id) : changed.error();
}
inline Result<SensorModelId> save(db::SensorStore sensors, const SensorRecord& sensor)
{
    if (!sensor.id.valid())
        return sensors.add(sensor);
    const auto changed = sensors.change(*sensors.sensor(sensor.id), sensor);
    return changed ? Result<SensorModelId>(sensor.id) : changed.error();
}
inline Result<AircraftTypeId> save(db::FleetStore fleet, const AircraftType& type)
{
    if (!type.id.valid())
        return fleet.add(type);
    const auto changed = fleet.change(type, type);
    return changed ? Result<AircraftTypeId>(type.id) : changed.error();
}
inline Result<AircraftId> save(db::FleetStore fleet, const Aircraft& aircraft)
{
    if (!aircraft.id.valid())
        return fleet.add(aircraft);
    const auto changed = fleet.change(*fleet.aircraft(aircraft.id), aircraft);
    return changed ? Result<AircraftId>(aircraft.id) : changed.error();
}
inline Result<CompassId> save(db::FleetStore fleet, const CompassSystem& compass)
{
    if (!compass.id.valid())
        return fleet.add(compass);
    const auto changed = fleet.change(*fleet.compass(compass.id), compass);
    return changed ? Result<CompassId>(compass.id) : changed.error();
}
inline Result<EventId> save(db::FleetStore fleet, const Event& event) { return fleet.add(event); }
inline Result<SiteId> save(db::SiteStore sites, const Site& site)
{
    if (!site.id.valid())
        return sites.add(site);
    const auto changed = sites.change(**sites.site(site.id), site);
    return changed ? Result<SiteId>(site.id) : changed.error();
}
inline Result<LimitsProfileId> save(db::SiteStore sites, const LimitsProfile& profile)
{
    const auto all = *sites.limitsProfiles();
    for (const auto& known : all)
        if (known.id == profile.id) {
            const auto changed = sites.change(known, profile);
            return changed ? Result<LimitsProfileId>(profile.id) : changed.error();
        }
    return sites.add(profile);
}
inline Result<void> save(db::SiteStore sites, const DatumInstrument& instrument)
{
    const auto all = *sites.instruments();
    for (const auto& known : all)
        if (known.record == instrument.record)
            return sites.change(known, instrument);
    return noValue(sites.add(instrument));
}
inline Result<void> save(db::DueStore due, const DueRule& rule) { return noValue(due.add(rule)); }
inline Result<void> save(db::DueStore due, const Waiver& waiver) { return due.add(waiver); }
inline Result<void> save(db::ElectricalStore electrical, CompassId compass, const ElectricalSwing& swing)
{
    const auto all = *electrical.of(compass);
    for (const auto& known : all)
        if (known.record == swing.record)
            return electrical.change(compass, known, swing);
    return noValue(electrical.add(compass, swing));
}

struct Stored {
    AircraftTypeId type;
    AircraftId aircraft;
    LimitsProfileId limits;
    SiteId site;
    CompassId compass;
};

inline db::Database inMemory()
{
    auto database = db::openDatabase(":memory:", db::OpenMode::ReadWriteCreate);
    LUBBERLINE_EXPECT(database.ok(), "a database in memory opens");
    return std::move(database.value());
}

inline Stored store(db::Database& database)
{
    db::FleetStore fleet(database);
    db::SiteStore sites(database);
    Stored stored;
    stored.type = save(fleet, AircraftType{{}, {}, "Su-22", "Sukhoi", ""}).value();
    Aircraft aircraft;
    aircraft.type = stored.type;
    aircraft.registration = "3713";
    stored.aircraft = save(fleet, aircraft).value();
    LimitsProfile limits;
    limits.name = "ten degrees";
    limits.maxDeviation_deg = 10.0;
    stored.limits = save(sites, limits).value();
    Site site;
    site.name = "Deblin";
    site.variation_deg = 6.5;
    stored.site = save(sites, site).value();
    CompassSystem compass;
    compass.aircraft = stored.aircraft;
    compass.name = "standby compass";
    compass.limits = stored.limits;
    stored.compass = save(fleet, compass).value();
    return stored;
}

inline Swing swingOf(const Stored& stored, Date date = "2026-11-20")
{
    Swing swing;
    swing.compass = stored.compass;
    swing.site = stored.site;
    swing.date = date;
    swing.readings = worksheetReadings();
    return swing;
}

inline FieldStamp stampOf(Date date) { return {"WMM2025", {51.55, 21.89, 117.0}, date, {18879.125, 2311.0625, 0.1 + 0.2}}; }

inline SensorRecord sensorOf(const Stored& stored, const std::string& name = "as entered")
{
    SensorRecord sensor;
    sensor.compass = stored.compass;
    sensor.name = name;
    sensor.note = "by hand";
    sensor.model.softIron(0, 2) = 1.0 / 3.0;
    sensor.model.hardIron_nT = {850, -420, 0.1};
    sensor.model.circuits = {{"landing light", {12.5, -3, 0}, 10, true}};
    return sensor;
}

} // namespace lubberline::test
