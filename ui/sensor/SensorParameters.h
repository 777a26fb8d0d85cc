#pragma once
/// The figures of a sensor model as the form shows them: name, unit, range, and where each is kept. Angles are shown in
/// degrees.

#include <functional>
#include <vector>

#include "core/sensor/SensorModel.h"
#include "ui/sensor/ParameterCell.h"

namespace lubberline::ui {

template <class Record>
struct Parameter {
    ParameterSpec spec; ///< its meaning is named in Undo, too
    std::function<double(const Record&)> get;
    std::function<void(Record&, double)> set;
};

/// a…k, row by row.
[[nodiscard]] std::vector<Parameter<SensorModel>> softIronParameters();
[[nodiscard]] std::vector<Parameter<SensorModel>> hardIronParameters();
[[nodiscard]] std::vector<Parameter<PolarHardIron>> polarParameters();
[[nodiscard]] std::vector<Parameter<SensorModel>> softConstantParameters();
[[nodiscard]] std::vector<Parameter<SensorModel>> misalignmentParameters();
/// Current, then S, T, V per ampere; names begin with `prefix`.
[[nodiscard]] std::vector<Parameter<Circuit>> circuitParameters(const QString& prefix);

} // namespace lubberline::ui
