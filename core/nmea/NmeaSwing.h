#pragma once
/// A swing from an NMEA log of a turn: each compass heading (HDG, HDM) with the reference of that moment.

#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "core/angle/Heading.h"
#include "core/base/Date.h"
#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/nmea/NmeaDelay.h"
#include "core/nmea/NmeaVariation.h"
#include "core/nmea/NmeaWind.h"
#include "core/record/Swing.h"
#include "core/swing/SharedDoubts.h"

namespace lubberline {

/// What the compass is held against.
enum class NmeaReference {
    Track,       ///< the track over ground of RMC or VTG: the heading on the ground and in still air; in wind it is taken out
    HeadingTrue, ///< HDT, THS (VHW) of a gyro or a pair of GPS antennas
    Magnetic,    ///< the HDM or HDG of another instrument (another talker; else HDM against HDG)
};

enum class NmeaWindChoice {
    Found,   ///< taken out where it shows and the aircraft flies
    TakeOut, ///< wherever it shows: afloat, a current
    Leave,   ///< it moves on wheels: its track is its heading
};

struct NmeaOptions {
    NmeaReference reference = NmeaReference::Track;
    NmeaVariation variation = {};
    double minSpeed_kt = 2.0;       ///< with Track only: below, a track is the noise of the receiver
    double maxTurnRate_deg_s = 5.0; ///< faster, a compass lags; applied where the log tells the time
    std::string compassTalker = {}; ///< whose HDG and HDM are the compass; empty: the only one, or HC
    NmeaWindChoice wind = NmeaWindChoice::Found;
    double variationError_deg = 0; ///< standard error of the variation, where the user knows of one
    Date date = {};                ///< empty: the log's
    Date today = {};               ///< of the user's clock; empty: not known
};

struct NmeaPair {
    CompassHeading compass;
    MagneticHeading magnetic; ///< of the reference at the same moment
    double seconds = 0;       ///< of the log's own scale
    std::optional<double> speed_kt;
    std::optional<double> turnRate_deg_s; ///< of the compass; none where the log does not tell
    std::string timeUtc;                  ///< ISO 8601; empty where the log does not tell
    bool used = false;
};

/// The turns to the right held against those to the left, after the delay.
struct NmeaDirections {
    double clockwiseA_deg = 0, counterClockwiseA_deg = 0;
    double largestDifference_deg = 0; ///< of the two curves, over the headings that were read both ways
};

struct NmeaSwing {
    std::int64_t lines = 0;
    std::int64_t sentences = 0; ///< well formed, with a right checksum or with none
    std::int64_t badChecksums = 0;
    std::int64_t withoutChecksum = 0;
    std::int64_t otherLines = 0;  ///< neither a sentence nor blank
    std::int64_t badHeadings = 0; ///< negative, or beyond 360
    std::vector<NmeaPair> pairs;
    std::size_t used = 0;
    std::string compassTalker;
    std::string referenceSource;        ///< "GPRMC"
    std::optional<Variation> variation; ///< that was applied
    std::string variationSource;        ///< "stated", "log", "WMM2025 at 60.0°N 24.8°E"
    std::optional<double> variationOfModel_deg;
    Date date;                                         ///< of the first fix, or as stated; empty: not told
    std::optional<double> latitude_deg, longitude_deg; ///< of the first fix
    bool timesTold = false;                            ///< false: seconds are made of the steps of the reference
    double step_s = 1;                                 ///< then: how long one was taken to be
    NmeaDelay delay;
    std::optional<NmeaWind> wind; ///< of a track
    std::optional<NmeaDirections> directions;
    std::vector<SharedDoubt> doubts; ///< of the used pairs
    std::vector<Message> warnings;
    std::vector<Message> limits; ///< those of them that say how sure the coefficients can be
};

/// Errors: Io, Cancelled, InvalidInput: no sentences; no compass headings; several talkers and none chosen (names them); no
/// reference of the kind; no fix; no variation to be found. `name` is the file named in errors.
Result<NmeaSwing> readNmeaSwing(std::istream& input, const std::string& name, const NmeaOptions& options, const Progress& progress = {});
Result<NmeaSwing> readNmeaSwingFile(const std::string& path, const NmeaOptions& options, const Progress& progress = {});

/// The used pairs in order of time as a calibration swing with its date and variation; what it is of is for the user to say. Its
/// note says in English how sure its coefficients can be, because a record has no other place for what its readings share.
[[nodiscard]] Swing toSwing(const NmeaSwing& swing);

} // namespace lubberline
