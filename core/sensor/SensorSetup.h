#pragma once
/// A sensor and the field it stands in: what a Model JSON holds.

#include <optional>
#include <string>
#include <variant>

#include "core/base/Result.h"
#include "core/earth/FieldModel.h"
#include "core/sensor/ModelUncertainty.h"
#include "core/sensor/SensorModel.h"

namespace lubberline {

/// A field at a place and date, to be computed from a model of the Earth.
struct PlaceAndDate {
    Place place;
    std::string date; ///< ISO 8601 date, or a decimal year
    friend bool operator==(const PlaceAndDate&, const PlaceAndDate&) = default;
};

/// A field of which only its size is known, as an ellipsoid tells it: neither H nor dip, so that no deviation can be computed in it.
struct TotalField {
    double total_nT = 0; ///< or in the sensor's counts
    friend bool operator==(const TotalField&, const TotalField&) = default;
};

struct SensorSetup {
    std::variant<MeridianField, PlaceAndDate, TotalField> field;
    SensorModel model;
    std::string note;                                 ///< in the user's words; empty: none
    std::optional<ModelUncertainty> uncertainty = {}; ///< of a calibration; none: not known
    friend bool operator==(const SensorSetup&, const SensorSetup&) = default;
};

/// The field as given, or that of the default model of the date. Errors: those of fieldForCompass(); InvalidInput: only its size is known.
Result<MeridianField> fieldOf(const SensorSetup& setup);

} // namespace lubberline
