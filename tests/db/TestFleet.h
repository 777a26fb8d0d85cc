#pragma once
/// A small fleet for storage tests: one type, one aircraft, one compass with a 10° limit, one site.

#include <QTemporaryDir>

#include "core/record/Fleet.h"
#include "db/Database.h"
#include "db/FleetRepository.h"
#include "db/SensorRepository.h"
#include "db/SiteRepository.h"
#include "db/SwingRepository.h"

namespace lubberline::test {

inline constexpr int kSwingsAtOnce = 10; ///< in one transaction of the importing writer

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

struct Stored {
    AircraftTypeId type;
    AircraftId aircraft;
    LimitsProfileId limits;
    SiteId site;
    CompassId compass;
};

inline db::Database inMemory()
{
    auto database = db::Database::open(":memory:", db::OpenMode::ReadWriteCreate);
    LUBBERLINE_EXPECT(database.ok(), "a database in memory opens");
    return std::move(database.value());
}

inline Stored store(db::Database& database)
{
    db::FleetRepository fleet(database);
    db::SiteRepository sites(database);
    Stored stored;
    stored.type = fleet.save(AircraftType{{}, {}, "Su-22", "Sukhoi", ""}).value();
    Aircraft aircraft;
    aircraft.type = stored.type;
    aircraft.registration = "3713";
    stored.aircraft = fleet.save(aircraft).value();
    LimitsProfile limits;
    limits.name = "ten degrees";
    limits.maxDeviation_deg = 10.0;
    stored.limits = sites.save(limits).value();
    Site site;
    site.name = "Deblin";
    site.variation_deg = 6.5;
    stored.site = sites.save(site).value();
    CompassSystem compass;
    compass.aircraft = stored.aircraft;
    compass.name = "standby compass";
    compass.limits = stored.limits;
    stored.compass = fleet.save(compass).value();
    return stored;
}

inline Swing swingOf(const Stored& stored, const std::string& date = "2026-11-20")
{
    Swing swing;
    swing.compass = stored.compass;
    swing.site = stored.site;
    swing.date = date;
    swing.readings = worksheetReadings();
    return swing;
}

inline FieldStamp stampOf(const std::string& date) { return {"WMM2025", {51.55, 21.89, 117.0}, date, {18879.125, 2311.0625, 0.1 + 0.2}}; }

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
