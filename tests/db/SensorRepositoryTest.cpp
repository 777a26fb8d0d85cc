#include <gmock/gmock.h>

#include <limits>

#include "db/engine/Statement.h"
#include "db/transfer/Maintenance.h"
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

TEST(SensorStore, whatCouldNotBeReadAgainIsNotStored)
{
    auto database = inMemory();
    const Stored stored = store(database);
    SensorRecord sensor = sensorOf(stored);
    IronBench bench;
    bench.parts.push_back(
        {"turned twice round", Box{{0.1, 0.05, 0.02}}, 100, {0, 0, 0}, "", {{"", {0.3, 0.2, 0.1}, 0, 0, 10.0}}}); // yaw [rad]
    sensor.bench = bench;
    const auto refused = db::SensorStore(database).add(sensor);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::InvalidInput);
    EXPECT_THAT(refused.error().message.english(), testing::HasSubstr("yaw_deg"));
    EXPECT_TRUE(db::SensorStore(database).of(stored.compass)->empty());
}

SensorRecord calibratedOf(const Stored& stored)
{
    SensorRecord sensor = sensorOf(stored, "calibrated");
    sensor.uncertainty.emplace();
    for (int i = 0; i < kUncertainParameters; ++i)
        sensor.uncertainty->covariance(i, i) = i < 9 ? 1e-6 * (i + 1) : 400.0 * i;
    sensor.uncertainty->covariance(0, 9) = sensor.uncertainty->covariance(9, 0) = 0.0125;
    return sensor;
}

TEST(SensorStore, howSureACalibrationIsStaysWithItsModel)
{
    auto database = inMemory();
    const Stored stored = store(database);
    db::SensorStore sensors(database);
    const auto id = save(sensors, calibratedOf(stored));
    ASSERT_TRUE(id) << describe(id.error());
    const auto back = sensors.sensor(*id);
    ASSERT_TRUE(back && back->uncertainty);
    EXPECT_EQ(back->uncertainty, calibratedOf(stored).uncertainty);
    SensorRecord wrong = *back;
    wrong.uncertainty->covariance(3, 3) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(sensors.change(*back, wrong).error().code, ErrorCode::InvalidInput);
    wrong.uncertainty->covariance(3, 3) = -1;
    EXPECT_EQ(sensors.change(*back, wrong).error().code, ErrorCode::InvalidInput);
    ASSERT_TRUE(db::execute(database, "UPDATE sensor_model SET uncertainty_json = '{\"covariance\": [[1]]}'"));
    EXPECT_EQ(sensors.sensor(*id).error().code, ErrorCode::Corrupt);
    EXPECT_FALSE(db::verify(database, {})->findings.empty());
}

TEST(SensorStore, aModelComesBackWhole)
{
    auto database = inMemory();
    const Stored stored = store(database);
    db::SensorStore sensors(database);
    for (SensorRecord sensor : {sensorOf(stored), benchOf(stored)}) {
        const auto id = save(sensors, sensor);
        ASSERT_TRUE(id) << describe(id.error());
        const auto back = sensors.sensor(*id);
        ASSERT_TRUE(back) << describe(back.error());
        EXPECT_TRUE(isRecordId(back->record));
        sensor.id = *id;
        sensor.record = back->record;
        EXPECT_EQ(*back, sensor);
    }
    const auto listed = *sensors.of(stored.compass);
    ASSERT_EQ(listed.size(), 2u);
    EXPECT_EQ(listed[0].name, "bench"); // newest first
    EXPECT_TRUE(sensors.of(CompassId{99})->empty());
    EXPECT_EQ(sensors.sensor(SensorModelId{99}).error().code, ErrorCode::NotFound);
    EXPECT_EQ(db::status(database)->sensorModels, 2);
    EXPECT_TRUE(db::verify(database, {})->findings.empty());
}

TEST(SensorStore, changesAndRemovalStandInTheAuditTrail)
{
    auto database = inMemory();
    const Stored stored = store(database);
    db::SensorStore sensors(database);
    SensorRecord sensor = sensorOf(stored);
    sensor.id = *save(sensors, sensor);
    sensor.model.hardIron_nT.x() = 900;
    ASSERT_TRUE(save(sensors, sensor));
    EXPECT_EQ(sensors.sensor(sensor.id)->model.hardIron_nT.x(), 900);
    ASSERT_EQ(auditOf(database, "changed sensor model").size(), 1u);
    EXPECT_THAT(auditOf(database, "changed sensor model").front(), testing::AllOf(HasSubstr("850"), HasSubstr("900")));
    ASSERT_TRUE(save(sensors, sensor)); // nothing changed: nothing is said
    EXPECT_EQ(auditOf(database, "changed sensor model").size(), 1u);
    ASSERT_TRUE(sensors.remove(sensor.id));
    EXPECT_THAT(auditOf(database, "removed sensor model").front(),
        testing::AllOf(HasSubstr("as entered"), HasSubstr("900"), HasSubstr("landing light")));
    EXPECT_TRUE(sensors.of(stored.compass)->empty());
    EXPECT_EQ(sensors.remove(sensor.id).error().code, ErrorCode::NotFound);
}

TEST(SensorStore, aNameIsThereOnceForACompass)
{
    auto database = inMemory();
    const Stored stored = store(database);
    db::SensorStore sensors(database);
    ASSERT_TRUE(save(sensors, sensorOf(stored)));
    EXPECT_EQ(save(sensors, sensorOf(stored)).error().code, ErrorCode::Conflict);
    EXPECT_EQ(save(sensors, sensorOf(stored, "")).error().code, ErrorCode::InvalidInput);
    CompassSystem other = *db::FleetStore(database).compass(stored.compass);
    other.id = {};
    other.record.clear();
    other.name = "remote compass";
    SensorRecord sensor = sensorOf(stored);
    sensor.compass = *save(db::FleetStore(database), other);
    EXPECT_TRUE(save(sensors, sensor));
    sensor.compass = CompassId{99};
    sensor.name = "of no compass";
    EXPECT_FALSE(save(sensors, sensor));
}

TEST(SensorStore, whatCannotBeReadBackIsNotStored)
{
    auto database = inMemory();
    const Stored stored = store(database);
    db::SensorStore sensors(database);
    SensorRecord sensor = sensorOf(stored);
    sensor.model.circuits[0].current_A = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(save(sensors, sensor).error().code, ErrorCode::InvalidInput);
    sensor = benchOf(stored);
    sensor.bench->parts[0].susceptibility = -1;
    EXPECT_EQ(save(sensors, sensor).error().code, ErrorCode::InvalidInput);
    EXPECT_TRUE(sensors.of(stored.compass)->empty());
}

TEST(SensorStore, oneThatDoesNotReadIsNamed)
{
    auto database = inMemory();
    const Stored stored = store(database);
    db::SensorStore sensors(database);
    const auto id = *save(sensors, sensorOf(stored));
    ASSERT_TRUE(db::execute(database, "UPDATE sensor_model SET model_json = '{\"soft_irn\": 1}'"));
    for (const Error& error : {sensors.sensor(id).error(), sensors.of(stored.compass).error()}) {
        EXPECT_EQ(error.code, ErrorCode::Corrupt);
        EXPECT_THAT(error.message.english(), testing::AllOf(HasSubstr("as entered"), HasSubstr("soft_irn")));
    }
    ASSERT_EQ(sensors.faults()->size(), 1u);
}

TEST(FieldOfASwing, isKeptWholeAndFrozenWhenItIsSigned)
{
    auto database = inMemory();
    const Stored stored = store(database);
    db::SwingStore swings(database);
    Swing swing = swingOf(stored);
    swing.id = *save(swings, swing);
    EXPECT_FALSE(swings.swing(swing.id)->field);
    swing.field = stampOf("2026-11-20");
    swing.indexRemoved_deg = -2.25;
    ASSERT_TRUE(save(swings, swing));
    EXPECT_EQ(swings.swing(swing.id)->field, swing.field);
    EXPECT_EQ(swings.swing(swing.id)->indexRemoved_deg, -2.25);
    EXPECT_THAT(auditOf(database, "changed swing").front(),
        testing::AllOf(HasSubstr("field_model: WMM2025"), HasSubstr("field_north_nT: 18879.125")));
    EXPECT_FALSE(db::execute(database, "UPDATE swing SET field_date = NULL")); // whole or not at all
    EXPECT_FALSE(db::execute(database, "UPDATE swing SET field_latitude_deg = 91"));
    swing.field.reset();
    ASSERT_TRUE(save(swings, swing));
    EXPECT_FALSE(swings.swing(swing.id)->field);
    swing.field = stampOf("2026-11-20");
    swing.state = SwingState::Signed;
    ASSERT_TRUE(save(swings, swing));
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
    const auto id = save(db::SwingStore(database), swing);
    ASSERT_TRUE(id);
    EXPECT_EQ(db::SwingStore(database).swing(*id)->field, swing.field);
    std::vector<std::optional<FieldStamp>> seen;
    ASSERT_TRUE(db::SwingStore(database).forEach([&](const Swing& one) {
        seen.push_back(one.field);
        return true;
    }));
    EXPECT_EQ(seen, std::vector<std::optional<FieldStamp>>{swing.field});
}

} // namespace lubberline::test
