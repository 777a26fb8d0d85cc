#pragma once
/// Bench JSON: ferrous parts, loops and wires round a sensor.
///   {"sensor_m": [x,y,z],
///    "parts": [{"name": "gear leg", "shape": "cylinder", "diameter_m": 0.08, "length_m": 0.9, "susceptibility": 50,
///               "remanence_T": [0,0,0], "group": "gear",
///               "placements": [{"state": "retracted", "centre_m": [x,y,z], "roll_deg": 0, "pitch_deg": 0, "yaw_deg": 0}, …]}],
///    "circuits": [{"name": "landing light", "current_A": 10, "on": true,
///                  "conductors": [{"kind": "loop", "centre_m": [x,y,z], "normal": [x,y,z], "diameter_m": 0.1, "turns": 1},
///                                 {"kind": "wire", "points_m": [[x,y,z], [x,y,z]]}]}]}
/// Shapes: "box" and "ellipsoid" with size_m, "cylinder" with diameter_m and length_m, "sphere" with diameter_m. A part without
/// a group has one placement without a state. susceptibility, remanence_T, group, the angles, turns (1), parts and circuits may
/// be left out. Strict, like Model JSON: a missing, doubled, unknown or misspelt key is named by its path.

#include <string>
#include <string_view>

#include "core/base/Result.h"
#include "core/iron/FerrousPart.h"

namespace lubberline {

class FirstFault;
class JsonObject;
class JsonWriter;

/// What is read is a bench that checkBench() accepts. Errors: Format, InvalidInput. `name` is the file named in errors.
Result<IronBench> readBenchJson(std::string_view text, const std::string& name);
/// Errors: also Io.
Result<IronBench> readBenchJsonFile(const std::string& path);
/// Reads back equal (angles to 1e-12 rad), and is written the same again. @pre all numbers are finite.
[[nodiscard]] std::string writeBenchJson(const IronBench& bench);

/// The same as the keys of an object inside another file: a sensor's bench in the exchange file.
[[nodiscard]] IronBench readBench(JsonObject& object, FirstFault& fault);
void writeBench(JsonWriter& json, const IronBench& bench);

} // namespace lubberline
