#pragma once
/// Ferrous parts, current loops and wires round a sensor, as an engineer places them. Metres in body axes from the aircraft's
/// datum point: x forward, y starboard, z down.

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

namespace lubberline {

/// Uniform bodies by their full lengths along their own axes [m].
struct Box {
    Eigen::Vector3d size_m = Eigen::Vector3d::Zero();
    bool operator==(const Box&) const = default;
};
struct Cylinder {
    double diameter_m = 0, length_m = 0;
    bool operator==(const Cylinder&) const = default;
}; ///< axis along the part's own x
struct Ellipsoid {
    Eigen::Vector3d size_m = Eigen::Vector3d::Zero();
    bool operator==(const Ellipsoid&) const = default;
}; ///< full axes
struct Sphere {
    double diameter_m = 0;
    bool operator==(const Sphere&) const = default;
};
using Shape = std::variant<Box, Cylinder, Ellipsoid, Sphere>;

/// Where a part is while the aircraft is in a state ("gear": "extended").
struct Placement {
    std::string state = {}; ///< of the part's group; empty: always here
    Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
    double roll_rad = 0, pitch_rad = 0, yaw_rad = 0; ///< the part's own axes against the body's, as of an attitude
    bool operator==(const Placement&) const = default;
};

struct FerrousPart {
    std::string name;
    Shape shape = Sphere{};
    double susceptibility = 0;                             ///< χ of the material, dimensionless (SI), ≥ 0
    Eigen::Vector3d remanence_T = Eigen::Vector3d::Zero(); ///< μ0 M_r in the part's own axes [T]
    std::string group = {};                                ///< moving parts: "gear"; empty: fixed
    std::vector<Placement> placements;                     ///< one, or one for each state of its group
    std::optional<double> coercivity_A_per_m = {};         ///< none: not known
    bool operator==(const FerrousPart&) const = default;
};

/// A circular loop: the field of one turn times `turns`; the current runs clockwise seen along the normal.
struct CurrentLoop {
    Eigen::Vector3d centre_m = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::Zero();
    double diameter_m = 0;
    int turns = 1;
    bool operator==(const CurrentLoop&) const = default;
};
/// Straight wires from point to point; the current runs in the order given. An open path is allowed (return through the
/// airframe).
struct WirePath {
    std::vector<Eigen::Vector3d> points_m;
    bool operator==(const WirePath&) const = default;
};

struct BenchCircuit {
    std::string name;
    std::vector<std::variant<CurrentLoop, WirePath>> conductors;
    double current_A = 0;
    bool on = false;
    bool operator==(const BenchCircuit&) const = default;
};

/// The forward model of an airframe.
struct IronBench {
    Eigen::Vector3d sensor_m = Eigen::Vector3d::Zero();
    std::vector<FerrousPart> parts;
    std::vector<BenchCircuit> circuits;
    bool operator==(const IronBench&) const = default;
};

/// Chosen state of each group: {"gear": "extended"}.
using BenchStates = std::map<std::string, std::string>;

} // namespace lubberline
