#pragma once
/// A swing from an NMEA log of a slow turn: each compass heading (HDG, HDM) with the reference that was newest then.

#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/angle/Heading.h"
#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/deviation/Smith.h"
#include "core/nmea/NmeaValues.h"
#include "core/record/Swing.h"

namespace lubberline {

/// What the compass is held against.
enum class NmeaReference {
    Track,       ///< the track over ground of RMC or VTG: right only without drift (on the ground, in still air)
    HeadingTrue, ///< HDT of a gyro or a pair of GPS antennas
    Magnetic,    ///< the HDM or HDG of another instrument (another talker; else HDM against HDG)
};

struct VariationOfLog {};   ///< what RMC or HDG say
struct VariationOfModel {}; ///< WMM or IGRF at the log's position and date
struct VariationFound {};   ///< the log's where it has one, else the model's
using NmeaVariation = std::variant<VariationFound, Variation, VariationOfLog, VariationOfModel>;

struct NmeaOptions {
    NmeaReference reference = NmeaReference::Track;
    NmeaVariation variation = {};
    double minSpeed_kt = 2.0;       ///< with Track only: below, a track is the noise of the receiver
    double maxTurnRate_deg_s = 5.0; ///< faster, a compass lags; applied where the log tells the time
    std::string compassTalker = {}; ///< whose HDG and HDM are the compass; empty: the only one, or HC
};

struct NmeaPair {
    CompassHeading compass;
    MagneticHeading magnetic;
    std::optional<double> speed_kt;
    std::optional<double> turnRate_deg_s; ///< none where the log does not tell
    std::string timeUtc;                  ///< ISO 8601; empty where the log does not tell
    bool used = false;
};

struct NmeaSwing {
    std::int64_t lines = 0;
    std::int64_t sentences = 0; ///< well formed, with a right checksum or with none
    std::int64_t badChecksums = 0;
    std::int64_t withoutChecksum = 0;
    std::int64_t otherLines = 0; ///< neither a sentence nor blank
    std::vector<NmeaPair> pairs;
    std::size_t used = 0;
    std::string compassTalker;
    std::optional<Variation> variation; ///< the last that was applied
    std::string variationSource;        ///< "stated", "log", "WMM2025 at 60.0°N 24.8°E"
    std::string date;                   ///< of the first fix, ISO 8601; empty: not told
    std::vector<Message> warnings;
};

/// Errors: Io, Cancelled, InvalidInput: no sentences; no compass headings; several talkers and none chosen (names them); no
/// reference of the kind; no variation to be found. `name` is the file named in errors.
Result<NmeaSwing> readNmeaSwing(std::istream& input, const std::string& name, const NmeaOptions& options, const Progress& progress = {});
Result<NmeaSwing> readNmeaSwingFile(const std::string& path, const NmeaOptions& options, const Progress& progress = {});

/// The used pairs as a calibration swing with its date and variation; what it is of is for the user to say.
[[nodiscard]] Swing toSwing(const NmeaSwing& swing);

} // namespace lubberline
