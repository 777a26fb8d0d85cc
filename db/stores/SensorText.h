#pragma once
/// Private to db: the parts of a sensor model that are kept as JSON text.

#include <string>

#include "core/base/Result.h"
#include "core/record/SensorRecord.h"

namespace lubberline::db {

/// Reads model, bench (empty: none), states and uncertainty (empty: none) into the record. Errors: Corrupt, naming the record.
Result<SensorRecord> withTexts(
    SensorRecord sensor, const std::string& model, const std::string& bench, const std::string& states, const std::string& uncertainty);

/// Whether it can be kept. Errors: InvalidInput (a figure of the model that is not finite; a bench that checkBench() refuses).
Result<void> checkSensor(const SensorRecord& sensor);

} // namespace lubberline::db
