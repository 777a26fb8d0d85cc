#include "db/stores/SensorStore.h"

#include "core/format/exchange/BenchJson.h"
#include "core/format/exchange/ModelJson.h"
#include "core/format/exchange/RowJson.h"
#include "db/stores/Saving.h"
#include "db/stores/SensorText.h"

namespace lubberline::db {

namespace {

const Table& sensorTable()
{
    static const Table table{
        MARKED("db", "sensor model"), "sensor_model", {"compass_id", "name", "origin", "note", "model_json", "bench_json", "states_json"}};
    return table;
}

QString selectSensor() { return "SELECT id, record, " + sensorTable().fields.join(", ") + " FROM sensor_model "; }

Result<SensorRecord> sensorFrom(const Statement& row, const Database& database)
{
    SensorRecord sensor;
    sensor.id = row.id<SensorModelId>(0);
    sensor.record = row.text(1);
    sensor.compass = row.id<CompassId>(2);
    sensor.name = row.text(3);
    sensor.origin = row.as<ModelOrigin>(4);
    sensor.note = row.text(5);
    auto whole = withTexts(std::move(sensor), row.text(6), row.text(7), row.text(8));
    if (whole)
        return whole;
    Error error = whole.error();
    error.file = database.path().toStdString();
    return error;
}

void bindSensor(Statement& statement, const SensorRecord& sensor)
{
    statement << sensor.compass << sensor.name << static_cast<int>(sensor.origin) << sensor.note << writeSensorModelJson(sensor.model);
    if (sensor.bench)
        statement << writeBenchJson(*sensor.bench);
    else
        statement.null();
    statement << writeStatesRow(sensor.benchStates);
}

Result<void> check(const SensorRecord& sensor)
{
    if (auto named = requireName(sensor.name, MARKED("db", "the name of the sensor model")); !named)
        return named;
    return checkSensor(sensor);
}

} // namespace

Result<std::vector<SensorRecord>> SensorStore::of(CompassId compass)
{
    Statement statement(m_database, selectSensor() + "WHERE compass_id = ? ORDER BY id DESC");
    statement << compass;
    return wholeRows(rowsOf<Result<SensorRecord>>(statement, [this](Statement& row) { return sensorFrom(row, m_database); }));
}

Result<SensorRecord> SensorStore::sensor(SensorModelId id)
{
    Statement statement(m_database, selectSensor() + "WHERE id = ?");
    statement << id;
    auto row = oneOf<Result<SensorRecord>>(
        statement, m_database, MARKED("db", "sensor model"), [this](Statement& found) { return sensorFrom(found, m_database); });
    if (!row)
        return row.error();
    return std::move(row.value());
}

Result<std::vector<Message>> SensorStore::faults()
{
    Statement statement(m_database, selectSensor() + "ORDER BY id");
    auto rows = rowsOf<Result<SensorRecord>>(statement, [this](Statement& row) { return sensorFrom(row, m_database); });
    if (!rows)
        return rows.error();
    std::vector<Message> faults;
    for (const auto& row : *rows)
        if (!row)
            faults.push_back(row.error().message);
    return faults;
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
