#pragma once
/// The electrical swing of a remote compass (MC-1, MC-2, TM 11-4920-292-15): the calibrator makes fields as if the aircraft
/// were turned, while it stands on a north–south line. A record of its own kind: its figures are the calibrator's, not headings
/// of an aircraft. Sign of the sources, and of every figure here that is called an error: indicated − selected (indicator
/// greater: +). The deviation of the rest of the program is its negative.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/Date.h"
#include "core/record/Id.h"

namespace lubberline {

/// The nulled voltages of one field setting, in the normal and the reversed position.
struct FieldVoltage {
    std::optional<double> normal_V, reversed_V;
    [[nodiscard]] std::optional<double> mean_V() const;
    friend bool operator==(const FieldVoltage&, const FieldVoltage&) = default;
};

/// The swing data sheet's table F1: what is indicated with 0, 90, 180 and 270 selected.
struct FourPointTable {
    std::array<std::optional<double>, 4> indicated_deg;
    friend bool operator==(const FourPointTable&, const FourPointTable&) = default;
};

/// One of the headings every 15°.
struct SelectedHeading {
    double selected_deg = 0;
    std::optional<double> indicated_deg;
    friend bool operator==(const SelectedHeading&, const SelectedHeading&) = default;
};

struct ElectricalSwing {
    RecordId record;
    Date date;
    std::string line; ///< id of the north–south line
    std::string calibrator, calibratorSerial, sensorSheet;
    FieldVoltage E1, E2;
    std::optional<double> misalignment_deg, delta180_deg, delta270_deg; ///< as set on the controls
    FourPointTable before, after;                                       ///< table F1, before and after the controls were turned
    std::vector<SelectedHeading> headings;                              ///< 24, every 15°
    std::vector<SelectedHeading> selfCheck; ///< the same headings by the turntable, for the set's own check; may be empty
    std::string by, note;
    friend bool operator==(const ElectricalSwing&, const ElectricalSwing&) = default;
};

} // namespace lubberline
