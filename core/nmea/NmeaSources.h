#pragma once
/// Who of a log is the compass, and what it is held against.

#include <optional>
#include <string>
#include <vector>

#include "core/nmea/NmeaLog.h"
#include "core/nmea/NmeaSwing.h"

namespace lubberline {

struct NmeaSources {
    const NmeaStream* compass = nullptr; ///< both of the log
    const NmeaStream* reference = nullptr;
    std::vector<Message> warnings;
};

[[nodiscard]] std::string nameOf(const NmeaSource& source);

/// Of two that send a compass heading, whether the first is the likelier compass to be swung: any before a speed log, which repeats some
/// compass (VHW); HC, the standard's talker of a magnetic compass, before others; what it reads (HDG) before what may be corrected
/// already (HDM); else by name.
[[nodiscard]] bool likelierCompass(const NmeaSource& one, const NmeaSource& other);

/// Why a reference may be made of the very compass that it is held against, and would then show no deviation: a true heading of a speed
/// log or of a magnetic compass, a true heading or a second magnetic one of the compass's own talker. None: nothing speaks against it.
[[nodiscard]] std::optional<Message> doubtOfReference(const NmeaSource& reference, NmeaNorth north, const NmeaSource& compass);

/// Errors: InvalidInput: no compass; several talkers and none chosen (names them); no reference of the kind, or one without a fix.
Result<NmeaSources> chooseSources(const NmeaLog& log, const NmeaOptions& options);

/// What a log says of itself: damage, receivers that had no fix or made it up, headings that are none.
[[nodiscard]] std::vector<Message> toldOfLog(const NmeaLog& log);

} // namespace lubberline
