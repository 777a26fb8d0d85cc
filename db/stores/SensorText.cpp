#include "db/stores/SensorText.h"

#include <cmath>

#include "core/format/exchange/BenchJson.h"
#include "core/format/exchange/ModelJson.h"
#include "core/format/exchange/RowJson.h"
#include "core/iron/BenchCheck.h"

namespace lubberline::db {

namespace {

bool isFinite(const SensorModel& model, const std::optional<ModelUncertainty>& uncertainty)
{
    if (uncertainty && !uncertainty->covariance.allFinite())
        return false;
    const auto& mount = model.misalignment;
    bool finite = model.softIron.allFinite() && model.hardIron_nT.allFinite() && model.softConstant_nT.allFinite()
        && std::isfinite(mount.roll_rad) && std::isfinite(mount.pitch_rad) && std::isfinite(mount.yaw_rad);
    for (const auto& circuit : model.circuits)
        finite = finite && circuit.field_nT_per_A.allFinite() && std::isfinite(circuit.current_A);
    return finite;
}

Error corruptSensor(const Message& why) { return {ErrorCode::Corrupt, why}; }

} // namespace

Result<void> checkSensor(const SensorRecord& sensor)
{
    if (!isFinite(sensor.model, sensor.uncertainty))
        return Error{ErrorCode::InvalidInput,
            {MARKED("db", "a figure of the sensor model %1 is not a real number; expected finite ones"), sensor.name}};
    if (sensor.bench)
        if (auto checked = checkBench(*sensor.bench); !checked)
            return checked;
    // What could not be read again must not be stored.
    auto back = withTexts(sensor, writeSensorModelJson(sensor.model), sensor.bench ? writeBenchJson(*sensor.bench) : std::string(),
        writeStatesRow(sensor.benchStates), sensor.uncertainty ? writeUncertaintyJson(*sensor.uncertainty) : std::string());
    if (back)
        return {};
    Error error = back.error();
    error.code = ErrorCode::InvalidInput;
    return error;
}

Result<SensorRecord> withTexts(
    SensorRecord sensor, const std::string& model, const std::string& bench, const std::string& states, const std::string& uncertainty)
{
    const std::string name = "sensor model " + sensor.name + " (record " + sensor.record + ")";
    auto readModel = readSensorModelJson(model, name);
    if (!readModel)
        return corruptSensor(described(readModel.error()));
    sensor.model = std::move(readModel.value());
    if (!bench.empty()) {
        auto readBench = readBenchJson(bench, name);
        if (!readBench)
            return corruptSensor(described(readBench.error()));
        sensor.bench = std::move(readBench.value());
    }
    auto readStates = readStatesRow(states);
    if (!readStates)
        return corruptSensor({MARKED("db", "%1: the states of its moving parts do not read: %2"), name, readStates.error().message});
    sensor.benchStates = std::move(readStates.value());
    if (!uncertainty.empty()) {
        auto readUncertainty = readUncertaintyJson(uncertainty, name);
        if (!readUncertainty)
            return corruptSensor(described(readUncertainty.error()));
        sensor.uncertainty = std::move(readUncertainty.value());
    }
    return sensor;
}

} // namespace lubberline::db
