#include <gmock/gmock.h>

#include <limits>

#include "db/Maintenance.h"
#include "db/Statement.h"
#include "tests/db/TestFleet.h"

namespace lubberline::test {

using testing::HasSubstr;

namespace {

std::vector<std::string> auditOf(db::Database& database, const std::string& what)
{
    db::Statement statement(database, "SELECT detail FROM audit_entry WHERE what = ? ORDER BY id");
    statement << what;
    return db::rowsOf<std::string>(statement, [](db::Statement& row) { return row.text(0); }).value();
}

SensorRecord benchOf(const Stored& stored)
{
    SensorRecord sensor = sensorOf(stored, "bench");
    sensor.origin = ModelOrigin::IronBench;
    sensor.bench = IronBench{{-2, 0, -1},
        {{"gear leg", Cylinder{0.08, 0.9}, 50, {0, 0, 0.1}, "gear",
            {{"retracted", {0, 0, 1}, 0, 0, 0}, {"extended", {0, 0, 1.5}, 0, 0, 0}}}},
        {}};
    sensor.benchStates = {{"gear", "extended"}};
    return sensor;
}

} // namespace

TEST(SensorRepository, aModelComesBackWhole)
{
    auto database = inMemory();
    const Stored stored = store(database);
    db::SensorRepository sensors(database);
    for (SensorRecord sensor : {sensorOf(stored), benchOf(stored)}) {
        const auto id = sensors.save(sensor);
        ASSERT_TRUE(id) << describe(id.error());
        const auto back = sensors.sensor(*id);
        ASSERT_TRUE(back) << describe(back.error());
        EXPECT_TRUE(isRecordId(back->record));
        sensor.id = *id;
        sensor.record = back->record;
        EXPECT_EQ(*back, sensor);
    }
    const auto listed = *sensors.sensorsOf(stored.compass);
    ASSERT_EQ(listed.size(), 2u);
    EXPECT_EQ(listed[0].name, "bench"); // newest first
    EXPECT_TRUE(sensors.sensorsOf(CompassId{99})->empty());
    EXPECT_EQ(sensors.sensor(SensorModelId{99}).error().code, ErrorCode::NotFound);
    EXPECT_EQ(db::status(database)->sensorModels, 2);
    EXPECT_TRUE(db::verify(database, {})->findings.empty());
}

TEST(SensorRepository, changesAndRemovalStandInTheAuditTrail)
{
    auto database = inMemory();
    const Stored stored = store(database);
    db::SensorRepository sensors(database);
    SensorRecord sensor = sensorOf(stored);
    sensor.id = *sensors.save(sensor);
    sensor.model.hardIron_nT.x() = 900;
    ASSERT_TRUE(sensors.save(sensor));
    EXPECT_EQ(sensors.sensor(sensor.id)->model.hardIron_nT.x(), 900);
    ASSERT_EQ(auditOf(database, "changed sensor model").size(), 1u);
    EXPECT_THAT(auditOf(database, "changed sensor model").front(), testing::AllOf(HasSubstr("850"), HasSubstr("900")));
    ASSERT_TRUE(sensors.save(sensor)); // nothing changed: nothing is said
    EXPECT_EQ(auditOf(database, "changed sensor model").size(), 1u);
    ASSERT_TRUE(sensors.remove(sensor.id));
    EXPECT_THAT(auditOf(database, "removed sensor model").front(),
        testing::AllOf(HasSubstr("as entered"), HasSubstr("900"), HasSubstr("landing light")));
    EXPECT_TRUE(sensors.sensorsOf(stored.compass)->empty());
    EXPECT_EQ(sensors.remove(sensor.id).error().code, ErrorCode::NotFound);
}

TEST(SensorRepository, aNameIsThereOnceForACompass)
{
    auto database = inMemory();
    const Stored stored = store(database);
    db::SensorRepository sensors(database);
    ASSERT_TRUE(sensors.save(sensorOf(stored)));
    EXPECT_EQ(sensors.save(sensorOf(stored)).error().code, ErrorCode::Conflict);
    EXPECT_EQ(sensors.save(sensorOf(stored, "")).error().code, ErrorCode::InvalidInput);
    CompassSystem other = *db::FleetRepository(database).compass(stored.compass);
    other.id = {};
    other.record.clear();
    other.name = "remote compass";
    SensorRecord sensor = sensorOf(stored);
    sensor.compass = *db::FleetRepository(database).save(other);
    EXPECT_TRUE(sensors.save(sensor));
    sensor.compass = CompassId{99};
    sensor.name = "of no compass";
    EXPECT_FALSE(sensors.save(sensor));
}

TEST(SensorRepository, whatCannotBeReadBackIsNotStored)
{
    auto database = inMemory();
    const Stored stored = store(database);
    db::SensorRepository sensors(database);
    SensorRecord sensor = sensorOf(stored);
    sensor.model.circuits[0].current_A = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(sensors.save(sensor).error().code, ErrorCode::InvalidInput);
    sensor = benchOf(stored);
    sensor.bench->parts[0].susceptibility = -1;
    EXPECT_EQ(sensors.save(sensor).error().code, ErrorCode::InvalidInput);
    EXPECT_TRUE(sensors.sensorsOf(stored.compass)->empty());
}

TEST(SensorRepository, oneThatDoesNotReadIsNamed)
{
    auto database = inMemory();
    const Stored stored = store(database);
    db::SensorRepository sensors(database);
    const auto id = *sensors.save(sensorOf(stored));
    ASSERT_TRUE(db::execute(database, "UPDATE sensor_model SET model_json = '{\"soft_irn\": 1}'"));
    for (const Error& error : {sensors.sensor(id).error(), sensors.sensorsOf(stored.compass).error()}) {
        EXPECT_EQ(error.code, ErrorCode::Corrupt);
        EXPECT_THAT(error.message, testing::AllOf(HasSubstr("as entered"), HasSubstr("soft_irn")));
    }
    ASSERT_EQ(sensors.faults()->size(), 1u);
}

TEST(FieldOfASwing, isKeptWholeAndFrozenWhenItIsSigned)
{
    auto database = inMemory();
    const Stored stored = store(database);
    db::SwingRepository swings(database);
    Swing swing = swingOf(stored);
    swing.id = *swings.save(swing);
    EXPECT_FALSE(swings.swing(swing.id)->field);
    swing.field = stampOf("2026-11-20");
    swing.indexRemoved_deg = -2.25;
    ASSERT_TRUE(swings.save(swing));
    EXPECT_EQ(swings.swing(swing.id)->field, swing.field);
    EXPECT_EQ(swings.swing(swing.id)->indexRemoved_deg, -2.25);
    EXPECT_THAT(auditOf(database, "changed swing").front(),
        testing::AllOf(HasSubstr("field_model: WMM2025"), HasSubstr("field_north_nT: 18879.125")));
    EXPECT_FALSE(db::execute(database, "UPDATE swing SET field_date = NULL")); // whole or not at all
    EXPECT_FALSE(db::execute(database, "UPDATE swing SET field_latitude_deg = 91"));
    swing.field.reset();
    ASSERT_TRUE(swings.save(swing));
    EXPECT_FALSE(swings.swing(swing.id)->field);
    swing.field = stampOf("2026-11-20");
    swing.state = SwingState::Signed;
    ASSERT_TRUE(swings.save(swing));
    for (const char* change : {"field_model = 'IGRF-14'", "field_latitude_deg = 1", "field_longitude_deg = 1", "field_height_m = 1",
             "field_date = '2026-01-01'", "field_north_nT = 1", "field_east_nT = 1", "field_down_nT = 1", "index_removed_deg = 1"})
        EXPECT_EQ(db::execute(database, QStringLiteral("UPDATE swing SET %1").arg(QLatin1String(change))).error().code, ErrorCode::Frozen)
            << change;
    EXPECT_EQ(swings.swing(swing.id)->field, stampOf("2026-11-20"));
}

TEST(FieldOfASwing, comesInWithASignedOne)
{
    auto database = inMemory();
    Swing swing = swingOf(store(database));
    swing.field = stampOf("2026-11-20");
    swing.state = SwingState::Signed;
    const auto id = db::SwingRepository(database).save(swing);
    ASSERT_TRUE(id);
    EXPECT_EQ(db::SwingRepository(database).swing(*id)->field, swing.field);
    std::vector<std::optional<FieldStamp>> seen;
    ASSERT_TRUE(db::SwingRepository(database).forEach([&](const Swing& one) {
        seen.push_back(one.field);
        return true;
    }));
    EXPECT_EQ(seen, std::vector<std::optional<FieldStamp>>{swing.field});
}

} // namespace lubberline::test
