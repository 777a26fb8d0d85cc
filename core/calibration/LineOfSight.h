#pragma once
/// The line of sight of a helmet, as two magnetic sensors tell it: azimuth and elevation in the aircraft's axes and in a turret's, and what
/// makes them wrong. Each sensor's heading comes of its field and of the pitch and roll that it was told [P 22], so an error of a tilt turns
/// the heading as well: by some tan I.
/// Errors that stay (iron that is still there, a field of the cockpit) and errors by chance (noise, tilt, mount) are told apart.

#include <vector>

#include "core/base/Message.h"
#include "core/sensor/Attitude.h"
#include "core/sensor/SensorModel.h"

namespace lubberline {

/// In the axes that are named with it: azimuth from forward to starboard, elevation upward.
struct SightAngles {
    double azimuth_deg = 0, elevation_deg = 0;
};

struct SightSensor {
    SensorModel iron = {};    ///< what is left of it in the headings
    double noise_nT = 0;      ///< standard deviation of one axis
    double tiltError_deg = 0; ///< standard deviation of its pitch and of its roll
};

struct SightCase {
    MeridianField field;
    SightSensor aircraft = {}, helmet = {};
    Attitude aircraftAttitude = {};
    Misalignment turret = {};   ///< of its mount, in the aircraft's axes
    double turretError_deg = 0; ///< standard deviation of each of its angles
    /// Of the cockpit at the helmet, uniform and constant, in the aircraft's axes. A field that is made to track the helmet (coils) is none
    /// of this and is not modelled.
    Eigen::Vector3d cockpit_nT = Eigen::Vector3d::Zero();
};

/// Of one cause, or of all: in the aircraft's axes and in the turret's. Of a cause by chance its standard deviation.
struct SightError {
    SightAngles aircraft, turret;
};

struct SightCause {
    Message name;
    bool byChance = false;
    SightError error;
};

struct SightBudget {
    SightAngles look; ///< true, in the aircraft's axes
    SightError truth; ///< of the line itself
    Attitude helmet;  ///< in the Earth's axes
    std::vector<SightCause> causes;
    SightError stays;    ///< all that stays, together
    SightError byChance; ///< root of the sum of squares
    SightError whole;    ///< root of both squares
    std::vector<Message> warnings;
};

/// @param look in the aircraft's axes. @param helmetRoll_deg about the line of sight
[[nodiscard]] SightBudget sightBudget(const SightCase& given, const SightAngles& look, double helmetRoll_deg = 0);

/// Budgets over where one looks: azimuth ±120° in steps of 15°, for each elevation in turn (−30, 0, +30°).
[[nodiscard]] std::vector<SightBudget> sightSweep(const SightCase& given);

} // namespace lubberline
