#pragma once
/// What a sentence says, with its senses: headings by their north, variation and deviation east positive, knots, UTC.
/// Read: HDG, HDM, HDT, RMC, VTG, GGA. A field that is empty or unreadable is not there; nothing is guessed.

#include <optional>
#include <string>
#include <variant>

#include "core/angle/Heading.h"
#include "core/nmea/NmeaSentence.h"

namespace lubberline {

/// HDG: the magnetic sensor's own heading, before any deviation is applied: what the compass reads. HDM: a compass's heading.
struct NmeaCompass {
    std::string talker;
    std::string type; ///< "HDG" or "HDM"
    CompassHeading heading;
    std::optional<Deviation> deviation; ///< that the instrument would apply; not applied here
    std::optional<Variation> variation;
};

/// HDT.
struct NmeaTrueHeading {
    std::string talker;
    TrueHeading heading;
};

struct NmeaTime {
    double secondsOfDay = 0;         ///< UTC, [0, 86401)
    std::optional<std::string> date; ///< ISO 8601; RMC only
};

/// RMC, VTG: ground track. After a void fix (RMC status V, mode N) there is none: all is empty.
struct NmeaTrack {
    std::string talker;
    std::optional<TrueHeading> track;
    std::optional<double> speed_kt;
    std::optional<Variation> variation;
    std::optional<NmeaTime> time;
    std::optional<double> latitude_deg, longitude_deg;
};

/// GGA.
struct NmeaFix {
    std::string talker;
    std::optional<NmeaTime> time;
    double latitude_deg = 0, longitude_deg = 0;
    std::optional<double> altitude_m; ///< above mean sea level
};

using NmeaValue = std::variant<std::monostate, NmeaCompass, NmeaTrueHeading, NmeaTrack, NmeaFix>;

/// Nothing (monostate) for sentences of other types, and for those that hold no value.
[[nodiscard]] NmeaValue valueOf(const NmeaSentence& sentence);

} // namespace lubberline
