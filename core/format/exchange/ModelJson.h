#pragma once
/// Model JSON: a sensor on an aircraft and the field it stands in.
///   {"note": "…",
///    "field": {"H_nT": 18500, "dip_deg": 67} | {"H_nT": 0, "Z_nT": 56000} | {"F_nT": 49800} | {"lat_deg": …, "lon_deg": …, "alt_m": …, "date":
///    "2026-11-23"}, "soft_iron": [[a,b,c],[d,e,f],[g,h,k]], "hard_iron_nT": [P,Q,R], "soft_constant_nT": [D1,D2,D3],
///    "circuits": [{"name": "landing light", "field_nT_per_A": [S,T,V], "current_A": 10, "on": true}],
///    "misalignment_deg": {"roll": 0, "pitch": 0, "yaw": 0},
///    "covariance": twelve rows of twelve, of a … k and P, Q, R: how sure a calibration is (only where it is known)}
/// Strict: a missing, doubled, unknown or misspelt key is an error that names it by its path. Every part but `field` may be
/// left out and is zero then, `alt_m` too; a circuit has all its four keys. Z_nT (positive down) is for a field whose dip does
/// not tell it: at a magnetic pole H is 0. F_nT is a size without a direction: nothing can be computed in such a field. Files of before it
/// have F in H_nT with a dip of 0 then, and say so in their note: they are read as F_nT.

#include <optional>
#include <string>
#include <string_view>

#include "core/base/Result.h"
#include "core/sensor/SensorSetup.h"

namespace lubberline {

class JsonObject;
class JsonWriter;

/// Errors: Format, InvalidInput, naming the key's path. `name` is the file named in errors.
Result<SensorSetup> readModelJson(std::string_view text, const std::string& name);
/// Errors: also Io.
Result<SensorSetup> readModelJsonFile(const std::string& path);
/// Reads back equal (angles to 1e-15 of their size), and is written the same again; parts that are zero are written, so that a
/// user sees what there is to fill in. All numbers must be finite.
[[nodiscard]] std::string writeModelJson(const SensorSetup& setup);

/// The same without `field` and `note`: how a sensor model is kept where the field is not part of it.
Result<SensorModel> readSensorModelJson(std::string_view text, const std::string& name);
[[nodiscard]] std::string writeSensorModelJson(const SensorModel& model);

/// {"covariance": …} alone: how the uncertainty of a stored model is kept beside it.
Result<ModelUncertainty> readUncertaintyJson(std::string_view text, const std::string& name);
[[nodiscard]] std::string writeUncertaintyJson(const ModelUncertainty& uncertainty);

/// The key "covariance" inside another object.
[[nodiscard]] std::optional<ModelUncertainty> readCovariance(JsonObject& object);
void writeCovariance(JsonWriter& json, const std::optional<ModelUncertainty>& uncertainty); ///< none: no key

/// The keys of a sensor model inside another object: reads and writes them as keys of it. The object's finish() or only() is
/// the caller's.
[[nodiscard]] SensorModel readSensorModel(JsonObject& object);
void writeSensorModel(JsonWriter& json, const SensorModel& model);

} // namespace lubberline
