#pragma once
/// What a sentence says, with its senses: headings by their north, variation and deviation east positive, knots, UTC.
/// Read: HDG, HDM, HDT, THS, VHW, RMC, VTG, GGA, ZDA. A field that is empty or unreadable is not there; nothing is guessed. An angle that
/// is written and cannot be read (`-15.2,W`: east or west?) is kept as it is written, to be told.

#include <optional>
#include <string>
#include <variant>

#include "core/angle/Heading.h"
#include "core/base/Date.h"
#include "core/nmea/NmeaSentence.h"

namespace lubberline {

/// How a sender came by what it says (the mode letter of RMC, VTG and THS, the quality of GGA).
enum class NmeaMode {
    Measured,
    Estimated, ///< E: dead reckoning: perhaps from the very compass that is swung
    Manual,    ///< M: typed in
    Simulated, ///< S
};

/// HDG: the magnetic sensor's own heading, before any deviation is applied: what the compass reads. HDM: a compass's heading.
struct NmeaCompass {
    std::string talker;
    std::string type; ///< "HDG" or "HDM"
    CompassHeading heading;
    std::optional<Deviation> deviation; ///< that the instrument would apply; not applied here
    std::optional<Variation> variation;
    std::string unread = {}; ///< a variation or deviation as it is written, where it is no size with its side
};

/// HDT, THS.
struct NmeaTrueHeading {
    std::string talker;
    std::string type;
    TrueHeading heading;
    NmeaMode mode = NmeaMode::Measured;
};

/// VHW: what a speed log knows of a compass's heading.
struct NmeaWater {
    std::string talker;
    std::optional<TrueHeading> heading;
    std::optional<CompassHeading> compass;
};

/// A heading that is none: negative, or beyond 360.
struct NmeaBadHeading {
    std::string talker;
};

struct NmeaTime {
    double secondsOfDay = 0;  ///< UTC, [0, 86401)
    std::optional<Date> date; ///< RMC and ZDA
};

/// ZDA.
struct NmeaClock {
    std::string talker;
    NmeaTime time;
};

/// RMC, VTG: ground track.
struct NmeaTrack {
    std::string talker;
    std::string type;
    bool noFix = false; ///< RMC status V, mode N: no track, no place
    NmeaMode mode = NmeaMode::Measured;
    std::optional<TrueHeading> track;
    std::optional<double> speed_kt;
    std::optional<Variation> variation;
    std::optional<NmeaTime> time;
    std::optional<double> latitude_deg, longitude_deg;
    std::string unread = {}; ///< a variation as it is written, where it is no size with its side
};

/// GGA.
struct NmeaFix {
    std::string talker;
    NmeaMode mode = NmeaMode::Measured;
    std::optional<NmeaTime> time;
    double latitude_deg = 0, longitude_deg = 0;
    std::optional<double> altitude_m; ///< above mean sea level
};

/// THS of mode V: the instrument says that it has no heading.
struct NmeaNoHeading {
    std::string talker;
};

using NmeaValue
    = std::variant<std::monostate, NmeaCompass, NmeaTrueHeading, NmeaWater, NmeaBadHeading, NmeaNoHeading, NmeaClock, NmeaTrack, NmeaFix>;

/// Nothing (monostate) for sentences of other types, and for those that hold no value.
[[nodiscard]] NmeaValue valueOf(const NmeaSentence& sentence);

/// What RMC, GGA and ZDA say of when and where, and is none: hour 24, the 31st of a month of 30, a latitude of 95°; as it is written.
/// Empty: nothing. What a receiver without a fix leaves empty is no such thing.
struct NmeaUnread {
    std::string time, date, place;
};
[[nodiscard]] NmeaUnread unreadOf(const NmeaSentence& sentence);

} // namespace lubberline
