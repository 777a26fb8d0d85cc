#pragma once
/// A sensor model kept with a compass system.

#include <optional>
#include <string>

#include "core/iron/FerrousPart.h"
#include "core/record/Id.h"
#include "core/sensor/ModelUncertainty.h"
#include "core/sensor/SensorModel.h"

namespace lubberline {

enum class ModelOrigin { Entered, Loaded, EstimatedFromSwings, IronBench };

struct SensorRecord {
    SensorModelId id;
    RecordId record = {};
    CompassId compass;
    std::string name; ///< unique for its compass
    ModelOrigin origin = ModelOrigin::Entered;
    std::string note;
    SensorModel model;
    std::optional<IronBench> bench;                   ///< what the model was computed from, when its origin is the iron bench
    BenchStates benchStates;                          ///< chosen states of the bench's moving parts
    std::optional<ModelUncertainty> uncertainty = {}; ///< of the calibration that gave the model; none: not known
    friend bool operator==(const SensorRecord&, const SensorRecord&) = default;
};

} // namespace lubberline
