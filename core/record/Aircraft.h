#pragma once
/// Aircraft types, aircraft, the compass systems installed on them, and the events of their lives.

#include <optional>
#include <string>

#include "core/base/Date.h"
#include "core/record/Id.h"

namespace lubberline {

struct AircraftType {
    AircraftTypeId id;
    RecordId record = {};
    std::string name; ///< "Su-22"; unique
    std::string maker;
    std::string note;
    friend bool operator==(const AircraftType&, const AircraftType&) = default;
};

struct Aircraft {
    AircraftId id;
    RecordId record = {};
    AircraftTypeId type;
    std::string registration; ///< registration or tail number; unique
    std::string serialNumber;
    std::string operatorName;
    std::optional<int> builtYear;
    std::string note;
    bool demonstration = false; ///< invented data, marked as such wherever it is shown
    SiteId base = {};           ///< where it is based now; not valid: not stated
    friend bool operator==(const Aircraft&, const Aircraft&) = default;
};

/// Direct reading, or remote indicating (not stabilised, or gyro-stabilised).
enum class CompassKind { DirectReading, RemoteUnstabilised, RemoteStabilised, NotStated };
enum class Compensator { Unknown, None, Screws, Magnets, Electronic };

/// A compass system as installed on one aircraft.
struct CompassSystem {
    CompassId id;
    RecordId record = {};
    AircraftId aircraft;
    std::string name; ///< "standby compass", "No. 1"; unique on its aircraft
    CompassKind kind = CompassKind::DirectReading;
    Compensator compensator = Compensator::Unknown;
    std::string maker;
    std::string partNumber;
    std::string serialNumber;
    std::string location;
    double resolution_deg = 1.0;  ///< smallest division that is read [deg]; drawn as the readings' bars
    LimitsProfileId limits;       ///< not valid: no limits are set
    Date installed = {};          ///< since when it is on this aircraft; empty: not stated
    bool resolutionStated = true; ///< false: nobody did, and resolution_deg is what the figures of its first file speak of
    friend bool operator==(const CompassSystem&, const CompassSystem&) = default;
};

/// The occasions after which sources want a new swing (docs/bibliography.md).
enum class DueCause {
    Other,         ///< opens nothing
    PartsReplaced, ///< ferrous part, flux valve, compass, compensator installed, removed or repaired
    EngineChange,
    Modification, ///< cockpit or avionics
    ElectricalChange,
    Lightning,
    ElectricalStorm,
    HardLanding, ///< shock, turbulence, accident
    MagneticCargo,
    Moved,           ///< to a place of a very different field
    ParkedOverAYear, ///< on one heading
    AccuracySuspected,
};
inline constexpr int kDueCauses = 12;

/// Something that may have changed the magnetism of an aircraft (lightning, engine change, hard landing, …).
struct Event {
    EventId id;
    RecordId record = {};
    AircraftId aircraft;
    Date date;                        ///< UTC
    std::string kind;                 ///< in the crew's words
    DueCause cause = DueCause::Other; ///< what it is to the rules on when a swing is due
    std::string note;
    friend bool operator==(const Event&, const Event&) = default;
};

} // namespace lubberline
