#pragma once
/// The instruments that tell the aircraft's heading; what their figures mean: core/record/DatumInstrument.h.

#include <string>

#include "core/base/Date.h"
#include "core/record/Id.h"

namespace lubberline {

enum class DatumKind {
    RoseLine,        ///< the aircraft is set on a painted line: the line's heading, with the rose's error of today
    SightingCompass, ///< read from ahead or astern
    Theodolite,      ///< circle reading + zero
    DigitalCompass,  ///< fixed to the aircraft, with laser sight
    TransferGyro,
    Astrocompass, ///< true
    Runway,       ///< the runway's surveyed direction, true or magnetic
    Inertial,     ///< INS or GPS: true
    ElectricalCalibrator,
    ShadowPin, ///< bearing of the sun's shadow from the nose: with place and time a true heading
};

/// Whether the instrument faces the aircraft's way. Sources differ by instrument, so that it is a setting of each.
enum class SightingDirection { Direct, Reciprocal };

struct DatumInstrument {
    RecordId record;
    std::string name; ///< unique
    DatumKind kind = DatumKind::SightingCompass;
    std::string maker, serialNumber;
    Date calibrationDue;                                 ///< empty: none stated
    SightingDirection ahead = SightingDirection::Direct; ///< how it reads when the observer stands ahead of the aircraft
    bool givesTrue = false;                              ///< its figures are from true north: magnetic = true − variation
    double zero_deg = 0;         ///< added to every figure: circle zero of a theodolite, instrument error, offset of a painted line
    double resolution_deg = 0.5; ///< smallest division that is read
    std::string note;
    friend bool operator==(const DatumInstrument&, const DatumInstrument&) = default;
};

} // namespace lubberline
