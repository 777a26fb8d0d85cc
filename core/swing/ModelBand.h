#pragma once
/// The band round a prediction by a model that is not exact.

#include "core/sensor/ModelUncertainty.h"
#include "core/swing/Prediction.h"

namespace lubberline {

/// Widens the curve of predict(model, …) so that all of it lies in the band with kBoundProbability: five coefficients of a level curve, so
/// √χ²(5) standard deviations at each heading (Scheffé).
void addModelBand(Prediction& prediction, const SensorModel& model, const ModelUncertainty& uncertainty);

} // namespace lubberline
