#include "db/stores/SensorStore.h"

#include "core/format/exchange/BenchJson.h"
#include "core/format/exchange/ModelJson.h"
#include "core/format/exchange/RowJson.h"
#include "db/saving/Saving.h"
#include "db/stores/SensorText.h"
#include "db/stores/Tables.h"

namespace lubberline::db {

namespace {

SensorRecord sensorFrom(const Statement& row)
{
    SensorRecord sensor;
    sensor.id = row.id<SensorModelId>(0);
    (void)row.record(1);
    sensor.record = row.anything(1); // what is none still names the row
    sensor.compass = row.id<CompassId>(2);
    sensor.name = row.name(3);
    sensor.origin = row.as(4, ModelOrigin::IronBench);
    sensor.note = row.text(5);
    auto whole = withTexts(sensor, row.longText(6), row.optionalLongText(7), row.longText(8), row.longText(9));
    if (whole)
        return std::move(*whole);
    row.damages(6, whole.error());
    return sensor;
}

void bindSensor(Statement& statement, const SensorRecord& sensor)
{
    statement << sensor.compass << sensor.name << static_cast<int>(sensor.origin) << sensor.note << writeSensorModelJson(sensor.model);
    if (sensor.bench)
        statement << writeBenchJson(*sensor.bench);
    else
        statement.null();
    statement << writeStatesRow(sensor.benchStates) << (sensor.uncertainty ? writeUncertaintyJson(*sensor.uncertainty) : std::string());
}

Result<void> check(const SensorRecord& sensor)
{
    if (auto named = requireName(sensor.name, MARKED("db", "the name of the sensor model")); !named)
        return named;
    return checkSensor(sensor);
}

} // namespace

const Table& sensorTable()
{
    static const Table table{MARKED("db", "sensor model"), "sensor_model",
        {"compass_id", "name", "origin", "note", "model_json", "bench_json", "states_json", "uncertainty_json"},
        [](const Statement& row) { (void)sensorFrom(row); }};
    return table;
}

Result<std::vector<SensorRecord>> SensorStore::of(CompassId compass)
{
    Statement statement(m_database, selectFrom(sensorTable()) + "WHERE compass_id = ? ORDER BY id DESC");
    statement << compass;
    return rowsOf<SensorRecord>(statement, sensorFrom);
}

Result<SensorRecord> SensorStore::sensor(SensorModelId id)
{
    Statement statement(m_database, selectFrom(sensorTable()) + "WHERE id = ?");
    statement << id;
    return oneOf<SensorRecord>(statement, m_database, MARKED("db", "sensor model"), sensorFrom);
}

Result<std::vector<Message>> SensorStore::faults()
{
    Statement statement(m_database, selectFrom(sensorTable()) + "ORDER BY id");
    return damagesIn(statement, [](Statement& row) { (void)sensorFrom(row); });
}

Result<SensorModelId> SensorStore::add(const SensorRecord& sensor)
{
    if (const auto checked = check(sensor); !checked)
        return checked.error();
    return noting(
        m_database, [&] { return addRecord<SensorModelId>(m_database, sensorTable(), sensor, bindSensor); },
        [&](SensorModelId) { m_database.changes().note(change::Sensors{sensor.compass}); });
}

Result<void> SensorStore::change(const SensorRecord& known, const SensorRecord& sensor)
{
    if (const auto checked = check(sensor); !checked)
        return checked.error();
    return noting(
        m_database, [&] { return changeRecord(m_database, sensorTable(), sensor.id, known, sensor, bindSensor); },
        [&] { m_database.changes().note(change::Sensors{sensor.compass}); });
}

Result<void> SensorStore::remove(SensorModelId id)
{
    const auto found = sensor(id);
    if (!found)
        return found.error();
    return noting(
        m_database, [&] { return removeRecord(m_database, sensorTable(), found->record); },
        [&] { m_database.changes().note(change::Sensors{found->compass}); });
}

} // namespace lubberline::db
