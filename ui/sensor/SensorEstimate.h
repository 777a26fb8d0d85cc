#pragma once
/// Sensor models from the swings that a compass has: gathers what storage keeps, core estimates.

#include "core/record/SensorRecord.h"
#include "core/swing/IronSeparation.h"
#include "db/stores/Stores.h"

namespace lubberline::ui {

/// From the exact coefficients of the newest swing that has all five. A swing that keeps no field is taken in `field`, and the
/// note says so. The record is new: it is the caller's to store. Errors: InvalidInput (no such swing), those of modelOf().
Result<SensorRecord> estimateFromNewest(db::Stores& stores, CompassId compass, Origin origin, const Result<MeridianField>& field);

/// From the newest swing of each place, hard iron separated from vertical soft iron; uncertainties and warnings stand in the
/// note. Errors: InvalidInput (swings of fewer than two places), those of separateIron().
Result<SensorRecord> estimateBySeparation(db::Stores& stores, CompassId compass);

} // namespace lubberline::ui
